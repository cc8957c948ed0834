//! Stock mdBook, which calls the preprocessor as a command, builds the same pages byte for byte.

use std::path::Path;
use std::process::Command;

use mdbook_driver::MDBook;

use crate::fixture::{files_below, the_book};

/// Asserts that two sites have the same files with the same bytes.
#[track_caller]
fn same(site: &Path) {
    let files = files_below(the_book(), "");
    assert_eq!(files_below(site, ""), files);
    for file in files {
        let ours = std::fs::read(the_book().join(&file)).expect("the file is read");
        let theirs = std::fs::read(site.join(&file)).expect("the file is read");
        assert!(ours == theirs, "{} differs", file.display());
    }
}

/// mdBook runs the command of `book.toml`; here the command is the binary that was just built.
#[test]
fn the_command_gives_the_same_site_as_the_library() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("book");
    let mut book = MDBook::load(&root).expect("mdBook loads the book");
    let mut config = book.config.clone();
    let command = format!("'{}' preprocessor", env!("CARGO_BIN_EXE_workbook"));
    config
        .set("preprocessor.workbook.command", command)
        .expect("the command is set");
    config.build.build_dir = folder.path().join("site");
    book = MDBook::load_with_config(&root, config).expect("mdBook loads the book");
    book.build().expect("mdBook builds the book");
    same(&folder.path().join("site"));
}

/// The program `mdbook` builds the same pages, where it is installed.
#[test]
fn the_program_mdbook_gives_the_same_pages() {
    if Command::new("mdbook").arg("--version").output().is_err() {
        eprintln!("SKIPPED: the program `mdbook` is not installed (`cargo install mdbook@0.5.4`)");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let site = folder.path().join("site");
    let output = Command::new("mdbook")
        .arg("build")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("book"))
        .arg("--dest-dir")
        .arg(&site)
        .output()
        .expect("mdbook runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    // The program comes with other versions of the crates behind its search, so the index has another name.
    let masked = |folder: &Path, page: &Path| {
        let page = std::fs::read_to_string(folder.join(page)).expect("the page is read");
        let mut parts = page.split("searchindex-");
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| {
            text + part.trim_start_matches(|letter: char| letter.is_ascii_hexdigit())
        })
    };
    let pages: Vec<_> = files_below(the_book(), "html");
    assert_eq!(files_below(&site, "html"), pages);
    for page in pages {
        let same = masked(&site, &page) == masked(the_book(), &page);
        assert!(same, "{} differs", page.display());
    }
}

/// The command says for which renderer it is made.
#[test]
fn the_command_supports_html_alone() {
    let supports = |renderer: &str| {
        Command::new(env!("CARGO_BIN_EXE_workbook"))
            .args(["preprocessor", "supports", renderer])
            .status()
            .expect("the command runs")
            .success()
    };
    assert!(supports("html"));
    assert!(!supports("epub"));
}
