//! All submissions, on all cores.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use super::assignment::Assignment;
use super::grades::{Grade, Grades, Status, StudentGrades};
use super::submissions::{Student, Submissions};
use crate::workbook::checking::{Answer, Checker, CheckingError, Outcome};

/// The seed of the random inputs: that of `check`, so that who passes there passes here.
pub(super) const SEED: u64 = 1;

/// Grades all submissions, in parallel; `tell` is called whenever one is finished, with its student.
///
/// A check that cannot run is told in its own cell; the others go on.
pub fn grade(
    checker: &Checker,
    submissions: &Submissions,
    assignments: &[Assignment],
    tell: &(dyn Fn(&Student) + Sync),
) -> Grades {
    let cells: Vec<(&Student, &Assignment)> = submissions
        .students
        .iter()
        .flat_map(|student| assignments.iter().map(move |of| (student, of)))
        .collect();
    let graded: Mutex<Vec<Option<Grade>>> = Mutex::new(vec![None; cells.len()]);
    let next = AtomicUsize::new(0);
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some((student, assignment)) = cells.get(index) else {
                break;
            };
            let grade = one(checker, student, assignment);
            graded.lock().unwrap_or_else(PoisonError::into_inner)[index] = Some(grade);
            tell(student);
        }
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..cores.min(cells.len()) {
            scope.spawn(work);
        }
    });
    let mut graded = graded
        .into_inner()
        .unwrap_or_else(PoisonError::into_inner)
        .into_iter()
        .flatten();
    Grades {
        isolation: checker.isolation().to_string(),
        exercises: assignments
            .iter()
            .map(|of| of.exercise.name.clone())
            .collect(),
        students: submissions
            .students
            .iter()
            .map(|student| StudentGrades {
                student: student.name.clone(),
                exercises: graded.by_ref().take(assignments.len()).collect(),
            })
            .collect(),
        remarks: submissions.remarks.clone(),
    }
}

/// The grade of one exercise of one student.
fn one(checker: &Checker, student: &Student, assignment: &Assignment) -> Grade {
    let name = &assignment.exercise.name;
    let unchecked = |status, reason| Grade::unchecked(name, status, assignment.tests(), reason);
    let Some(submission) = student.answers.get(name) else {
        return unchecked(Status::Missing, None);
    };
    match &submission.source {
        Err(reason) => unchecked(Status::Unusable, Some(reason.clone())),
        Ok(text) => {
            let answer = Answer {
                shown_as: submission.file.clone(),
                text: text.clone(),
            };
            check(checker, assignment, &answer)
                .unwrap_or_else(|e| unchecked(Status::NotChecked, Some(e.to_string())))
        }
    }
}

fn check(
    checker: &Checker,
    assignment: &Assignment,
    answer: &Answer,
) -> Result<Grade, CheckingError> {
    let check = |tested| checker.check(assignment.exercise, tested, answer, SEED);
    let verdict = check(assignment.tested)?;
    let hidden = match &assignment.hidden {
        Some(hidden) if verdict.outcome != Outcome::DoesNotCompile => Some(check(hidden)?),
        _ => None,
    };
    Ok(Grade::of(verdict, hidden, assignment.tests()))
}
