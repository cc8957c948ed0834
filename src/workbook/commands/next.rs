//! `next`: what to do next.

use clap::Args;
use serde::Serialize;

use super::{Desk, Place, PracticeError, print, print_json};
use crate::book::exercise::ExerciseName;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{GOOD, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::next::next;
use crate::workbook::practice::typed;
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
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
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
            command(&typed("check", exercise))
        )
    } else {
        format!(
            "Next is “{title}”, about {} minutes: {}",
            exercise.front.minutes,
            command(&typed(&format!("start {}", exercise.name), exercise))
        )
    };
    wrapped(&what, "", "")
}
