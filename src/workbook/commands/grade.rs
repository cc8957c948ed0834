//! `cargo run -- grade DIR`: checks what students have handed in.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use super::verify::{absolute_packs, is_named, progress_bar, require_names};
use crate::book::catalogue::Catalogue;
use crate::book::exercise::{Exercise, Exercises, HiddenTests};
use crate::workbook::checking::Checker;
use crate::workbook::command_line::{Failure, Outcome};
use crate::workbook::grade::{
    Assignment, GradeError, Grades, Status, Submissions, grade, junit, spreadsheet,
};
use crate::workbook::house;
use crate::workbook::sandbox::Isolation;

/// What `grade` is asked.
#[derive(Debug, Args)]
pub struct Grade {
    /// The folder of the submissions: `DIR/<student>/<chapter>/<name>.rs`
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Only this exercise, `chapter/name`, or all of this chapter; without it, those that somebody has answered
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Read the exercises and hidden tests of this pack as well
    #[arg(long, value_name = "DIR")]
    pack: Vec<PathBuf>,
    /// Print JSON, with a verdict for each answer
    #[arg(long)]
    json: bool,
    /// Write the table as CSV to this file as well
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write JUnit XML to this file as well
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Run the submissions even if this system cannot keep them from your files and the network
    #[arg(long = "unsafe")]
    accept_risk: bool,
}

impl Grade {
    /// Grades the submissions.
    ///
    /// # Errors
    ///
    /// The workbook or the submissions are not found, an exercise or hidden tests do not follow the schema, the
    /// system does not keep programs apart, or a check could not run.
    pub(crate) fn run(&self) -> Result<Outcome, Failure> {
        for file in self.csv.iter().chain(&self.junit) {
            must_be_writable(file)?;
        }
        let root = house::find()?;
        let catalogue = Catalogue::load(&root)?;
        let packs = absolute_packs(&self.pack)?;
        let exercises = Exercises::load(&root, &packs, &catalogue)?;
        let hidden = HiddenTests::load(&root, &packs, &exercises)?;
        require_names(&self.names, &exercises)?;
        let isolation = Isolation::best();
        if !isolation.is_complete() {
            if !self.accept_risk {
                return Err(GradeError::NotIsolated(isolation).into());
            }
            eprintln!("warning: {}", isolation.describe());
        }
        let submissions = Submissions::read(&self.folder, &exercises)?;
        let is_named = |exercise: &Exercise| is_named(&self.names, exercise);
        let chosen: Option<&dyn Fn(&Exercise) -> bool> = match self.names.is_empty() {
            true => None,
            false => Some(&is_named),
        };
        let assignments = Assignment::all(&exercises, &hidden, &submissions, chosen);
        if assignments.is_empty() {
            return Err(GradeError::NothingHandedIn {
                folder: self.folder.clone(),
                first: submissions.remarks.first().cloned(),
            }
            .into());
        }
        for name in assignments
            .iter()
            .map(|assignment| &assignment.exercise.name)
        {
            let mut students = submissions.students.iter();
            if !students.any(|student| student.answers.contains_key(name)) {
                eprintln!("note: nobody has handed in an answer to `{name}`");
            }
        }
        let checker = Checker::new(&root, isolation)?;
        for assignment in &assignments {
            assignment.accepts_the_solution(&checker)?;
        }
        let bar = progress_bar();
        bar.set_length((submissions.students.len() * assignments.len()) as u64);
        let grades = grade(&checker, &submissions, &assignments, &|student| {
            bar.set_message(student.name.clone());
            bar.inc(1);
        });
        bar.finish_and_clear();
        self.write(&grades)?;
        Ok(if grades.all_passed() {
            Outcome::Fine
        } else if grades.count(Status::NotChecked) > 0 {
            Outcome::CouldNotRun
        } else {
            Outcome::FallsShort
        })
    }

    /// Prints the grades and writes the files that were asked for.
    fn write(&self, grades: &Grades) -> Result<(), Failure> {
        if let Some(file) = &self.csv {
            to_file(file, |out| spreadsheet::write(grades, out))?;
        }
        if let Some(file) = &self.junit {
            let xml = junit::xml(grades);
            to_file(file, |out| {
                xml.serialize(out).map_err(std::io::Error::other)
            })?;
        }
        if self.json {
            let text = serde_json::to_string_pretty(grades).map_err(std::io::Error::from)?;
            writeln!(std::io::stdout(), "{text}")?;
        } else {
            write!(anstream::stdout(), "{grades}")?;
        }
        Ok(())
    }
}

/// Tries whether a file that was asked for can be written, before anybody waits for what it will hold.
pub(super) fn must_be_writable(file: &Path) -> Result<(), GradeError> {
    let opened = File::options().create(true).append(true).open(file);
    opened.map(drop).map_err(|e| cannot_write(file, &e))
}

fn cannot_write(file: &Path, error: &std::io::Error) -> GradeError {
    GradeError::Output {
        file: file.to_path_buf(),
        reason: error.to_string(),
    }
}

/// Writes a file that was asked for.
pub(super) fn to_file(
    file: &Path,
    write: impl FnOnce(File) -> std::io::Result<()>,
) -> Result<(), GradeError> {
    File::create(file)
        .and_then(write)
        .map_err(|e| cannot_write(file, &e))
}
