//! The table for people: a line for each student, a column for each exercise.

use std::fmt;

use anstyle::Style;

use super::grades::{Grade, Grades, Status};
use crate::workbook::feedback::paint::{ATTENTION, BAD, FAINT, GOOD, STRONG, padded, paint};

impl fmt::Display for Grades {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table(self, f)?;
        exercises(self, f)?;
        reasons(self, f)?;
        if !self.remarks.is_empty() {
            writeln!(f, "\n{}", paint(STRONG, "Not graded"))?;
            for remark in &self.remarks {
                writeln!(f, "  {}: {}", remark.file, remark.found)?;
            }
        }
        totals(self, f)
    }
}

/// Students × exercises; the exercises are numbered, because their names are long.
fn table(grades: &Grades, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let names = grades.students.iter().map(|s| s.student.chars().count());
    let first = names.chain(["student".len()]).max().unwrap_or(0);
    let widths: Vec<usize> = (0..grades.exercises.len())
        .map(|column| {
            let cells = grades.students.iter().map(|s| cell(&s.exercises[column]).0);
            let widths = cells.map(|cell| cell.chars().count());
            widths
                .max()
                .unwrap_or(0)
                .max((column + 1).to_string().len())
        })
        .collect();
    write!(f, "{}", paint(STRONG, padded("student", first)))?;
    for (column, width) in widths.iter().enumerate() {
        write!(
            f,
            "  {}",
            paint(STRONG, padded(&(column + 1).to_string(), *width))
        )?;
    }
    writeln!(f, "  {}", paint(STRONG, "passed"))?;
    for student in &grades.students {
        write!(f, "{}", padded(&student.student, first))?;
        for (grade, width) in student.exercises.iter().zip(&widths) {
            let (text, style) = cell(grade);
            write!(f, "  {}", padded(&paint(style, text), *width))?;
        }
        writeln!(f, "  {} of {}", student.passed(), grades.exercises.len())?;
    }
    Ok(())
}

/// What stands in a cell, short.
fn cell(grade: &Grade) -> (String, Style) {
    let style = match grade.status {
        Status::Passed => GOOD,
        Status::Failed | Status::DoesNotCompile | Status::Unusable => BAD,
        Status::Missing => FAINT,
        Status::NotChecked => ATTENTION,
    };
    let text = match grade.status {
        Status::Missing => "–".into(),
        Status::DoesNotCompile => "no compile".into(),
        _ => grade.in_words(),
    };
    (text, style)
}

/// The names behind the numbers, and how many passed.
fn exercises(grades: &Grades, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f)?;
    let names = grades.exercises.iter().map(|name| name.to_string().len());
    let width = names.max().unwrap_or(0);
    let digits = grades.exercises.len().to_string().len();
    for (index, name) in grades.exercises.iter().enumerate() {
        let of = |status| {
            let column = grades.students.iter().map(|s| &s.exercises[index]);
            column.filter(|grade| grade.status == status).count()
        };
        let handed_in = grades.students.len() - of(Status::Missing);
        let passed = of(Status::Passed);
        let name = padded(&name.to_string(), width);
        writeln!(
            f,
            "{:>digits$}  {name}  {passed} of {handed_in} handed in passed",
            index + 1
        )?;
    }
    Ok(())
}

/// Why a file could not be used or checked.
fn reasons(grades: &Grades, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let with_reason: Vec<_> = grades
        .iter()
        .filter_map(|(student, grade)| Some((student, grade, grade.reason.as_ref()?)))
        .collect();
    if !with_reason.is_empty() {
        writeln!(f, "\n{}", paint(STRONG, "Not checked"))?;
    }
    for (student, grade, reason) in with_reason {
        writeln!(f, "  {}/{}.rs: {reason}", student.student, grade.exercise)?;
    }
    Ok(())
}

fn totals(grades: &Grades, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let words = [
        (Status::Passed, "passed"),
        (Status::Failed, "failed"),
        (Status::DoesNotCompile, "do not compile"),
        (Status::Unusable, "unusable"),
        (Status::Missing, "missing"),
        (Status::NotChecked, "not checked"),
    ];
    let counted: Vec<String> = words
        .into_iter()
        .map(|(status, word)| (grades.count(status), word))
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| format!("{count} {word}"))
        .collect();
    let style = if grades.all_passed() { GOOD } else { BAD };
    writeln!(f, "\n{}", paint(style, counted.join(", ")))
}
