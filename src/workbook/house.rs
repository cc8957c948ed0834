//! Where the sources of the workbook stand.

use std::path::{Path, PathBuf};

use thiserror::Error;

/// The folder of the workbook's sources was not found.
#[derive(Debug, Error)]
#[error(
    "`{}` is not inside a copy of the workbook (a folder with `Cargo.toml` and `book/book.toml`)\n\
     next step: change into the folder of the workbook and run the command again",
    start.display()
)]
pub struct NoHouse {
    start: PathBuf,
}

/// The root of the workbook: the folder with `Cargo.toml` and `book/book.toml`.
///
/// The current folder and the folders above it are asked first.
/// If none fits, the folder of the package that `cargo run` started is taken, so that
/// `cargo run --manifest-path …` works from anywhere.
///
/// # Errors
///
/// [`NoHouse`] if neither leads to a workbook.
pub fn find() -> Result<PathBuf, NoHouse> {
    let start = std::env::current_dir().unwrap_or_else(|_| PathBuf::from("."));
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    start
        .ancestors()
        .chain(package.as_deref())
        .find(|folder| is_house(folder))
        .map(Path::to_path_buf)
        .ok_or(NoHouse { start })
}

fn is_house(folder: &Path) -> bool {
    folder.join("Cargo.toml").is_file() && folder.join("book/book.toml").is_file()
}
