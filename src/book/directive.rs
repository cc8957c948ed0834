//! The directives of the chapters: `{{#statement …}}`, `{{#ref …}}` and their kin.
//!
//! This file knows how one directive is written. Where directives may stand, and which of them open and close blocks,
//! is the business of [`page`](super::page).

use std::collections::BTreeMap;
use std::ops::Range;

use super::error::Problem;

/// One directive of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Directive {
    /// What it asks for.
    pub action: Action,
    /// The bytes of the page it takes, braces included.
    pub span: Range<usize>,
    /// The line of the page, counted from 1.
    pub line: usize,
    /// Whether it fills its line, from the first column on.
    pub alone: bool,
}

/// What a directive asks for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Action {
    /// `{{#statement ID key=name …}}` opens the statement of that id.
    Statement {
        /// The id in the catalogue.
        id: String,
        /// Names of its law and tests where they are not the id's own: `law=end_values`.
        options: Options,
    },
    /// `{{#proof}}` opens the proof of the statement around it.
    Proof,
    /// `{{#errata}}` opens what the lecture notes have wrong about the statement around it.
    Errata,
    /// `{{/statement}}`, `{{/proof}}`, `{{/errata}}` close their block.
    Close(Block),
    /// `{{#figure ID}}` shows a figure.
    Figure {
        /// The id of the figure.
        id: String,
    },
    /// `{{#listing PATH ITEM}}` shows an item of the source code.
    Listing {
        /// The file, relative to the root of the package.
        path: String,
        /// The item: `bernstein`, `BezierCurve`, `BezierCurve::at`.
        item: String,
    },
    /// `{{#ref ID}}` links to a statement or figure; `{{#ref ID number}}` leaves the title out.
    Ref {
        /// The id.
        id: String,
        /// Whether the title is left out.
        number_only: bool,
    },
    /// `{{#cite KEY §4.2}}` cites the bibliography.
    Cite {
        /// The key in the bibliography.
        key: String,
        /// The place in the work cited; may be empty.
        locator: String,
    },
    /// `{{#term KEY}}` introduces a term of the glossary, with the German one.
    Term {
        /// The key in the glossary.
        key: String,
    },
    /// `{{#computed CHAPTER NAME}}` puts in the text that a function computes.
    Computed {
        /// The chapter whose function it is.
        chapter: String,
        /// The name of the function.
        name: String,
    },
}

/// The names that a statement directive gives, by evidence: `law`, `property`, `exact`, …
pub type Options = BTreeMap<String, Vec<String>>;

/// A block that is opened and closed by directives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// A statement.
    Statement,
    /// A proof.
    Proof,
    /// An erratum.
    Errata,
}

impl Block {
    /// The directive that closes it.
    pub fn closing(self) -> &'static str {
        match self {
            Self::Statement => "{{/statement}}",
            Self::Proof => "{{/proof}}",
            Self::Errata => "{{/errata}}",
        }
    }
}

/// How each directive is written, for messages.
const KNOWN: &str =
    "`statement`, `proof`, `errata`, `figure`, `listing`, `ref`, `cite`, `term` and `computed`";

/// The keys that a statement directive may give names for.
const OPTION_KEYS: [&str; 4] = ["law", "property", "exact", "figure"];

impl Action {
    /// Reads a directive, braces included: `{{#ref bezier-blossom}}`.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownDirective`] for a name that is none, [`Problem::Arguments`] for too few or too many words.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::book::directive::Action;
    /// let action = Action::parse("{{#listing src/bezier/curve.rs BezierCurve::at}}")?;
    /// let path = "src/bezier/curve.rs".to_owned();
    /// assert_eq!(action, Action::Listing { path, item: "BezierCurve::at".to_owned() });
    /// assert!(Action::parse("{{#listing src/bezier/curve.rs}}").is_err());
    /// # Ok::<(), cagd::book::error::Problem>(())
    /// ```
    pub fn parse(source: &str) -> Result<Self, Problem> {
        let inner = source
            .strip_prefix("{{")
            .and_then(|rest| rest.strip_suffix("}}"))
            .unwrap_or(source)
            .trim();
        let mut words = inner.split_whitespace();
        let name = words.next().unwrap_or_default();
        let words: Vec<&str> = words.collect();
        let arguments = |usage| Problem::Arguments {
            found: source.to_owned(),
            usage,
        };
        match (name, words.as_slice()) {
            ("#statement", [id, options @ ..]) => Ok(Self::Statement {
                id: (*id).to_owned(),
                options: parse_options(options).ok_or_else(|| arguments(USAGE_STATEMENT))?,
            }),
            ("#statement", []) => Err(arguments(USAGE_STATEMENT)),
            ("#proof", []) => Ok(Self::Proof),
            ("#proof", _) => Err(arguments("{{#proof}}")),
            ("#errata", []) => Ok(Self::Errata),
            ("#errata", _) => Err(arguments("{{#errata}}")),
            ("/statement", []) => Ok(Self::Close(Block::Statement)),
            ("/proof", []) => Ok(Self::Close(Block::Proof)),
            ("/errata", []) => Ok(Self::Close(Block::Errata)),
            ("#figure", [id]) => Ok(Self::Figure {
                id: (*id).to_owned(),
            }),
            ("#figure", _) => Err(arguments("{{#figure ID}}")),
            ("#listing", [path, item]) => Ok(Self::Listing {
                path: (*path).to_owned(),
                item: (*item).to_owned(),
            }),
            ("#listing", _) => Err(arguments("{{#listing PATH ITEM}}")),
            ("#ref", [id]) => Ok(Self::reference(id, false)),
            ("#ref", [id, "number"]) => Ok(Self::reference(id, true)),
            ("#ref", _) => Err(arguments("{{#ref ID}} or {{#ref ID number}}")),
            ("#cite", [key, locator @ ..]) => Ok(Self::Cite {
                key: (*key).to_owned(),
                locator: locator.join(" "),
            }),
            ("#cite", []) => Err(arguments("{{#cite KEY PLACE}}")),
            ("#term", [key]) => Ok(Self::Term {
                key: (*key).to_owned(),
            }),
            ("#term", _) => Err(arguments("{{#term KEY}}")),
            ("#computed", [chapter, name]) => Ok(Self::Computed {
                chapter: (*chapter).to_owned(),
                name: (*name).to_owned(),
            }),
            ("#computed", _) => Err(arguments("{{#computed CHAPTER NAME}}")),
            _ => Err(Problem::UnknownDirective {
                found: name.to_owned(),
                known: KNOWN,
            }),
        }
    }

    /// A reference to `id`.
    fn reference(id: &str, number_only: bool) -> Self {
        Self::Ref {
            id: id.to_owned(),
            number_only,
        }
    }

    /// Whether it must fill its line.
    pub fn is_block(&self) -> bool {
        match self {
            Self::Statement { .. }
            | Self::Proof
            | Self::Errata
            | Self::Close(_)
            | Self::Figure { .. }
            | Self::Listing { .. } => true,
            Self::Ref { .. } | Self::Cite { .. } | Self::Term { .. } | Self::Computed { .. } => {
                false
            }
        }
    }
}

/// How a statement directive is written.
const USAGE_STATEMENT: &str =
    "{{#statement ID}} or {{#statement ID law=NAME property=NAME,NAME exact=NAME figure=NAME}}";

/// Reads `key=name,name` for each word.
fn parse_options(words: &[&str]) -> Option<Options> {
    let mut options = Options::new();
    for word in words {
        let (key, names) = word.split_once('=')?;
        if !OPTION_KEYS.contains(&key) {
            return None;
        }
        let names: Vec<String> = names.split(',').map(str::to_owned).collect();
        if names.iter().any(String::is_empty) {
            return None;
        }
        options.insert(key.to_owned(), names);
    }
    Some(options)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_name_laws_and_tests() {
        let action = Action::parse("{{#statement bezier-x law=end_values exact=a,b}}");
        let Ok(Action::Statement { id, options }) = action else {
            panic!("{action:?} is no statement");
        };
        assert_eq!(id, "bezier-x");
        assert_eq!(options["law"], ["end_values"]);
        assert_eq!(options["exact"], ["a", "b"]);
    }

    #[test]
    fn an_option_without_name_is_refused() {
        assert!(Action::parse("{{#statement bezier-x law=}}").is_err());
        assert!(Action::parse("{{#statement bezier-x lemma=y}}").is_err());
    }

    #[test]
    fn a_citation_keeps_its_place() {
        let action = Action::parse("{{#cite farin2002 §4.2, p. 57}}");
        let key = "farin2002".to_owned();
        let locator = "§4.2, p. 57".to_owned();
        assert_eq!(action, Ok(Action::Cite { key, locator }));
    }

    #[test]
    fn a_misspelt_name_is_refused() {
        let action = Action::parse("{{#theorem bezier-x}}");
        assert!(matches!(action, Err(Problem::UnknownDirective { .. })));
    }
}
