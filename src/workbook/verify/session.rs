//! Many exercises at once, on all cores, with the cache.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use super::cache::{self, Record};
use super::candidate::Candidate;
use super::judge::{exempt, judge};
use super::report::Report;
use super::trial::{self, Trial};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::{Checker, CheckingError};

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
    key: String,
    last: Option<Record>,
    trials: Mutex<Vec<Option<Trial>>>,
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
    let mut jobs: Vec<(usize, usize, Candidate)> = Vec::new();
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
            last => {
                let candidates = Candidate::all(exercise, tested);
                let trials = Mutex::new(vec![None; candidates.len()]);
                let which = open.len();
                let numbered = candidates.into_iter().enumerate();
                jobs.extend(numbered.map(|(number, candidate)| (which, number, candidate)));
                open.push(Open {
                    place,
                    exercise,
                    tested,
                    key,
                    last,
                    trials,
                });
            }
        }
    }

    let (next, finished) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let found: Mutex<Vec<(usize, Result<Verified, CheckingError>)>> = Mutex::new(Vec::new());
    let work = || {
        while let Some((which, number, candidate)) = jobs.get(next.fetch_add(1, Ordering::Relaxed))
        {
            let open = &open[*which];
            let result = open.try_out(checker, *number, candidate.clone());
            let result = match result {
                Ok(None) => None,
                Ok(Some(verified)) => Some(Ok(verified)),
                Err(error) => {
                    // The same would happen to the others.
                    next.store(jobs.len(), Ordering::Relaxed);
                    Some(Err(error))
                }
            };
            if let Some(result) = result {
                lock(&found).push((open.place, result));
            }
            tell(Progress {
                finished: finished.fetch_add(1, Ordering::Relaxed) + 1,
                all: jobs.len(),
                exercise: open.exercise,
            });
        }
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..cores.min(jobs.len()) {
            scope.spawn(work);
        }
    });
    for (place, result) in found.into_inner().unwrap_or_else(PoisonError::into_inner) {
        verified[place] = Some(result?);
    }
    // Without an error each exercise has its report.
    Ok(verified.into_iter().flatten().collect())
}

impl Open<'_> {
    /// Tries one answer; after the last one the exercise is judged and the record written.
    fn try_out(
        &self,
        checker: &Checker,
        number: usize,
        candidate: Candidate,
    ) -> Result<Option<Verified>, CheckingError> {
        let trial = trial::run(checker, self.exercise, self.tested, candidate)?;
        let trials: Vec<Trial> = {
            let mut trials = lock(&self.trials);
            trials[number] = Some(trial);
            if trials.iter().any(Option::is_none) {
                return Ok(None);
            }
            trials.drain(..).flatten().collect()
        };
        let report = judge(self.exercise, self.tested, &trials);
        let record = Record {
            key: self.key.clone(),
            before: self.before(),
            report,
        };
        cache::write(checker, self.exercise, &record)?;
        Ok(Some(Verified {
            report: record.report,
            before: record.before,
            from_cache: false,
        }))
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

/// The content of a lock; a thread that panicked while it held it has not left it half written.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
