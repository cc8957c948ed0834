//! Tableaux to compute by hand: fresh numbers, and what the schema asks of their folders.

use std::fs;
use std::path::Path;

use cagd::bezier::tableaux;
use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::Exercises;
use cagd::workbook::checking::Outcome;

use super::{answer, checker, exercises, root, tested};

const CUBIC: &str = "bezier/cubic-tableau";

#[test]
fn every_round_is_checked_by_its_own_numbers() {
    let exercises = exercises();
    let (exercise, tested) = tested(&exercises, CUBIC);
    let checker = checker();
    let check = |text: &str| {
        let verdict = checker.check(exercise, tested, &answer(text), 1);
        verdict.unwrap_or_else(|error| panic!("{error}"))
    };
    let round = 2;
    let begun = exercise.fresh_answer_file(round).expect("it deals numbers");
    assert_eq!(check(&begun).outcome, Outcome::Failed);

    let filled = tableaux::cubic(round).solved_file();
    assert_eq!(check(&filled).outcome, Outcome::Passed);

    // The same table under the name of another round is a table of other numbers.
    let renamed = filled.replace("ROUND: u64 = 2", "ROUND: u64 = 3");
    assert_ne!(renamed, filled);
    assert_eq!(check(&renamed).outcome, Outcome::Failed);
}

/// The mutants have the numbers of round 0; the reader has others.
#[test]
fn a_misconception_is_recognised_in_every_round() {
    let exercises = exercises();
    let (exercise, tested) = tested(&exercises, CUBIC);
    // Round 2 has t = 1/4; this is the table for 3/4.
    let exchanged = "(0, 4)\n(8, 4) (6, 4)\n(16, 16) (14, 13) (12, 43/4)\n(20, 0) (19, 4) (71/4, 25/4) (261/16, 59/8)\n";
    let blank = tableaux::cubic(2).tableau.blank();
    let begun = exercise.fresh_answer_file(2).expect("it deals numbers");
    let text = begun.replace(&blank, exchanged);
    assert_ne!(text, begun);
    let verdict = checker().check(exercise, tested, &answer(&text), 1);
    let verdict = verdict.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(verdict.outcome, Outcome::Failed);
    let misconception = verdict.misconception.expect("it is that of a mutant");
    assert_eq!(misconception.mutant, "exchanged");
}

#[test]
fn other_kinds_deal_no_numbers() {
    let exercises = exercises();
    let (exercise, _) = tested(&exercises, "bezier/parabola-point");
    assert_eq!(exercise.fresh_answer_file(0), None);
}

/// What the schema says of a copy of the exercise in which `file` was changed.
fn complaint(file: &str, from: &str, to: &str) -> String {
    let pack = tempfile::tempdir().expect("a temporary folder");
    let original = root().join("book/exercises").join(CUBIC);
    let copy = pack.path().join("bezier/changed-tableau");
    copy_folder(&original, &copy);
    let text = fs::read_to_string(copy.join(file)).expect("the file is there");
    let changed = text.replacen(from, to, 1);
    assert_ne!(changed, text, "`{from}` does not stand in {file}");
    fs::write(copy.join(file), changed).expect("it can be written");
    let catalogue = Catalogue::load(&root()).expect("the catalogue loads");
    let loaded = Exercises::load(&root(), &[pack.path().to_owned()], &catalogue);
    loaded.expect_err("it is refused").to_string()
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("it can be made");
    for entry in fs::read_dir(from).expect("it can be listed") {
        let path = entry.expect("an entry").path();
        let target = to.join(path.file_name().expect("it has a name"));
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            fs::copy(&path, &target).expect("it can be copied");
        }
    }
}

#[test]
fn the_folder_shows_what_round_0_deals() {
    let told = complaint("answer.rs", "//| (8, 16)", "//| (8, 12)");
    assert!(
        told.contains("the starter is not what `cubic` deals in round 0"),
        "{told}"
    );
    let told = complaint("answer.rs", "(18, 9/4)", "(18, 9/2)");
    assert!(
        told.contains("the solution is not what `cubic` deals"),
        "{told}"
    );
}

#[test]
fn an_unknown_tableau_is_refused() {
    let told = complaint("exercise.md", "tableau = \"cubic\"", "tableau = \"cubics\"");
    assert!(
        told.contains("no tableau `cubics`") && told.contains("did you mean `cubic`?"),
        "{told}"
    );
}
