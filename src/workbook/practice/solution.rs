//! The solution, once the exercise is solved or when it is asked for twice.

use super::{Desk, PracticeError};
use crate::book::exercise::Exercise;
use crate::tableaux;

/// What comes of asking for the solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Asked {
    /// Whether the reader may see it now.
    pub may_see: bool,
    /// How many hints are left.
    pub hints_left: usize,
    /// The solution as Rust, for the numbers that this reader was dealt, or the model answer in Markdown.
    pub source: String,
}

/// Asks for the solution, and remembers that it was asked for.
///
/// # Errors
///
/// The progress cannot be kept.
pub fn ask(desk: &Desk, exercise: &Exercise) -> Result<Asked, PracticeError> {
    let (may_see, hints, seed) = desk.update(|progress| {
        let entry = progress.entry(&exercise.name);
        let may_see = entry.solved.is_some() || entry.asked_for_solution;
        entry.asked_for_solution |= entry.solved.is_none();
        (may_see, entry.hints, entry.seed)
    })?;
    Ok(Asked {
        may_see,
        hints_left: exercise.document.hints.len().saturating_sub(hints),
        source: source(exercise, seed),
    })
}

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
