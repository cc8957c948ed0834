//! How a reader stands with an exercise: all that its page has to know.

use serde::Serialize;

use super::begin::starter;
use super::{Desk, PracticeError, shown};
use crate::book::exercise::{Exercise, ExerciseKind, ExerciseName};
use crate::check::tableau::{Deal, ReadingError, sheet};
use crate::tableaux;
use crate::workbook::progress::digest;

/// How a reader stands with an exercise.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Standing {
    /// The exercise.
    pub exercise: ExerciseName,
    /// Its title.
    pub title: String,
    /// Its kind.
    pub kind: ExerciseKind,
    /// Where the answer is, or will be.
    pub file: String,
    /// The answer, or what the reader begins with.
    pub text: String,
    /// The digest of the answer; none if there is no file yet.
    pub digest: Option<String>,
    /// Whether it was solved.
    pub solved: bool,
    /// How often it was checked.
    pub checks: u32,
    /// How many hints were seen.
    pub hints: usize,
    /// Whether the next question for the solution is answered.
    pub may_see_solution: bool,
    /// Whether the starter is another than the one with which the reader began.
    pub starter_changed: bool,
    /// The table of a tableau, as [`tableaux::answer`] describes it; none if the file is no longer of that form.
    pub tableau: Option<String>,
}

impl Standing {
    /// How the reader stands with this exercise.
    ///
    /// # Errors
    ///
    /// The answer or the progress cannot be read.
    pub fn of(desk: &Desk, exercise: &Exercise) -> Result<Self, PracticeError> {
        let written = desk.answers.read(exercise)?;
        let entry = desk.progress()?.of(&exercise.name);
        let digest = written.as_deref().map(digest);
        let text = written.unwrap_or_else(|| starter(exercise));
        let tableau = deal_of(exercise, &text).and_then(|deal| {
            let fields = deal.fields(&text)?;
            Some(sheet::described(&deal, &fields))
        });
        Ok(Self {
            exercise: exercise.name.clone(),
            title: exercise.front.title.clone(),
            kind: exercise.front.kind,
            file: shown(&desk.answers.file(exercise)).display().to_string(),
            starter_changed: digest.is_some() && desk.starter_changed(exercise, &entry),
            solved: entry.solved.is_some(),
            checks: entry.checks,
            hints: entry.hints.min(exercise.document.hints.len()),
            may_see_solution: entry.solved.is_some() || entry.asked_for_solution,
            text,
            digest,
            tableau,
        })
    }
}

/// The numbers of an answer file; none if it is no file of a tableau.
fn deal_of(exercise: &Exercise, text: &str) -> Option<Deal> {
    deal(exercise, sheet::round_of(text)?)
}

fn deal(exercise: &Exercise, round: u64) -> Option<Deal> {
    let name = exercise.front.tableau.as_ref()?;
    let dealer = tableaux::find(exercise.name.chapter(), name)?;
    Some((dealer.deal)(round))
}

/// The answer file with the fields of a table that was filled on the page.
///
/// What else stands in the file, such as comments of the reader, stays.
///
/// # Errors
///
/// The exercise has no tableau; inside, a field that cannot be read.
pub fn with_fields(
    desk: &Desk,
    exercise: &Exercise,
    round: u64,
    fields: &sheet::Fields,
) -> Result<Result<String, ReadingError>, PracticeError> {
    let Some(deal) = deal(exercise, round) else {
        let name = &exercise.name;
        let text = format!("`{name}` has no tableau\nnext step: reload the page");
        return Err(PracticeError::Unfit(text));
    };
    let written = desk.answers.read(exercise)?.unwrap_or_default();
    let into = |file: &str| deal.with_fields(file, fields).transpose();
    let filled = into(&written).or_else(|| into(&deal.answer_file()));
    Ok(filled.unwrap_or_else(|| Ok(deal.answer_file())))
}

/// What the cells of a table are worth.
pub fn judged(exercise: &Exercise, round: u64, fields: &sheet::Fields) -> Option<String> {
    Some(sheet::described(&deal(exercise, round)?, fields))
}
