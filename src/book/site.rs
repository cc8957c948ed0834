//! What every expansion looks things up in, and where it reports errors.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path};
use std::sync::{Mutex, OnceLock};

use super::catalogue::{Catalogue, Statement};
use super::data::Data;
use super::error::{BookError, Place};
use super::evidence::AllEvidence;
use super::exercise::Exercises;
use super::formula::Formulas;
use super::laws::Laws;
use super::listing::Listings;
use super::manuscript::{Manuscript, Written};
use super::registry::Registry;

/// The book as a whole.
pub(crate) struct Site<'a> {
    pub(crate) root: &'a Path,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) data: &'a Data,
    pub(crate) manuscript: &'a Manuscript,
    pub(crate) registry: &'a Registry,
    pub(crate) exercises: &'a Exercises,
    /// Whether the pages show the solutions of the exercises.
    pub(crate) with_solutions: bool,
    /// The evidence, once another thread has found it.
    pub(crate) evidence: OnceLock<AllEvidence>,
    pub(crate) laws: &'a Laws,
    pub(crate) formulas: Formulas,
    pub(crate) listings: Listings,
    /// The lines of source files that a page links to; these files become pages.
    pub(crate) linked: Mutex<BTreeMap<String, BTreeSet<usize>>>,
    errors: Mutex<Vec<BookError>>,
}

/// What a site is made from.
pub(crate) struct Parts<'a> {
    pub(crate) root: &'a Path,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) data: &'a Data,
    pub(crate) manuscript: &'a Manuscript,
    pub(crate) registry: &'a Registry,
    pub(crate) laws: &'a Laws,
    pub(crate) exercises: &'a Exercises,
    /// Whether the pages show the solutions of the exercises.
    pub(crate) with_solutions: bool,
}

impl<'a> Site<'a> {
    /// The site with nothing linked yet; `errors` are those found so far.
    pub(crate) fn new(parts: Parts<'a>, errors: Vec<BookError>) -> Self {
        Self {
            root: parts.root,
            catalogue: parts.catalogue,
            data: parts.data,
            manuscript: parts.manuscript,
            registry: parts.registry,
            exercises: parts.exercises,
            with_solutions: parts.with_solutions,
            evidence: OnceLock::new(),
            laws: parts.laws,
            formulas: Formulas::new(),
            listings: Listings::default(),
            linked: Mutex::new(BTreeMap::new()),
            errors: Mutex::new(errors),
        }
    }

    /// Reports an error.
    pub(crate) fn report(&self, error: BookError) {
        let mut errors = self.errors.lock().unwrap_or_else(|e| e.into_inner());
        errors.push(error);
    }

    /// All errors that were reported.
    pub(crate) fn into_errors(self) -> Vec<BookError> {
        self.errors.into_inner().unwrap_or_else(|e| e.into_inner())
    }

    /// The address of the built page with the index `page`, from the top of the site: `bezier/shape.html`.
    pub(crate) fn address(&self, page: usize) -> String {
        address_of(&self.manuscript.pages[page].file)
    }

    /// The address of a line of a source file; the file becomes a page of the site.
    pub(crate) fn source(&self, place: &Place) -> String {
        let path = slashes(&place.file);
        let mut linked = self.linked.lock().unwrap_or_else(|e| e.into_inner());
        let address = format!("source/{path}.html#L{}", place.line);
        linked.entry(path).or_default().insert(place.line);
        address
    }

    /// The name of a statement without its title: `Theorem 4.12`.
    pub(crate) fn numbered(&self, statement: &Statement, written: &Written) -> String {
        format!("{}\u{a0}{}", statement.kind.title(), written.number)
    }
}

/// The address of the page made from the Markdown file `file`, from the top of the site.
pub(crate) fn address_of(file: &Path) -> String {
    let below = file.strip_prefix("book/src").unwrap_or(file);
    slashes(&below.with_extension("html"))
}

/// A path with forward slashes on every system.
pub(crate) fn slashes(path: &Path) -> String {
    let parts: Vec<_> = path
        .components()
        .filter_map(|component| match component {
            Component::Normal(part) => part.to_str(),
            _ => None,
        })
        .collect();
    parts.join("/")
}

/// The link from one page to an address, both from the top of the site.
///
/// A link within a page is its anchor alone.
pub(crate) fn link(from: &str, to: &str) -> String {
    if let Some(anchor) = to.strip_prefix(from)
        && anchor.starts_with('#')
    {
        return anchor.to_owned();
    }
    let up = "../".repeat(from.matches('/').count());
    format!("{up}{to}")
}

/// Text as HTML: `&`, `<`, `>` and quotes written as entities.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            _ => escaped.push(letter),
        }
    }
    escaped
}

/// Text as HTML that may stand in a paragraph of Markdown.
pub(crate) fn escape_inline(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' | '<' | '>' | '"' | '*' | '_' | '`' | '[' | ']' | '\\' | '~' | '|' | '!' | '$'
            | '^' | '{' | '}' => escaped.push_str(&format!("&#{};", u32::from(letter))),
            _ => escaped.push(letter),
        }
    }
    escaped
}

/// A title as HTML: powers such as `X^2` and `C^infinity` are raised.
pub(crate) fn title_html(title: &str) -> String {
    let mut parts = title.split('^');
    let mut html = escape_inline(parts.next().unwrap_or_default());
    for part in parts {
        let end = part
            .find(|c: char| !c.is_alphanumeric())
            .unwrap_or(part.len());
        let (power, rest) = part.split_at(end);
        let power = if power == "infinity" { "∞" } else { power };
        html.push_str(&format!(
            "<sup>{}</sup>{}",
            escape(power),
            escape_inline(rest)
        ));
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_go_up_and_stay_within_a_page() {
        assert_eq!(
            link("bezier/shape.html", "errata.html#x"),
            "../errata.html#x"
        );
        assert_eq!(link("bezier/shape.html", "bezier/shape.html#x"), "#x");
        assert_eq!(link("a.html", "bezier/shape.html#x"), "bezier/shape.html#x");
    }

    #[test]
    fn powers_in_titles_are_raised() {
        assert_eq!(
            title_html("X, X^2 and C^infinity"),
            "X, X<sup>2</sup> and C<sup>∞</sup>"
        );
    }
}
