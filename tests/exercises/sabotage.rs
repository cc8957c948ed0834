//! Sabotage: an exercise that proves nothing is noticed, and told with what to do.

use std::time::Duration;

use cagd::workbook::checking::Checker;
use cagd::workbook::checking::verdict::TestOutcome;
use cagd::workbook::sandbox::{Isolation, Limits};

use crate::pack::{Pack, assert_falls_short};

#[test]
fn without_sabotage_nothing_falls_short() {
    let pack = Pack::new();
    let report = pack.report();
    assert!(report.is_sound(), "{report:#?}");
    let killed_by: Vec<_> = report
        .mutants
        .iter()
        .flatten()
        .map(|mutant| (mutant.name.as_str(), mutant.by.as_deref()))
        .collect();
    assert_eq!(
        killed_by,
        [
            ("forgets-one", Some("one")),
            ("square", Some("many")),
            ("starts-at-one", Some("nothing"))
        ]
    );
}

#[test]
fn a_broken_solution() {
    let pack = Pack::new();
    pack.replace("answer.rs", "(n + 1)", "(n + 2)");
    assert_falls_short(
        &pack.report(),
        &[("solution", "the test `many` rejects it")],
    );
}

#[test]
fn a_solution_that_only_some_random_inputs_reject() {
    let pack = Pack::new();
    // A seed of its own stands for the rare input.
    pack.replace(
        "tests.rs",
        "#[test]\nfn one() {",
        "#[test]\nfn one() {\n    let seed = std::env::var(\"PROPTEST_RNG_SEED\").unwrap_or_default();\n    claim(\"luck\").holds(seed != \"9\", \"luck\", \"none\");",
    );
    assert_falls_short(
        &pack.report(),
        &[(
            "solution",
            "with other random inputs the test `one` rejects it (one of 20 more seeds: 9)",
        )],
    );
}

#[test]
fn an_answer_with_warnings() {
    let pack = Pack::new();
    pack.replace("answer.rs", "//| let _ = n;", "//| let m = n;");
    assert_falls_short(&pack.report(), &[("starter", "it compiles with a warning")]);
}

#[test]
fn a_starter_that_passes() {
    let pack = Pack::new();
    pack.replace("answer.rs", "//| 2", "//| (0..=n).sum()");
    assert_falls_short(&pack.report(), &[("starter", "it passes every test")]);
}

#[test]
fn mutants_that_are_no_wrong_answers() {
    let pack = Pack::new();
    pack.mutant("survives", "it is right", "(0..=n).sum()");
    pack.mutant("refused", "letters are numbers", "m");
    pack.mutant("panics", "a sum needs a number", "[][n as usize]");
    pack.mutant("hopeless", "a sum is negative", "-1 - n");
    assert_falls_short(
        &pack.report(),
        &[
            ("mutant refused", "it does not compile"),
            (
                "mutant hopeless",
                "it passes no test, so it is not the answer of somebody who tried",
            ),
            (
                "mutant panics",
                "no assertion rejects it; it panics in the test `nothing`",
            ),
            ("mutant survives", "it passes every test"),
            (
                "probes",
                "they do not tell the solution and the mutant survives apart",
            ),
        ],
    );
}

/// Most answers share a program; what one of them does stays with it.
#[test]
fn one_answer_does_not_harm_another() {
    let pack = Pack::new();
    pack.mutant(
        "endless",
        "counting never ends",
        "if n == 1 { loop {} } else { n }",
    );
    pack.mutant(
        "exits",
        "the end is the end",
        "if n == 3 { std::process::exit(0) } else { n }",
    );
    let limits = Limits {
        time: Duration::from_secs(2),
        ..Limits::answer()
    };
    let report = pack.verify(&pack.checker().with_limits(limits)).report;
    assert_falls_short(
        &report,
        &[
            (
                "mutant exits",
                "no assertion rejects it; it ends the program or runs too long in the test `many`",
            ),
            ("probes", "the mutant endless gives no values"),
            ("probes", "the mutant exits gives no values"),
        ],
    );
    // The test after the one that never ends has its result all the same.
    let columns = report.matrix.expect("the answers were tried");
    let outcomes = |name: &str| {
        let mut columns = columns.iter();
        let column = columns.find(|column| column.answer == name);
        column.map(|column| column.outcomes.clone())
    };
    use TestOutcome::{Ended, Passed, Rejected};
    assert_eq!(
        outcomes("mutant endless"),
        Some(vec![Passed, Ended, Rejected])
    );
    assert_eq!(outcomes("mutant exits"), Some(vec![Passed, Passed, Ended]));
    assert_eq!(
        outcomes("mutant square"),
        Some(vec![Passed, Passed, Rejected])
    );
}

/// Answers that do not fit the tests are told with the words of the compiler, and the others are judged as ever.
#[test]
fn an_answer_that_the_tests_cannot_use() {
    let pack = Pack::new();
    let file = "mutants/renamed.rs";
    pack.write(
        file,
        "//! misconception: any name will do\n\n/// 1 + 2 + … + n.\npub fn total(n: i64) -> i64 {\n    n\n}\n",
    );
    let report = pack.report();
    let [only] = report.shortcomings.as_slice() else {
        panic!("{report:#?}");
    };
    assert_eq!(only.about, "mutant renamed");
    assert_eq!(only.found, "the tests do not compile with it");
    assert!(only.remedy.contains(file), "{only:#?}");
    let place = format!("{}/tests.rs:4:", crate::pack::NAME);
    assert!(only.details.contains(&place), "{only:#?}");
}

#[test]
fn tests_that_assert_nothing() {
    let pack = Pack::new();
    pack.write(
        "tests.rs",
        "fn probes() -> Vec<String> {\n    cagd::probes![answer::sum(0), answer::sum(1), answer::sum(3)]\n}\n\n#[test]\nfn it_runs() {\n    let _ = answer::sum(3);\n}\n",
    );
    assert_falls_short(
        &pack.report(),
        &[
            ("starter", "it passes every test"),
            ("mutant forgets-one", "it passes every test"),
            ("mutant square", "it passes every test"),
            ("mutant starts-at-one", "it passes every test"),
            (
                "test it_runs",
                "it rejects neither the starter nor a mutant",
            ),
        ],
    );
}

/// A test that adds nothing needs a reason.
#[test]
fn tests_that_add_nothing() {
    let pack = Pack::new();
    let tests = "
#[test]
fn two() {
    claim(\"the sum of two numbers\").equal(answer::sum(2), 3);
}

/// Why: four is the last number that one adds by heart.
#[test]
fn four() {
    claim(\"the sum of four numbers\").equal(answer::sum(4), 10);
}

/// Why: it shows how a claim is written.
#[test]
fn always() {
    claim(\"a truth\").equal(answer::sum(3) - answer::sum(3), 0);
}

#[test]
fn never() {
    claim(\"a truth\").equal(answer::sum(4) - answer::sum(4), 0);
}

#[test]
fn many() {";
    pack.replace("tests.rs", "\n#[test]\nfn many() {", tests);
    // The square is rejected by three tests now.
    assert_falls_short(
        &pack.report(),
        &[
            ("test two", "other tests reject all that it rejects"),
            ("test never", "it rejects neither the starter nor a mutant"),
            ("test many", "other tests reject all that it rejects"),
        ],
    );
}

#[test]
fn probes_that_do_not_tell_two_mutants_apart() {
    let pack = Pack::new();
    pack.mutant("cube", "the sum is the cube", "n * n * n");
    pack.replace("tests.rs", ", answer::sum(3)]", "]");
    assert_falls_short(
        &pack.report(),
        &[
            (
                "probes",
                "they do not tell the solution and the mutant cube apart",
            ),
            (
                "probes",
                "they do not tell the solution and the mutant square apart",
            ),
            (
                "probes",
                "they do not tell the mutant cube and the mutant square apart",
            ),
        ],
    );
}

#[test]
fn a_test_that_rejects_another_right_answer() {
    let pack = Pack::new();
    let recursive = "/// 1 + 2 + … + n.\npub fn sum(n: i64) -> i64 {\n    if n < 1 { n.min(0) } else { n + sum(n - 1) }\n}\n";
    pack.write("alternatives/recursive.rs", recursive);
    pack.replace("tests.rs", "sum(3), 6", "sum(-3), 3");
    assert_falls_short(
        &pack.report(),
        &[("alternative recursive", "the test `many` rejects it")],
    );
}

/// What was verified is verified anew when a file of the exercise or the library changes.
#[test]
fn a_stale_build() {
    let pack = Pack::new();
    let checker = pack.checker();
    assert!(!pack.verify(&checker).from_cache);
    assert!(pack.verify(&checker).from_cache);

    pack.replace("answer.rs", "n * (n + 1) / 2", "n + 1");
    let broken = pack.verify(&checker);
    assert!(!broken.from_cache && !broken.report.is_sound());
    // What falls short is never taken from the cache.
    assert!(!pack.verify(&checker).from_cache);

    pack.replace("answer.rs", "n + 1", "n * (n + 1) / 2");
    assert!(pack.verify(&checker).report.is_sound());
    assert!(pack.verify(&checker).from_cache);
    let mut library = checker.library().clone();
    library.fingerprint.push('0');
    let changed = Checker::with_library(library, Isolation::best());
    assert!(!pack.verify(&changed).from_cache);
}

/// The report of a new test says what it rejects and nothing rejected before.
#[test]
fn a_new_test_is_compared_with_the_last_run() {
    let pack = Pack::new();
    let checker = pack.checker();
    pack.verify(&checker);
    pack.mutant(
        "late",
        "only small numbers are added so",
        "if n > 9 { n } else { n * (n + 1) / 2 }",
    );
    pack.replace(
        "tests.rs",
        "answer::sum(3)]",
        "answer::sum(3), answer::sum(10)]",
    );
    pack.replace(
        "tests.rs",
        "#[test]\nfn many",
        "#[test]\nfn ten() {\n    claim(\"the sum of ten numbers\").equal(answer::sum(10), 55);\n}\n\n#[test]\nfn many",
    );
    let text = |verified| {
        let text = cagd::workbook::verify::text::Text {
            verified: &[verified],
            matrix: true,
        };
        anstream::adapter::strip_str(&text.to_string()).to_string()
    };
    let news = "new: `ten` rejects what nothing rejected before: mutant late\n";
    for _ in 0..2 {
        let verified = pack.verify(&checker);
        let text = text(verified);
        assert!(text.contains(news), "{text}");
    }
}
