//! One answer of an exercise is compiled and run.

use std::time::Instant;

use super::candidate::{Candidate, Role};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::compile::{Source, compile_answer, compile_tests};
use crate::workbook::checking::trial::{AfterTooLong, run_probes, run_tests};
use crate::workbook::checking::verdict::{Diagnostic, TestOutcome, TestResult};
use crate::workbook::checking::{Checker, CheckingError};

/// The seed of the random inputs with which every answer is tried.
const SEED: u64 = 1;

/// How many other seeds the solution must stand.
pub const OTHER_SEEDS: u64 = 20;

/// How compiling ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Compilation {
    /// It compiles, perhaps with warnings.
    Compiled(Vec<Diagnostic>),
    /// The answer does not compile.
    Refused(Vec<Diagnostic>),
    /// The answer compiles, the tests do not compile with it.
    RefusedWithTests(Vec<Diagnostic>),
}

/// What one answer did.
#[derive(Debug, Clone)]
pub struct Trial {
    /// The answer.
    pub candidate: Candidate,
    /// How compiling it ended.
    pub compilation: Compilation,
    /// The result of each test; empty if it did not compile.
    pub results: Vec<TestResult>,
    /// What it does on the probe inputs.
    pub probes: Option<Vec<String>>,
    /// The first seed with which the solution fails although it passes with the usual one.
    pub failing_seed: Option<(u64, TestResult)>,
    /// How long it took.
    pub seconds: f64,
}

impl Trial {
    /// The warnings of the compiler.
    pub fn warnings(&self) -> &[Diagnostic] {
        match &self.compilation {
            Compilation::Compiled(warnings) => warnings,
            _ => &[],
        }
    }

    /// Whether it compiles, and the tests with it.
    pub fn compiles(&self) -> bool {
        matches!(self.compilation, Compilation::Compiled(_))
    }

    /// The tests that end in this way.
    pub fn ending(&self, outcome: TestOutcome) -> impl Iterator<Item = &TestResult> {
        self.results.iter().filter(move |r| r.outcome == outcome)
    }

    /// Whether an assertion rejects it.
    pub fn is_rejected(&self) -> bool {
        self.ending(TestOutcome::Rejected).next().is_some()
    }

    /// Whether every test passes, with every seed.
    pub fn passes(&self) -> bool {
        self.compiles() && first_failure(&self.results).is_none() && self.failing_seed.is_none()
    }
}

/// The first test that does not pass.
pub(super) fn first_failure(results: &[TestResult]) -> Option<&TestResult> {
    results.iter().find(|r| r.outcome != TestOutcome::Passed)
}

/// Compiles and runs one answer.
///
/// # Errors
///
/// The compiler or the program does not start.
pub fn run(
    checker: &Checker,
    exercise: &Exercise,
    tested: &Tested,
    candidate: Candidate,
) -> Result<Trial, CheckingError> {
    let start = Instant::now();
    let mut trial = Trial {
        candidate,
        compilation: Compilation::Refused(Vec::new()),
        results: Vec::new(),
        probes: None,
        failing_seed: None,
        seconds: 0.0,
    };
    try_out(checker, exercise, tested, &mut trial)?;
    trial.seconds = start.elapsed().as_secs_f64();
    Ok(trial)
}

fn try_out(
    checker: &Checker,
    exercise: &Exercise,
    tested: &Tested,
    trial: &mut Trial,
) -> Result<(), CheckingError> {
    let (library, runner) = (checker.library(), checker.runner());
    let answer = match compile_answer(library, &trial.candidate.source, runner)? {
        Ok(answer) => answer,
        Err(diagnostics) => {
            trial.compilation = Compilation::Refused(diagnostics);
            return Ok(());
        }
    };
    let warnings = answer.diagnostics.clone();
    let tests = Source {
        shown_as: exercise.folder.join("tests.rs").display().to_string(),
        text: tested.tests.program(),
    };
    let program = match compile_tests(library, answer, &tests, runner)? {
        Ok(program) => program,
        Err(diagnostics) => {
            trial.compilation = Compilation::RefusedWithTests(diagnostics);
            return Ok(());
        }
    };
    trial.compilation = Compilation::Compiled(warnings);
    let names: Vec<&str> = tested.tests.tests.iter().map(|t| t.name.as_str()).collect();
    let run = |seed| {
        run_tests(
            &program,
            &names,
            seed,
            checker.limits(),
            runner,
            AfterTooLong::RunTheOthers,
        )
    };
    trial.results = run(SEED)?.tests;
    trial.probes = run_probes(&program, checker.limits(), runner)?;
    if trial.candidate.role == Role::Solution && first_failure(&trial.results).is_none() {
        for seed in (SEED + 1)..=(SEED + OTHER_SEEDS) {
            let results = run(seed)?.tests;
            if let Some(failure) = first_failure(&results) {
                trial.failing_seed = Some((seed, failure.clone()));
                break;
            }
        }
    }
    Ok(())
}
