//! A pack with one small exercise, in a folder of its own, to be sabotaged.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use cagd::book::catalogue::Catalogue;
use cagd::book::error::BookErrors;
use cagd::book::exercise::{Exercise, Exercises};
use cagd::workbook::checking::{Checker, Library};
use cagd::workbook::sandbox::Isolation;
use cagd::workbook::verify::{Report, Verified, verify};
use tempfile::TempDir;

/// The exercise of every pack here.
pub const NAME: &str = "bezier/sum-of-numbers";

const EXERCISE: &str = r#"+++
title = "The sum of the first numbers"
kind = "implement"
statements = ["bezier-de-casteljau-examples"]
difficulty = 1
minutes = 5
order = 10
+++

Write `sum`.

## Hint

Begin with small numbers.

## Hint

Write the numbers a second time below, in reverse.

## Hint

The sum is $n (n + 1) / 2$.
"#;

const ANSWER: &str = "//! The sum of the first numbers.

/// 1 + 2 + … + n.
pub fn sum(n: i64) -> i64 {
    //@ solution
    n * (n + 1) / 2
    //@ starter
    //| let _ = n;
    //| 2
    //@ end
}
";

const TESTS: &str = r#"use cagd::check::claim;

fn probes() -> Vec<String> {
    cagd::probes![answer::sum(0), answer::sum(1), answer::sum(3)]
}

#[test]
fn nothing() {
    claim("the sum of no numbers").equal(answer::sum(0), 0);
}

#[test]
fn one() {
    claim("the sum of one number").equal(answer::sum(1), 1);
}

#[test]
fn many() {
    claim("the sum of three numbers").equal(answer::sum(3), 6);
}
"#;

/// A pack, and a place of its own for what checking it makes.
pub struct Pack {
    folder: TempDir,
}

impl Pack {
    /// A pack whose exercise is sound.
    pub fn new() -> Self {
        let pack = Self {
            folder: tempfile::tempdir().expect("a folder"),
        };
        pack.write("exercise.md", EXERCISE);
        pack.write("answer.rs", ANSWER);
        pack.write("tests.rs", TESTS);
        for (name, misconception, body) in [
            ("square", "the sum is the square", "n * n"),
            (
                "starts-at-one",
                "a sum is never 0",
                "(n * (n + 1) / 2).max(1)",
            ),
            (
                "forgets-one",
                "a single number is no sum",
                "if n == 1 { 0 } else { n * (n + 1) / 2 }",
            ),
        ] {
            pack.mutant(name, misconception, body);
        }
        pack
    }

    /// The folder of everything.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    fn exercise_folder(&self) -> PathBuf {
        self.folder.path().join("pack").join(NAME)
    }

    /// Writes a file of the exercise.
    pub fn write(&self, file: &str, text: &str) {
        let path = self.exercise_folder().join(file);
        fs::create_dir_all(path.parent().expect("it has a folder")).expect("a folder");
        fs::write(path, text).expect("it can be written");
    }

    /// Writes a wrong answer.
    pub fn mutant(&self, name: &str, misconception: &str, body: &str) {
        self.write(&format!("mutants/{name}.rs"), &format!(
            "//! misconception: {misconception}\n\n/// 1 + 2 + … + n.\npub fn sum(n: i64) -> i64 {{\n    {body}\n}}\n"
        ));
    }

    /// Replaces a text in a file of the exercise.
    #[track_caller]
    pub fn replace(&self, file: &str, from: &str, to: &str) {
        let path = self.exercise_folder().join(file);
        let text = fs::read_to_string(&path).expect("the file is there");
        assert!(text.contains(from), "`{from}` is not in {file}");
        fs::write(path, text.replacen(from, to, 1)).expect("it can be written");
    }

    /// Reads the pack; without a book there are its exercises alone.
    pub fn exercises(&self) -> Result<Exercises, BookErrors> {
        let catalogue = Catalogue::load(&crate::root()).expect("the catalogue loads");
        let pack = self.folder.path().join("pack");
        Exercises::load(self.folder.path(), &[pack], &catalogue)
    }

    /// Reads the exercise.
    pub fn load(&self) -> Result<Exercise, BookErrors> {
        let exercises = self.exercises()?;
        let name = NAME.parse().expect("a name");
        Ok(exercises.get(&name).expect("it is in the pack").clone())
    }

    /// What checks it: the library of the workbook, its own folder for everything else.
    pub fn checker(&self) -> Checker {
        static LIBRARY: OnceLock<Library> = OnceLock::new();
        let built = LIBRARY.get_or_init(|| crate::checker().library().clone());
        let work = self.folder.path().join("work");
        Checker::with_library(
            Library {
                work,
                ..built.clone()
            },
            Isolation::best(),
        )
    }

    /// Verifies the exercise, with the cache.
    pub fn verify(&self, checker: &Checker) -> Verified {
        let exercise = self.load().unwrap_or_else(|errors| panic!("{errors}"));
        let verified = verify(checker, &[&exercise], true, &|_| {});
        verified.unwrap_or_else(|error| panic!("{error}")).remove(0)
    }

    /// The report about the exercise.
    pub fn report(&self) -> Report {
        self.verify(&self.checker()).report
    }
}

/// Asserts that exactly this falls short, what it is about and what was found, and that each has a remedy.
#[track_caller]
pub fn assert_falls_short(report: &Report, expected: &[(&str, &str)]) {
    let found = report.shortcomings.iter();
    let found: Vec<_> = found
        .map(|s| (s.about.as_str(), s.found.as_str()))
        .collect();
    assert_eq!(found, expected);
    for shortcoming in &report.shortcomings {
        assert!(
            !shortcoming.remedy.is_empty(),
            "{shortcoming:?} has no remedy"
        );
    }
}
