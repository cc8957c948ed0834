//! `next`: what to do next.

use clap::Args;
use serde::Serialize;

use super::{CommandError, Desk, Place, print, print_json};
use crate::book::exercise::{Exercise, ExerciseName};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{GOOD, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::progress::Progress;

/// The arguments of `next`.
#[derive(Debug, Args)]
pub struct Next {
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `next --json` prints; the fields are null when everything is solved.
#[derive(Debug, Serialize)]
struct Proposal<'a> {
    exercise: Option<&'a ExerciseName>,
    title: Option<&'a str>,
    /// Whether it was begun already.
    begun: Option<bool>,
}

impl Next {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, CommandError> {
        let desk = self.place.open()?;
        let progress = desk.progress()?;
        if self.json {
            let next = next(&desk, &progress);
            print_json(&Proposal {
                exercise: next.map(|exercise| &exercise.name),
                title: next.map(|exercise| exercise.front.title.as_str()),
                begun: next.map(|exercise| desk.is_begun(exercise)),
            })?;
        } else {
            print(&sentence(&desk, &progress))?;
        }
        Ok(Outcome::Fine)
    }
}

/// The exercise to do next: the one begun last if it is not solved, then the first whose prerequisites are solved,
/// in the chapter of the one begun last if there is one.
fn next<'a>(desk: &'a Desk, progress: &Progress) -> Option<&'a Exercise> {
    let is_open = |exercise: &&Exercise| !progress.is_solved(&exercise.name);
    let last = progress.begun_last.as_ref();
    let last = last.and_then(|name| desk.exercises.get(name));
    let is_ready = |exercise: &&Exercise| {
        let needed = &exercise.front.prerequisites;
        needed.iter().all(|name| progress.is_solved(name))
    };
    // Something is always ready while something is open: prerequisites do not go round in circles.
    let ready = || desk.exercises.iter().filter(is_open).filter(is_ready);
    let is_here = |exercise: &&Exercise| {
        last.is_some_and(|last| last.name.chapter() == exercise.name.chapter())
    };
    last.filter(is_open)
        .or_else(|| ready().find(is_here))
        .or_else(|| ready().next())
}

/// What to do next, in words.
pub(super) fn sentence(desk: &Desk, progress: &Progress) -> String {
    let Some(exercise) = next(desk, progress) else {
        let text = if desk.exercises.iter().next().is_none() {
            "There is no exercise yet.".to_owned()
        } else {
            paint(GOOD, "You have solved every exercise there is.")
        };
        return text + "\n";
    };
    let title = &exercise.front.title;
    let what = if desk.is_begun(exercise) {
        format!(
            "“{title}” is begun. {} tests your answer.",
            command("check")
        )
    } else {
        format!(
            "Next is “{title}”, about {} minutes: {}",
            exercise.front.minutes,
            command(&format!("start {}", exercise.name))
        )
    };
    wrapped(&what, "", "")
}
