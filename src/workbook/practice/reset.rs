//! An exercise is begun anew; the answer is kept under another name.

use std::path::PathBuf;

use super::begin::begin;
use super::{Desk, PracticeError};
use crate::book::exercise::Exercise;
use crate::workbook::progress::Entry;

/// Puts the answer away, forgets the progress of the exercise and begins it anew; returns where the answer is now.
///
/// # Errors
///
/// The exercise was not begun, or a file cannot be written.
pub fn reset(desk: &Desk, exercise: &Exercise) -> Result<PathBuf, PracticeError> {
    let Some(backup) = desk.answers.put_away(exercise)? else {
        return Err(PracticeError::not_begun(exercise));
    };
    desk.update(|progress| *progress.entry(&exercise.name) = Entry::default())?;
    begin(desk, exercise, None)?;
    Ok(backup)
}
