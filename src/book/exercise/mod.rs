//! Exercises: a folder each, `book/exercises/<chapter>/<name>/`.
//!
//! | file | holds |
//! |---|---|
//! | `exercise.md` | front matter between two lines `+++`, the task, at least three hints ([`document`]) |
//! | `answer.rs` | one source from which the starter and the solution come ([`marked`]) |
//! | `tests.rs` | the tests, plain `#[test]` functions and `proptest!` blocks ([`tests_source`]) |
//! | `mutants/<name>.rs` | wrong answers; each opens with `//! misconception: …` |
//! | `alternatives/<name>.rs` | other right answers, if there are any |
//!
//! A *compute* exercise asks for a tableau ([`crate::check::tableau`]). Its front matter names one of those that
//! `src/<chapter>/tableaux.rs` deals; `answer.rs` holds what it deals in round 0, blank and filled, and the wrong
//! answers are wrong tableaux. The tests deal the numbers again, by `answer::ROUND`.
//!
//! An *explain* exercise has `exercise.md` alone, with the sections `## Model answer` and `## Checklist`.
//! Nothing else has to be edited to add an exercise.
//!
//! A pack, `--pack DIR`, is a folder of exercises elsewhere. It may also hold tests that only `grade` runs ([`hidden`]).

pub mod collection;
pub mod document;
pub mod front_matter;
pub mod hidden;
pub mod marked;
pub mod tests_source;

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::tableaux;

pub use collection::{Exercises, Mistakes};
pub use document::{Document, Section};
pub use front_matter::FrontMatter;
pub use hidden::HiddenTests;
pub use marked::MarkedSource;
pub use tests_source::{TestItem, TestsSource};

/// The stable name of an exercise: `bezier/first-steps`.
///
/// Progress, submissions and prerequisites refer to it; the place in the list is another matter.
///
/// # Examples
///
/// ```
/// use cagd::book::exercise::ExerciseName;
///
/// let name: ExerciseName = "bezier/first-steps".parse()?;
/// assert_eq!((name.chapter(), name.name()), ("bezier", "first-steps"));
/// assert!("first-steps".parse::<ExerciseName>().is_err());
/// assert!("../answers/x".parse::<ExerciseName>().is_err());
/// # Ok::<(), cagd::book::exercise::NotAName>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct ExerciseName {
    chapter: String,
    name: String,
}

impl ExerciseName {
    /// The chapter: `bezier`.
    pub fn chapter(&self) -> &str {
        &self.chapter
    }

    /// The name inside the chapter: `first-steps`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where the answer to it stands below a folder of answers: `bezier/first-steps.rs`.
    pub fn answer_file(&self) -> PathBuf {
        Path::new(&self.chapter).join(format!("{}.rs", self.name))
    }
}

/// A text is no name of an exercise.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is no name of an exercise; write it as `chapter/name` with lower-case letters, digits and hyphens"
)]
pub struct NotAName(String);

impl FromStr for ExerciseName {
    type Err = NotAName;

    fn from_str(text: &str) -> Result<Self, NotAName> {
        let is_word = |word: &str| {
            word.starts_with(|c: char| c.is_ascii_lowercase())
                && word
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
        };
        match text.split_once('/') {
            Some((chapter, name)) if is_word(chapter) && is_word(name) => Ok(Self {
                chapter: chapter.to_owned(),
                name: name.to_owned(),
            }),
            _ => Err(NotAName(text.to_owned())),
        }
    }
}

impl TryFrom<String> for ExerciseName {
    type Error = NotAName;

    fn try_from(text: String) -> Result<Self, NotAName> {
        text.parse()
    }
}

impl From<ExerciseName> for String {
    fn from(name: ExerciseName) -> Self {
        name.to_string()
    }
}

impl fmt::Display for ExerciseName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.chapter, self.name)
    }
}

/// What an exercise asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ExerciseKind {
    /// Write the function.
    Implement,
    /// Find the bug.
    Repair,
    /// Give input that refutes a false statement.
    Counterexample,
    /// Write the law and let the exact check run it.
    Prove,
    /// Fill a tableau with fractions, by hand.
    Compute,
    /// Answer in words; compared with a model answer by the reader.
    Explain,
}

impl ExerciseKind {
    /// All kinds.
    pub const ALL: [Self; 6] = [
        Self::Implement,
        Self::Repair,
        Self::Counterexample,
        Self::Prove,
        Self::Compute,
        Self::Explain,
    ];

    /// The name as the front matter writes it: `implement`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Implement => "implement",
            Self::Repair => "repair",
            Self::Counterexample => "counterexample",
            Self::Prove => "prove",
            Self::Compute => "compute",
            Self::Explain => "explain",
        }
    }

    /// The name as a reader sees it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Implement => "implement",
            Self::Repair => "repair",
            Self::Counterexample => "find a counterexample",
            Self::Prove => "prove by program",
            Self::Compute => "compute by hand",
            Self::Explain => "explain",
        }
    }

    /// Whether the answer is a program that tests judge; an explanation is judged by the reader.
    pub fn is_tested(self) -> bool {
        self != Self::Explain
    }
}

impl fmt::Display for ExerciseKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A wrong answer, or another right one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variant {
    /// Its name, that of the file without `.rs`.
    pub name: String,
    /// The file, relative to the root of the package or as the pack was named.
    pub file: PathBuf,
    /// Its source.
    pub text: String,
    /// What the one who writes this thinks; empty for an alternative.
    pub misconception: String,
}

/// What makes an exercise a program that is checked: everything but `exercise.md`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tested {
    /// Starter and solution.
    pub answer: MarkedSource,
    /// The tests.
    pub tests: TestsSource,
    /// The wrong answers, by name.
    pub mutants: Vec<Variant>,
    /// Other right answers, by name.
    pub alternatives: Vec<Variant>,
}

/// An exercise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exercise {
    /// The stable name.
    pub name: ExerciseName,
    /// Its folder, relative to the root of the package or as the pack was named.
    pub folder: PathBuf,
    /// What `exercise.md` says first.
    pub front: FrontMatter,
    /// The task, the hints and what comes after.
    pub document: Document,
    /// The program; `None` for an *explain* exercise.
    pub tested: Option<Tested>,
}

impl Exercise {
    /// The pack that holds it, as it was named; `None` for an exercise of the book.
    pub fn pack(&self) -> Option<&Path> {
        let is_of_the_book = self.folder.starts_with(collection::FOLDER);
        // Above the folder are those of the chapter and of the pack.
        let above = self.folder.ancestors().nth(2);
        above.filter(|_| !is_of_the_book)
    }

    /// The file with the task.
    pub fn file(&self) -> PathBuf {
        self.folder.join("exercise.md")
    }

    /// The answer file of a *compute* exercise with the numbers that `round` deals; `None` for the other kinds.
    ///
    /// The same round deals the same numbers; the starter in the folder is that of round 0.
    pub fn fresh_answer_file(&self, round: u64) -> Option<String> {
        let name = self.front.tableau.as_ref()?;
        let dealer = tableaux::find(self.name.chapter(), name)?;
        Some((dealer.deal)(round).answer_file())
    }
}
