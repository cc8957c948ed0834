//! The invariants of the house, each kept by a test.
//!
//! | file | keeps |
//! |---|---|
//! | `layers.rs` | the reading order is the import order, and the mathematics knows nothing but mathematics |
//! | `dependencies.rs` | heavy crates stay out of the core, and every crate builds with the stated Rust |
//! | `shape.rs` | few entries at the top level, short files, no lint silenced without a reason |
//! | `evidence.rs` | the evidence for a statement is found where it is, and only there |
//! | `pages.rs` | one sentence a line, and every block of the book runs |

mod dependencies;
mod evidence;
mod layers;
mod pages;
mod paths;
mod shape;

use std::path::{Path, PathBuf};

/// The folder of the package.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A text file of the package; `file` is relative to [`root`].
#[track_caller]
fn read(file: impl AsRef<Path>) -> String {
    let file = file.as_ref();
    std::fs::read_to_string(root().join(file))
        .unwrap_or_else(|error| panic!("{} cannot be read: {error}", file.display()))
}

/// All files with this extension below `folder`, relative to [`root`], sorted.
fn files_below(folder: &str, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![root().join(folder)];
    while let Some(folder) = open.pop() {
        let Ok(entries) = std::fs::read_dir(&folder) else {
            continue;
        };
        for entry in entries {
            let path = entry.expect("a folder can be listed").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                let relative = path.strip_prefix(root()).expect("it is below the root");
                found.push(relative.to_path_buf());
            }
        }
    }
    found.sort();
    found
}

/// Fails with all violations, one a line.
#[track_caller]
fn assert_none(violations: &[String], advice: &str) {
    assert!(
        violations.is_empty(),
        "\n{}\n{advice}\n",
        violations.join("\n")
    );
}
