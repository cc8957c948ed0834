//! An exercise is begun: the file of the answer is made.

use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use super::{Desk, PracticeError};
use crate::book::exercise::Exercise;
use crate::workbook::answers::Begun;
use crate::workbook::progress::{Entry, digest, now};

/// A starter with fresh numbers.
#[derive(Debug, Clone)]
pub struct Fresh {
    /// What dealt them.
    pub seed: u64,
    text: String,
}

impl Fresh {
    /// The numbers of this seed.
    ///
    /// # Errors
    ///
    /// The exercise deals no numbers.
    pub fn deal(exercise: &Exercise, seed: u64) -> Result<Self, PracticeError> {
        match exercise.fresh_answer_file(seed) {
            Some(text) => Ok(Self { seed, text }),
            None => Err(PracticeError::Unfit(format!(
                "`{}` has no fresh numbers; only tableaux to compute by hand have\n\
                 next step: start it without `--fresh`",
                exercise.name
            ))),
        }
    }
}

/// A seed that nobody has chosen; it is short, so that it can be passed on.
pub fn any_seed() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(1, |time| u64::from(time.subsec_micros()) % 9999 + 1)
}

/// What a reader begins with.
pub fn starter(exercise: &Exercise) -> String {
    match &exercise.tested {
        Some(tested) => tested.answer.starter.clone(),
        None => format!("# {}\n\nWrite your answer here.\n", exercise.front.title),
    }
}

/// Makes the file of the answer, if there is none, and remembers that it was begun.
///
/// # Errors
///
/// A file cannot be written.
pub fn begin(
    desk: &Desk,
    exercise: &Exercise,
    fresh: Option<&Fresh>,
) -> Result<Begun, PracticeError> {
    let starter = match fresh {
        Some(fresh) => fresh.text.clone(),
        None => starter(exercise),
    };
    let begun = desk.answers.begin(exercise, &starter)?;
    desk.update(|progress| {
        progress.begun_last = Some(exercise.name.clone());
        let entry = progress.entry(&exercise.name);
        if begun == Begun::New {
            *entry = Entry {
                // Fresh numbers do not come from the starter.
                starter: match fresh {
                    None => exercise.tested.as_ref().map(|_| digest(&starter)),
                    Some(_) => None,
                },
                seed: fresh.map(|fresh| fresh.seed),
                // What was reached before the file went away stays true.
                solved: entry.solved,
                hints: entry.hints,
                checks: entry.checks,
                asked_for_solution: entry.asked_for_solution,
                ..Entry::default()
            };
        }
        entry.begun.get_or_insert_with(now);
    })?;
    Ok(begun)
}

/// Begins with fresh numbers; an answer that was there is put away, and its place is returned.
///
/// # Errors
///
/// A file cannot be written.
pub fn begin_fresh(
    desk: &Desk,
    exercise: &Exercise,
    fresh: &Fresh,
) -> Result<(Begun, Option<PathBuf>), PracticeError> {
    let backup = desk.answers.put_away(exercise)?;
    let begun = begin(desk, exercise, Some(fresh))?;
    Ok((begun, backup))
}
