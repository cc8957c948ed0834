//! A verdict for the terminal.

use super::paint::{ATTENTION, BAD, CODE, FAINT, GOOD, STRONG, paint, table, wrapped};
use super::told::{Failure, Row, Told};
use crate::workbook::checking::verdict::{Diagnostic, Outcome, Verdict};

/// The result of a check in words, without what comes after it.
///
/// `picture` is the picture for the terminal.
pub fn described(verdict: &Verdict, title: &str, picture: Option<&str>) -> String {
    let told = Told::of(verdict);
    let mut text = heading(verdict, title);
    text.push_str(&format!("\n{}", wrapped(&told.summary, "", "")));
    if let Some(warnings) = &told.warnings {
        text.push_str(&format!("\n{warnings}\n"));
    }
    if !told.diagnostics.is_empty() {
        text.push('\n');
    }
    for diagnostic in &told.diagnostics {
        text.push_str(&rendered(diagnostic));
    }
    if let Some(more) = &told.more_diagnostics {
        text.push_str(&format!("{more}\n"));
    }
    if verdict.outcome == Outcome::DoesNotCompile {
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    if let Some(failure) = &told.failure {
        text.push_str(&failed(failure));
    }
    if let Some(picture) = picture.filter(|_| told.failure.is_some()) {
        text.push('\n');
        for line in picture.lines() {
            text.push_str(&format!("  {line}\n"));
        }
    }
    if let Some(misconception) = &told.misconception {
        text.push('\n');
        text.push_str(&wrapped(misconception, &paint(ATTENTION, "» "), "  "));
    }
    for line in &told.others {
        text.push('\n');
        text.push_str(&paint(FAINT, wrapped(line, "", "").trim_end()));
        text.push('\n');
    }
    if !told.printed.is_empty() {
        text.push_str(&format!("\n{}\n", paint(FAINT, "Your answer printed:")));
    }
    for line in told.printed.iter().chain(&told.more_printed) {
        text.push_str(&format!("  {line}\n"));
    }
    text
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
            format!("· {} · {:.1} s", verdict.exercise, verdict.seconds)
        ),
    )
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

/// The test that failed first, and what it has found.
fn failed(failure: &Failure) -> String {
    let painted = |row: &Row| match row.is_right {
        Some(is_right) => paint(if is_right { GOOD } else { BAD }, &row.text),
        None => row.text.clone(),
    };
    let rows = failure.rows.iter().map(|row| (row.name, painted(row)));
    format!(
        "\n{} {}\n{}",
        paint(STRONG, format!("“{}”", failure.test)),
        paint(BAD, failure.ending),
        table(&rows.collect::<Vec<_>>(), "  ")
    )
}

/// A command as the reader types it; its blanks do not break ([`super::paint::printable`]).
pub fn command(arguments: &str) -> String {
    let text = format!("`cargo run -- {arguments}`");
    paint(CODE, text.replace(' ', "\u{a0}"))
}
