//! The table as CSV: a line for each student, a column for each exercise.

use std::io;

use super::grades::Grades;

/// The grades as CSV; the last column counts the exercises that passed.
///
/// # Errors
///
/// The output cannot be written.
pub fn write(grades: &Grades, out: impl io::Write) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    let exercises = grades.exercises.iter().map(ToString::to_string);
    let head = std::iter::once("student".to_owned()).chain(exercises);
    table.write_record(head.chain(["passed".to_owned()]))?;
    for student in &grades.students {
        let cells = student.exercises.iter().map(|grade| grade.in_words());
        let row = std::iter::once(harmless(&student.student)).chain(cells);
        table.write_record(row.chain([student.passed().to_string()]))?;
    }
    table.flush()
}

/// A name that a spreadsheet does not take for a formula.
fn harmless(name: &str) -> String {
    if name.starts_with(['=', '+', '-', '@']) {
        format!("'{name}")
    } else {
        name.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workbook::grade::grades::StudentGrades;

    #[test]
    fn a_name_is_one_cell_and_no_formula() {
        let student = |name: &str| StudentGrades {
            student: name.to_owned(),
            exercises: Vec::new(),
        };
        let grades = Grades {
            isolation: String::new(),
            exercises: Vec::new(),
            students: vec![student("=1+1"), student("Doe, \"J\"")],
            remarks: Vec::new(),
        };
        let mut out = Vec::new();
        write(&grades, &mut out).expect("a vector takes everything");
        let text = String::from_utf8(out).expect("CSV is text");
        assert_eq!(text, "student,passed\n'=1+1,0\n\"Doe, \"\"J\"\"\",0\n");
    }
}
