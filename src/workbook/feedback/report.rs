//! A verdict in words.

use super::paint::{ATTENTION, BAD, CODE, FAINT, GOOD, STRONG, paint, table, wrapped};
use crate::workbook::checking::verdict::{Diagnostic, Outcome, TestOutcome, TestResult, Verdict};

/// How many lines of what an answer printed are shown.
const PRINTED: usize = 12;

/// How many errors of the compiler are shown; the later ones often come from the first.
const ERRORS: usize = 3;

/// The result of a check in words, without what comes after it.
///
/// `picture` is the picture for the terminal.
pub fn described(verdict: &Verdict, title: &str, picture: Option<&str>) -> String {
    let mut text = heading(verdict, title);
    match verdict.outcome {
        Outcome::DoesNotCompile => does_not_compile(verdict, &mut text),
        Outcome::Failed => failed(verdict, picture, &mut text),
        Outcome::Passed => passed(verdict, &mut text),
        // An explanation is compared by its reader; `check` shows him the checklist instead.
        Outcome::Open | Outcome::SelfAssessed => {}
    }
    if !verdict.output.trim().is_empty() {
        let lines = collapsed(verdict.output.trim_end());
        text.push_str(&format!("\n{}\n", paint(FAINT, "Your answer printed:")));
        for line in lines.iter().take(PRINTED) {
            text.push_str(&format!("  {line}\n"));
        }
        if lines.len() > PRINTED {
            text.push_str(&format!("  … and {} lines more\n", lines.len() - PRINTED));
        }
    }
    text
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

fn heading(verdict: &Verdict, title: &str) -> String {
    let (sign, style) = match verdict.outcome {
        Outcome::Passed | Outcome::SelfAssessed => ("✓", GOOD),
        _ => ("✗", BAD),
    };
    format!(
        "{} {} {}\n",
        paint(style, sign),
        paint(STRONG, title),
        paint(
            FAINT,
            format!("{} · {:.1} s", verdict.exercise, verdict.seconds)
        ),
    )
}

fn does_not_compile(verdict: &Verdict, text: &mut String) {
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
    let sentence = format!("{what} {count}.");
    text.push_str(&format!("\n{}\n", wrapped(&sentence, "", "")));
    for error in errors.iter().take(ERRORS) {
        text.push_str(&rendered(error));
    }
    if errors.len() > ERRORS {
        let more = errors.len() - ERRORS;
        let line = format!("… and {more} more; the first ones often cause the others.\n");
        text.push_str(&line);
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
}

/// The words of the compiler, with a coloured beginning.
fn rendered(diagnostic: &Diagnostic) -> String {
    let style = if diagnostic.level == "error" {
        BAD
    } else {
        ATTENTION
    };
    let text = diagnostic.rendered.trim_end();
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let (head, words) = first.split_once(": ").unwrap_or(("", first));
    let head = if head.is_empty() {
        String::new()
    } else {
        paint(style, format!("{head}: "))
    };
    format!("{head}{}\n{rest}\n\n", paint(STRONG, words))
}

fn failed(verdict: &Verdict, picture: Option<&str>, text: &mut String) {
    let passed = verdict
        .tests
        .iter()
        .filter(|test| test.outcome == TestOutcome::Passed)
        .count();
    let all = verdict.tests.len();
    text.push_str(&match passed {
        0 => format!("\nNone of the {all} tests passed yet.\n"),
        _ => format!("\n{passed} of {all} tests passed.\n"),
    });
    let Some(first) = verdict.first_failure() else {
        return;
    };
    text.push_str(&format!(
        "\n{} {}\n",
        paint(STRONG, words(&first.test)),
        paint(BAD, ending(first.outcome))
    ));
    text.push_str(&finding(first));
    if let Some(picture) = picture {
        text.push('\n');
        for line in picture.lines() {
            text.push_str(&format!("  {line}\n"));
        }
    }
    if let Some(misconception) = &verdict.misconception {
        let sentence = format!(
            "It looks as if you think: {}.",
            misconception.text.trim_end_matches('.')
        );
        text.push('\n');
        text.push_str(&wrapped(&sentence, &paint(ATTENTION, "» "), "  "));
    }
    let (not_reached, wrong): (Vec<&TestResult>, Vec<&TestResult>) = verdict
        .tests
        .iter()
        .filter(|test| test.outcome != TestOutcome::Passed && test.test != first.test)
        .partition(|test| test.outcome == TestOutcome::NotRun);
    for (what, others) in [
        ("Not yet right either", wrong),
        ("Not reached", not_reached),
    ] {
        if others.is_empty() {
            continue;
        }
        let names: Vec<String> = others.iter().map(|test| words(&test.test)).collect();
        let line = format!("{what}: {}.", names.join(", "));
        text.push('\n');
        text.push_str(&paint(FAINT, wrapped(&line, "", "").trim_end()));
        text.push('\n');
    }
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

/// What was tested, with which input, what is right and what was found.
fn finding(test: &TestResult) -> String {
    let mut rows: Vec<(&str, String)> = Vec::new();
    let mut row = |name: &'static str, text: &Option<String>, style| {
        if let Some(text) = text {
            rows.push((name, style_lines(text, style)));
        }
    };
    row("tested", &test.claim, None);
    row("input", &test.input, None);
    row("expected", &test.expected, Some(GOOD));
    row("found", &test.found, Some(BAD));
    if rows.is_empty() {
        let message = test.message.trim();
        rows.push(("because", without_proptest(message)));
    } else if test.outcome == TestOutcome::Panicked {
        rows.push(("because", without_proptest(test.message.trim())));
    }
    table(&rows, "  ")
}

fn style_lines(text: &str, style: Option<anstyle::Style>) -> String {
    match style {
        Some(style) => paint(style, text),
        None => text.to_owned(),
    }
}

/// The words of a panic, without what proptest counts.
fn without_proptest(message: &str) -> String {
    let end = message.find("\n\tsuccesses:").unwrap_or(message.len());
    let text = message[..end].replace("minimal failing input: ", "with ");
    text.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

fn passed(verdict: &Verdict, text: &mut String) {
    let names: Vec<String> = verdict.tests.iter().map(|test| words(&test.test)).collect();
    let line = match names.as_slice() {
        [only] => format!("Right. Tested was: {only}."),
        _ => format!(
            "Right. All {} tests passed: {}.",
            names.len(),
            names.join(", ")
        ),
    };
    text.push('\n');
    text.push_str(&wrapped(&line, "", ""));
    let warnings = verdict.warnings();
    if warnings > 0 {
        let count = if warnings == 1 {
            "a warning".to_owned()
        } else {
            format!("{warnings} warnings")
        };
        text.push_str(&format!("\nThe compiler has {count} for you:\n\n"));
        for diagnostic in verdict.diagnostics.iter().take(ERRORS) {
            text.push_str(&rendered(diagnostic));
        }
    }
}

/// A command as the reader types it; its blanks do not break ([`super::paint::printable`]).
pub fn command(arguments: &str) -> String {
    let text = format!("`cargo run -- {arguments}`");
    paint(CODE, text.replace(' ', "\u{a0}"))
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
