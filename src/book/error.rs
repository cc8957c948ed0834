//! What can be wrong with a book, told with file, line and remedy.

use std::fmt;
use std::path::{Path, PathBuf};

/// A line of a file, relative to the root of the package.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The file, relative to the root of the package.
    pub file: PathBuf,
    /// The line, counted from 1.
    pub line: usize,
}

impl Place {
    /// The line `line` of `file`.
    pub fn new(file: impl Into<PathBuf>, line: usize) -> Self {
        Self {
            file: file.into(),
            line,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file.display(), self.line)
    }
}

/// What is wrong, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// A data file of the book does not parse.
    #[error("this is not what the file should hold: {reason}")]
    Data {
        /// What the parser says.
        reason: String,
    },
    /// A file cannot be read.
    #[error("the file cannot be read ({reason}); write it or take its mention out")]
    Unreadable {
        /// What the operating system says.
        reason: String,
    },
    /// The catalogue, the bibliography or the glossary names a thing twice.
    #[error(
        "`{id}` is already listed at {first}; each id stands for one thing, so rename or remove one of them"
    )]
    ListedTwice {
        /// The id.
        id: String,
        /// Where it was listed first.
        first: Place,
    },
    /// An id does not open with the name of its chapter.
    #[error("`{id}` does not open with its chapter's name; call it `{chapter}-…`")]
    ForeignId {
        /// The id.
        id: String,
        /// The chapter in whose file it stands.
        chapter: String,
    },
    /// A directive's name is not known.
    #[error("there is no directive `{found}`; the directives are {known}")]
    UnknownDirective {
        /// What was written.
        found: String,
        /// The names there are.
        known: &'static str,
    },
    /// A directive has the wrong arguments.
    #[error("`{found}` is not complete; write it as `{usage}`")]
    Arguments {
        /// What was written.
        found: String,
        /// How it is written.
        usage: &'static str,
    },
    /// A block directive shares its line with text.
    #[error("`{found}` shares its line with text; put it on a line of its own")]
    NotAlone {
        /// What was written.
        found: String,
    },
    /// A directive opens a block and nothing closes it.
    #[error("`{opening}` is never closed; write `{closing}` on a line of its own where it ends")]
    Unclosed {
        /// The opening directive.
        opening: String,
        /// What would close it.
        closing: &'static str,
    },
    /// Two braces open a directive, and no two braces close it on the same line.
    #[error("`{{{{` opens a directive which no `}}}}` closes on the same line")]
    UnclosedBraces,
    /// A closing directive closes nothing, or something else.
    #[error("`{found}` closes nothing here: {state}")]
    Unopened {
        /// The closing directive.
        found: String,
        /// What is open.
        state: String,
    },
    /// A block stands where it must not.
    #[error("`{found}` cannot stand here: {rule}")]
    Misplaced {
        /// The directive.
        found: String,
        /// What holds for it.
        rule: &'static str,
    },
    /// A reference or a statement names an id that no catalogue lists.
    #[error("no catalogue in `book/statements/` lists `{id}`{}", nearest(.near))]
    UnknownStatement {
        /// The id.
        id: String,
        /// The most similar id that there is.
        near: Option<String>,
    },
    /// A statement is written twice.
    #[error(
        "`{id}` is already stated at {first}; keep one of the two and refer to it by `{{{{#ref {id}}}}}`"
    )]
    StatedTwice {
        /// The id.
        id: String,
        /// Where it was stated first.
        first: Place,
    },
    /// A figure is not in the registry.
    #[error("no figure is called `{id}`{}; figures are listed in `src/<chapter>/figures/mod.rs`", nearest(.near))]
    UnknownFigure {
        /// The id.
        id: String,
        /// The most similar id that there is.
        near: Option<String>,
    },
    /// A figure has no title or description.
    #[error("the figure `{id}` has no {missing}; a reader who cannot see it needs one")]
    MuteFigure {
        /// The id.
        id: String,
        /// Which text is missing.
        missing: &'static str,
    },
    /// A figure could not be drawn.
    #[error("the figure `{id}` could not be drawn: {reason}")]
    Undrawable {
        /// The id.
        id: String,
        /// What the figure says.
        reason: String,
    },
    /// A formula does not parse.
    #[error("the formula `{formula}` does not parse: {reason}")]
    Formula {
        /// The formula.
        formula: String,
        /// What the parser says.
        reason: String,
    },
    /// A dollar sign belongs to no formula.
    #[error("this `{sign}` belongs to no formula; {remedy}")]
    StrayDollar {
        /// One dollar sign or two.
        sign: &'static str,
        /// What to write instead.
        remedy: &'static str,
    },
    /// A source listing names a file or an item that is not there.
    #[error("the listing of `{item}` from `{path}` is not possible: {reason}")]
    Listing {
        /// The item.
        item: String,
        /// The file.
        path: String,
        /// What is wrong.
        reason: String,
    },
    /// A citation names a key that is not in the bibliography.
    #[error("`book/bibliography.toml` has no entry `{key}`{}", nearest(.near))]
    UnknownCitation {
        /// The key.
        key: String,
        /// The most similar key that there is.
        near: Option<String>,
    },
    /// A term is not in the glossary.
    #[error("`book/glossary.toml` has no entry `{key}`{}", nearest(.near))]
    UnknownTerm {
        /// The key.
        key: String,
        /// The most similar key that there is.
        near: Option<String>,
    },
    /// A computed text is not in the registry.
    #[error("the chapter `{chapter}` computes no `{name}`{}; such functions are listed by `computed::all()` of their chapter", nearest(.near))]
    UnknownComputed {
        /// The chapter.
        chapter: String,
        /// The function.
        name: String,
        /// The most similar name that there is.
        near: Option<String>,
    },
    /// A code block would pass `cargo test` without being run.
    #[error("{what}; {remedy}")]
    Unrun {
        /// What is wrong with the block.
        what: String,
        /// What to write instead.
        remedy: &'static str,
    },
    /// The evidence of the statements could not be collected.
    #[error("the evidence of the statements could not be collected: {reason}")]
    Evidence {
        /// What is wrong.
        reason: String,
    },
    /// A file of an exercise is not what the schema asks for.
    #[error("{found}; {remedy}")]
    Exercise {
        /// What was found.
        found: String,
        /// What to do.
        remedy: String,
    },
    /// mdBook could not load or render the book.
    #[error("mdBook says: {reason}")]
    MdBook {
        /// mdBook's own words.
        reason: String,
    },
    /// The place for the built book cannot be written.
    #[error("the built book cannot be written here ({reason}); name another folder with `--out`")]
    Output {
        /// What the operating system says.
        reason: String,
    },
}

/// The end of a message that suggests a similar name.
fn nearest(near: &Option<String>) -> String {
    match near {
        Some(near) => format!("; did you mean `{near}`?"),
        None => String::new(),
    }
}

/// One thing that is wrong, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {problem}")]
pub struct BookError {
    /// Where.
    pub place: Place,
    /// What.
    pub problem: Problem,
}

impl BookError {
    /// The problem `problem` in the line `line` of `file`.
    pub fn new(file: impl AsRef<Path>, line: usize, problem: Problem) -> Self {
        Self {
            place: Place::new(file.as_ref(), line),
            problem,
        }
    }
}

/// All that is wrong with a book, in the order of files and lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BookErrors(Vec<BookError>);

impl BookErrors {
    /// `Ok` if `errors` is empty, else all of them, sorted by file and line.
    ///
    /// # Errors
    ///
    /// The given errors, if there are any.
    pub fn none_of(mut errors: Vec<BookError>) -> Result<(), Self> {
        if errors.is_empty() {
            return Ok(());
        }
        errors.sort_by(|a, b| a.place.cmp(&b.place));
        errors.dedup();
        Err(Self(errors))
    }

    /// The errors, in the order of files and lines.
    pub fn iter(&self) -> impl Iterator<Item = &BookError> {
        self.0.iter()
    }

    /// How many there are; never 0.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one error")]
    pub fn len(&self) -> usize {
        self.0.len()
    }
}

impl From<BookError> for BookErrors {
    fn from(error: BookError) -> Self {
        Self(vec![error])
    }
}

impl fmt::Display for BookErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for error in &self.0 {
            writeln!(f, "{error}")?;
        }
        match self.0.len() {
            1 => write!(f, "The book has one error."),
            n => write!(f, "The book has {n} errors."),
        }
    }
}

impl std::error::Error for BookErrors {}

/// The candidate most similar to `name`, if one is similar enough to be meant.
///
/// Similar enough is: at most a third of the letters differ.
pub(crate) fn most_similar<'a>(
    name: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<String> {
    candidates
        .into_iter()
        .map(|candidate| (edit_distance(name, candidate), candidate))
        .min()
        .filter(|(distance, _)| 3 * distance <= name.chars().count())
        .map(|(_, candidate)| candidate.to_owned())
}

/// The number of letters to insert, delete or replace to come from `a` to `b` (Levenshtein).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for j in 0..b.len() {
            let replaced = diagonal + usize::from(letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_typing_error_is_recognised() {
        let known = ["bezier-convex-hull", "bezier-blossom"];
        assert_eq!(
            most_similar("bezier-convex-hul", known).as_deref(),
            Some("bezier-convex-hull")
        );
        assert_eq!(most_similar("subdivision", known), None);
    }

    #[test]
    fn edits_are_counted() {
        assert_eq!(edit_distance("knot", "knots"), 1);
        assert_eq!(edit_distance("", "abc"), 3);
        assert_eq!(edit_distance("kitten", "sitting"), 3);
    }
}
