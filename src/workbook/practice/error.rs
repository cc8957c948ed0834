//! Why something that a reader wants cannot be done.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::desk::typed;
use crate::book::error::{BookError, BookErrors};
use crate::book::exercise::{Exercise, ExerciseName};
use crate::workbook::answers::AnswersError;
use crate::workbook::checking::CheckingError;
use crate::workbook::house::NoHouse;
use crate::workbook::progress::ProgressError;

/// It could not be done; nothing was lost.
#[derive(Debug, Error)]
pub enum PracticeError {
    /// There is no workbook here.
    #[error(transparent)]
    House(#[from] NoHouse),
    /// The book or an exercise has errors.
    #[error("{0}")]
    Book(#[from] BookErrors),
    /// An answer cannot be checked at all.
    #[error(transparent)]
    Checking(#[from] CheckingError),
    /// The folder of answers cannot be used.
    #[error(transparent)]
    Answers(#[from] AnswersError),
    /// The progress cannot be read or kept.
    #[error(transparent)]
    Progress(#[from] ProgressError),
    /// No exercise has this name.
    #[error(
        "there is no exercise `{name}`{}\nnext step: `cargo run -- list` shows all of them",
        .similar.as_ref().map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
    )]
    UnknownExercise {
        /// What was asked for.
        name: String,
        /// The most similar name.
        similar: Option<String>,
    },
    /// An exercise of this name was begun, and the book has it no more.
    #[error(
        "the book has no exercise `{name}` any more; your answer is kept at `{}`\n\
         next step: `cargo run -- list` shows what there is; if it belongs to a pack, name the pack with `--pack`",
        file.display()
    )]
    LeftTheBook {
        /// What was asked for.
        name: String,
        /// The answer.
        file: PathBuf,
    },
    /// The exercise does not follow the schema; what is wrong is told beside this, all at once.
    #[error(
        "the exercise `{name}` has mistakes of its own\n\
         next step: mend them, or take another exercise: `cargo run -- list`"
    )]
    HasMistakes {
        /// The exercise.
        name: ExerciseName,
        /// What is wrong with it.
        mistakes: Vec<BookError>,
    },
    /// No exercise was named, and none was begun.
    #[error("no exercise was begun yet\nnext step: `cargo run -- next` names one to begin with")]
    NothingBegun,
    /// The exercise was not begun.
    #[error("`{name}` was not begun yet\nnext step: `cargo run -- {start}`")]
    NotBegun {
        /// The exercise.
        name: ExerciseName,
        /// The command that begins it.
        start: String,
    },
    /// The arguments do not fit the exercise.
    #[error("{0}")]
    Unfit(String),
    /// The answer cannot be written.
    #[error("cannot write the answer: {0}")]
    Output(#[from] io::Error),
}

impl PracticeError {
    /// This exercise was not begun.
    pub(crate) fn not_begun(exercise: &Exercise) -> Self {
        let name = exercise.name.clone();
        let start = typed(&format!("start {name}"), exercise);
        Self::NotBegun { name, start }
    }
}
