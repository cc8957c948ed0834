//! The answers of an exercise are compiled and run.

use std::time::Instant;

use super::candidate::{Candidate, Role};
use crate::book::exercise::Tested;
use crate::workbook::checking::check::Compiled;
use crate::workbook::checking::compile::Source;
use crate::workbook::checking::trial::{AfterTooLong, WithProbes, run_probes, run_tests};
use crate::workbook::checking::verdict::{Diagnostic, TestOutcome, TestResult};
use crate::workbook::checking::{Checker, CheckingError};
use crate::workbook::parallel::in_parallel;

/// The seed of the random inputs with which every answer is tried.
const SEED: u64 = 1;

/// How many other seeds the solution must stand.
pub const OTHER_SEEDS: u64 = 20;

/// How many answers of one exercise are run at a time; other exercises use the other cores.
const AT_ONCE: usize = 2;

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

/// Compiles and runs answers of an exercise; `tell` is called whenever one is finished.
///
/// The solution is compiled as an answer of a reader is, the others together.
///
/// # Errors
///
/// The compiler or the program does not start.
pub fn run(
    checker: &Checker,
    tested: &Tested,
    candidates: &[Candidate],
    tell: &(dyn Fn() + Sync),
) -> Result<Vec<Trial>, CheckingError> {
    let (solutions, others): (Vec<&Candidate>, Vec<&Candidate>) = candidates
        .iter()
        .partition(|candidate| candidate.role == Role::Solution);
    let groups: Vec<&[&Candidate]> = solutions.chunks(1).chain([others.as_slice()]).collect();
    let trials = in_parallel(&groups, groups.len(), |group| {
        let start = Instant::now();
        let sources: Vec<&Source> = group.iter().map(|candidate| &candidate.source).collect();
        let compiled = checker.compile_all(tested, &sources)?;
        let share = start.elapsed().as_secs_f64() / group.len().max(1) as f64;
        let pairs: Vec<(&&Candidate, Compiled)> = group.iter().zip(compiled).collect();
        in_parallel(&pairs, AT_ONCE, |(candidate, compiled)| {
            let start = Instant::now();
            let mut trial = try_out(checker, tested, candidate, compiled)?;
            trial.seconds = share + start.elapsed().as_secs_f64();
            tell();
            Ok::<_, CheckingError>(trial)
        })
    })?;
    let mut trials: Vec<Trial> = trials.into_iter().flatten().collect();
    // The judge finds them in the order of the candidates.
    trials.sort_by_key(|trial| {
        let is_of =
            |c: &Candidate| c.role == trial.candidate.role && c.name == trial.candidate.name;
        candidates.iter().position(is_of)
    });
    Ok(trials)
}

/// Runs a compiled answer.
fn try_out(
    checker: &Checker,
    tested: &Tested,
    candidate: &Candidate,
    compiled: &Compiled,
) -> Result<Trial, CheckingError> {
    let (runner, limits) = (checker.runner(), checker.limits());
    let mut trial = Trial {
        candidate: candidate.clone(),
        compilation: Compilation::Refused(Vec::new()),
        results: Vec::new(),
        probes: None,
        failing_seed: None,
        seconds: 0.0,
    };
    let program = match compiled {
        Compiled::Program(program, warnings) => {
            trial.compilation = Compilation::Compiled(warnings.clone());
            program
        }
        Compiled::Refused(errors) => {
            trial.compilation = Compilation::Refused(errors.clone());
            return Ok(trial);
        }
        Compiled::RefusedWithTests(errors) => {
            trial.compilation = Compilation::RefusedWithTests(errors.clone());
            return Ok(trial);
        }
    };
    let names: Vec<&str> = tested.tests.tests.iter().map(|t| t.name.as_str()).collect();
    let run = |seed, probes| {
        let after = AfterTooLong::RunTheOthers;
        run_tests(program, &names, seed, limits, runner, after, probes)
    };
    let results = run(SEED, WithProbes::Always)?;
    trial.results = results.tests;
    trial.probes = match results.probes {
        // An answer that has ended the program may still answer the probes.
        None if tested.tests.has_probes => run_probes(program, limits, runner)?,
        probes => probes,
    };
    if trial.candidate.role == Role::Solution && first_failure(&trial.results).is_none() {
        for seed in (SEED + 1)..=(SEED + OTHER_SEEDS) {
            let results = run(seed, WithProbes::No)?.tests;
            if let Some(failure) = first_failure(&results) {
                trial.failing_seed = Some((seed, failure.clone()));
                break;
            }
        }
    }
    Ok(trial)
}
