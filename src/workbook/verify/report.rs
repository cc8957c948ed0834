//! What `verify --json` prints about an exercise.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::book::exercise::{ExerciseKind, ExerciseName};
use crate::workbook::checking::verdict::TestOutcome;

/// What was found about an exercise; fields that its kind does not have are `None`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The exercise.
    pub exercise: ExerciseName,
    /// Its kind; none if the exercise cannot be read.
    pub kind: Option<ExerciseKind>,
    /// What the reader begins with.
    pub starter: Option<StarterReport>,
    /// What passes.
    pub solution: Option<SolutionReport>,
    /// The wrong answers.
    pub mutants: Option<Vec<MutantReport>>,
    /// How long the trials took, added up over the cores.
    pub seconds: f64,
    /// Other right answers.
    pub alternatives: Option<Vec<AlternativeReport>>,
    /// The tests.
    pub tests: Option<Vec<TestReport>>,
    /// How each test ended with each answer.
    pub matrix: Option<Vec<Column>>,
    /// What was found about the hidden tests of a pack, if it has some for this exercise.
    pub hidden: Option<HiddenReport>,
    /// What falls short; empty if the exercise is sound.
    pub shortcomings: Vec<Shortcoming>,
}

impl Report {
    /// Whether nothing falls short.
    pub fn is_sound(&self) -> bool {
        self.shortcomings.is_empty()
    }
}

/// What was found about the starter.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct StarterReport {
    /// Whether it compiles, and the tests with it.
    pub compiles: bool,
    /// Whether an assertion rejects it.
    pub rejected: bool,
    /// The number of warnings.
    pub warnings: usize,
    /// The first test that rejects it.
    pub by: Option<String>,
}

/// What was found about the solution.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SolutionReport {
    /// Whether it passes every test, with all seeds.
    pub passes: bool,
    /// The number of warnings.
    pub warnings: usize,
}

/// What was found about a wrong answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct MutantReport {
    /// Its name.
    pub name: String,
    /// What the one who writes this thinks.
    pub misconception: String,
    /// Whether it compiles, and the tests with it.
    pub compiles: bool,
    /// Whether an assertion rejects it.
    pub rejected: bool,
    /// The first test that rejects it.
    pub by: Option<String>,
    /// The number of warnings.
    pub warnings: usize,
    /// The tests that it passes.
    pub passes: Vec<String>,
}

/// What was found about another right answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct AlternativeReport {
    /// Its name.
    pub name: String,
    /// Whether it passes every test.
    pub passes: bool,
    /// The first test that it does not pass.
    pub fails: Option<String>,
}

/// What was found about a test.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TestReport {
    /// Its name.
    pub name: String,
    /// Its line in `tests.rs`.
    pub line: usize,
    /// Why it is there although it rejects nothing alone, as its author says.
    pub why: Option<String>,
    /// What it rejects of the starter and the mutants, called as in the matrix.
    pub rejects: Vec<String>,
    /// What no other test rejects.
    pub alone: Vec<String>,
}

/// What was found about hidden tests.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct HiddenReport {
    /// Their file.
    pub file: PathBuf,
    /// The tests; what one rejects alone is rejected by no test of the exercise either.
    pub tests: Vec<TestReport>,
    /// How each test ended with each answer.
    pub matrix: Vec<Column>,
}

/// How the tests ended with one answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// The answer: `starter`, `mutant wrong-end`, `alternative blossom`.
    pub answer: String,
    /// How each test ended, in their order; empty if it does not compile.
    pub outcomes: Vec<TestOutcome>,
}

/// What falls short, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shortcoming {
    /// What it is about: `starter`, `solution`, `mutant wrong-end`, `alternative blossom`, `test both_ends`, `probes`.
    pub about: String,
    /// What was found.
    pub found: String,
    /// What to do.
    pub remedy: String,
    /// What the compiler or the test says; may be empty.
    pub details: String,
}
