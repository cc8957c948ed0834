//! The data files of the book: bibliography, glossary, notation.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::catalogue::toml_error;
use super::error::{BookError, Problem, most_similar};

/// A work that is cited.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Work {
    /// How citations show it: `Farin 2002`.
    pub short: String,
    /// The authors, for instance `Gerald Farin`.
    pub authors: String,
    /// The title.
    pub title: String,
    /// Where it appeared: publisher, or journal with volume and pages.
    pub published: String,
    /// The year.
    pub year: u16,
    /// What the work is good for, in a sentence.
    #[serde(default)]
    pub note: String,
}

/// A term of the field, in both languages.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// The English term.
    pub english: String,
    /// The German term of the lecture notes.
    pub german: String,
    /// What it means, in a sentence; may hold formulas.
    #[serde(default)]
    pub definition: String,
    /// The statement that introduces it.
    #[serde(default)]
    pub statement: Option<String>,
}

/// A sign of the notation.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sign {
    /// The sign, in LaTeX.
    pub sign: String,
    /// What it means; may hold formulas.
    pub meaning: String,
    /// What the code calls it; may be empty.
    #[serde(default)]
    pub code: String,
    /// The statement that introduces it.
    #[serde(default)]
    pub statement: Option<String>,
}

/// The notation of the book, in the order of its file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
struct NotationFile {
    #[serde(default, rename = "sign")]
    signs: Vec<Sign>,
}

/// Bibliography, glossary and notation.
#[derive(Debug, Clone, Default)]
pub struct Data {
    /// The works by key, from `book/bibliography.toml`.
    pub works: BTreeMap<String, Work>,
    /// The terms by key, from `book/glossary.toml`.
    pub terms: BTreeMap<String, Term>,
    /// The signs, from `book/notation.toml`.
    pub signs: Vec<Sign>,
}

impl Data {
    /// Reads the three files below `root`; one that is not there is empty.
    ///
    /// What is wrong with them is added to `errors`.
    pub fn load(root: &Path, errors: &mut Vec<BookError>) -> Self {
        let notation: NotationFile = load(root, "book/notation.toml", errors);
        Self {
            works: load(root, "book/bibliography.toml", errors),
            terms: load(root, "book/glossary.toml", errors),
            signs: notation.signs,
        }
    }

    /// The work with this key.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownCitation`] if there is none.
    pub fn work(&self, key: &str) -> Result<&Work, Problem> {
        self.works.get(key).ok_or_else(|| Problem::UnknownCitation {
            key: key.to_owned(),
            near: most_similar(key, self.works.keys().map(String::as_str)),
        })
    }

    /// The term with this key.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownTerm`] if there is none.
    pub fn term(&self, key: &str) -> Result<&Term, Problem> {
        self.terms.get(key).ok_or_else(|| Problem::UnknownTerm {
            key: key.to_owned(),
            near: most_similar(key, self.terms.keys().map(String::as_str)),
        })
    }
}

/// Reads one file.
fn load<T: DeserializeOwned + Default>(root: &Path, file: &str, errors: &mut Vec<BookError>) -> T {
    let text = match std::fs::read_to_string(root.join(file)) {
        Ok(text) => text,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return T::default(),
        Err(e) => {
            let reason = e.to_string();
            errors.push(BookError::new(file, 1, Problem::Unreadable { reason }));
            return T::default();
        }
    };
    toml::from_str(&text).unwrap_or_else(|error| {
        errors.push(toml_error(Path::new(file), &text, &error));
        T::default()
    })
}
