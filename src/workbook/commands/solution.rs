//! `solution`: the solution, once the exercise is solved or when it is asked for twice.

use clap::Args;
use serde::Serialize;

use super::place::about;
use super::{Place, PracticeError, print, print_json};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{FAINT, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::solution::{self, Asked};
use crate::workbook::practice::typed;

/// The arguments of `solution`.
#[derive(Debug, Args)]
pub struct Solution {
    /// The exercise; without it, the one begun last
    name: Option<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `solution --json` prints.
#[derive(Debug, Serialize)]
struct Shown<'a> {
    exercise: String,
    /// The solution, or null when it is asked for the first time before the exercise is solved.
    solution: Option<&'a String>,
}

impl Solution {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        let progress = desk.progress()?;
        let exercise = desk.exercise_or_last(self.name.as_deref(), &progress)?;
        let Asked {
            may_see,
            hints_left,
            source,
        } = solution::ask(&desk, exercise)?;
        if self.json {
            print_json(&Shown {
                exercise: exercise.name.to_string(),
                solution: may_see.then_some(&source),
            })?;
            return Ok(Outcome::Fine);
        }
        let name = &exercise.name;
        if !may_see {
            let hint = command(&about("hint", exercise, &progress));
            let hints = match hints_left {
                0 => String::new(),
                1 => format!("One hint is left: {hint}. "),
                _ => format!("{hints_left} hints are left: {hint}. "),
            };
            let sentence = format!(
                "You have not solved “{}” yet. {hints}If you want to see the solution all the same, ask once more: {}",
                exercise.front.title,
                command(&typed(&format!("solution {name}"), exercise))
            );
            print(&wrapped(&sentence, "", ""))?;
            return Ok(Outcome::Fine);
        }
        let is_code = exercise.tested.is_some();
        let what = if is_code {
            "A solution"
        } else {
            "A model answer"
        };
        let mut text = format!(
            "{} · {} {}\n\n",
            paint(STRONG, what),
            exercise.front.title,
            paint(FAINT, name)
        );
        if is_code {
            text.push_str(&source);
            if let Some(afterwards) = &exercise.document.afterwards {
                text.push_str(&format!("\n{}\n\n", paint(STRONG, "Afterwards")));
                text.push_str(&markdown::rendered(&afterwards.text, &desk.catalogue));
            }
        } else {
            text.push_str(&markdown::rendered(&source, &desk.catalogue));
        }
        print(&text)?;
        Ok(Outcome::Fine)
    }
}
