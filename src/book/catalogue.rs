//! The catalogue: every statement of the workbook by id, known from the start.
//!
//! It is read from `book/statements/<chapter>.toml`. What a statement says stands in the chapter's pages; the
//! catalogue says what it is called, where it comes from and which evidence it needs.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::error::{BookError, BookErrors, Place, Problem, most_similar};

/// The chapters, in reading order.
///
/// The place of a chapter, counted from 1, is the first part of the numbers of its statements.
pub const CHAPTERS: [&str; 9] = [
    "affine",
    "curves",
    "interpolation",
    "bezier",
    "bspline",
    "nurbs",
    "surfaces",
    "subdivision",
    "moebius",
];

/// The number of a chapter, counted from 1 in reading order.
///
/// ```
/// use cagd::book::catalogue::chapter_number;
/// assert_eq!(chapter_number("bezier"), Some(4));
/// assert_eq!(chapter_number("topology"), None);
/// ```
pub fn chapter_number(chapter: &str) -> Option<usize> {
    CHAPTERS.iter().position(|&c| c == chapter).map(|i| i + 1)
}

/// What a statement is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A definition.
    Definition,
    /// A theorem.
    Theorem,
    /// A lemma.
    Lemma,
    /// A corollary.
    Corollary,
    /// An algorithm.
    Algorithm,
    /// A worked example.
    Example,
    /// A remark.
    Remark,
    /// An exercise of the lecture notes.
    Exercise,
    /// A figure.
    Figure,
}

impl Kind {
    /// All kinds, in the order in which the statement index offers them.
    pub const ALL: [Self; 9] = [
        Self::Definition,
        Self::Theorem,
        Self::Lemma,
        Self::Corollary,
        Self::Algorithm,
        Self::Example,
        Self::Remark,
        Self::Exercise,
        Self::Figure,
    ];

    /// The name as it opens a statement: `Theorem`.
    pub fn title(self) -> &'static str {
        match self {
            Self::Definition => "Definition",
            Self::Theorem => "Theorem",
            Self::Lemma => "Lemma",
            Self::Corollary => "Corollary",
            Self::Algorithm => "Algorithm",
            Self::Example => "Example",
            Self::Remark => "Remark",
            Self::Exercise => "Exercise",
            Self::Figure => "Figure",
        }
    }

    /// The name as the catalogue and the pages' classes write it: `theorem`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Definition => "definition",
            Self::Theorem => "theorem",
            Self::Lemma => "lemma",
            Self::Corollary => "corollary",
            Self::Algorithm => "algorithm",
            Self::Example => "example",
            Self::Remark => "remark",
            Self::Exercise => "exercise",
            Self::Figure => "figure",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A kind of evidence that a statement needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Need {
    /// A Rust block of the chapter that asserts what the statement says.
    Example,
    /// A property test.
    Property,
    /// A test over exact numbers.
    Exact,
    /// A reviewed figure.
    Figure,
    /// A figure that the reader can change.
    Interactive,
    /// An exercise that trains it.
    Exercise,
    /// A complete proof in the chapter.
    Proof,
    /// A block that must not compile, with its error code.
    CompileFail,
}

impl Need {
    /// All kinds of evidence, in the order in which they are shown.
    pub const ALL: [Self; 8] = [
        Self::Example,
        Self::Property,
        Self::Exact,
        Self::Figure,
        Self::Interactive,
        Self::Exercise,
        Self::Proof,
        Self::CompileFail,
    ];

    /// The name as the catalogue writes it: `compile_fail`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Example => "example",
            Self::Property => "property",
            Self::Exact => "exact",
            Self::Figure => "figure",
            Self::Interactive => "interactive",
            Self::Exercise => "exercise",
            Self::Proof => "proof",
            Self::CompileFail => "compile_fail",
        }
    }
}

impl fmt::Display for Need {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One statement of the catalogue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The id, for instance `bezier-convex-hull`.
    pub id: String,
    /// The chapter, for instance `bezier`.
    pub chapter: &'static str,
    /// What it is.
    pub kind: Kind,
    /// What it is called.
    pub title: String,
    /// Where the lecture notes have it, for instance `Compendium Theorem 8`.
    pub sources: Vec<String>,
    /// The evidence it needs.
    pub needs: Vec<Need>,
    /// Whether the lecture notes have something wrong here.
    pub errata: bool,
    /// Where the catalogue lists it.
    pub place: Place,
}

impl Statement {
    /// The name that its law, tests and figure have in the code: the id without the chapter, with underscores.
    ///
    /// `bezier-convex-hull` ⇒ `convex_hull`.
    pub fn code_name(&self) -> String {
        self.id
            .strip_prefix(self.chapter)
            .and_then(|rest| rest.strip_prefix('-'))
            .unwrap_or(&self.id)
            .replace('-', "_")
    }
}

/// All statements of the workbook, chapter by chapter in reading order.
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    statements: Vec<Statement>,
    by_id: BTreeMap<String, usize>,
}

/// The file of one chapter.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChapterFile {
    #[serde(default, rename = "statement")]
    statements: Vec<Entry>,
}

/// One entry of a chapter's file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    id: Spanned<String>,
    kind: Kind,
    title: String,
    sources: Vec<String>,
    needs: Vec<Need>,
    #[serde(default)]
    errata: bool,
}

impl Catalogue {
    /// Reads the catalogue below `root`, the folder that holds `book/`.
    ///
    /// A chapter without a file has no statements.
    ///
    /// # Errors
    ///
    /// Each file that cannot be read or parsed, each id that is listed twice or does not open with its chapter's name.
    pub fn load(root: &Path) -> Result<Self, BookErrors> {
        let mut catalogue = Self::default();
        let mut errors = Vec::new();
        for chapter in CHAPTERS {
            let file = PathBuf::from(format!("book/statements/{chapter}.toml"));
            match std::fs::read_to_string(root.join(&file)) {
                Ok(text) => catalogue.add_chapter(chapter, &file, &text, &mut errors),
                Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
                Err(e) => {
                    let reason = e.to_string();
                    errors.push(BookError::new(file, 1, Problem::Unreadable { reason }));
                }
            }
        }
        BookErrors::none_of(errors)?;
        Ok(catalogue)
    }

    /// Adds the statements of one chapter's file.
    fn add_chapter(
        &mut self,
        chapter: &'static str,
        file: &Path,
        text: &str,
        errors: &mut Vec<BookError>,
    ) {
        let parsed: ChapterFile = match toml::from_str(text) {
            Ok(parsed) => parsed,
            Err(error) => {
                errors.push(toml_error(file, text, &error));
                return;
            }
        };
        for entry in parsed.statements {
            let line = line_of(text, entry.id.span().start);
            let id = entry.id.into_inner();
            if !id.starts_with(&format!("{chapter}-")) {
                let chapter = chapter.to_owned();
                errors.push(BookError::new(
                    file,
                    line,
                    Problem::ForeignId { id, chapter },
                ));
                continue;
            }
            if let Some(first) = self.get(&id) {
                let first = first.place.clone();
                errors.push(BookError::new(
                    file,
                    line,
                    Problem::ListedTwice { id, first },
                ));
                continue;
            }
            self.by_id.insert(id.clone(), self.statements.len());
            self.statements.push(Statement {
                id,
                chapter,
                kind: entry.kind,
                title: entry.title,
                sources: entry.sources,
                needs: entry.needs,
                errata: entry.errata,
                place: Place::new(file, line),
            });
        }
    }

    /// The statement with this id.
    pub fn get(&self, id: &str) -> Option<&Statement> {
        self.by_id.get(id).map(|&index| &self.statements[index])
    }

    /// The statement with this id, or the error that says what may have been meant.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownStatement`] if no chapter lists it.
    pub fn require(&self, id: &str) -> Result<&Statement, Problem> {
        self.get(id).ok_or_else(|| Problem::UnknownStatement {
            id: id.to_owned(),
            near: most_similar(id, self.by_id.keys().map(String::as_str)),
        })
    }

    /// All statements, chapter by chapter, each chapter in the order of the lecture notes.
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }

    /// The statements of one chapter.
    pub fn chapter<'a>(&'a self, chapter: &'a str) -> impl Iterator<Item = &'a Statement> {
        self.statements.iter().filter(move |s| s.chapter == chapter)
    }
}

/// The error of a TOML file, with its line.
pub(crate) fn toml_error(file: &Path, text: &str, error: &toml::de::Error) -> BookError {
    let line = error.span().map_or(1, |span| line_of(text, span.start));
    let reason = error.message().to_owned();
    BookError::new(file, line, Problem::Data { reason })
}

/// The line, counted from 1, that holds the byte `offset`.
pub(crate) fn line_of(text: &str, offset: usize) -> usize {
    text.as_bytes()[..offset.min(text.len())]
        .iter()
        .filter(|&&byte| byte == b'\n')
        .count()
        + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The catalogue of this package.
    fn catalogue() -> Catalogue {
        Catalogue::load(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the catalogue loads")
    }

    #[test]
    fn every_statement_is_listed() {
        assert_eq!(catalogue().statements().len(), 372);
        assert_eq!(catalogue().chapter("bezier").count(), 72);
    }

    #[test]
    fn a_code_name_drops_the_chapter() {
        let catalogue = catalogue();
        let statement = catalogue
            .get("bezier-convex-hull")
            .expect("the catalogue lists it");
        assert_eq!(statement.code_name(), "convex_hull");
        assert_eq!(statement.kind, Kind::Theorem);
    }

    #[test]
    fn the_names_of_kinds_and_needs_are_those_of_the_files() {
        for kind in Kind::ALL {
            let text = serde_json::to_string(&kind).expect("a kind serialises");
            assert_eq!(text, format!("\"{kind}\""));
        }
        for need in Need::ALL {
            let text = serde_json::to_string(&need).expect("a need serialises");
            assert_eq!(text, format!("\"{need}\""));
        }
    }

    #[test]
    fn an_id_listed_twice_is_refused_with_both_lines() {
        let text = "[[statement]]\nid = \"bezier-a\"\nkind = \"lemma\"\ntitle = \"A\"\nsources = []\nneeds = []\n";
        let mut catalogue = Catalogue::default();
        let mut errors = Vec::new();
        let file = Path::new("book/statements/bezier.toml");
        catalogue.add_chapter("bezier", file, &text.repeat(2), &mut errors);
        let first = Place::new(file, 2);
        let id = "bezier-a".to_owned();
        assert_eq!(
            errors,
            [BookError::new(file, 8, Problem::ListedTwice { id, first })]
        );
    }
}
