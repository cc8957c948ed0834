//! `hint`: one more hint each time.

use clap::Args;
use serde::Serialize;

use super::place::about;
use super::{Place, PracticeError, print, print_json};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::hint::{self, Hints};

/// The arguments of `hint`.
#[derive(Debug, Args)]
pub struct Hint {
    /// The exercise; without it, the one begun last
    name: Option<String>,
    /// Show again what you have seen, and nothing more
    #[arg(long)]
    again: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `hint --json` prints.
#[derive(Debug, Serialize)]
struct Shown<'a> {
    exercise: String,
    /// How many hints the reader has seen now.
    shown: usize,
    /// How many there are.
    of: usize,
    /// Those shown by this call, in Markdown.
    hints: Vec<&'a str>,
}

impl Hint {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        let progress = desk.progress()?;
        let exercise = desk.exercise_or_last(self.name.as_deref(), &progress)?;
        let hints = &exercise.document.hints;
        let Hints { before, now, of } = match self.again {
            true => hint::seen(&desk, exercise)?,
            false => hint::take(&desk, exercise)?,
        };
        // Where all have been seen, the last one is shown again.
        let first = match (self.again, before < now) {
            (true, _) => 0,
            (false, true) => before,
            (false, false) => now.saturating_sub(1),
        };
        if self.json {
            let seen = hints[first..now].iter();
            print_json(&Shown {
                exercise: exercise.name.to_string(),
                shown: now,
                of,
                hints: seen.map(|hint| hint.text.as_str()).collect(),
            })?;
            return Ok(Outcome::Fine);
        }
        let mut text = String::new();
        for (number, hint) in hints.iter().enumerate().take(now).skip(first) {
            let heading = format!("Hint {} of {}", number + 1, hints.len());
            let title = &exercise.front.title;
            text.push_str(&format!("{} · {title}\n\n", paint(STRONG, heading)));
            text.push_str(&markdown::rendered(&hint.text, &desk.catalogue));
            text.push('\n');
        }
        let (sentence, next) = match (self.again, now) {
            (true, 0) => ("You have seen no hint yet.", "hint"),
            (_, now) if now < hints.len() => ("There is one more, if you need it:", "hint"),
            (false, now) if before == now => {
                ("These were all. If it still does not work:", "solution")
            }
            _ => ("This was the last hint.", "check"),
        };
        let sentence = format!("{sentence} {}", command(&about(next, exercise, &progress)));
        text.push_str(&wrapped(&sentence, "", ""));
        print(&text)?;
        Ok(Outcome::Fine)
    }
}
