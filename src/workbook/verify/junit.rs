//! The report for a build server, as JUnit XML.

use std::time::Duration;

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

use super::report::{Report, Shortcoming};
use super::session::Verified;

/// The reports as JUnit XML: a suite for each exercise, a case for each answer, each test and the probes.
pub fn xml(verified: &[Verified]) -> quick_junit::Report {
    let mut whole = quick_junit::Report::new("verify");
    for verified in verified {
        whole.add_test_suite(suite(&verified.report));
    }
    whole
}

fn suite(report: &Report) -> TestSuite {
    let name = report.exercise.to_string();
    let mut suite = TestSuite::new(&name);
    suite.set_time(Duration::try_from_secs_f64(report.seconds).unwrap_or_default());
    let answers = report
        .matrix
        .iter()
        .flatten()
        .map(|column| column.answer.clone());
    let tests = report
        .tests
        .iter()
        .flatten()
        .map(|test| format!("test {}", test.name));
    let probes = report.matrix.iter().map(|_| "probes".to_owned());
    let mut cases: Vec<String> = answers.chain(tests).chain(probes).collect();
    // What is left to do, mistakes in the files, hidden tests.
    for shortcoming in &report.shortcomings {
        if !cases.contains(&shortcoming.about) {
            cases.push(shortcoming.about.clone());
        }
    }
    for about in cases {
        let shortcomings: Vec<&Shortcoming> = report
            .shortcomings
            .iter()
            .filter(|s| s.about == about)
            .collect();
        let mut case = TestCase::new(about, status(&shortcomings));
        case.set_classname(&name);
        suite.add_test_case(case);
    }
    if report.matrix.is_none() && report.kind.is_some() {
        let mut status = TestCaseStatus::skipped();
        status.set_message("an explanation has no program to verify");
        let mut case = TestCase::new("explanation", status);
        case.set_classname(&name);
        suite.add_test_case(case);
    }
    suite
}

fn status(shortcomings: &[&Shortcoming]) -> TestCaseStatus {
    let Some(first) = shortcomings.first() else {
        return TestCaseStatus::success();
    };
    let texts: Vec<String> = shortcomings
        .iter()
        .map(|s| format!("{}\n{}\nnext step: {}", s.found, s.details, s.remedy))
        .collect();
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(&first.found);
    status.set_description(texts.join("\n\n"));
    status
}
