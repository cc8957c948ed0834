//! The book builds, and what is wrong with a book is told with file and line.

use std::path::Path;

/// The book of this package builds.
#[test]
fn the_book_builds() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join("site");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let report = cagd::book::build(root, &out).unwrap_or_else(|errors| panic!("{errors}"));
    println!("{report:?}");
    let index = std::fs::read_to_string(out.join("index.html")).expect("there is a first page");
    assert!(index.contains("<h1"), "the first page has a title");
}
