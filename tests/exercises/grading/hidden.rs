//! Hidden tests: they count, and nobody sees them.

use std::fs;
use std::path::Path;
use std::time::Duration;

use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::Exercises;
use cagd::workbook::grade::{Assignment, Status, junit, spreadsheet};
use tempfile::TempDir;

use super::class::{Class, HEAD, NAME, RIGHT, checker, hidden, of, solution};
use crate::{exercises, root};

const TIME: Duration = Duration::from_secs(10);

const TESTS: &str = "use cagd::affine::Point;
use cagd::check::claim;

#[test]
fn with_decimals() {
    let b = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new);
    claim(\"the point\").input(\"SECRET\").equal(answer::point(&b, 3.0), Point::new([6.0, -24.0]));
}
";

/// A pack with hidden tests at `place`.
fn pack(place: &str, tests: &str) -> TempDir {
    let pack = tempfile::tempdir().expect("a folder");
    write(pack.path(), place, "tests.rs", tests);
    pack
}

fn write(pack: &Path, place: &str, file: &str, text: &str) {
    let folder = pack.join(place);
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join(file), text).expect("it is written");
}

#[test]
fn hidden_tests_count_and_are_not_shown() {
    let pack = pack(NAME, TESTS);
    let hidden = hidden(pack.path(), &exercises()).unwrap_or_else(|error| panic!("{error}"));
    let class = Class::new();
    class.hands_in("anna", &solution());
    let only_fractions = format!(
        "{HEAD}    if std::any::type_name::<T>() == \"f64\" {{ return b[0].clone(); }}{RIGHT}"
    );
    class.hands_in("ben", &only_fractions);
    let grades = class.graded(&hidden, TIME);
    let (anna, ben) = (of(&grades, "anna"), of(&grades, "ben"));
    assert_eq!(
        (anna.status, anna.passed, anna.tests),
        (Status::Passed, 4, 4),
        "{anna:#?}"
    );
    assert_eq!(
        (ben.status, ben.passed, ben.tests),
        (Status::Failed, 3, 4),
        "{ben:#?}"
    );
    assert!(ben.verdict.as_ref().is_some_and(|verdict| verdict.passed()));

    let mut csv = Vec::new();
    spreadsheet::write(&grades, &mut csv).expect("it is written");
    let xml = junit::xml(&grades).to_string().expect("it is written");
    for text in [
        grades.to_string(),
        String::from_utf8(csv).expect("text"),
        xml,
    ] {
        assert!(text.contains("3 of 4"), "{text}");
        assert!(
            !text.contains("SECRET") && !text.contains("with_decimals"),
            "{text}"
        );
    }
    let json = serde_json::to_string(&grades).expect("JSON");
    assert!(json.contains("SECRET") && json.contains("with_decimals"));
}

#[test]
fn hidden_tests_that_reject_the_solution_are_told_before_anybody_fails() {
    let pack = pack(NAME, &TESTS.replace("-24.0", "24.0"));
    let exercises = exercises();
    let hidden = hidden(pack.path(), &exercises).unwrap_or_else(|error| panic!("{error}"));
    let class = Class::new();
    class.hands_in("anna", &solution());
    let all = Assignment::all(&exercises, &hidden, &class.read(), None);
    let error = all[0].accepts_the_solution(&checker(TIME));
    let error = error.expect_err("they are wrong").to_string();
    assert!(
        error.contains("with_decimals") && error.contains("tests.rs"),
        "{error}"
    );
}

#[test]
fn a_pack_of_hidden_tests_adds_no_exercise() {
    let pack = pack(NAME, TESTS);
    let catalogue = Catalogue::load(&root()).expect("the catalogue loads");
    let with = Exercises::load(&root(), &[pack.path().to_path_buf()], &catalogue);
    let with = with.unwrap_or_else(|errors| panic!("{errors}"));
    assert!(with.iter().eq(exercises().iter()));
}

#[test]
fn mistakes_are_told_with_file_and_remedy() {
    let told = |pack: &TempDir, words: &[&str]| {
        let error = hidden(pack.path(), &exercises()).expect_err("a mistake");
        for word in words {
            assert!(error.contains(word), "{error}");
        }
    };
    let unknown = pack("bezier/parabola-pont", TESTS);
    told(
        &unknown,
        &[
            "bezier/parabola-pont/tests.rs:1",
            "did you mean `bezier/parabola-point`?",
        ],
    );
    told(&pack(NAME, "fn f() {}\n"), &["tests.rs:1", "no test"]);
    told(
        &pack(NAME, &TESTS.replace("with_decimals", "half_way")),
        &["tests.rs:5", "rename"],
    );
    let explanation = exercises();
    let mut explanations = explanation.iter().filter(|e| e.tested.is_none());
    let explanation = explanations.next().expect("the book has an explanation");
    told(
        &pack(&explanation.name.to_string(), TESTS),
        &["is an explanation"],
    );
    let more = pack(NAME, TESTS);
    write(more.path(), NAME, "notes.txt", "");
    told(&more, &["notes.txt:1", "`mutants/`"]);
}
