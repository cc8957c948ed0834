//! Checking an explanation: the reader compares, and says so.

use super::check::after_success;
use super::{Desk, PracticeError, print, print_json};
use crate::book::exercise::Exercise;
use crate::workbook::checking::Verdict;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{CODE, FAINT, GOOD, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::{check::compare, shown, typed};

/// Shows the checklist, or marks the exercise as done.
pub(super) fn check(
    desk: &Desk,
    exercise: &Exercise,
    done: bool,
    json: bool,
) -> Result<Outcome, PracticeError> {
    let name = &exercise.name;
    let progress = compare(desk, exercise, done)?;
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
            command(&typed(&format!("solution {name}"), exercise)),
            command(&typed(&format!("check {name} --done"), exercise)),
        ));
        print(&text)?;
    }
    Ok(if is_done {
        Outcome::Fine
    } else {
        Outcome::FallsShort
    })
}
