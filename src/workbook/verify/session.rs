//! Many exercises at once, on all cores, with the cache.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::cache::{self, Record};
use super::candidate::Candidate;
use super::judge::{exempt, judge};
use super::report::Report;
use super::trial;
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::{Checker, CheckingError};
use crate::workbook::parallel::{cores, in_parallel};

/// The report about an exercise, and how it came about.
#[derive(Debug, Clone)]
pub struct Verified {
    /// The report.
    pub report: Report,
    /// The report before the tests or the answers last changed, to tell what a new test adds.
    pub before: Option<Report>,
    /// Whether the report was taken from the cache.
    pub from_cache: bool,
}

/// How far the trials are.
#[derive(Debug, Clone)]
pub struct Progress<'a> {
    /// How many trials are finished.
    pub finished: usize,
    /// How many there are.
    pub all: usize,
    /// The exercise of the last one.
    pub exercise: &'a Exercise,
}

/// An exercise whose answers are being tried.
struct Open<'a> {
    /// Its place among the exercises asked for.
    place: usize,
    exercise: &'a Exercise,
    tested: &'a Tested,
    candidates: Vec<Candidate>,
    key: String,
    last: Option<Record>,
}

/// Verifies exercises, in parallel, and returns a report for each of them in the same order.
///
/// With `use_cache` an exercise that was found sound is not tried again until something changes.
/// `tell` is called whenever an answer has been tried.
///
/// # Errors
///
/// The compiler or a program does not start, or the cache cannot be written.
pub fn verify(
    checker: &Checker,
    exercises: &[&Exercise],
    use_cache: bool,
    tell: &(dyn Fn(Progress) + Sync),
) -> Result<Vec<Verified>, CheckingError> {
    let mut verified: Vec<Option<Verified>> = vec![None; exercises.len()];
    let mut open = Vec::new();
    for (place, &exercise) in exercises.iter().enumerate() {
        let Some(tested) = &exercise.tested else {
            verified[place] = Some(Verified {
                report: exempt(exercise),
                before: None,
                from_cache: false,
            });
            continue;
        };
        let key = cache::key(checker.library(), exercise, tested);
        let last = cache::read(checker, exercise);
        match last {
            Some(record) if use_cache && record.key == key && record.report.is_sound() => {
                verified[place] = Some(Verified {
                    report: record.report,
                    before: record.before,
                    from_cache: true,
                });
            }
            last => open.push(Open {
                place,
                exercise,
                tested,
                candidates: Candidate::all(exercise, tested),
                key,
                last,
            }),
        }
    }
    let all = open.iter().map(|open| open.candidates.len()).sum();
    let finished = AtomicUsize::new(0);
    let found = in_parallel(&open, cores(), |open| {
        let tell = || {
            tell(Progress {
                finished: finished.fetch_add(1, Ordering::Relaxed) + 1,
                all,
                exercise: open.exercise,
            });
        };
        Ok::<_, CheckingError>((open.place, open.verify(checker, &tell)?))
    })?;
    for (place, result) in found {
        verified[place] = Some(result);
    }
    // Each exercise has its report now.
    Ok(verified.into_iter().flatten().collect())
}

impl Open<'_> {
    /// Tries all answers, judges the exercise and writes the record.
    fn verify(
        &self,
        checker: &Checker,
        tell: &(dyn Fn() + Sync),
    ) -> Result<Verified, CheckingError> {
        let trials = trial::run(checker, self.tested, &self.candidates, tell)?;
        let report = judge(self.exercise, self.tested, &trials);
        let record = Record {
            key: self.key.clone(),
            before: self.before(),
            report,
        };
        cache::write(checker, self.exercise, &record)?;
        Ok(Verified {
            report: record.report,
            before: record.before,
            from_cache: false,
        })
    }

    /// The last report about another state of the exercise.
    fn before(&self) -> Option<Report> {
        let last = self.last.as_ref()?;
        if last.key == self.key {
            last.before.clone()
        } else {
            Some(last.report.clone())
        }
    }
}
