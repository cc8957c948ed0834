//! What `exercise.md` says first, between two lines `+++`.

use serde::Deserialize;

use super::{ExerciseKind, ExerciseName};

/// The front matter of an exercise, in TOML.
///
/// ```toml
/// title = "A point of a parabola"
/// kind = "implement"             # implement, repair, counterexample, prove, compute, explain
/// statements = ["bezier-de-casteljau-examples"]   # what it trains; the page of the first one shows it
/// difficulty = 1                 # 1 first steps … 5 exam
/// minutes = 15
/// order = 100                    # its place in the list of the chapter; leave gaps
/// prerequisites = []             # exercises by name, `chapter/name`
/// tableau = "cubic"              # only for `compute`: which tableau deals the numbers
/// ```
///
/// The tableaux of a chapter are listed in its `tableaux::all`; see [`Dealer`](crate::check::tableau::Dealer).
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FrontMatter {
    /// What it is called.
    pub title: String,
    /// What it asks for.
    pub kind: ExerciseKind,
    /// The statements that it trains, by id; the page of the first one shows it.
    pub statements: Vec<String>,
    /// From 1, first steps, to 5, exam.
    pub difficulty: u8,
    /// How long it takes.
    pub minutes: u32,
    /// Its place in the list of its chapter; equal places are sorted by name.
    pub order: u32,
    /// The exercises to do before, by name.
    #[serde(default)]
    pub prerequisites: Vec<ExerciseName>,
    /// For *compute*: the tableau that deals the numbers, by its name in the chapter.
    pub tableau: Option<String>,
}
