//! The schema: a mistake in a file of an exercise is told with file, line and remedy.

use crate::pack::{NAME, Pack};

/// Asserts that this change is found at this line, and that the message says this.
#[track_caller]
fn assert_told(file: &str, from: &str, to: &str, line: usize, said: &[&str]) {
    let pack = Pack::new();
    pack.replace(file, from, to);
    let errors = pack.load().expect_err("it is a mistake");
    let place = format!("{NAME}/{file}:{line}");
    let text = errors.to_string();
    assert!(text.contains(&place), "not at {place}:\n{text}");
    for said in said {
        assert!(text.contains(said), "`{said}` is missing:\n{text}");
    }
}

#[test]
fn front_matter() {
    let file = "exercise.md";
    assert_told(
        file,
        "minutes = 5",
        "minuets = 5",
        6,
        &["minuets", "minutes"],
    );
    assert_told(
        file,
        "minutes = 5",
        "minutes = 0",
        1,
        &["0 minutes", "how long"],
    );
    assert_told(
        file,
        "difficulty = 1",
        "difficulty = 6",
        1,
        &["the difficulty is 6", "5 (exam)"],
    );
    assert_told(
        file,
        "\"implement\"",
        "\"invent\"",
        3,
        &["invent", "repair"],
    );
    assert_told(
        file,
        "bezier-de-casteljau-examples",
        "bezier-de-casteljou-examples",
        1,
        &["bezier-de-casteljau-examples"],
    );
    assert_told(
        file,
        "order = 10",
        "order = 10\nprerequisites = [\"bezier/first\"]",
        1,
        &["no exercise `bezier/first`", "`prerequisites`"],
    );
    assert_told(
        file,
        "order = 10",
        "order = 10\ntableau = \"cubic\"",
        1,
        &["`tableau`", "change the kind"],
    );
}

#[test]
fn hints() {
    let file = "exercise.md";
    assert_told(
        file,
        "## Hint\n\nBegin with small numbers.",
        "",
        1,
        &["2 hints", "at least three"],
    );
    assert_told(
        file,
        "Begin with small numbers.",
        "",
        13,
        &["hint 1 is empty", "write it"],
    );
    let first = "Begin with small numbers.";
    assert_told(
        file,
        "Write the numbers a second time below, in reverse.",
        first,
        18,
        &["repeats", "say more"],
    );
    assert_told(
        file,
        "$n (n + 1) / 2$",
        "known",
        22,
        &["no formula and no code", "leaves only writing"],
    );
    assert_told(file, "## Hint", "## Tip", 12, &["## Tip", "`## Hint`"]);
}

#[test]
fn sources() {
    assert_told(
        "answer.rs",
        "//@ end",
        "//@ ende",
        10,
        &["//@ ende", "in this order"],
    );
    assert_told("answer.rs", "//| 2", "2", 9, &["starter", "`//|`"]);
    assert_told(
        "tests.rs",
        "#[test]\nfn one",
        "#[test]\n#[ignore]\nfn one",
        13,
        &["ignore", "take it out"],
    );
    assert_told(
        "tests.rs",
        "fn probes",
        "fn prob",
        1,
        &["`probes`", "cagd::probes!"],
    );
    assert_told(
        "tests.rs",
        "use cagd::check::claim;",
        "use answer::*;",
        1,
        &["`answer::`"],
    );
    assert_told(
        "mutants/square.rs",
        "//! misconception: the",
        "//! The",
        1,
        &["//! misconception: …"],
    );
}

#[test]
fn files() {
    let pack = Pack::new();
    pack.write("notes.txt", "");
    let text = pack.load().expect_err("it is a mistake").to_string();
    assert!(
        text.contains("notes.txt:1") && text.contains("does not belong here"),
        "{text}"
    );
}
