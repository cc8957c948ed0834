//! How pages show exercises.

use crate::fixture::Fixture;

const PAGE: &str = "# P\n\n{{#statement bezier-hull}}\nSo.\n{{/statement}}\n";

const TASK: &str = "+++\ntitle = \"Half of it\"\nkind = \"implement\"\nstatements = [\"bezier-hull\"]\ndifficulty = 2\nminutes = 5\norder = 10\n+++\n\nHalve $x$, see {{#ref bezier-hull number}}.\n\n## Hint\nA nudge.\n\n## Hint\nAn idea.\n\n## Hint\n`x / 2`\n\n## Afterwards\nEven numbers are easy.\n";

const ANSWER: &str = "pub fn half(x: u8) -> u8 {\n    //@ solution\n    x / 2\n    //@ starter\n    //| x\n    //@ end\n}\n";

const TESTS: &str = "fn probes() -> Vec<String> { cagd::probes![answer::half(4)] }\n\n#[test]\nfn four() { assert_eq!(answer::half(4), 2) }\n";

/// A book with an exercise whose task is this text.
fn with_task(task: &str) -> Fixture {
    let below = |file: &str| format!("book/exercises/bezier/half/{file}");
    let mutant = "//! misconception: it is a third\npub fn half(x: u8) -> u8 { x / 3 }\n";
    ["a", "b", "c"].iter().fold(
        Fixture::new(PAGE)
            .with_file(&below("exercise.md"), task)
            .with_file(&below("answer.rs"), ANSWER)
            .with_file(&below("tests.rs"), TESTS),
        |fixture, name| fixture.with_file(&below(&format!("mutants/{name}.rs")), mutant),
    )
}

#[test]
fn an_exercise_stands_at_the_end_of_the_page_of_its_statement() {
    let html = with_task(TASK).page();
    let statement = html.find("id=\"bezier-hull\"").expect("the statement");
    let exercise = html
        .find("<section class=\"practice\" id=\"exercise--bezier--half\"")
        .expect("the exercise");
    assert!(statement < exercise);
    for part in [
        "Half of it",
        "data-kind=\"implement\"",
        "difficulty 2 of 5",
        "cargo run -- start bezier/half",
        "<summary>Hint 3</summary>",
        "<summary>What you begin with</summary>",
        "<summary>Solution</summary>",
        "x / 2\n}",
        "Even numbers are easy.",
        // The task is expanded like a page.
        "Theorem\u{a0}4.1",
        "<math",
    ] {
        assert!(
            html[exercise..].contains(part),
            "{part} is missing in {html}"
        );
    }
    assert!(
        html[..exercise].contains("<a href=\"#exercise--bezier--half\">exercise</a>"),
        "{html}"
    );
}

#[test]
fn the_site_to_hand_out_has_no_solution() {
    let html = with_task(TASK).page_without_solutions();
    assert!(html.contains("What you begin with"), "{html}");
    for part in ["Solution", "x / 2\n", "Even numbers are easy."] {
        assert!(!html.contains(part), "{part} is shown in {html}");
    }
}

#[test]
fn a_mistake_in_a_task_is_told_with_its_line() {
    for (wrong, line, words) in [
        ("An idea with {{#ref bezier-hul}}.", 16, "bezier-hull"),
        ("An idea $x.", 16, "belongs to no formula"),
        (
            "An idea.\n\n```rust\nlet x = 1;\n```",
            18,
            "tag its fence as `text`",
        ),
        ("A nudge.", 16, "repeats another"),
    ] {
        let errors = with_task(&TASK.replace("An idea.", wrong)).errors();
        let place = format!("book/exercises/bezier/half/exercise.md:{line}: ");
        assert!(errors[0].starts_with(&place), "{errors:#?}");
        assert!(errors[0].contains(words), "{errors:#?}");
    }
}
