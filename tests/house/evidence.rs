//! Evidence is found where it is, and nothing else is taken for it.
//!
//! The tests build a small house with one statement, look at it, then break one thing after another.

use std::fs;
use std::path::Path;

use cagd::book::coverage::Coverage;
use cagd::book::exercise::Exercise;
use tempfile::TempDir;

const ID: &str = "bezier-convex-hull";

const PAGE: &str = "# Shape

{{#statement bezier-convex-hull}}
The curve stays inside.

```rust
assert!(1 < 2);
```

```rust,compile_fail,E0369
let sum = () + ();
```

{{#figure bezier-convex-hull}}

{{#proof}}
Each point is a convex combination.
{{/proof}}

{{#errata}}
The notes forget that the parameter is bounded.

```rust
# // a hidden line
# assert_eq!(1, 1);
```
{{/errata}}
{{/statement}}
";

const CATALOGUE: &str = "[[statement]]
id = \"bezier-convex-hull\"
kind = \"theorem\"
title = \"Convex hull\"
sources = []
needs = [\"example\", \"property\", \"exact\", \"figure\", \"proof\", \"compile_fail\"]
errata = true
";

const LAW_TEST: &str = "#[test]
fn convex_hull() {
    let law = |implementation| for_all(curves(), |curve| laws::convex_hull(implementation, curve));
    holds(law(hull));
    rejects(\"nothing is inside\", law(nothing));
}
";

const PROPTEST: &str = "proptest! {
    #[test]
    fn convex_hull(curve in curves()) {
        holds(bezier::laws::convex_hull::<f64>(&curve));
        rejects(\"nothing is inside\", laws::convex_hull(nothing, &curve));
    }
}
";

const FIGURE_TEST: &str = "#[test]
fn convex_hull() {
    let figure = figures::convex_hull();
    holds(inside(&figure));
    rejects(\"a corner is moved\", inside(&figure.moved(0)));
}
";

/// The files of a house in which the statement has all the evidence it needs.
const HOUSE: [(&str, &str); 13] = [
    ("book/statements/bezier.toml", CATALOGUE),
    ("book/src/SUMMARY.md", "- [Shape](bezier/shape.md)\n"),
    ("book/src/bezier/shape.md", PAGE),
    ("snapshots/bezier/bezier-convex-hull.snap.svg", "<svg/>"),
    ("tests/property/main.rs", "mod bezier;\n"),
    ("tests/property/bezier/mod.rs", "mod shape;\n"),
    ("tests/property/bezier/shape.rs", PROPTEST),
    (
        "tests/exact/main.rs",
        "#[path = \"../support/mod.rs\"]\nmod support;\nmod bezier;\n",
    ),
    ("tests/exact/bezier/mod.rs", "mod shape;\n"),
    ("tests/exact/bezier/shape.rs", LAW_TEST),
    ("tests/support/mod.rs", ""),
    ("tests/figures/main.rs", "mod bezier {\n    mod shape;\n}\n"),
    ("tests/figures/bezier/shape.rs", FIGURE_TEST),
];

/// The house with some of its files written differently.
fn house(changes: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (file, text) in HOUSE.iter().chain(changes) {
        let path = folder.path().join(file);
        fs::create_dir_all(path.parent().expect("a file has a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    folder
}

/// Every exercise passes.
fn all_sound(asked: &[&Exercise]) -> Vec<Result<(), String>> {
    vec![Ok(()); asked.len()]
}

fn missing(root: &Path) -> Vec<&'static str> {
    let coverage = Coverage::find(root, &[], &[], all_sound).expect("the house is sound");
    assert_eq!(coverage.entries.len(), 1);
    assert_eq!(coverage.entries[0].id, ID);
    coverage.entries[0].missing.clone()
}

#[test]
fn all_kinds_of_evidence_are_found_with_their_lines() {
    let house = house(&[]);
    let coverage = Coverage::find(house.path(), &[], &[], all_sound).expect("the house is sound");
    let entry = &coverage.entries[0];
    let found: Vec<(String, Vec<String>)> = entry
        .evidence
        .iter()
        .map(|(need, places)| (need.to_string(), places.clone()))
        .collect();
    let expected = [
        ("example", vec!["book/src/bezier/shape.md:6"]),
        ("property", vec!["tests/property/bezier/shape.rs:3"]),
        ("exact", vec!["tests/exact/bezier/shape.rs:2"]),
        ("figure", vec!["tests/figures/bezier/shape.rs:2"]),
        ("interactive", vec![]),
        ("exercise", vec![]),
        ("proof", vec!["book/src/bezier/shape.md:16"]),
        ("compile_fail", vec!["book/src/bezier/shape.md:10"]),
    ];
    let expected = expected.map(|(need, places)| {
        let places: Vec<String> = places.into_iter().map(str::to_owned).collect();
        (need.to_owned(), places)
    });
    assert_eq!(found, expected);
    assert!(coverage.is_complete(), "{coverage}");
}

/// What is missing when one file says something else.
#[track_caller]
fn assert_missing(file: &str, from: &str, to: &str, expected: &[&str]) {
    let (_, text) = HOUSE
        .iter()
        .find(|(name, _)| *name == file)
        .expect("a file of the house");
    assert!(text.contains(from), "`{from}` is not in {file}");
    let house = house(&[(file, &text.replace(from, to))]);
    assert_eq!(
        missing(house.path()),
        expected,
        "{file}: `{from}` replaced by `{to}`"
    );
}

#[test]
fn a_block_counts_only_if_it_runs_and_asserts() {
    let page = "book/src/bezier/shape.md";
    for tag in ["rust,ignore", "rust,no_run", "rust,should_panic", "text"] {
        assert_missing(
            page,
            "```rust\nassert",
            &format!("```{tag}\nassert"),
            &["example"],
        );
    }
    assert_missing(page, "assert!(1 < 2);", "let _ = 1 < 2;", &["example"]);
    assert_missing(page, "assert!(1 < 2);", "// assert!(1 < 2);", &["example"]);
    assert_missing(page, ",E0369", "", &["compile_fail"]);
    assert_missing(page, "# assert_eq!(1, 1);", "", &["errata"]);
}

#[test]
fn a_statement_and_its_proof_need_words() {
    let page = "book/src/bezier/shape.md";
    assert_missing(
        page,
        "Each point is a convex combination.",
        "{{#ref bezier-convex-hull}}",
        &["proof"],
    );
    let (_, text) = HOUSE[2];
    let wordless = "# Shape\n\n{{#statement bezier-convex-hull}}\n{{#proof}}\nClear.\n{{/proof}}\n{{/statement}}\n";
    assert_ne!(text, wordless);
    let house = house(&[(page, wordless)]);
    let missing = missing(house.path());
    assert_eq!(
        missing,
        ["statement", "example", "figure", "compile_fail", "errata"]
    );
}

#[test]
fn a_law_test_counts_only_if_it_runs_calls_its_law_and_rejects_a_mutant() {
    let exact = "tests/exact/bezier/shape.rs";
    assert_missing(exact, "fn convex_hull", "fn convexity", &["exact"]);
    assert_missing(exact, "laws::convex_hull", "laws::chord_bound", &["exact"]);
    assert_missing(
        exact,
        "laws::convex_hull",
        "bspline::laws::convex_hull",
        &["exact"],
    );
    assert_missing(exact, "rejects(", "report(", &["exact"]);
    assert_missing(exact, "rejects(", "// rejects(", &["exact"]);
    assert_missing(exact, "#[test]", "#[test]\n#[ignore]", &["exact"]);
    assert_missing(exact, "#[test]", "", &["exact"]);
    assert_missing("tests/exact/bezier/mod.rs", "mod shape;", "", &["exact"]);
    assert_missing("tests/exact/main.rs", "mod bezier;", "", &["exact"]);
    let property = "tests/property/bezier/shape.rs";
    assert_missing(property, "#[test]", "", &["property"]);
    assert_missing(property, "#[test]", "#[test]\n#[ignore]", &["property"]);
    assert_missing(property, "rejects(", "report(", &["property"]);
}

#[test]
fn a_directive_names_tests_and_laws_that_are_not_the_ids_own() {
    let page = "book/src/bezier/shape.md";
    let opening = "{{#statement bezier-convex-hull}}";
    let named = |options: &str| format!("{{{{#statement bezier-convex-hull {options}}}}}");
    assert_missing(page, opening, &named("exact=hull"), &["exact"]);
    assert_missing(page, opening, &named("exact=convex_hull,hull"), &["exact"]);
    let other = LAW_TEST.replace("convex_hull", "hull");
    let changes = [
        (page, &*PAGE.replace(opening, &named("exact=hull"))),
        ("tests/exact/bezier/shape.rs", &*other),
    ];
    assert_eq!(missing(house(&changes).path()), [""; 0]);
}

#[test]
fn a_figure_counts_only_if_it_is_shown_reviewed_and_refused_when_wrong() {
    let page = "book/src/bezier/shape.md";
    let test = "tests/figures/bezier/shape.rs";
    assert_missing(page, "{{#figure bezier-convex-hull}}", "", &["figure"]);
    assert_missing(
        page,
        "{{#figure bezier-convex-hull}}",
        "{{#figure bezier-blossom}}",
        &["figure"],
    );
    assert_missing(test, "fn convex_hull", "fn hull", &["figure"]);
    assert_missing(test, "figures::convex_hull", "figures::hull", &["figure"]);
    assert_missing(test, "rejects(", "report(", &["figure"]);
    let house = house(&[]);
    fs::remove_file(
        house
            .path()
            .join("snapshots/bezier/bezier-convex-hull.snap.svg"),
    )
    .expect("it is there");
    assert_eq!(missing(house.path()), ["figure"]);
}

#[test]
fn a_chapter_begins_with_its_first_statement() {
    let page = "book/src/bezier/shape.md";
    let house = house(&[(page, "# Shape\n")]);
    let begun = Coverage::find(house.path(), &[], &[], all_sound).expect("the house is sound");
    assert!(begun.entries.is_empty());
    let asked = Coverage::find(house.path(), &["bezier".into()], &[], all_sound)
        .expect("the house is sound");
    let missing = &asked.entries[0].missing;
    assert_eq!(
        missing,
        &[
            "statement",
            "example",
            "figure",
            "proof",
            "compile_fail",
            "errata"
        ]
    );
}

#[test]
fn a_figure_needs_no_words_besides_its_own() {
    let page = "book/src/bezier/shape.md";
    let catalogue = CATALOGUE
        .replace("theorem", "figure")
        .replace("errata = true", "");
    let catalogue = ("book/statements/bezier.toml", &*catalogue);
    let opening = "{{#statement bezier-convex-hull}}\n";
    let shown = format!("{opening}{{{{#figure bezier-convex-hull}}}}\n{{{{/statement}}}}\n");
    let shown = missing(house(&[catalogue, (page, &shown)]).path());
    assert!(!shown.contains(&"statement"), "{shown:?}");
    let bare = format!("{opening}{{{{/statement}}}}\n");
    let bare = missing(house(&[catalogue, (page, &bare)]).path());
    assert!(bare.contains(&"statement"), "{bare:?}");
}

const TASK: &str = "+++
title = \"Inside\"
kind = \"implement\"
statements = [\"bezier-convex-hull\"]
difficulty = 1
minutes = 5
order = 10
+++
Write it.

## Hint
One.

## Hint
Two.

## Hint
`three`
";

/// The files of an exercise that trains the statement.
fn exercise_files() -> Vec<(&'static str, &'static str)> {
    let mutant = "//! misconception: one is two\npub fn f() -> u8 { 2 }\n";
    vec![
        ("book/exercises/bezier/inside/exercise.md", TASK),
        (
            "book/exercises/bezier/inside/answer.rs",
            "pub fn f() -> u8 {\n    //@ solution\n    1\n    //@ starter\n    //| 0\n    //@ end\n}\n",
        ),
        (
            "book/exercises/bezier/inside/tests.rs",
            "fn probes() -> Vec<String> { cagd::probes![answer::f()] }\n#[test]\nfn one() { assert_eq!(answer::f(), 1) }\n",
        ),
        ("book/exercises/bezier/inside/mutants/a.rs", mutant),
        ("book/exercises/bezier/inside/mutants/b.rs", mutant),
        ("book/exercises/bezier/inside/mutants/c.rs", mutant),
    ]
}

#[test]
fn an_exercise_counts_if_it_is_sound() {
    let catalogue = CATALOGUE.replace("\"proof\",", "\"proof\", \"exercise\",");
    let mut files = exercise_files();
    files.push(("book/statements/bezier.toml", &catalogue));
    let needs_one = house(&[("book/statements/bezier.toml", &catalogue)]);
    assert_eq!(missing(needs_one.path()), ["exercise"]);

    let trained = house(&files);
    assert_eq!(missing(trained.path()), [""; 0]);
    let refuse = |asked: &[&Exercise]| vec![Err("a mutant survives".to_owned()); asked.len()];
    let coverage = Coverage::find(trained.path(), &[], &[], refuse).expect("the house is sound");
    assert_eq!(coverage.entries[0].missing, ["exercise"]);
    assert!(coverage.to_string().contains("a mutant survives"));
}

#[test]
fn an_explanation_alone_trains_nobody() {
    let catalogue = CATALOGUE.replace("\"proof\",", "\"proof\", \"exercise\",");
    let explain = TASK.replace("implement", "explain")
        + "\n## Model answer\nBecause.\n\n## Checklist\n- [ ] because\n";
    let explained = house(&[
        ("book/statements/bezier.toml", &catalogue),
        ("book/exercises/bezier/inside/exercise.md", &explain),
    ]);
    assert_eq!(missing(explained.path()), ["exercise"]);
}

#[test]
fn a_figure_that_the_reader_can_change_is_interactive_as_well() {
    // A figure of the library, since only those can be changed.
    let page = PAGE.replace(
        "{{#figure bezier-convex-hull}}",
        "{{#figure bezier-figure-convex-hull}}",
    );
    let test = FIGURE_TEST.replace("convex_hull()", "figure_convex_hull()");
    let catalogue = CATALOGUE.replace("\"figure\",", "\"figure\", \"interactive\",");
    let house = house(&[
        ("book/src/bezier/shape.md", &page),
        ("book/statements/bezier.toml", &catalogue),
        ("tests/figures/bezier/shape.rs", &test),
        (
            "snapshots/bezier/bezier-figure-convex-hull.snap.svg",
            "<svg/>",
        ),
    ]);
    assert_eq!(missing(house.path()), [""; 0]);
}
