//! `solution`: the solution, once the exercise is solved or when it is asked for twice.

use clap::Args;
use serde::Serialize;

use super::desk::about;
use super::{CommandError, Place, print, print_json};
use crate::book::exercise::Exercise;
use crate::tableaux;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{FAINT, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;

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
    pub(crate) fn run(self) -> Result<Outcome, CommandError> {
        let desk = self.place.open()?;
        let progress = desk.progress()?;
        let exercise = desk.exercise_or_last(self.name.as_deref(), &progress)?;
        let (may_see, hints_seen, seed) = desk.update(|progress| {
            let entry = progress.entry(&exercise.name);
            let may_see = entry.solved.is_some() || entry.asked_for_solution;
            entry.asked_for_solution |= entry.solved.is_none();
            (may_see, entry.hints, entry.seed)
        })?;
        let source = source(exercise, seed);
        if self.json {
            print_json(&Shown {
                exercise: exercise.name.to_string(),
                solution: may_see.then_some(&source),
            })?;
            return Ok(Outcome::Fine);
        }
        let name = &exercise.name;
        if !may_see {
            let left = exercise.document.hints.len().saturating_sub(hints_seen);
            let hint = command(&about("hint", exercise, &progress));
            let hints = match left {
                0 => String::new(),
                1 => format!("One hint is left: {hint}. "),
                _ => format!("{left} hints are left: {hint}. "),
            };
            let sentence = format!(
                "You have not solved “{}” yet. {hints}If you want to see the solution all the same, ask once more: {}",
                exercise.front.title,
                command(&format!("solution {name}"))
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

/// The solution as Rust, for the numbers that this reader was dealt, or the model answer in Markdown.
fn source(exercise: &Exercise, seed: Option<u64>) -> String {
    let tableau = exercise.front.tableau.as_ref();
    let dealer = tableau.and_then(|name| tableaux::find(exercise.name.chapter(), name));
    if let (Some(seed), Some(dealer)) = (seed, dealer) {
        return (dealer.deal)(seed).solved_file();
    }
    match (&exercise.tested, &exercise.document.model_answer) {
        (Some(tested), _) => tested.answer.solution.clone(),
        (None, Some(answer)) => answer.text.clone(),
        (None, None) => String::new(),
    }
}
