//! The rules: what the trials of an exercise must show.

use super::candidate::Role;
use super::report::{
    AlternativeReport, Column, MutantReport, Report, Shortcoming, SolutionReport, StarterReport,
    TestReport,
};
use super::to_do;
use super::trial::{Compilation, OTHER_SEEDS, Trial, first_failure};
use crate::book::error::BookError;
use crate::book::exercise::{Exercise, ExerciseKind, ExerciseName, TestItem, Tested};
use crate::workbook::checking::misconception::behave_alike;
use crate::workbook::checking::verdict::{Diagnostic, TestOutcome, TestResult};

/// The report about an explanation, which has no program to verify.
pub fn exempt(exercise: &Exercise) -> Report {
    Report {
        shortcomings: to_do::list(exercise),
        ..nothing_tried(&exercise.name, Some(exercise.front.kind))
    }
}

/// The report about an exercise that does not follow the schema.
pub fn unreadable(name: &ExerciseName, mistakes: &[BookError]) -> Report {
    let shortcomings = mistakes.iter().map(|mistake| Shortcoming {
        about: "schema".into(),
        found: mistake.to_string(),
        remedy: format!("mend `{}`", mistake.place.file.display()),
        details: String::new(),
    });
    Report {
        shortcomings: shortcomings.collect(),
        ..nothing_tried(name, None)
    }
}

/// A report in which every field is still open.
fn nothing_tried(name: &ExerciseName, kind: Option<ExerciseKind>) -> Report {
    Report {
        exercise: name.clone(),
        kind,
        starter: None,
        solution: None,
        mutants: None,
        seconds: 0.0,
        alternatives: None,
        tests: None,
        matrix: None,
        hidden: None,
        shortcomings: Vec::new(),
    }
}

/// The report about an exercise whose answers have all been tried.
pub fn judge(exercise: &Exercise, tested: &Tested, trials: &[Trial]) -> Report {
    let mut judge = Judge {
        exercise,
        shortcomings: to_do::list(exercise),
    };
    let of = |role| trials.iter().filter(move |t| t.candidate.role == role);
    for trial in trials {
        judge.compilation(trial);
    }
    for trial in of(Role::Solution).chain(of(Role::Alternative)) {
        judge.right_answer(trial);
    }
    for trial in of(Role::Starter).chain(of(Role::Mutant)) {
        judge.wrong_answer(trial);
    }
    let tests = tests(&tested.tests.tests, trials, |_| false);
    for test in &tests {
        judge.test(test);
    }
    let distinct: Vec<&Trial> = of(Role::Solution).chain(of(Role::Mutant)).collect();
    judge.probes(&distinct);
    let shortcomings = judge.shortcomings;
    Report {
        starter: of(Role::Starter).next().map(|trial| StarterReport {
            compiles: trial.compiles(),
            rejected: trial.is_rejected(),
            warnings: trial.warnings().len(),
            by: rejected_by(trial),
        }),
        solution: of(Role::Solution).next().map(|trial| SolutionReport {
            passes: trial.passes(),
            warnings: trial.warnings().len(),
        }),
        mutants: Some(
            of(Role::Mutant)
                .zip(&tested.mutants)
                .map(|(trial, mutant)| MutantReport {
                    name: mutant.name.clone(),
                    misconception: mutant.misconception.clone(),
                    compiles: trial.compiles(),
                    rejected: trial.is_rejected(),
                    by: rejected_by(trial),
                    warnings: trial.warnings().len(),
                    passes: trial
                        .ending(TestOutcome::Passed)
                        .map(|result| result.test.clone())
                        .collect(),
                })
                .collect(),
        ),
        alternatives: Some(
            of(Role::Alternative)
                .map(|trial| AlternativeReport {
                    name: trial.candidate.name.clone(),
                    passes: trial.passes(),
                    fails: first_failure(&trial.results).map(|result| result.test.clone()),
                })
                .collect(),
        ),
        tests: Some(tests),
        matrix: Some(matrix(trials)),
        seconds: trials.iter().map(|trial| trial.seconds).sum(),
        shortcomings,
        ..nothing_tried(&exercise.name, Some(exercise.front.kind))
    }
}

/// The first test that rejects an answer by an assertion.
fn rejected_by(trial: &Trial) -> Option<String> {
    let mut rejecting = trial.ending(TestOutcome::Rejected);
    rejecting.next().map(|result| result.test.clone())
}

/// What each test rejects, and what nothing else rejects: neither another of these tests nor one elsewhere.
pub(super) fn tests(
    items: &[TestItem],
    trials: &[Trial],
    is_rejected_elsewhere: impl Fn(&Trial) -> bool,
) -> Vec<TestReport> {
    let wrong: Vec<&Trial> = trials.iter().filter(|t| t.candidate.is_wrong()).collect();
    items
        .iter()
        .map(|test| {
            let rejected = wrong.iter().filter(|trial| {
                trial
                    .ending(TestOutcome::Rejected)
                    .any(|result| result.test == test.name)
            });
            let (mut rejects, mut alone) = (Vec::new(), Vec::new());
            for trial in rejected {
                let name = trial.candidate.to_string();
                let is_alone = trial.ending(TestOutcome::Rejected).count() == 1;
                if is_alone && !is_rejected_elsewhere(trial) {
                    alone.push(name.clone());
                }
                rejects.push(name);
            }
            TestReport {
                name: test.name.clone(),
                line: test.line,
                why: test.why.clone(),
                rejects,
                alone,
            }
        })
        .collect()
}

/// How each test ended with each answer.
pub(super) fn matrix(trials: &[Trial]) -> Vec<Column> {
    trials
        .iter()
        .map(|trial| Column {
            answer: trial.candidate.to_string(),
            outcomes: trial.results.iter().map(|result| result.outcome).collect(),
        })
        .collect()
}

/// Collects what falls short.
struct Judge<'a> {
    exercise: &'a Exercise,
    shortcomings: Vec<Shortcoming>,
}

impl Judge<'_> {
    fn falls_short(&mut self, about: &str, found: String, remedy: String, details: String) {
        self.shortcomings.push(Shortcoming {
            about: about.to_owned(),
            found,
            remedy,
            details,
        });
    }

    /// The file of an answer, as its author knows it.
    fn file(&self, trial: &Trial) -> String {
        match trial.candidate.role {
            Role::Starter | Role::Solution => {
                self.exercise.folder.join("answer.rs").display().to_string()
            }
            Role::Mutant | Role::Alternative | Role::HiddenMutant => {
                trial.candidate.source.shown_as.clone()
            }
        }
    }

    fn tests_file(&self) -> String {
        self.exercise.folder.join("tests.rs").display().to_string()
    }

    /// Every answer compiles without a warning, and the tests with it.
    fn compilation(&mut self, trial: &Trial) {
        let about = trial.candidate.to_string();
        let file = self.file(trial);
        match &trial.compilation {
            Compilation::Compiled(warnings) if warnings.is_empty() => {}
            Compilation::Compiled(warnings) => {
                let count = match warnings.len() {
                    1 => "a warning".to_owned(),
                    n => format!("{n} warnings"),
                };
                self.falls_short(
                    &about,
                    format!("it compiles with {count}"),
                    format!("mend `{file}`"),
                    rendered(warnings),
                );
            }
            Compilation::Refused(errors) => self.falls_short(
                &about,
                "it does not compile".into(),
                format!("mend `{file}`"),
                rendered(errors),
            ),
            Compilation::RefusedWithTests(errors) => {
                let remedy = if trial.candidate.role == Role::Solution {
                    format!("mend `{}`", self.tests_file())
                } else {
                    format!("give `{file}` the same public functions as the solution has")
                };
                self.falls_short(
                    &about,
                    "the tests do not compile with it".into(),
                    remedy,
                    rendered(errors),
                );
            }
        }
    }

    /// Solution and alternatives pass.
    fn right_answer(&mut self, trial: &Trial) {
        let about = trial.candidate.to_string();
        let remedy = if trial.candidate.role == Role::Solution {
            format!("mend the solution or `{}`", self.tests_file())
        } else {
            format!(
                "let the test accept every right answer, or take `{}` out if it is wrong",
                self.file(trial)
            )
        };
        if let Some(failure) = first_failure(&trial.results) {
            let found = format!("the test `{}` {} it", failure.test, verb(failure.outcome));
            self.falls_short(&about, found, remedy, failure.message.clone());
        } else if let Some((seed, failure)) = &trial.failing_seed {
            let found = format!(
                "with other random inputs the test `{}` {} it (one of {OTHER_SEEDS} more seeds: {seed})",
                failure.test,
                verb(failure.outcome),
            );
            self.falls_short(&about, found, remedy, failure.message.clone());
        }
    }

    /// Starter and mutants are rejected by an assertion; a mutant also passes a test.
    fn wrong_answer(&mut self, trial: &Trial) {
        if !trial.compiles() {
            return;
        }
        let about = trial.candidate.to_string();
        let (file, tests) = (self.file(trial), self.tests_file());
        let is_mutant = trial.candidate.role == Role::Mutant;
        if !trial.is_rejected() {
            match first_failure(&trial.results) {
                None => {
                    let remedy = if is_mutant {
                        format!("write a test in `{tests}` that it fails")
                    } else {
                        format!(
                            "let the starter in `{file}` do less, or write a test that it fails"
                        )
                    };
                    let found = "it passes every test".to_owned();
                    self.falls_short(&about, found, remedy, String::new());
                }
                Some(failure) => {
                    let found = format!(
                        "no assertion rejects it; {} in the test `{}`",
                        end(failure),
                        failure.test
                    );
                    let remedy = format!("let it return a wrong value instead, in `{file}`");
                    self.falls_short(&about, found, remedy, failure.message.clone());
                }
            }
        } else if is_mutant && trial.ending(TestOutcome::Passed).next().is_none() {
            let found =
                "it passes no test, so it is not the answer of somebody who tried".to_owned();
            let remedy =
                format!("let `{file}` be right in an easy case, or test such a case in `{tests}`");
            self.falls_short(&about, found, remedy, String::new());
        }
    }

    /// Every test rejects something that no other rejects, or says why it is there.
    fn test(&mut self, test: &TestReport) {
        let about = format!("test {}", test.name);
        let place = format!("{}:{}", self.tests_file(), test.line);
        if test.why.as_ref().is_some_and(|why| !why.is_empty()) {
            return;
        }
        if test.rejects.is_empty() {
            let remedy = format!(
                "let it claim something (`{place}`), write the mutant that only it rejects, or say by `/// Why: …` above it why it is there"
            );
            let found = "it rejects neither the starter nor a mutant".to_owned();
            self.falls_short(&about, found, remedy, String::new());
        } else if test.alone.is_empty() {
            let remedy = format!(
                "say by `/// Why: …` above it why it is there (`{place}`), or write the mutant that only it rejects"
            );
            let found = "other tests reject all that it rejects".to_owned();
            self.falls_short(&about, found, remedy, String::new());
        }
    }

    /// The probes tell the solution and all mutants apart.
    fn probes(&mut self, trials: &[&Trial]) {
        let tests = self.tests_file();
        for trial in trials.iter().filter(|trial| trial.compiles()) {
            if trial.probes.is_none() {
                let found = format!("the {} gives no values", trial.candidate);
                let remedy = format!("return at least one value from `probes` in `{tests}`");
                self.falls_short("probes", found, remedy, String::new());
            }
        }
        for (index, a) in trials.iter().enumerate() {
            for b in &trials[..index] {
                if let (Some(x), Some(y)) = (&a.probes, &b.probes)
                    && behave_alike(x, y)
                {
                    let found = format!(
                        "they do not tell the {} and the {} apart",
                        b.candidate, a.candidate
                    );
                    let remedy =
                        format!("add an input on which the two differ to `probes` in `{tests}`");
                    self.falls_short("probes", found, remedy, x.join(", "));
                }
            }
        }
    }
}

/// What the compiler says, without the empty lines behind.
pub(super) fn rendered(diagnostics: &[Diagnostic]) -> String {
    let texts: Vec<&str> = diagnostics.iter().map(|d| d.rendered.trim_end()).collect();
    texts.join("\n")
}

/// What a test does to an answer.
pub(super) fn verb(outcome: TestOutcome) -> &'static str {
    match outcome {
        TestOutcome::Passed => "passes",
        TestOutcome::Rejected => "rejects",
        TestOutcome::Panicked => "meets a panic in",
        TestOutcome::Ended => "is ended by",
        TestOutcome::NotRun => "is not reached with",
    }
}

/// How a test that is no rejection ended.
fn end(result: &TestResult) -> &'static str {
    match result.outcome {
        TestOutcome::Panicked => "it panics",
        TestOutcome::Ended => "it ends the program or runs too long",
        _ => "it ends before a result",
    }
}
