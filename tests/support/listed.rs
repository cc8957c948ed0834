//! The book counts a test as evidence only if the binary that should hold it does.

use std::path::Path;
use std::process::Command;

use cagd::book::evidence::tests_of_binary;

/// What the book finds in the sources is what this binary lists.
///
/// A `cfg`, a `mod` that was forgotten or a test inside an unknown macro would make them differ.
#[test]
fn the_book_counts_only_listed_tests() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let counted = tests_of_binary(root, env!("CARGO_CRATE_NAME")).expect("the sources are read");
    assert!(!counted.is_empty(), "the book finds no test at all");

    let binary = std::env::current_exe().expect("a test knows its binary");
    let output = Command::new(binary)
        .arg("--list")
        .output()
        .expect("the binary runs");
    let listed = String::from_utf8(output.stdout).expect("test names are UTF-8");
    let listed: Vec<&str> = listed
        .lines()
        .filter_map(|line| line.strip_suffix(": test"))
        .collect();

    let unlisted: Vec<String> = counted
        .iter()
        .filter(|test| !listed.contains(&test.path.as_str()))
        .map(|test| format!("{} ({})", test.path, test.place))
        .collect();
    assert!(
        unlisted.is_empty(),
        "the book counts tests that this binary does not run: {unlisted:#?}"
    );
    let overlooked: Vec<&&str> = listed
        .iter()
        .filter(|name| !counted.iter().any(|test| test.path == **name))
        .collect();
    assert!(
        overlooked.is_empty(),
        "the book overlooks tests that this binary runs: {overlooked:#?}"
    );
}
