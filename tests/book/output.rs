//! A build appears at once or not at all.

use crate::fixture::{Fixture, files_below};

/// The names in the folder of the fixture.
fn names(folder: &std::path::Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("the folder is read")
        .map(|entry| {
            entry
                .expect("the entry is read")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}

#[test]
fn a_failing_build_leaves_the_last_good_one_as_it_was() {
    let good = Fixture::new("# Good\n");
    let bad = Fixture::new("# Bad\n\n{{#ref nothing}}\n")
        .with_file("site/index.html", "the last good one");
    let before = names(bad.root());
    let (folder, report) = bad.build_into("site");
    assert!(report.is_err());
    assert_eq!(names(folder.path()), before);
    let index = std::fs::read_to_string(folder.path().join("site/index.html"));
    assert_eq!(index.expect("it is still there"), "the last good one");
    assert!(good.build_into("site").1.is_ok());
}

#[test]
fn a_build_replaces_the_last_one_and_leaves_nothing_beside_it() {
    let fixture = Fixture::new("# P\n").with_file("site/stale.html", "stale");
    let before = names(fixture.root());
    let (folder, report) = fixture.build_into("site");
    let report = report.expect("the book is built");
    assert_eq!(names(folder.path()), before);
    let pages = files_below(&folder.path().join("site"), "html");
    assert!(!pages.iter().any(|page| page.ends_with("stale.html")));
    assert_eq!(report.pages, pages.len());
}

#[test]
fn a_folder_that_cannot_be_written_is_a_typed_error() {
    let (_folder, report) = Fixture::new("# P\n").build_into("book/book.toml/site");
    let errors = report.expect_err("a file is no folder").to_string();
    assert!(errors.contains("cannot be written here"), "{errors}");
    assert!(errors.contains("--out"), "{errors}");
}
