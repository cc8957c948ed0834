//! An answer is judged: by its tests, or, for an explanation, by the reader.

use std::fs;
use std::path::PathBuf;

use super::begin::starter;
use super::{Desk, PracticeError, shown, typed};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::{Answer, Checker, Verdict};
use crate::workbook::durable;
use crate::workbook::feedback::picture;
use crate::workbook::progress::{Progress, now};

/// The seed of the random input.
///
/// It stays the same, so that an input that fails is met again until the answer is mended.
const SEED: u64 = 1;

/// Checks the answer in its file and remembers how it ended.
///
/// # Errors
///
/// The exercise was not begun, or the check could not run.
pub fn check(
    desk: &Desk,
    exercise: &Exercise,
    tested: &Tested,
    checker: &Checker,
) -> Result<Verdict, PracticeError> {
    let file = desk.answers.file(exercise);
    let Some(text) = desk.answers.read(exercise)? else {
        return Err(PracticeError::not_begun(exercise));
    };
    let answer = Answer {
        shown_as: shown(&file).display().to_string(),
        text,
    };
    let verdict = checker.check(exercise, tested, &answer, SEED)?;
    desk.update(|progress| {
        progress.begun_last = Some(exercise.name.clone());
        let entry = progress.entry(&exercise.name);
        entry.begun.get_or_insert_with(now);
        entry.checks += 1;
        if verdict.passed() {
            entry.solved.get_or_insert_with(now);
        }
    })?;
    Ok(verdict)
}

/// Compares an explanation with what a good answer says; `done` when the reader finds that his says all of it.
///
/// # Errors
///
/// The exercise was not begun, there is nothing to call done, or the progress cannot be kept.
pub fn compare(desk: &Desk, exercise: &Exercise, done: bool) -> Result<Progress, PracticeError> {
    let name = &exercise.name;
    if !desk.is_begun(exercise) {
        return Err(PracticeError::not_begun(exercise));
    }
    let answer = desk.answers.read(exercise)?.unwrap_or_default();
    if done && (answer.trim().is_empty() || answer == starter(exercise)) {
        let file = shown(&desk.answers.file(exercise));
        return Err(PracticeError::Unfit(format!(
            "there is no answer in `{}` yet\n\
             next step: write yours, a few sentences will do, and compare it: `cargo run -- {}`",
            file.display(),
            typed(&format!("check {name}"), exercise)
        )));
    }
    desk.update(|progress| {
        progress.begun_last = Some(name.clone());
        let entry = progress.entry(name);
        entry.begun.get_or_insert_with(now);
        entry.checks += u32::from(done);
        // To compare is what the reader does now, so the model answer is not held back any more.
        entry.asked_for_solution = true;
        if done {
            entry.solved.get_or_insert_with(now);
        }
        progress.clone()
    })
}

/// Draws what is wrong into a file and returns its place; a picture of an earlier check goes away.
///
/// A picture that cannot be drawn or saved is no reason to withhold the verdict.
pub fn keep_picture(desk: &Desk, exercise: &Exercise, verdict: &Verdict) -> Option<PathBuf> {
    let file = desk.answers.picture(&exercise.name);
    let Some(svg) = picture::of(verdict, &exercise.front.title) else {
        let _ = fs::remove_file(&file);
        return None;
    };
    durable::replace(&file, svg.as_bytes()).ok()?;
    Some(file)
}
