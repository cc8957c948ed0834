//! What a reader does with exercises, under the same rules in the terminal and on the page.
//!
//! | module | is |
//! |---|---|
//! | [`desk`] | what all of it works with: exercises, answers, progress |
//! | [`begin`] | the file of the answer is made, with the starter or with fresh numbers |
//! | [`save`] | an answer that was written on the page, and what if the file has changed meanwhile |
//! | [`check`] | an answer is judged, and how it ended is remembered |
//! | [`hint`] | one more hint each time |
//! | [`solution`] | the solution, once the exercise is solved or when it is asked for twice |
//! | [`standing`] | all that the page has to know of it |
//! | [`reset`] | an exercise is begun anew, and the answer is kept |
//! | [`next`] | what to do next |
//!
//! Nothing here prints; `commands` and `server` say what happened, each in its way.

pub mod begin;
pub mod check;
pub mod desk;
mod error;
pub mod hint;
pub mod next;
pub mod reset;
pub mod save;
pub mod solution;
pub mod standing;

pub use desk::{Desk, shown, typed};
pub use error::PracticeError;
