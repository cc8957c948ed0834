//! A class that hands in answers to one exercise.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use cagd::book::exercise::{Exercises, HiddenTests};
use cagd::workbook::checking::{Checker, Library};
use cagd::workbook::grade::{Assignment, Grade, Grades, Submissions, grade};
use cagd::workbook::sandbox::{Isolation, Limits};
use tempfile::TempDir;

use crate::{exercises, root, tested};

/// The exercise that everybody answers.
pub const NAME: &str = "bezier/parabola-point";

/// The beginning of an answer, up to the body of `point`.
pub const HEAD: &str = "use cagd::affine::Point;
use cagd::scalar::Scalar;

pub fn point<T: Scalar>(b: &[Point<T, 2>; 3], t: T) -> Point<T, 2> {
";

/// The right end of a body.
pub const RIGHT: &str = "
    let between = |p: &Point<T, 2>, q: &Point<T, 2>| p.clone() + (q.clone() - p.clone()) * t.clone();
    between(&between(&b[0], &b[1]), &between(&b[1], &b[2]))
}
";

/// The folder of a class.
pub struct Class {
    folder: TempDir,
}

impl Class {
    pub fn new() -> Self {
        Self {
            folder: tempfile::tempdir().expect("a folder"),
        }
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// The file in which a student answers.
    pub fn file(&self, student: &str) -> PathBuf {
        self.path().join(student).join(NAME).with_extension("rs")
    }

    pub fn hands_in(&self, student: &str, answer: &str) {
        let file = self.file(student);
        fs::create_dir_all(file.parent().expect("a folder")).expect("the folder is made");
        fs::write(file, answer).expect("the answer is written");
    }

    pub fn read(&self) -> Submissions {
        let read = Submissions::read(self.path(), &exercises());
        read.unwrap_or_else(|error| panic!("{error}"))
    }

    /// The grades, with a limit for each run.
    pub fn graded(&self, hidden: &[HiddenTests], time: Duration) -> Grades {
        let exercises = exercises();
        let submissions = self.read();
        let assignments = Assignment::all(&exercises, hidden, &submissions, None);
        grade(&checker(time), &submissions, &assignments, &|_| {})
    }
}

/// The solution of the exercise.
pub fn solution() -> String {
    let exercises = exercises();
    tested(&exercises, NAME).1.answer.solution.clone()
}

pub fn checker(time: Duration) -> Checker {
    let checker = Checker::new(&root(), Isolation::best());
    let limits = Limits {
        time,
        ..Limits::answer()
    };
    checker
        .unwrap_or_else(|error| panic!("{error}"))
        .with_limits(limits)
}

/// The folder in which answers are compiled.
pub fn work() -> PathBuf {
    Library::build(&root())
        .unwrap_or_else(|error| panic!("{error}"))
        .work
}

/// The grade of a student who has answered one exercise.
pub fn of<'a>(grades: &'a Grades, student: &str) -> &'a Grade {
    let found = grades.students.iter().find(|of| of.student == student);
    &found.expect("the student is there").exercises[0]
}

/// The hidden tests of a pack.
pub fn hidden(pack: &Path, exercises: &Exercises) -> Result<Vec<HiddenTests>, String> {
    HiddenTests::load(&root(), &[pack.to_path_buf()], exercises).map_err(|e| e.to_string())
}
