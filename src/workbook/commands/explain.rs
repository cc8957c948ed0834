//! Checking an explanation: the reader compares, and says so.

use super::check::after_success;
use super::desk::shown;
use super::{CommandError, Desk, print, print_json};
use crate::book::exercise::Exercise;
use crate::workbook::checking::Verdict;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{CODE, FAINT, GOOD, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::progress::now;

/// The file with which an explanation begins.
pub(super) fn sheet(exercise: &Exercise) -> String {
    format!("# {}\n\nWrite your answer here.\n", exercise.front.title)
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
    let answer = desk.answers.read(exercise)?.unwrap_or_default();
    if done && (answer.trim().is_empty() || answer == sheet(exercise)) {
        let file = shown(&desk.answers.file(exercise));
        return Err(CommandError::Unfit(format!(
            "there is no answer in `{}` yet\n\
             next step: write yours, a few sentences will do, and compare it: `cargo run -- check {name}`",
            file.display()
        )));
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
        print_json(&Verdict::self_assessed(name.clone(), is_done, checklist))?;
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
