//! What `grade --json` prints.

use serde::Serialize;

use super::submissions::Remark;
use crate::book::exercise::ExerciseName;
use crate::workbook::checking::{Outcome, Verdict};

/// How it stands with one exercise of one student.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Every test passed.
    Passed,
    /// A test failed.
    Failed,
    /// The answer does not compile, or not with the tests.
    DoesNotCompile,
    /// The file cannot be used: too large, a link, no text.
    Unusable,
    /// Nothing was handed in.
    Missing,
    /// The check itself could not run; it says nothing about the answer.
    NotChecked,
}

/// The grade of one exercise of one student.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Grade {
    /// The exercise.
    pub exercise: ExerciseName,
    /// How it stands.
    pub status: Status,
    /// Why the file is unusable or was not checked.
    pub reason: Option<String>,
    /// How many tests passed, hidden ones included.
    pub passed: usize,
    /// How many tests there are, hidden ones included.
    pub tests: usize,
    /// What a check says, as `check --json` does.
    pub verdict: Option<Verdict>,
    /// The same for the hidden tests.
    pub hidden: Option<Verdict>,
}

/// The grades of one student.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StudentGrades {
    /// The name of the student's folder.
    pub student: String,
    /// A grade for each exercise that is graded.
    pub exercises: Vec<Grade>,
}

/// All grades.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Grades {
    /// What kept the submissions apart.
    pub isolation: String,
    /// The exercises that are graded, in the order of the book.
    pub exercises: Vec<ExerciseName>,
    /// The students, by name.
    pub students: Vec<StudentGrades>,
    /// What belongs to nobody's grade.
    pub remarks: Vec<Remark>,
}

impl Grade {
    /// A grade without a check.
    pub fn unchecked(
        exercise: &ExerciseName,
        status: Status,
        tests: usize,
        reason: Option<String>,
    ) -> Self {
        Self {
            exercise: exercise.clone(),
            status,
            reason,
            passed: 0,
            tests,
            verdict: None,
            hidden: None,
        }
    }

    /// The grade that a check gives.
    pub fn of(verdict: Verdict, hidden: Option<Verdict>, tests: usize) -> Self {
        let verdicts = || std::iter::once(&verdict).chain(&hidden);
        let passed: usize = verdicts().map(Verdict::passed_tests).sum();
        let status = if verdict.outcome == Outcome::DoesNotCompile {
            Status::DoesNotCompile
        } else if verdicts().all(Verdict::passed) && passed == tests {
            Status::Passed
        } else {
            Status::Failed
        };
        Self {
            passed,
            hidden,
            ..Self {
                verdict: Some(verdict.clone()),
                ..Self::unchecked(&verdict.exercise, status, tests, None)
            }
        }
    }

    /// The grade in a cell of a table.
    pub fn in_words(&self) -> String {
        match self.status {
            Status::Passed => "passed".into(),
            Status::Failed => format!("{} of {}", self.passed, self.tests),
            Status::DoesNotCompile => "does not compile".into(),
            Status::Unusable => "unusable".into(),
            Status::Missing => "missing".into(),
            Status::NotChecked => "not checked".into(),
        }
    }
}

impl StudentGrades {
    /// How many exercises passed.
    pub fn passed(&self) -> usize {
        let passed = |grade: &&Grade| grade.status == Status::Passed;
        self.exercises.iter().filter(passed).count()
    }
}

impl Grades {
    /// All grades, student by student.
    pub fn iter(&self) -> impl Iterator<Item = (&StudentGrades, &Grade)> {
        self.students.iter().flat_map(|student| {
            let grades = student.exercises.iter();
            grades.map(move |grade| (student, grade))
        })
    }

    /// How many grades have this status.
    pub fn count(&self, status: Status) -> usize {
        self.iter()
            .filter(|(_, grade)| grade.status == status)
            .count()
    }

    /// Whether everything that was handed in passed.
    pub fn all_passed(&self) -> bool {
        self.iter()
            .all(|(_, grade)| matches!(grade.status, Status::Passed | Status::Missing))
    }
}
