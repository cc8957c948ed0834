//! What was verified stays so until something changes.
//!
//! A record below `target/exercises/verified` holds the last report about an exercise and a key: a digest of the
//! sources of the exercise, of the library with its lock file and compiler, and of the verifier itself.
//! Only a sound exercise is taken from its record; one that falls short is tried again.

use std::fs;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::candidate::Candidate;
use super::report::Report;
use super::to_do::texts;
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::library::{Library, hex, replace};
use crate::workbook::checking::{Checker, CheckingError};

/// The sources that decide what a report says; whoever changes them makes every record stale.
const VERIFIER: [&str; 8] = [
    include_str!("candidate.rs"),
    include_str!("trial.rs"),
    include_str!("judge.rs"),
    include_str!("report.rs"),
    include_str!("to_do.rs"),
    include_str!("../checking/check.rs"),
    include_str!("../checking/compile.rs"),
    include_str!("../checking/trial.rs"),
];

/// The last report about an exercise.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Record {
    /// The digest of everything that the report depends on.
    pub key: String,
    /// The report.
    pub report: Report,
    /// The report before the tests or the answers last changed.
    pub before: Option<Report>,
}

/// The digest of everything that the report about an exercise depends on.
///
/// It is made of what was read, not of the files, which may have changed since.
pub fn key(library: &Library, exercise: &Exercise, tested: &Tested) -> String {
    let mut digest = Sha256::new();
    let mut add = |text: &str| {
        digest.update((text.len() as u64).to_le_bytes());
        digest.update(text);
    };
    add(&library.fingerprint);
    VERIFIER.iter().for_each(|source| add(source));
    add(&exercise.folder.to_string_lossy());
    add(exercise.front.kind.name());
    for (_, _, text) in texts(exercise) {
        add(text);
    }
    add(&tested.tests.text);
    add(&tested.tests.program());
    for candidate in Candidate::all(exercise, tested) {
        add(&candidate.to_string());
        add(&candidate.source.text);
    }
    hex(&digest.finalize())
}

/// Where the record of an exercise stands.
fn file(checker: &Checker, exercise: &Exercise) -> PathBuf {
    let name = &exercise.name;
    let folder = checker.library().work.with_file_name("verified");
    folder.join(format!("{}-{}.json", name.chapter(), name.name()))
}

/// The record of an exercise, whether or not it is still true; `None` if there is none that can be read.
pub fn read(checker: &Checker, exercise: &Exercise) -> Option<Record> {
    let bytes = fs::read(file(checker, exercise)).ok()?;
    serde_json::from_slice(&bytes).ok()
}

/// Writes the record of an exercise.
///
/// # Errors
///
/// The file cannot be written.
pub fn write(checker: &Checker, exercise: &Exercise, record: &Record) -> Result<(), CheckingError> {
    let file = file(checker, exercise);
    let text = serde_json::to_vec(record).map_err(|e| CheckingError::file(&file, &e.into()))?;
    replace(&file, &text)
}
