//! A folder of submissions is checked: `DIR/<student>/<chapter>/<name>.rs`.
//!
//! ```text
//! DIR ─▶ Submissions ─▶ checks (in parallel) ─▶ Grades ─▶ table, CSV, JSON, JUnit
//!            └─▶ Remark: what belongs to nobody's grade
//! ```
//!
//! | module | is |
//! |---|---|
//! | [`submissions`] | what was handed in, read with care |
//! | [`assignment`] | the exercises that are graded, with their hidden tests |
//! | [`session`] | all submissions, on all cores |
//! | [`grades`] | what `grade --json` prints |
//! | [`text`] | the table for people |
//! | [`spreadsheet`] | the table as CSV |
//! | [`junit`] | the grades for a build server |
//!
//! Nothing that one student hands in changes the grade of another.
//! Whatever is wrong with a file is told in its own cell, or as a remark.

pub mod assignment;
pub mod grades;
pub mod junit;
pub mod session;
pub mod spreadsheet;
pub mod submissions;
pub mod text;

use std::path::PathBuf;

use thiserror::Error;

use super::checking::CheckingError;
use super::sandbox::Isolation;

pub use assignment::Assignment;
pub use grades::{Grade, Grades, Status};
pub use session::grade;
pub use submissions::Submissions;

/// Grading could not begin.
#[derive(Debug, Error)]
pub enum GradeError {
    /// The folder of the submissions cannot be read.
    #[error(
        "the submissions in `{}` cannot be read ({reason})\n\
         next step: name the folder that holds a folder for each student",
        folder.display()
    )]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the operating system says.
        reason: String,
    },
    /// No student has a folder.
    #[error(
        "there is no student in `{}`\n\
         next step: name the folder that holds the submissions as `<student>/<chapter>/<name>.rs`",
        .0.display()
    )]
    NoStudent(PathBuf),
    /// Not one file is an answer to an exercise that is graded.
    #[error(
        "nothing in `{}` is an answer to an exercise that is graded{}\n\
         next step: lay the submissions out as `<student>/<chapter>/<name>.rs`; exercises of a pack need `--pack`",
        folder.display(),
        .first.as_ref().map(|remark| format!("; `{}`: {}", remark.file, remark.found)).unwrap_or_default()
    )]
    NothingHandedIn {
        /// The folder.
        folder: PathBuf,
        /// The first thing that was found instead.
        first: Option<submissions::Remark>,
    },
    /// The hidden tests reject the solution that the exercise brings.
    #[error(
        "the hidden tests in `{}` do not accept the solution of `{exercise}`: {found}\n\
         next step: mend them; a right answer would fail as well",
        file.display()
    )]
    Hidden {
        /// The exercise.
        exercise: String,
        /// The file of the hidden tests.
        file: PathBuf,
        /// What is wrong.
        found: String,
    },
    /// The system does not keep submissions apart well enough.
    #[error(
        "submissions are programs of other people, and this system does not keep them apart.\n{}\n\
         next step: install bubblewrap (`bwrap`) on Linux, or accept the risk with `--unsafe`",
        .0.describe()
    )]
    NotIsolated(Isolation),
    /// The checks cannot run at all.
    #[error(transparent)]
    Checking(#[from] CheckingError),
    /// A file for the grades cannot be written.
    #[error("`{}` cannot be written ({reason})\nnext step: name a file in a folder that is yours", file.display())]
    Output {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        reason: String,
    },
}
