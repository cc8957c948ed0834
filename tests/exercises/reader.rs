//! The reader's side: what the commands print, write and never lose.

mod answers;
mod checking;
mod progress;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use cagd::book::exercise::Tested;
use serde_json::Value;
use tempfile::TempDir;

use super::{exercises, root, tested};

/// An exercise that is in the book.
const NAME: &str = "bezier/parabola-point";

/// A reader with a folder of answers of his own.
struct Reader {
    folder: TempDir,
}

impl Reader {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        Self { folder }
    }

    /// One who has begun the exercise.
    fn begun() -> Self {
        let reader = Self::new();
        reader.run(&["start", NAME]).assert_status(0);
        reader
    }

    fn path(&self, file: &str) -> PathBuf {
        self.folder.path().join("answers").join(file)
    }

    /// The answer to the exercise.
    fn file(&self) -> PathBuf {
        self.path("bezier/parabola-point.rs")
    }

    #[track_caller]
    fn write(&self, text: &str) {
        fs::write(self.file(), text).expect("the answer can be written");
    }

    #[track_caller]
    fn read(&self, file: &str) -> String {
        let path = self.path(file);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        command
            .args(arguments)
            .arg("--answers")
            .arg(self.path(""))
            .current_dir(root())
            .env("LANG", "C.UTF-8")
            .env_remove("LC_ALL")
            .env_remove("NO_COLOR")
            .env_remove("CLICOLOR_FORCE")
            .env_remove("COLUMNS")
            .env_remove("CARGO_MANIFEST_DIR");
        command
    }

    fn run(&self, arguments: &[&str]) -> Run {
        Run::of(&mut self.command(arguments))
    }

    /// What a command answers with `--json`.
    #[track_caller]
    fn json(&self, arguments: &[&str]) -> Value {
        let run = self.run(&[arguments, &["--json"]].concat());
        serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}: {run:#?}"))
    }

    /// What the list says about the exercise.
    #[track_caller]
    fn item(&self) -> Value {
        let list = self.json(&["list"]);
        let items = list.as_array().expect("an array").iter();
        let mut found = items.filter(|item| item["exercise"] == NAME);
        found.next().expect("the exercise is listed").clone()
    }
}

/// The starter, the solution and the mutants of the exercise.
fn sources() -> Tested {
    let exercises = exercises();
    tested(&exercises, NAME).1.clone()
}

/// What a command did.
#[derive(Debug)]
struct Run {
    status: Option<i32>,
    stdout: String,
    stderr: String,
}

impl Run {
    fn of(command: &mut Command) -> Self {
        let Output {
            status,
            stdout,
            stderr,
        } = command.output().expect("the command starts");
        Self {
            status: status.code(),
            stdout: String::from_utf8_lossy(&stdout).into_owned(),
            stderr: String::from_utf8_lossy(&stderr).into_owned(),
        }
    }

    #[track_caller]
    fn assert_status(&self, expected: i32) -> &Self {
        assert_eq!(self.status, Some(expected), "{self:#?}");
        self
    }

    /// The words, wherever the lines are broken.
    #[track_caller]
    fn assert_says(&self, text: &str) -> &Self {
        assert!(self.says(text), "`{text}` is not in {self:#?}");
        self
    }

    #[track_caller]
    fn assert_silent_about(&self, text: &str) -> &Self {
        assert!(!self.says(text), "`{text}` is in {self:#?}");
        self
    }

    fn says(&self, text: &str) -> bool {
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        words(&self.stdout).contains(text) || words(&self.stderr).contains(text)
    }
}

/// The names of all files below a folder, sorted.
fn files_below(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).into_iter().flatten().flatten() {
            if entry.path().is_dir() {
                folders.push(entry.path());
            } else if let Ok(name) = entry.path().strip_prefix(folder) {
                found.push(name.display().to_string());
            }
        }
    }
    found.sort();
    found
}
