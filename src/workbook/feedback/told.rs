//! What there is to say about a verdict, in words without looks: the terminal paints them, the page marks them up.

use crate::workbook::checking::verdict::{Diagnostic, Outcome, TestOutcome, TestResult, Verdict};

/// How many lines of what an answer printed are shown.
const PRINTED: usize = 12;

/// How many errors of the compiler are shown; the later ones often come from the first.
const ERRORS: usize = 3;

/// What there is to say about a verdict, in the order in which it is said.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Told<'a> {
    /// How it ended, in a sentence or two.
    pub summary: String,
    /// What stands before the words of the compiler: that there are warnings.
    pub warnings: Option<String>,
    /// The words of the compiler that are shown.
    pub diagnostics: Vec<&'a Diagnostic>,
    /// That there are more.
    pub more_diagnostics: Option<String>,
    /// The test that failed first.
    pub failure: Option<Failure>,
    /// What the answer seems to have misunderstood, as a sentence.
    pub misconception: Option<String>,
    /// What else is not right yet, and what was not reached.
    pub others: Vec<String>,
    /// What the answer printed, line by line.
    pub printed: Vec<String>,
    /// That it printed more.
    pub more_printed: Option<String>,
}

/// A test that failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// What it is about.
    pub test: String,
    /// How it ended.
    pub ending: &'static str,
    /// What was tested, with which input, what is right and what was found.
    pub rows: Vec<Row>,
}

/// A line of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// What it is: `input`.
    pub name: &'static str,
    /// What it says; it may have several lines.
    pub text: String,
    /// Whether it is right or wrong; neither, for what was given.
    pub is_right: Option<bool>,
}

impl<'a> Told<'a> {
    /// What there is to say about this verdict.
    pub fn of(verdict: &'a Verdict) -> Self {
        let mut told = match verdict.outcome {
            Outcome::DoesNotCompile => does_not_compile(verdict),
            Outcome::Failed => failed(verdict),
            Outcome::Passed => passed(verdict),
            // An explanation is compared by its reader; the checklist tells the rest.
            Outcome::Open | Outcome::SelfAssessed => Self::new(String::new()),
        };
        let lines = collapsed(verdict.output.trim_end());
        if !verdict.output.trim().is_empty() {
            told.printed = lines.iter().take(PRINTED).cloned().collect();
        }
        if lines.len() > PRINTED {
            told.more_printed = Some(format!("… and {} lines more", lines.len() - PRINTED));
        }
        told
    }

    fn new(summary: String) -> Self {
        Self {
            summary,
            warnings: None,
            diagnostics: Vec::new(),
            more_diagnostics: None,
            failure: None,
            misconception: None,
            others: Vec::new(),
            printed: Vec::new(),
            more_printed: None,
        }
    }
}

/// The lines of a text; one that comes several times in a row stands once, with their number.
fn collapsed(text: &str) -> Vec<String> {
    let mut lines: Vec<(&str, usize)> = Vec::new();
    for line in text.lines() {
        match lines.last_mut() {
            Some((last, count)) if *last == line => *count += 1,
            _ => lines.push((line, 1)),
        }
    }
    let shown = |(line, count): (&str, usize)| {
        let line = without_controls(line);
        match count {
            1 => line,
            _ => format!("{line}  ({count} times)"),
        }
    };
    lines.into_iter().map(shown).collect()
}

/// What an answer prints must not paint or move the reader's cursor.
fn without_controls(line: &str) -> String {
    line.chars()
        .map(|c| if c.is_control() && c != '\t' { '·' } else { c })
        .collect()
}

fn does_not_compile(verdict: &Verdict) -> Told<'_> {
    let errors: Vec<&Diagnostic> = verdict
        .diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.level == "error")
        .collect();
    let count = match errors.len() {
        1 => "There is one error".to_owned(),
        count => format!("There are {count} errors"),
    };
    let in_tests = errors
        .iter()
        .any(|error| error.rendered.contains("/tests.rs:"));
    let what = if in_tests {
        "Your answer compiles alone, but the tests cannot use it. \
         Names, arguments and results must stay as the starter has them."
    } else {
        "Your answer does not compile yet."
    };
    let mut told = Told::new(format!("{what} {count}."));
    // Where a signature has changed, every call says the same.
    let shown = if in_tests { 1 } else { ERRORS };
    if errors.len() > shown {
        let more = errors.len() - shown;
        let words = format!("… and {more} more; the first ones often cause the others.");
        told.more_diagnostics = Some(words);
    }
    told.diagnostics = errors.into_iter().take(shown).collect();
    told
}

fn failed(verdict: &Verdict) -> Told<'_> {
    let all = verdict.tests.len();
    let mut told = Told::new(match verdict.passed_tests() {
        0 => format!("None of the {all} tests passed yet."),
        passed => format!("{passed} of {all} tests passed."),
    });
    let Some(first) = verdict.first_failure() else {
        return told;
    };
    told.failure = Some(Failure {
        test: words(&first.test),
        ending: ending(first.outcome),
        rows: finding(first),
    });
    told.misconception = verdict.misconception.as_ref().map(|misconception| {
        format!(
            "It looks as if you think: {}.",
            misconception.text.trim_end_matches('.')
        )
    });
    let (not_reached, wrong): (Vec<&TestResult>, Vec<&TestResult>) = verdict
        .tests
        .iter()
        .filter(|test| test.outcome != TestOutcome::Passed && test.test != first.test)
        .partition(|test| test.outcome == TestOutcome::NotRun);
    for (what, others) in [
        ("Not yet right either", wrong),
        ("Not reached", not_reached),
    ] {
        if !others.is_empty() {
            let names: Vec<String> = others.iter().map(|test| words(&test.test)).collect();
            told.others.push(format!("{what}: {}.", names.join(", ")));
        }
    }
    told
}

fn passed(verdict: &Verdict) -> Told<'_> {
    let names: Vec<String> = verdict.tests.iter().map(|test| words(&test.test)).collect();
    let mut told = Told::new(match names.as_slice() {
        [only] => format!("Right. Tested was: {only}."),
        _ => format!(
            "Right. All {} tests passed: {}.",
            names.len(),
            names.join(", ")
        ),
    });
    let warnings = verdict.warnings();
    if warnings > 0 {
        let count = if warnings == 1 {
            "a warning".to_owned()
        } else {
            format!("{warnings} warnings")
        };
        told.warnings = Some(format!("The compiler has {count} for you:"));
        told.diagnostics = verdict.diagnostics.iter().take(ERRORS).collect();
    }
    told
}

/// What the test of this name is about, in words: `both_ends` says “both ends”.
fn words(test: &str) -> String {
    test.replace('_', " ")
}

fn ending(outcome: TestOutcome) -> &'static str {
    match outcome {
        TestOutcome::Passed => "passed",
        TestOutcome::Rejected => "failed",
        TestOutcome::Panicked => "failed: your answer panicked",
        TestOutcome::Ended => "failed: your answer was ended",
        TestOutcome::NotRun => "was not reached",
    }
}

fn finding(test: &TestResult) -> Vec<Row> {
    let row = |name, text: &Option<String>, is_right| {
        text.clone().map(|text| Row {
            name,
            text,
            is_right,
        })
    };
    let mut rows: Vec<Row> = [
        row("tested", &test.claim, None),
        row("input", &test.input, None),
        row("expected", &test.expected, Some(true)),
        row("found", &test.found, Some(false)),
    ]
    .into_iter()
    .flatten()
    .collect();
    if rows.is_empty() || test.outcome == TestOutcome::Panicked {
        rows.push(Row {
            name: "because",
            text: without_proptest(test.message.trim()),
            is_right: None,
        });
    }
    rows
}

/// The words of a panic, without what proptest counts.
fn without_proptest(message: &str) -> String {
    let end = message.find("\n\tsuccesses:").unwrap_or(message.len());
    let text = message[..end].replace("minimal failing input: ", "with ");
    text.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_repeated_stands_once() {
        let text = "a\nmemory allocation failed\nmemory allocation failed\na\u{1b}";
        assert_eq!(
            collapsed(text),
            ["a", "memory allocation failed  (2 times)", "a·"]
        );
    }
}
