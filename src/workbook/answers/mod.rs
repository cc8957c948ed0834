//! The reader's own answers: a small Cargo package below `answers/`, made on first use.
//!
//! ```text
//! answers/
//!   Cargo.toml, Cargo.lock      made by the workbook, so that an editor completes
//!   <chapter>/<name>.rs         the reader's; never overwritten
//!   <chapter>/<name>.md         the answer to an explanation
//!   backups/<chapter>/          what `reset` has put away, numbered
//!   pictures/<chapter>/         what was wrong at the last check, as SVG
//!   progress.json               how far the reader is
//! ```

mod package;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::book::exercise::{Exercise, ExerciseName};
use crate::workbook::durable;

/// The folder of the answers, relative to the root of the workbook.
pub const FOLDER: &str = "answers";

/// The folder of answers cannot be used.
#[derive(Debug, Error)]
pub enum AnswersError {
    /// A file cannot be read or written.
    #[error("`{}` cannot be read or written ({source})\nnext step: see that the folder exists and is yours", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// The manifest of the workbook does not say what a package of answers needs.
    #[error("`{}` cannot be used for the answers: {reason}\nnext step: undo what changed there", path.display())]
    Manifest {
        /// The manifest.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

impl AnswersError {
    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::File { path, source }
    }
}

/// A folder of answers.
#[derive(Debug, Clone)]
pub struct Answers {
    house: PathBuf,
    folder: PathBuf,
}

/// What [`Answers::begin`] did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begun {
    /// The file is new.
    New,
    /// There was an answer; it was left alone.
    AlreadyThere,
}

impl Answers {
    /// The answers in `folder`, for the workbook at `house`.
    pub fn new(house: &Path, folder: &Path) -> Self {
        Self {
            house: house.to_path_buf(),
            folder: folder.to_path_buf(),
        }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The file of the answer to an exercise, whether or not it is there.
    pub fn file(&self, exercise: &Exercise) -> PathBuf {
        let extension = if exercise.tested.is_some() {
            "rs"
        } else {
            "md"
        };
        self.folder
            .join(exercise.name.answer_file())
            .with_extension(extension)
    }

    /// The file of the answer to an exercise that may have left the book.
    pub fn any_file(&self, name: &ExerciseName) -> Option<PathBuf> {
        let file = self.folder.join(name.answer_file());
        [file.clone(), file.with_extension("md")]
            .into_iter()
            .find(|file| file.is_file())
    }

    /// The picture of what was wrong.
    pub fn picture(&self, name: &ExerciseName) -> PathBuf {
        let file = name.answer_file().with_extension("svg");
        self.folder.join("pictures").join(file)
    }

    /// Writes `text` as the answer to begin with, if there is none yet, and brings the package up to date.
    ///
    /// # Errors
    ///
    /// A file cannot be written.
    pub fn begin(&self, exercise: &Exercise, text: &str) -> Result<Begun, AnswersError> {
        let file = self.file(exercise);
        let begun = if create(&file, text.as_bytes())? {
            Begun::New
        } else {
            Begun::AlreadyThere
        };
        self.update_package()?;
        Ok(begun)
    }

    /// The reader's answer; `None` if there is no file.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    pub fn read(&self, exercise: &Exercise) -> Result<Option<String>, AnswersError> {
        let file = self.file(exercise);
        match fs::read(&file) {
            // The compiler says what is wrong with bytes that are no text; they must not be lost on the way.
            Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(AnswersError::file(&file)(e)),
        }
    }

    /// Puts `text` into the place of the answer, whole or not at all; the file may be new.
    ///
    /// Where the answer is a link, the file behind it gets the text, and the link stays.
    ///
    /// # Errors
    ///
    /// The file cannot be written; the old answer is still there then.
    pub fn write(&self, exercise: &Exercise, text: &str) -> Result<(), AnswersError> {
        let file = self.file(exercise);
        durable::replace(&file, text.as_bytes()).map_err(AnswersError::file(&file))
    }

    /// Copies the answer under the next free number and returns where the copy is; `None` if there is no answer.
    ///
    /// # Errors
    ///
    /// The answer cannot be read, or the copy not be written.
    pub fn back_up(&self, exercise: &Exercise) -> Result<Option<PathBuf>, AnswersError> {
        let file = self.file(exercise);
        let bytes = match fs::read(&file) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(AnswersError::file(&file)(e)),
        };
        let extension = file.extension().unwrap_or_default().to_string_lossy();
        let folder = self.folder.join("backups").join(exercise.name.chapter());
        for number in 1_u32.. {
            let backup = folder.join(format!("{}.{number}.{extension}", exercise.name.name()));
            // A copy that is there already is never written over.
            if create(&backup, &bytes)? {
                return Ok(Some(backup));
            }
        }
        Ok(None)
    }

    /// Puts the answer away under the next free number and returns where it is now; `None` if there is no answer.
    ///
    /// Where the answer is a link, the file behind it is left alone.
    ///
    /// # Errors
    ///
    /// The file cannot be copied or removed.
    pub fn put_away(&self, exercise: &Exercise) -> Result<Option<PathBuf>, AnswersError> {
        let backup = self.back_up(exercise)?;
        if backup.is_some() {
            let file = self.file(exercise);
            fs::remove_file(&file).map_err(AnswersError::file(&file))?;
        }
        Ok(backup)
    }

    /// Writes the manifest and the lock file if they are not as they should be.
    ///
    /// # Errors
    ///
    /// A file cannot be written, or the manifest of the workbook is not understood.
    pub fn update_package(&self) -> Result<(), AnswersError> {
        package::update(&self.house, &self.folder)
    }
}

/// Creates a file with its folders; `false` if it is there already.
fn create(file: &Path, bytes: &[u8]) -> Result<bool, AnswersError> {
    let write = || {
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder)?;
        }
        match fs::File::create_new(file) {
            Ok(mut new) => {
                new.write_all(bytes)?;
                // What is removed because it is kept here must be on the disk.
                new.sync_all()?;
                Ok(true)
            }
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => Ok(false),
            Err(e) => Err(e),
        }
    };
    write().map_err(AnswersError::file(file))
}
