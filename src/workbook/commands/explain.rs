//! Checking an explanation: the reader compares, and says so.

use serde::Serialize;

use super::check::after_success;
use super::desk::shown;
use super::{CommandError, Desk, print, print_json};
use crate::book::exercise::Exercise;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{CODE, FAINT, GOOD, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::progress::now;

/// What `check --json` prints for an explanation, which has no verdict but the reader's own.
#[derive(Debug, Serialize)]
struct Comparison<'a> {
    exercise: String,
    /// `passed` when the reader has compared, `open` before.
    outcome: &'static str,
    checklist: &'a str,
}

/// Shows the checklist, or marks the exercise as done.
pub(super) fn check(
    desk: &Desk,
    exercise: &Exercise,
    done: bool,
    json: bool,
) -> Result<Outcome, CommandError> {
    let name = &exercise.name;
    if !desk.is_begun(exercise) {
        let name = name.to_string();
        return Err(CommandError::NotBegun { name });
    }
    let progress = desk.update(|progress| {
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
    })?;
    let is_done = progress.is_solved(name);
    let checklist = exercise.document.checklist.as_ref();
    let checklist = checklist.map_or("", |section| section.text.as_str());
    if json {
        print_json(&Comparison {
            exercise: name.to_string(),
            outcome: if is_done { "passed" } else { "open" },
            checklist,
        })?;
    } else if done {
        let title = paint(STRONG, &exercise.front.title);
        let mut text = format!("{} {title} is done.\n", paint(GOOD, "✓"));
        text.push_str(&after_success(desk, exercise, &progress));
        print(&text)?;
    } else {
        let file = shown(&desk.answers.file(exercise)).display().to_string();
        let mut text = format!(
            "{} {}\n\n",
            paint(STRONG, &exercise.front.title),
            paint(FAINT, name)
        );
        let sentence = format!("Compare {} with this list.", paint(CODE, file));
        text.push_str(&wrapped(&sentence, "", ""));
        text.push('\n');
        text.push_str(&markdown::rendered(checklist, &desk.catalogue));
        text.push_str(&format!(
            "\n{}  shows a model answer\n{}  if yours says all of it\n",
            command(&format!("solution {name}")),
            command(&format!("check {name} --done")),
        ));
        print(&text)?;
    }
    Ok(if is_done {
        Outcome::Fine
    } else {
        Outcome::FallsShort
    })
}
