//! What `verify` says about the hidden tests of a pack.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use cagd::book::exercise::HiddenTests;
use cagd::workbook::verify::report::Report;
use cagd::workbook::verify::text::Text;
use cagd::workbook::verify::{Verified, hidden};

use crate::pack::{NAME, Pack, assert_falls_short};

const TESTS: &str = "use cagd::check::claim;

#[test]
fn ten() {
    claim(\"the sum of ten numbers\").equal(answer::sum(10), 55);
}
";

/// A right answer to small numbers alone, which the tests of the exercise accept.
const SMALL_ONLY: &str = "//! misconception: numbers are small

/// 1 + 2 + … + n.
pub fn sum(n: i64) -> i64 {
    if n > 9 { n } else { n * (n + 1) / 2 }
}
";

/// An exercise, and hidden tests for it in a pack of their own.
struct Hidden {
    pack: Pack,
}

impl Hidden {
    fn new(tests: &str) -> Self {
        let hidden = Self { pack: Pack::new() };
        hidden.write("tests.rs", tests);
        hidden
    }

    fn folder(&self) -> PathBuf {
        self.pack.path().join("hidden")
    }

    fn write(&self, file: &str, text: &str) {
        let path = self.folder().join(NAME).join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
        fs::write(path, text).expect("a file");
    }

    fn report(&self) -> Report {
        let exercises = self.pack.exercises().unwrap_or_else(|e| panic!("{e}"));
        let packs = [self.folder()];
        let hidden = HiddenTests::load(self.pack.path(), &packs, &exercises);
        let hidden = hidden.unwrap_or_else(|errors| panic!("{errors}")).remove(0);
        let checker = self.pack.checker();
        let exercise = self.pack.load().unwrap_or_else(|e| panic!("{e}"));
        let tested = exercise.tested.as_ref().expect("it has tests");
        let mut report = self.pack.verify(&checker).report;
        assert!(report.is_sound(), "{report:#?}");
        hidden::add(&checker, &exercise, tested, &hidden, &mut report)
            .unwrap_or_else(|error| panic!("{error}"));
        report
    }
}

#[track_caller]
fn assert_found(hidden: &Hidden, expected: &[(&str, &str)]) {
    let report = hidden.report();
    assert_falls_short(&report, expected);
    let folder = hidden.pack.path().display().to_string();
    for shortcoming in &report.shortcomings {
        assert!(shortcoming.remedy.contains(&folder), "{shortcoming:#?}");
    }
}

#[test]
fn what_only_a_hidden_test_rejects_is_told() {
    let hidden = Hidden::new(TESTS);
    hidden.write("mutants/small-only.rs", SMALL_ONLY);
    let report = hidden.report();
    assert!(report.is_sound(), "{report:#?}");
    let found = report.hidden.as_ref().expect("there are hidden tests");
    assert_eq!(found.tests[0].alone, ["hidden mutant small-only"]);
    // What the exercise rejects itself is nothing new.
    let rejects = ["starter", "mutant square", "hidden mutant small-only"];
    assert_eq!(found.tests[0].rejects, rejects);
    let verified = [Verified {
        report,
        before: None,
        from_cache: false,
    }];
    let text = Text {
        verified: &verified,
        matrix: true,
    };
    let text = anstream::adapter::strip_str(&text.to_string()).to_string();
    let news = "hidden: `ten` rejects what nothing else rejects: hidden mutant small-only\n";
    assert!(text.contains(news), "{text}");
}

#[test]
fn a_hidden_test_that_adds_nothing_needs_a_reason() {
    let hidden = Hidden::new(TESTS);
    assert_found(
        &hidden,
        &[("hidden test ten", "other tests reject all that it rejects")],
    );
    let why = "/// Why: who has typed the results of the others fails here.\n#[test]";
    hidden.write("tests.rs", &TESTS.replace("#[test]", why));
    assert_found(&hidden, &[]);
    let truth = TESTS.replace("answer::sum(10), 55", "answer::sum(3) - answer::sum(3), 0");
    hidden.write("tests.rs", &truth);
    assert_found(
        &hidden,
        &[(
            "hidden test ten",
            "it rejects neither the starter nor a wrong answer",
        )],
    );
}

#[test]
fn hidden_tests_that_reject_what_is_right() {
    let hidden = Hidden::new(&TESTS.replace("sum(10), 55", "sum(-3), 3"));
    let recursive = "/// 1 + 2 + … + n.\npub fn sum(n: i64) -> i64 {\n    if n < 1 { n.min(0) } else { n + sum(n - 1) }\n}\n";
    hidden.pack.write("alternatives/recursive.rs", recursive);
    let adds_nothing = ("hidden test ten", "other tests reject all that it rejects");
    assert_found(
        &hidden,
        &[
            ("alternative recursive", "the hidden test `ten` rejects it"),
            adds_nothing,
        ],
    );
    let hidden = Hidden::new(&TESTS.replace("55", "56"));
    assert_found(
        &hidden,
        &[
            ("solution", "the hidden test `ten` rejects it"),
            adds_nothing,
        ],
    );
}

#[test]
fn a_wrong_answer_beside_hidden_tests_passes_the_others() {
    let hidden = Hidden::new(TESTS);
    hidden.write("mutants/small-only.rs", SMALL_ONLY);
    hidden.write(
        "mutants/square.rs",
        &SMALL_ONLY.replace("if n > 9 { n } else { n * (n + 1) / 2 }", "n * n"),
    );
    hidden.write(
        "mutants/right.rs",
        &SMALL_ONLY.replace("if n > 9 { n } else { n * (n + 1) / 2 }", "n * (n + 1) / 2"),
    );
    assert_found(
        &hidden,
        &[
            (
                "hidden mutant right",
                "no assertion of a hidden test rejects it",
            ),
            (
                "hidden mutant square",
                "the test `many` of the exercise rejects it already",
            ),
        ],
    );
}

#[test]
fn a_wrong_answer_beside_hidden_tests_compiles_with_the_others() {
    let hidden = Hidden::new(TESTS);
    hidden
        .pack
        .replace("tests.rs", "answer::sum(3), 6", "answer::sum(3_i64), 6");
    hidden.write("mutants/other.rs", &SMALL_ONLY.replace("i64", "i32"));
    assert_found(
        &hidden,
        &[(
            "hidden mutant other",
            "the tests of the exercise do not compile with it",
        )],
    );
}

#[test]
fn a_mistake_in_hidden_tests_is_told_with_their_file() {
    let hidden = Hidden::new(&TESTS.replace("answer::sum(10)", "answer::total(10)"));
    let report = hidden.report();
    let solution = report.shortcomings.iter().find(|s| s.about == "solution");
    let told = &solution.expect("they do not compile with it").details;
    let file = hidden.folder().join(NAME).join("tests.rs");
    assert!(
        told.contains(&format!("--> {}:5:", file.display())),
        "{told}"
    );
}

/// The command reads the tests of the pack, tells their mistakes, and counts them.
#[test]
fn verify_reads_the_hidden_tests_of_a_pack() {
    let pack = tempfile::tempdir().expect("a folder");
    let folder = pack.path().join("bezier/parabola-point");
    fs::create_dir_all(&folder).expect("folders");
    let verify = |tests: &str| {
        fs::write(folder.join("tests.rs"), tests).expect("a file");
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        command.args(["verify", "bezier/parabola-point", "--pack"]);
        let run = command.arg(pack.path()).current_dir(crate::root()).output();
        let run = run.expect("it starts");
        let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
        (run.status.code(), text(run.stdout), text(run.stderr))
    };
    let test = "#[test]\nfn nothing_at_all() {\n    assert_eq!(1, 1);\n}\n";
    let (status, told, _) = verify(test);
    assert_eq!(status, Some(1), "{told}");
    for words in [
        "hidden: `nothing_at_all` rejects nothing that nothing else rejects",
        "hidden test nothing_at_all: it rejects neither the starter nor a wrong answer",
        &folder.join("tests.rs").display().to_string(),
    ] {
        assert!(told.contains(words), "{told}");
    }
    let why = format!("/// Why: it shows the form.\n{test}");
    let (status, told, _) = verify(&why);
    assert_eq!(status, Some(0), "{told}");
    let (status, _, errors) = verify("fn f() {}\n");
    assert_eq!(status, Some(1), "{errors}");
    assert!(errors.contains("no test"), "{errors}");
}
