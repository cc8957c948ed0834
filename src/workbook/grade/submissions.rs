//! What was handed in, read with care.
//!
//! A submission is data of somebody else. Links are not followed, so that nobody hands in a file of the instructor;
//! devices and pipes are not opened; what is too large is not read.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{self, DirEntry, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::GradeError;
use crate::book::catalogue::CHAPTERS;
use crate::book::exercise::{ExerciseName, Exercises};

/// How many bytes an answer may have; the longest solution of the book has a few thousand.
pub const LARGEST: u64 = 256 << 10;

/// What else a folder of answers holds, see [`crate::workbook::answers`]; students hand in all of it.
const BESIDE: [&str; 6] = [
    "Cargo.toml",
    "Cargo.lock",
    "progress.json",
    "backups",
    "pictures",
    "target",
];

/// What one student has handed in.
#[derive(Debug, Clone)]
pub struct Student {
    /// The name of the folder; signs that a terminal would obey are written out.
    pub name: String,
    /// The answers.
    pub answers: BTreeMap<ExerciseName, Submission>,
}

/// One answer.
#[derive(Debug, Clone)]
pub struct Submission {
    /// The file, from the folder of the submissions on.
    pub file: String,
    /// The source, or why there is none.
    pub source: Result<String, String>,
}

/// Something in the folder that belongs to nobody's grade.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Remark {
    /// The file or folder, from the folder of the submissions on.
    pub file: String,
    /// What is the matter with it.
    pub found: String,
}

/// All that was handed in.
#[derive(Debug, Clone, Default)]
pub struct Submissions {
    /// The students, by name.
    pub students: Vec<Student>,
    /// What belongs to nobody's grade.
    pub remarks: Vec<Remark>,
}

impl Submissions {
    /// Reads a folder of submissions.
    ///
    /// # Errors
    ///
    /// The folder cannot be read, or holds no student. Everything else is a remark, or the reason why an answer
    /// cannot be used.
    pub fn read(folder: &Path, exercises: &Exercises) -> Result<Self, GradeError> {
        let mut found = Self::default();
        let entries = sorted(folder).map_err(|e| GradeError::Folder {
            folder: folder.to_path_buf(),
            reason: e.to_string(),
        })?;
        for entry in entries {
            let name = shown(&entry.file_name());
            match kind(&entry) {
                _ if is_hidden(&entry) => {}
                Kind::Folder => {
                    let answers = found.student(&entry, &name, exercises);
                    found.students.push(Student { name, answers });
                }
                Kind::Link => found.remark(
                    name,
                    "a link is not followed; put the student's folder here",
                ),
                Kind::File | Kind::Other => found.remark(name, "this is no folder of a student"),
            }
        }
        if found.students.is_empty() {
            return Err(GradeError::NoStudent(folder.to_path_buf()));
        }
        Ok(found)
    }

    /// The answers in the folder of one student.
    fn student(
        &mut self,
        folder: &DirEntry,
        student: &str,
        exercises: &Exercises,
    ) -> BTreeMap<ExerciseName, Submission> {
        let mut answers = BTreeMap::new();
        for entry in self.entries(folder, student) {
            let name = shown(&entry.file_name());
            let shown = format!("{student}/{name}");
            if is_hidden(&entry) || BESIDE.contains(&name.as_str()) {
                continue;
            }
            match kind(&entry) {
                Kind::Folder if CHAPTERS.contains(&name.as_str()) => {
                    self.chapter(&entry, &name, &shown, exercises, &mut answers);
                }
                Kind::Link => self.remark(shown, "a link is not followed; hand in what it names"),
                _ => self.remark(
                    shown,
                    "this is no chapter; answers belong into `<student>/<chapter>/<name>.rs`",
                ),
            }
        }
        answers
    }

    /// The answers to the exercises of one chapter.
    fn chapter(
        &mut self,
        folder: &DirEntry,
        chapter: &str,
        shown_folder: &str,
        exercises: &Exercises,
        answers: &mut BTreeMap<ExerciseName, Submission>,
    ) {
        for entry in self.entries(folder, shown_folder) {
            if is_hidden(&entry) {
                continue;
            }
            let file_name = shown(&entry.file_name());
            let file = format!("{shown_folder}/{file_name}");
            let stem = file_name
                .strip_suffix(".rs")
                .or_else(|| file_name.strip_suffix(".md"));
            let name = format!("{chapter}/{}", stem.unwrap_or(&file_name));
            let exercise = name.parse().ok().and_then(|name| exercises.get(&name));
            match (exercise, file_name.ends_with(".rs")) {
                (Some(exercise), true) if exercise.tested.is_some() => {
                    let source = read(&entry);
                    answers.insert(exercise.name.clone(), Submission { file, source });
                }
                (Some(exercise), _) if exercise.tested.is_none() => {
                    self.remark(file, "an explanation; read it yourself");
                }
                _ => {
                    let found = match exercises.similar(&name) {
                        Some(near) => {
                            format!("this belongs to no exercise; did they mean `{near}.rs`?")
                        }
                        None => "this belongs to no exercise".to_owned(),
                    };
                    self.remark(file, found);
                }
            }
        }
    }

    /// What a folder holds; one that cannot be read is remarked.
    fn entries(&mut self, folder: &DirEntry, shown: &str) -> Vec<DirEntry> {
        sorted(&folder.path()).unwrap_or_else(|e| {
            self.remark(shown.to_owned(), format!("this cannot be read ({e})"));
            Vec::new()
        })
    }

    fn remark(&mut self, file: String, found: impl Into<String>) {
        let found = found.into();
        self.remarks.push(Remark { file, found });
    }
}

/// What an entry is, without following a link.
enum Kind {
    Folder,
    File,
    Link,
    Other,
}

fn kind(entry: &DirEntry) -> Kind {
    match entry.file_type() {
        Ok(kind) if kind.is_dir() => Kind::Folder,
        Ok(kind) if kind.is_file() => Kind::File,
        Ok(kind) if kind.is_symlink() => Kind::Link,
        _ => Kind::Other,
    }
}

/// Files that a system or an editor has put there.
fn is_hidden(entry: &DirEntry) -> bool {
    let name = entry.file_name();
    name.as_encoded_bytes().starts_with(b".") || name == "__MACOSX"
}

fn sorted(folder: &Path) -> std::io::Result<Vec<DirEntry>> {
    let mut entries = fs::read_dir(folder)?.collect::<std::io::Result<Vec<_>>>()?;
    entries.sort_by_key(DirEntry::file_name);
    Ok(entries)
}

/// The text of an answer, or why it cannot be used.
fn read(entry: &DirEntry) -> Result<String, String> {
    match kind(entry) {
        Kind::File => {}
        Kind::Link => return Err("it is a link, which is not followed".into()),
        Kind::Folder | Kind::Other => return Err("it is no file".into()),
    }
    let path: PathBuf = entry.path();
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
        .map_err(|e| format!("it cannot be read ({e})"))?;
    if bytes.len() as u64 > LARGEST {
        return Err(format!("it is larger than {} KiB", LARGEST >> 10));
    }
    String::from_utf8(bytes).map_err(|_| "it is not written in UTF-8".into())
}

/// A name as it can be printed: no sign in it moves the cursor, breaks a line or turns the direction of writing.
fn shown(name: &OsStr) -> String {
    let turns = |c: char| matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    name.to_string_lossy()
        .chars()
        .flat_map(|c| {
            let escaped = c.is_control() || turns(c);
            let written = escaped.then(|| c.escape_unicode());
            let plain = (!escaped).then_some(c);
            written.into_iter().flatten().chain(plain)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cannot_command_a_terminal() {
        assert_eq!(shown(OsStr::new("Zoë Müller, B.Sc.")), "Zoë Müller, B.Sc.");
        assert_eq!(
            shown(OsStr::new("a\n\u{1b}[2Jb\u{202e}")),
            "a\\u{a}\\u{1b}[2Jb\\u{202e}"
        );
    }
}
