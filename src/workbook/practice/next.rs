//! What to do next.

use super::Desk;
use crate::book::exercise::Exercise;
use crate::workbook::progress::Progress;

/// The exercise to do next: the one begun last if it is not solved, then the first whose prerequisites are solved,
/// in the chapter of the one begun last if there is one.
pub fn next<'a>(desk: &'a Desk, progress: &Progress) -> Option<&'a Exercise> {
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
