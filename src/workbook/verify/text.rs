//! The report for people.

use std::fmt::{self, Write};

use anstyle::{AnsiColor, Style};

use super::report::{Column, HiddenReport, Report, Shortcoming, TestReport};
use super::session::Verified;
use crate::workbook::checking::verdict::TestOutcome;

const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default();
const FAINT: Style = Style::new().dimmed();

/// The reports on some exercises: a line each, below it what falls short and what to do.
#[derive(Debug, Clone, Copy)]
pub struct Text<'a> {
    /// The reports.
    pub verified: &'a [Verified],
    /// Whether to show which test rejects which answer.
    pub matrix: bool,
}

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.verified.iter().map(|v| v.report.exercise.to_string());
        let width = names.map(|name| name.chars().count()).max().unwrap_or(0);
        for verified in self.verified {
            line(f, verified, width)?;
            for shortcoming in &verified.report.shortcomings {
                falls_short(f, shortcoming)?;
            }
            if self.matrix {
                matrix(f, verified)?;
            }
            if let Some(hidden) = &verified.report.hidden {
                with_hidden(f, hidden, self.matrix)?;
            }
        }
        summary(f, self.verified)
    }
}

fn line(f: &mut fmt::Formatter<'_>, verified: &Verified, width: usize) -> fmt::Result {
    let report = &verified.report;
    let (style, sign) = if report.is_sound() {
        (GOOD, "✓")
    } else {
        (BAD, "✗")
    };
    let name = report.exercise.to_string();
    write!(f, "{style}{sign}{style:#} {name:width$}  {FAINT}")?;
    match (&report.mutants, &report.tests) {
        (Some(mutants), Some(tests)) => {
            let mutants = count(mutants.len(), "mutant");
            let tests = count(tests.len(), "test");
            write!(f, "{tests}, {mutants}, ")?;
            if verified.from_cache {
                f.write_str("unchanged since it was verified")?;
            } else {
                write!(f, "{:.1} s", report.seconds)?;
            }
        }
        _ => match report.kind {
            Some(kind) => write!(f, "{}: nothing to verify", kind.title())?,
            None => f.write_str("cannot be read")?,
        },
    }
    writeln!(f, "{FAINT:#}")
}

fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn falls_short(f: &mut fmt::Formatter<'_>, shortcoming: &Shortcoming) -> fmt::Result {
    let Shortcoming {
        about,
        found,
        remedy,
        details,
    } = shortcoming;
    writeln!(f, "    {BAD}{about}{BAD:#}: {found}")?;
    for line in details.lines() {
        writeln!(f, "        {FAINT}{line}{FAINT:#}")?;
    }
    writeln!(f, "        next step: {remedy}")
}

/// Which test rejects which answer, and what the tests bring that are new.
fn matrix(f: &mut fmt::Formatter<'_>, verified: &Verified) -> fmt::Result {
    let report = &verified.report;
    let (Some(tests), Some(columns)) = (&report.tests, &report.matrix) else {
        return Ok(());
    };
    table(f, tests, columns)?;
    news(f, report, verified.before.as_ref())
}

/// What the hidden tests of a pack bring that the tests of the exercise do not.
fn with_hidden(f: &mut fmt::Formatter<'_>, hidden: &HiddenReport, matrix: bool) -> fmt::Result {
    writeln!(f, "    hidden tests in {}", hidden.file.display())?;
    if matrix {
        table(f, &hidden.tests, &hidden.matrix)?;
    }
    for test in &hidden.tests {
        let name = &test.name;
        let what = match test.alone.as_slice() {
            [] => "nothing that nothing else rejects".to_owned(),
            alone => format!("what nothing else rejects: {}", alone.join(", ")),
        };
        writeln!(f, "    hidden: `{name}` rejects {what}")?;
    }
    Ok(())
}

/// A line for each test, a column for each answer.
fn table(f: &mut fmt::Formatter<'_>, tests: &[TestReport], columns: &[Column]) -> fmt::Result {
    let width = tests.iter().map(|t| t.name.chars().count()).max();
    let width = width.unwrap_or(0);
    let letters: Vec<char> = ('a'..='z').chain('A'..='Z').collect();
    let letter = |index: usize| letters.get(index).copied().unwrap_or('?');
    write!(f, "    {:width$} ", "")?;
    for index in 0..columns.len() {
        write!(f, " {}", letter(index))?;
    }
    writeln!(f)?;
    for (row, test) in tests.iter().enumerate() {
        write!(f, "    {:width$} ", test.name)?;
        for column in columns {
            let outcome = column.outcomes.get(row).copied();
            write!(f, " {}", sign(outcome))?;
        }
        if !test.alone.is_empty() {
            write!(f, "  alone rejects {}", test.alone.join(", "))?;
        }
        writeln!(f)?;
    }
    for (index, column) in columns.iter().enumerate() {
        let note = if column.outcomes.is_empty() {
            " (does not compile)"
        } else {
            ""
        };
        writeln!(f, "    {} {}{note}", letter(index), column.answer)?;
    }
    writeln!(
        f,
        "    {FAINT}✗ rejects  · passes  ! panics  … ends or runs too long  ? not reached{FAINT:#}"
    )
}

fn sign(outcome: Option<TestOutcome>) -> char {
    match outcome {
        Some(TestOutcome::Passed) => '·',
        Some(TestOutcome::Rejected) => '✗',
        Some(TestOutcome::Panicked) => '!',
        Some(TestOutcome::Ended) => '…',
        Some(TestOutcome::NotRun) => '?',
        None => ' ',
    }
}

/// What each test that was not there the last time rejects and no older test does.
fn news(f: &mut fmt::Formatter<'_>, report: &Report, before: Option<&Report>) -> fmt::Result {
    let (Some(tests), Some(before)) = (&report.tests, before.and_then(|b| b.tests.as_ref())) else {
        return Ok(());
    };
    let is_new = |test: &&TestReport| !before.iter().any(|old| old.name == test.name);
    let old: Vec<&TestReport> = tests.iter().filter(|test| !is_new(test)).collect();
    for test in tests.iter().filter(is_new) {
        let mut text = String::new();
        for answer in &test.rejects {
            if !old.iter().any(|old| old.rejects.contains(answer)) {
                write!(text, "{}{answer}", if text.is_empty() { "" } else { ", " })?;
            }
        }
        let name = &test.name;
        if text.is_empty() {
            writeln!(
                f,
                "    new: `{name}` rejects nothing that was not rejected before"
            )?;
        } else {
            writeln!(
                f,
                "    new: `{name}` rejects what nothing rejected before: {text}"
            )?;
        }
    }
    Ok(())
}

fn summary(f: &mut fmt::Formatter<'_>, verified: &[Verified]) -> fmt::Result {
    let sound = verified.iter().filter(|v| v.report.is_sound()).count();
    match (sound, verified.len()) {
        (1, 1) => writeln!(f, "{GOOD}1 exercise is sound{GOOD:#}"),
        (sound, all) if sound == all => writeln!(f, "{GOOD}{all} exercises are sound{GOOD:#}"),
        (sound, all) => writeln!(f, "{BAD}{sound} of {} sound{BAD:#}", count(all, "exercise")),
    }
}
