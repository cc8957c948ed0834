//! How far the reader is: `answers/progress.json`.
//!
//! Exercises are remembered by their stable names, so that a new order or a new exercise changes nothing here, and what
//! is said about one that has left the book is kept.

mod store;

use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

pub use store::{FILE, ProgressError, Store};

use super::checking::library::hex;
use crate::book::exercise::ExerciseName;

/// The version of the file that this program writes.
pub const VERSION: u32 = 1;

/// How far the reader is.
///
/// Times are seconds since the beginning of 1970 (UTC).
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Progress {
    /// The version of the format.
    pub version: u32,
    /// The exercise begun last; commands without a name mean it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begun_last: Option<ExerciseName>,
    /// What is known about each exercise that was begun.
    #[serde(default)]
    pub exercises: BTreeMap<ExerciseName, Entry>,
}

impl Default for Progress {
    fn default() -> Self {
        Self {
            version: VERSION,
            begun_last: None,
            exercises: BTreeMap::new(),
        }
    }
}

/// What is known about one exercise.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Entry {
    /// When it was begun.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begun: Option<u64>,
    /// The digest of the starter that the reader began with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub starter: Option<String>,
    /// With which seed fresh numbers were dealt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// How many hints were shown.
    #[serde(default)]
    pub hints: usize,
    /// How often it was checked.
    #[serde(default)]
    pub checks: u32,
    /// When it was solved first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solved: Option<u64>,
    /// Whether the reader has asked for the solution before solving it.
    #[serde(default)]
    pub asked_for_solution: bool,
}

impl Entry {
    /// Takes over what another record of the same exercise knows more about.
    fn join(&mut self, other: Self) {
        let earlier = |a: Option<u64>, b: Option<u64>| a.into_iter().chain(b).min();
        self.begun = earlier(self.begun, other.begun);
        self.solved = earlier(self.solved, other.solved);
        // Starter and seed belong to the file that lies in the folder.
        if self.starter.is_none() && self.seed.is_none() {
            self.starter = other.starter;
            self.seed = other.seed;
        }
        self.hints = self.hints.max(other.hints);
        self.checks = self.checks.max(other.checks);
        self.asked_for_solution |= other.asked_for_solution;
    }
}

impl Progress {
    /// What is known about an exercise, to change it.
    pub fn entry(&mut self, name: &ExerciseName) -> &mut Entry {
        self.exercises.entry(name.clone()).or_default()
    }

    /// What is known about an exercise; nothing, if it was never begun.
    pub fn of(&self, name: &ExerciseName) -> Entry {
        self.exercises.get(name).cloned().unwrap_or_default()
    }

    /// Whether the exercise was solved.
    pub fn is_solved(&self, name: &ExerciseName) -> bool {
        self.exercises
            .get(name)
            .is_some_and(|entry| entry.solved.is_some())
    }

    /// Takes over another record, such as one from another computer; nothing that is known is forgotten.
    pub fn join(&mut self, other: Self) {
        self.begun_last = self.begun_last.take().or(other.begun_last);
        for (name, entry) in other.exercises {
            self.entry(&name).join(entry);
        }
    }
}

/// The digest by which a starter is recognised.
pub fn digest(starter: &str) -> String {
    hex(&Sha256::digest(starter))
}

/// Now, in seconds since the beginning of 1970.
pub fn now() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |time| time.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joining_forgets_nothing() {
        let entry = |hints, solved| Entry {
            hints,
            solved,
            ..Entry::default()
        };
        let name = |text: &str| text.parse::<ExerciseName>().expect("a name");
        let mut here = Progress::default();
        here.exercises.insert(name("bezier/a"), entry(2, None));
        here.exercises.insert(name("bezier/b"), entry(0, Some(5)));
        let mut there = Progress::default();
        there.exercises.insert(name("bezier/a"), entry(1, Some(7)));
        there.exercises.insert(name("bezier/b"), entry(1, Some(9)));
        there.exercises.insert(name("bezier/c"), entry(3, None));
        here.join(there);
        assert_eq!(here.of(&name("bezier/a")), entry(2, Some(7)));
        assert_eq!(here.of(&name("bezier/b")), entry(1, Some(5)));
        assert_eq!(here.of(&name("bezier/c")), entry(3, None));
    }
}
