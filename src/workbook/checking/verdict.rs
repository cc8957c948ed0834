//! What a check says: printed by `check --json`, shown by the page, counted by `grade`.

use serde::{Deserialize, Serialize};

use crate::book::exercise::ExerciseName;

/// How a check ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Every test passed.
    Passed,
    /// A test failed, or the program ended before every test had a result.
    Failed,
    /// The answer does not compile.
    DoesNotCompile,
    /// An explanation, which its reader has not compared with the checklist yet.
    Open,
    /// An explanation, which its reader has compared with the checklist and calls done; no test has judged it.
    SelfAssessed,
}

/// What the compiler says about a line.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// `error` or `warning`.
    pub level: String,
    /// The first line of the message.
    pub message: String,
    /// The line in the reader's file, counted from 1; none if it is about no line of it.
    pub line: Option<usize>,
    /// The whole message, as the compiler prints it, without colours.
    pub rendered: String,
}

/// How one test ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TestOutcome {
    /// It passed.
    Passed,
    /// An assertion failed.
    Rejected,
    /// The answer panicked.
    Panicked,
    /// It ran until a limit ended it, or ended the program.
    Ended,
    /// It was not reached.
    NotRun,
}

/// One test and its result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TestResult {
    /// The name of the test.
    pub test: String,
    /// How it ended.
    pub outcome: TestOutcome,
    /// The words of the panic, or which limit ended it; empty if it passed.
    pub message: String,
    /// What was tested.
    pub claim: Option<String>,
    /// The smallest input with which it fails.
    pub input: Option<String>,
    /// What is right.
    pub expected: Option<String>,
    /// What the answer gave.
    pub found: Option<String>,
    /// The wrong curve beside the right one: strokes of points.
    pub picture: Option<Vec<PictureStroke>>,
}

/// A stroke of the picture that goes with a failed test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureStroke {
    /// `given`, `expected` or `found`.
    pub role: String,
    /// Its points in the plane.
    pub points: Vec<[f64; 2]>,
}

/// The misconception that an answer shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Misconception {
    /// The mutant that behaves alike.
    pub mutant: String,
    /// What the one who writes this thinks.
    pub text: String,
}

/// The result of checking one answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The exercise.
    pub exercise: ExerciseName,
    /// How it ended.
    pub outcome: Outcome,
    /// What the compiler says about the answer.
    pub diagnostics: Vec<Diagnostic>,
    /// The tests, in their order; empty if the answer does not compile.
    pub tests: Vec<TestResult>,
    /// What the answer seems to have misunderstood.
    pub misconception: Option<Misconception>,
    /// The checklist of an explanation, in Markdown; none where tests judge.
    #[serde(default)]
    pub checklist: Option<String>,
    /// What the answer printed.
    pub output: String,
    /// How long compiling and running took.
    pub seconds: f64,
}

impl Verdict {
    /// The verdict on an explanation: its reader's own.
    pub fn self_assessed(exercise: ExerciseName, is_done: bool, checklist: &str) -> Self {
        Self {
            exercise,
            outcome: if is_done {
                Outcome::SelfAssessed
            } else {
                Outcome::Open
            },
            diagnostics: Vec::new(),
            tests: Vec::new(),
            misconception: None,
            checklist: Some(checklist.to_owned()),
            output: String::new(),
            seconds: 0.0,
        }
    }

    /// Whether every test passed.
    pub fn passed(&self) -> bool {
        self.outcome == Outcome::Passed
    }

    /// How many tests passed.
    pub fn passed_tests(&self) -> usize {
        let passed = |test: &&TestResult| test.outcome == TestOutcome::Passed;
        self.tests.iter().filter(passed).count()
    }

    /// The number of warnings of the compiler.
    pub fn warnings(&self) -> usize {
        let is_warning = |diagnostic: &&Diagnostic| diagnostic.level == "warning";
        self.diagnostics.iter().filter(is_warning).count()
    }

    /// The first test that did not pass.
    pub fn first_failure(&self) -> Option<&TestResult> {
        self.tests
            .iter()
            .find(|test| test.outcome != TestOutcome::Passed)
    }
}
