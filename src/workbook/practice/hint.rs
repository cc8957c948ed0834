//! One more hint each time.

use super::{Desk, PracticeError};
use crate::book::exercise::Exercise;

/// Which hints a reader has seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hints {
    /// How many before.
    pub before: usize,
    /// How many now.
    pub now: usize,
    /// How many there are.
    pub of: usize,
}

/// Takes one more hint, if there is one left.
///
/// # Errors
///
/// The progress cannot be kept.
pub fn take(desk: &Desk, exercise: &Exercise) -> Result<Hints, PracticeError> {
    counted(desk, exercise, 1)
}

/// The hints that were seen, and no more.
///
/// # Errors
///
/// The progress cannot be kept.
pub fn seen(desk: &Desk, exercise: &Exercise) -> Result<Hints, PracticeError> {
    counted(desk, exercise, 0)
}

fn counted(desk: &Desk, exercise: &Exercise, more: usize) -> Result<Hints, PracticeError> {
    let of = exercise.document.hints.len();
    desk.update(|progress| {
        let entry = progress.entry(&exercise.name);
        // An exercise may have lost hints since.
        let before = entry.hints.min(of);
        if more > 0 {
            entry.hints = (before + more).min(of);
        }
        let now = entry.hints.min(of);
        Hints { before, now, of }
    })
}
