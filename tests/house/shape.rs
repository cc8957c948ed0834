//! Few entries at the top level, short files, no lint silenced without a reason.

use super::{assert_none, files_below, read, root};

/// What may stand at the top level, tracked or not.
const TOP_LEVEL: [&str; 14] = [
    ".ci",
    ".git",
    ".gitignore",
    "CONTRIBUTING.md",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE",
    "README.md",
    "answers",
    "benches",
    "book",
    "snapshots",
    "src",
    "tests",
];

#[test]
fn the_top_level_stays_small() {
    // Cargo marks the folders it builds into, whatever they are called.
    let is_target = |path: &std::path::Path| path.join("CACHEDIR.TAG").is_file();
    let violations: Vec<String> = std::fs::read_dir(root())
        .expect("the root can be listed")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| !is_target(path))
        .filter_map(|path| Some(path.file_name()?.to_string_lossy().into_owned()))
        .filter(|name| name != "target" && !TOP_LEVEL.contains(&name.as_str()))
        .collect();
    assert_none(&violations, "find it a place inside one of the folders");
}

/// Above this a file holds more than one concept.
const LONGEST_FILE: usize = 700;

#[test]
fn no_source_is_longer_than_a_reader_can_hold() {
    let violations: Vec<String> = ["src", "tests", "benches"]
        .iter()
        .flat_map(|folder| files_below(folder, "rs"))
        .map(|file| (read(&file).lines().count(), file))
        .filter(|(lines, _)| *lines > LONGEST_FILE)
        .map(|(lines, file)| format!("{}: {lines} lines", file.display()))
        .collect();
    assert_none(
        &violations,
        "split it: one concept a file, at most 700 lines",
    );
}

/// The lines of `source` with an `allow` or `expect` that gives no reason.
fn unreasoned(source: &str) -> Vec<usize> {
    let mut found = Vec::new();
    for opening in ["[allow(", "[expect("] {
        for (start, _) in source.match_indices(opening) {
            let is_attribute = source[..start].ends_with('#') || source[..start].ends_with("#!");
            let end = source[start..].find(")]").unwrap_or(source.len() - start);
            if is_attribute && !source[start..start + end].contains("reason") {
                found.push(source[..start].matches('\n').count() + 1);
            }
        }
    }
    found
}

#[test]
fn no_lint_is_silenced_without_a_reason() {
    let violations: Vec<String> = ["src", "tests", "benches"]
        .iter()
        .flat_map(|folder| files_below(folder, "rs"))
        // This file shows how it is done wrong, in the test below.
        .filter(|file| !file.ends_with("house/shape.rs"))
        .flat_map(|file| {
            let lines = unreasoned(&read(&file));
            lines
                .into_iter()
                .map(move |line| format!("{}:{line}", file.display()))
        })
        .collect();
    assert_none(&violations, "add `reason = \"…\"`");
}

#[test]
fn a_silenced_lint_without_a_reason_is_found() {
    assert_eq!(unreasoned("\n#[allow(dead_code)]"), [2]);
    assert_eq!(unreasoned("#![expect(clippy::x)]"), [1]);
    assert!(unreasoned("#[allow(clippy::x, reason = \"…\")]").is_empty());
}
