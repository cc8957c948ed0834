//! Checking an answer: compile it, run the tests, tell the verdict.
//!
//! ```text
//! answer.rs ─▶ compile ─▶ run (limits) ─▶ Verdict ─▶ feedback
//! ```
//!
//! | module | is |
//! |---|---|
//! | [`library`] | the mathematics, compiled once for all answers |
//! | [`compile`] | an answer and the tests of its exercise become a program |
//! | [`trial`] | the program runs, and tells its results over a channel of its own |
//! | [`verdict`] | what `check --json` prints, the page shows and `grade` counts |
//! | [`example`] | a Rust block of a page is compiled and run |
//! | [`runner`] | how compiler and program are run |
//! | [`mod@check`] | all of it for one answer |
//! | [`misconception`] | which mutant an answer behaves like |

pub mod check;
pub mod compile;
pub mod example;
pub mod library;
pub mod misconception;
pub mod runner;
pub mod trial;
pub mod verdict;

use std::path::PathBuf;

use thiserror::Error;

pub use check::{Answer, Checker};
pub use library::Library;
pub use runner::Runner;
pub use verdict::{Outcome, Verdict};

/// A check could not run; it says nothing about the answer.
#[derive(Debug, Error)]
pub enum CheckingError {
    /// A program that is needed does not start.
    #[error("`{program}` cannot be started ({reason})\nnext step: {remedy}")]
    Program {
        /// The program.
        program: String,
        /// What the operating system says.
        reason: String,
        /// What to do.
        remedy: String,
    },
    /// The library does not compile.
    #[error(
        "the library does not compile, so no answer can be checked:\n{0}\nnext step: mend `src/`, or undo what changed there"
    )]
    Library(String),
    /// The tests of an exercise do not compile with its own solution.
    #[error(
        "the tests of `{exercise}` do not compile:\n{diagnostics}\nnext step: mend `tests.rs` of the exercise"
    )]
    Tests {
        /// The exercise.
        exercise: String,
        /// What the compiler says.
        diagnostics: String,
    },
    /// A file cannot be read or written.
    #[error("`{}` cannot be read or written ({reason})\nnext step: see that the folder exists and is yours", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        reason: String,
    },
    /// The operating system does not have what running an answer needs.
    #[error("answers cannot be run on this system: {0}")]
    Unsupported(String),
    /// Nobody waits for the result any more.
    #[error("the check was stopped before its end")]
    Stopped,
}

impl CheckingError {
    pub(crate) fn file(path: impl Into<PathBuf>, error: &std::io::Error) -> Self {
        Self::File {
            path: path.into(),
            reason: error.to_string(),
        }
    }
}
