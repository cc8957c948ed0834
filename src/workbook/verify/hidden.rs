//! Hidden tests are proved as well: they accept what is right, and reject what nothing else rejects.

use super::candidate::{Candidate, Role};
use super::judge::{self, rendered, verb};
use super::report::{HiddenReport, Report, Shortcoming, TestReport};
use super::trial::{self, Compilation, Trial, first_failure};
use crate::book::exercise::{Exercise, HiddenTests, Tested};
use crate::workbook::checking::{Checker, CheckingError};

/// Tries the answers of an exercise with the hidden tests, and adds what was found to its report.
///
/// # Errors
///
/// The compiler or a program does not start.
pub fn add(
    checker: &Checker,
    exercise: &Exercise,
    tested: &Tested,
    hidden: &HiddenTests,
    report: &mut Report,
) -> Result<(), CheckingError> {
    let with_hidden = hidden.instead_of(tested);
    let more: Vec<Candidate> = hidden
        .mutants
        .iter()
        .map(|mutant| Candidate::of(Role::HiddenMutant, mutant))
        .collect();
    let mut all = Candidate::all(exercise, tested);
    all.extend(more.iter().cloned());
    let trials = trial::run(checker, &with_hidden, &all, &|| {})?;
    // The answers of the exercise have met its own tests already, the wrong answers beside the hidden ones have not.
    let with_own_tests = trial::run(checker, tested, &more, &|| {})?;

    let mut judge = Judge {
        hidden,
        shortcomings: Vec::new(),
    };
    for trial in &trials {
        judge.trial(trial);
    }
    for trial in &with_own_tests {
        judge.is_of_the_hidden_tests(trial);
    }
    let is_rejected_elsewhere = |trial: &Trial| match trial.candidate.role {
        Role::Starter => report.starter.as_ref().is_some_and(|s| s.rejected),
        Role::Mutant => {
            let mut mutants = report.mutants.iter().flatten();
            mutants.any(|m| m.name == trial.candidate.name && m.rejected)
        }
        _ => {
            let mut others = with_own_tests.iter();
            others.any(|other| {
                other.candidate.name == trial.candidate.name
                    && first_failure(&other.results).is_some()
            })
        }
    };
    let tests = judge::tests(&hidden.tests.tests, &trials, is_rejected_elsewhere);
    for test in &tests {
        judge.test(test);
    }
    report.shortcomings.extend(judge.shortcomings);
    report.seconds += trials
        .iter()
        .chain(&with_own_tests)
        .map(|t| t.seconds)
        .sum::<f64>();
    report.hidden = Some(HiddenReport {
        file: hidden.tests.file.clone(),
        tests,
        matrix: judge::matrix(&trials),
    });
    Ok(())
}

/// Collects what falls short.
struct Judge<'a> {
    hidden: &'a HiddenTests,
    shortcomings: Vec<Shortcoming>,
}

impl Judge<'_> {
    fn falls_short(&mut self, about: String, found: String, remedy: String, details: String) {
        self.shortcomings.push(Shortcoming {
            about,
            found,
            remedy,
            details,
        });
    }

    fn tests_file(&self) -> String {
        self.hidden.tests.file.display().to_string()
    }

    /// The tests compile with every answer; the right ones pass, and the wrong ones beside the tests are rejected.
    fn trial(&mut self, trial: &Trial) {
        let about = trial.candidate.to_string();
        let tests = self.tests_file();
        let own = trial.candidate.source.shown_as.clone();
        let is_hidden = trial.candidate.role == Role::HiddenMutant;
        match &trial.compilation {
            Compilation::Compiled(warnings) if is_hidden && !warnings.is_empty() => {
                let found = "it compiles with warnings".to_owned();
                self.falls_short(about, found, format!("mend `{own}`"), rendered(warnings));
                return;
            }
            Compilation::Compiled(_) => {}
            // What is of the exercise is told in its own report.
            Compilation::Refused(_) if !is_hidden => return,
            Compilation::Refused(errors) => {
                let found = "it does not compile".to_owned();
                self.falls_short(about, found, format!("mend `{own}`"), rendered(errors));
                return;
            }
            Compilation::RefusedWithTests(errors) => {
                let found = "the hidden tests do not compile with it".to_owned();
                let remedy = match is_hidden {
                    true => {
                        format!("give `{own}` the same public functions as the solution has")
                    }
                    false => format!("mend `{tests}`"),
                };
                self.falls_short(about, found, remedy, rendered(errors));
                return;
            }
        }
        if trial.candidate.is_wrong() {
            if is_hidden && !trial.is_rejected() {
                let found = "no assertion of a hidden test rejects it".to_owned();
                let remedy =
                    format!("write a test in `{tests}` that it fails, or take `{own}` out");
                self.falls_short(about, found, remedy, String::new());
            }
            return;
        }
        let failure = first_failure(&trial.results).map(|failure| (failure, String::new()));
        let with_seed = trial.failing_seed.as_ref();
        let with_seed = with_seed.map(|(seed, f)| (f, format!(", with the seed {seed}")));
        if let Some((failure, when)) = failure.or(with_seed) {
            let verb = verb(failure.outcome);
            let found = format!("the hidden test `{}` {verb} it{when}", failure.test);
            let remedy = format!("let `{tests}` accept every right answer");
            self.falls_short(about, found, remedy, failure.message.clone());
        }
    }

    /// A wrong answer beside the hidden tests is one that the tests of the exercise do not reject.
    fn is_of_the_hidden_tests(&mut self, trial: &Trial) {
        let (found, details) = match (&trial.compilation, first_failure(&trial.results)) {
            (Compilation::RefusedWithTests(errors), _) => {
                let found = "the tests of the exercise do not compile with it".to_owned();
                (found, rendered(errors))
            }
            (_, Some(failure)) => {
                let (test, verb) = (&failure.test, verb(failure.outcome));
                let found = format!("the test `{test}` of the exercise {verb} it already");
                (found, failure.message.clone())
            }
            _ => return,
        };
        let remedy = format!(
            "take `{}` out, or let it pass the tests that readers see",
            trial.candidate.source.shown_as
        );
        self.falls_short(trial.candidate.to_string(), found, remedy, details);
    }

    /// Every hidden test rejects something that no other test rejects, or says why it is there.
    fn test(&mut self, test: &TestReport) {
        if test.why.as_ref().is_some_and(|why| !why.is_empty()) || !test.alone.is_empty() {
            return;
        }
        let found = match test.rejects.is_empty() {
            true => "it rejects neither the starter nor a wrong answer",
            false => "other tests reject all that it rejects",
        };
        let folder = self.hidden.tests.file.with_file_name("mutants");
        let remedy = format!(
            "write the wrong answer that only it rejects into `{}`, or say by `/// Why: …` above it why it is there (`{}:{}`)",
            folder.display(),
            self.tests_file(),
            test.line
        );
        let about = format!("hidden test {}", test.name);
        self.falls_short(about, found.to_owned(), remedy, String::new());
    }
}
