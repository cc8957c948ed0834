//! The grades for a build server, as JUnit XML.

use std::time::Duration;

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

use super::grades::{Grade, Grades, Status};
use crate::workbook::checking::verdict::{TestOutcome, TestResult};

/// The grades as JUnit XML: a suite for each student, a case for each exercise.
///
/// Of the hidden tests it says only how many passed.
pub fn xml(grades: &Grades) -> quick_junit::Report {
    let mut whole = quick_junit::Report::new("grade");
    for student in &grades.students {
        let mut suite = TestSuite::new(&student.student);
        for grade in &student.exercises {
            let mut case = TestCase::new(grade.exercise.to_string(), status(grade));
            case.set_classname(&student.student);
            let verdicts = grade.verdict.iter().chain(&grade.hidden);
            let seconds: f64 = verdicts.map(|verdict| verdict.seconds).sum();
            case.set_time(Duration::try_from_secs_f64(seconds).unwrap_or_default());
            suite.add_test_case(case);
        }
        whole.add_test_suite(suite);
    }
    whole
}

fn status(grade: &Grade) -> TestCaseStatus {
    let kind = match grade.status {
        Status::Passed => return TestCaseStatus::success(),
        Status::Missing => {
            let mut status = TestCaseStatus::skipped();
            status.set_message("nothing was handed in");
            return status;
        }
        Status::NotChecked => NonSuccessKind::Error,
        Status::Failed | Status::DoesNotCompile | Status::Unusable => NonSuccessKind::Failure,
    };
    let mut status = TestCaseStatus::non_success(kind);
    status.set_message(grade.in_words());
    status.set_description(description(grade));
    status
}

fn description(grade: &Grade) -> String {
    let mut parts: Vec<String> = grade.reason.iter().cloned().collect();
    if let Some(verdict) = &grade.verdict {
        parts.extend(verdict.diagnostics.iter().map(|d| d.rendered.clone()));
        let failed = |test: &&TestResult| test.outcome != TestOutcome::Passed;
        let tests = verdict.tests.iter().filter(failed);
        parts.extend(tests.map(|test| format!("{}: {}", test.test, test.message)));
        parts.extend(verdict.misconception.iter().map(|m| m.text.clone()));
    }
    if let Some(hidden) = &grade.hidden {
        let (passed, all) = (hidden.passed_tests(), hidden.tests.len());
        parts.push(format!("hidden tests: {passed} of {all} passed"));
    }
    parts.join("\n\n")
}
