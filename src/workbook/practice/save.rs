//! An answer that was written on the page goes into the reader's file.
//!
//! The same file may be open in an editor and on a second page. So whoever writes says on which text he has worked, by
//! its digest: if the file holds another one by now, nothing is written, and the reader chooses.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use super::begin::{begin, starter};
use super::{Desk, PracticeError};
use crate::book::exercise::Exercise;
use crate::workbook::progress::digest;

/// What a reader has written, and on which text.
#[derive(Debug, Clone, Copy)]
pub struct Draft<'a> {
    /// The new text.
    pub text: &'a str,
    /// The digest of the text that was there when the reader began; `None` if there was no file.
    pub base: Option<&'a str>,
    /// Whether the reader has seen what is there now and wants his own; what is there is kept as a backup.
    pub replace: bool,
}

/// What became of a draft.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Saved {
    /// The file holds it.
    Written {
        /// The digest of the text, to go on with.
        digest: String,
        /// Where the text is that it has replaced, if the reader wanted so.
        backup: Option<PathBuf>,
    },
    /// The file holds something that the reader has not seen, and still does.
    Conflict {
        /// What it holds.
        text: String,
        /// The digest of that.
        digest: String,
    },
}

/// Between reading the file and writing it, no other page may write.
static WRITING: Mutex<()> = Mutex::new(());

/// Writes a draft into the file of the answer, unless there is something that the reader has not seen.
///
/// A first draft begins the exercise.
///
/// # Errors
///
/// A file cannot be read or written.
pub fn save(desk: &Desk, exercise: &Exercise, draft: Draft<'_>) -> Result<Saved, PracticeError> {
    let _alone = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    let new = digest(draft.text);
    let mut backup = None;
    match desk.answers.read(exercise)? {
        Some(text) => {
            let there = digest(&text);
            // Nothing is lost either where the same was written twice, or only the starter is there.
            let is_seen = draft.base == Some(there.as_str())
                || there == new
                || draft.base.is_none() && text == starter(exercise);
            if !is_seen && !draft.replace {
                let digest = there;
                return Ok(Saved::Conflict { text, digest });
            }
            if !is_seen {
                backup = desk.answers.back_up(exercise)?;
            }
        }
        None => {
            begin(desk, exercise, None)?;
        }
    }
    desk.answers.write(exercise, draft.text)?;
    Ok(Saved::Written {
        digest: new,
        backup,
    })
}
