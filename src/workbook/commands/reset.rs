//! `reset`: begins an exercise anew; the answer is kept under another name.

use clap::Args;
use serde::Serialize;

use super::{Place, PracticeError, print, print_json};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{CODE, paint};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::{reset::reset, shown, typed};

/// The arguments of `reset`.
#[derive(Debug, Args)]
pub struct Reset {
    /// The exercise: `chapter/name`, or the name alone
    name: String,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `reset --json` prints.
#[derive(Debug, Serialize)]
struct Anew {
    exercise: String,
    file: String,
    /// Where the answer is kept.
    backup: String,
}

impl Reset {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        let exercise = desk.exercise(&self.name)?;
        let backup = reset(&desk, exercise)?;
        let file = shown(&desk.answers.file(exercise)).display().to_string();
        let backup = shown(&backup).display().to_string();
        if self.json {
            print_json(&Anew {
                exercise: exercise.name.to_string(),
                file,
                backup,
            })?;
        } else {
            print(&format!(
                "Your answer is kept as {}.\n{} holds the starter again.\n\nnext step: {}\n",
                paint(CODE, backup),
                paint(CODE, file),
                command(&typed(&format!("check {}", exercise.name), exercise))
            ))?;
        }
        Ok(Outcome::Fine)
    }
}
