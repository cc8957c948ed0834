//! `new exercise`: a folder that follows the schema, with a to-do for everything that its author has to say.
//!
//! What is scaffolded is a small sound exercise of its kind, so that each part can be replaced while the others still
//! work; `verify` lists the lines with `TODO`.

mod templates;

use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::book::catalogue::{CHAPTERS, Catalogue};
use crate::book::exercise::{ExerciseKind, ExerciseName, Exercises, collection};
use templates::{Template, template};

/// An exercise cannot be scaffolded.
#[derive(Debug, thiserror::Error)]
pub enum ScaffoldError {
    /// There is already something of this name.
    #[error("`{}` is already there\nnext step: choose another name", .0.display())]
    Exists(PathBuf),
    /// The chapter is unknown.
    #[error("`{0}` is no chapter\nnext step: choose one of {list}", list = CHAPTERS.join(", "))]
    NoChapter(String),
    /// The chapter has no statement that an exercise could train.
    #[error(
        "the chapter `{0}` lists no statement\nnext step: list what the exercise trains in `book/statements/{0}.toml`"
    )]
    NoStatement(String),
    /// A file cannot be written.
    #[error("`{}` cannot be written ({reason})\nnext step: see that the folder exists and is yours", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        reason: String,
    },
}

/// Writes a new exercise into the book, or into a pack, and returns its folder.
///
/// # Errors
///
/// The folder is already there, or the chapter is not, or the files cannot be written.
pub fn exercise(
    root: &Path,
    pack: Option<&Path>,
    name: &ExerciseName,
    kind: ExerciseKind,
    catalogue: &Catalogue,
    exercises: &Exercises,
) -> Result<PathBuf, ScaffoldError> {
    let chapter = name.chapter();
    if !CHAPTERS.contains(&chapter) {
        return Err(ScaffoldError::NoChapter(chapter.to_owned()));
    }
    let statement = catalogue
        .chapter(chapter)
        .next()
        .ok_or_else(|| ScaffoldError::NoStatement(chapter.to_owned()))?;
    let last = exercises
        .iter()
        .filter(|exercise| exercise.name.chapter() == chapter)
        .map(|exercise| exercise.front.order)
        .max();
    let folder = pack
        .map_or_else(|| root.join(collection::FOLDER), Path::to_path_buf)
        .join(chapter)
        .join(name.name());
    if folder.exists() || exercises.get(name).is_some() {
        return Err(ScaffoldError::Exists(folder));
    }
    let task = templates::task(kind, &statement.id, last.unwrap_or(0) + 10);
    write(&folder.join("exercise.md"), &task)?;
    if let Some(Template {
        answer,
        tests,
        mutants,
    }) = template(kind)
    {
        write(&folder.join("answer.rs"), answer)?;
        write(&folder.join("tests.rs"), tests)?;
        for (mutant, text) in mutants {
            write(&folder.join("mutants").join(format!("{mutant}.rs")), text)?;
        }
    }
    Ok(folder)
}

fn write(file: &Path, text: &str) -> Result<(), ScaffoldError> {
    let create = || -> io::Result<()> {
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(file, text)
    };
    create().map_err(|e| ScaffoldError::File {
        file: file.to_path_buf(),
        reason: e.to_string(),
    })
}
