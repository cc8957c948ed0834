//! Building the site: into a folder of its own first, which then takes the place of the old one.

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use mdbook_driver::MDBook;

use super::error::{BookError, BookErrors, Problem};
use super::preprocessor::Workbook;

/// What a build did.
#[derive(Debug, Clone)]
pub struct BuildReport {
    /// The folder that holds the site.
    pub out: PathBuf,
    /// The number of pages that were written or generated, source pages included.
    pub pages: usize,
    /// The time it took.
    pub duration: Duration,
}

/// Builds the book of the package at `root` into the folder `out`.
///
/// The site appears at once when everything went well; otherwise what was at `out` stays as it was.
///
/// # Errors
///
/// Everything that is wrong with the book, each with file and line; or that `out` cannot be written.
pub fn build(root: &Path, out: &Path) -> Result<BuildReport, BookErrors> {
    build_with(root, out, Workbook::default(), &[])
}

/// Builds a book with the given preprocessor, which has the figures and computed texts; see [`build`].
///
/// The files `more` are put beside the pages.
///
/// # Errors
///
/// As for [`build`].
pub fn build_with(
    root: &Path,
    out: &Path,
    workbook: Workbook,
    more: &[(String, Vec<u8>)],
) -> Result<BuildReport, BookErrors> {
    let start = Instant::now();
    let root = std::path::absolute(root).map_err(|e| unwritable(out, &e))?;
    let out = std::path::absolute(out).map_err(|e| unwritable(out, &e))?;
    let mut book = MDBook::load(root.join("book")).map_err(|e| mdbook_error(&root, &e))?;
    let parent = out.parent().unwrap_or(&out);
    std::fs::create_dir_all(parent).map_err(|e| unwritable(&out, &e))?;
    let fresh = tempfile::Builder::new()
        .prefix(".book-")
        .tempdir_in(parent)
        .map_err(|e| unwritable(&out, &e))?;
    let site = fresh.path().join("site");
    book.config.build.build_dir = site.clone();
    book.with_preprocessor(workbook);
    book.build().map_err(|e| mdbook_error(&root, &e))?;
    for (name, bytes) in more {
        std::fs::write(site.join(name), bytes).map_err(|e| unwritable(&out, &e))?;
    }
    swap(&site, &out, fresh.path()).map_err(|e| unwritable(&out, &e))?;
    Ok(BuildReport {
        pages: count_pages(&out),
        out,
        duration: start.elapsed(),
    })
}

/// Puts the folder `new` in the place of `out`; what was there goes to `aside`, which is removed afterwards.
fn swap(new: &Path, out: &Path, aside: &Path) -> io::Result<()> {
    if out.exists() {
        let old = aside.join("old");
        std::fs::rename(out, &old)?;
        if let Err(e) = std::fs::rename(new, out) {
            std::fs::rename(&old, out)?;
            return Err(e);
        }
        return Ok(());
    }
    std::fs::rename(new, out)
}

/// The number of pages below a folder.
fn count_pages(folder: &Path) -> usize {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return 0;
    };
    entries
        .flatten()
        .map(|entry| {
            let path = entry.path();
            if path.is_dir() {
                count_pages(&path)
            } else {
                usize::from(path.extension().is_some_and(|e| e == "html"))
            }
        })
        .sum()
}

/// The error of an output folder that cannot be written.
fn unwritable(out: &Path, error: &io::Error) -> BookErrors {
    let reason = error.to_string();
    BookError::new(out, 1, Problem::Output { reason }).into()
}

/// What mdBook reports: our own errors as they are, anything else in its words.
fn mdbook_error(root: &Path, error: &mdbook_driver::errors::Error) -> BookErrors {
    if let Some(errors) = error.downcast_ref::<BookErrors>() {
        return errors.clone();
    }
    let reason: Vec<String> = error.chain().map(ToString::to_string).collect();
    let reason = reason.join(": ");
    let (file, line) = place_of(root, &reason);
    BookError::new(file, line, Problem::MdBook { reason }).into()
}

/// The line of the table of contents that lists a file which mdBook misses, else `book.toml`.
fn place_of(root: &Path, reason: &str) -> (&'static str, usize) {
    let summary = "book/src/SUMMARY.md";
    let text = std::fs::read_to_string(root.join(summary)).unwrap_or_default();
    let listed = text.lines().position(|line| {
        let file = line
            .split_once("](")
            .and_then(|(_, rest)| rest.split_once(')'));
        file.is_some_and(|(file, _)| {
            !file.is_empty() && reason.contains(file.trim_start_matches("./"))
        })
    });
    match listed {
        Some(line) => (summary, line + 1),
        None if reason.contains("SUMMARY") => (summary, 1),
        None => ("book/book.toml", 1),
    }
}
