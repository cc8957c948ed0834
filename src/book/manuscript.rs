//! The manuscript: all pages in reading order, and the numbers of what they state and show.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag};

use super::catalogue::{Catalogue, Kind, chapter_number, line_of};
use super::directive::Action;
use super::error::{BookError, Place, Problem};
use super::page::Page;

/// All pages of the book, in reading order.
#[derive(Debug, Clone, Default)]
pub struct Manuscript {
    /// The pages.
    pub pages: Vec<Page>,
    /// The statements that are written, by id.
    pub statements: BTreeMap<String, Written>,
    /// The figures that are shown, by id: each where it stands first.
    pub figures: BTreeMap<String, Written>,
}

/// Where a statement or figure stands, and its number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The index of its page in [`Manuscript::pages`].
    pub page: usize,
    /// The line of its directive.
    pub line: usize,
    /// The byte at which its directive opens.
    pub offset: usize,
    /// Its number: `4.12`.
    pub number: String,
}

impl Manuscript {
    /// Reads the pages that `book/src/SUMMARY.md` below `root` lists.
    ///
    /// What is wrong with them is added to `errors`.
    pub fn load(root: &Path, catalogue: &Catalogue, errors: &mut Vec<BookError>) -> Self {
        let mut sources = Vec::new();
        for (file, line) in summary(root, errors) {
            match std::fs::read_to_string(root.join(&file)) {
                Ok(text) => sources.push((file, text)),
                Err(e) => {
                    let reason = format!("{}: {e}", file.display());
                    let problem = Problem::Unreadable { reason };
                    errors.push(BookError::new(SUMMARY, line, problem));
                }
            }
        }
        Self::new(sources, catalogue, errors)
    }

    /// Takes the given pages apart and numbers what they state and show.
    ///
    /// What is wrong with them is added to `errors`.
    pub fn new(
        sources: Vec<(PathBuf, String)>,
        catalogue: &Catalogue,
        errors: &mut Vec<BookError>,
    ) -> Self {
        let mut manuscript = Self {
            pages: sources
                .into_iter()
                .map(|(file, text)| Page::parse(file, &text, errors))
                .collect(),
            ..Self::default()
        };
        manuscript.number(catalogue, errors);
        manuscript
    }

    /// Numbers statements and figures, each kind of count beginning anew in each chapter.
    ///
    /// Statements share one count. Figures have another, and a statement of the kind *figure* takes its number from
    /// theirs: the first figure in it is the one it is about.
    fn number(&mut self, catalogue: &Catalogue, errors: &mut Vec<BookError>) {
        let mut counts: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
        for (index, page) in self.pages.iter().enumerate() {
            let Some(chapter) = page.chapter else {
                continue;
            };
            let first = chapter_number(chapter).unwrap_or_default();
            let (statements, figures) = counts.entry(chapter).or_default();
            // The number that the next figure shares with the statement around it.
            let mut shared: Option<String> = None;
            for directive in &page.directives {
                let written = |number: String| Written {
                    page: index,
                    line: directive.line,
                    offset: directive.span.start,
                    number,
                };
                match &directive.action {
                    Action::Statement { id, .. } => {
                        let problem = |problem| BookError::new(&page.file, directive.line, problem);
                        let statement = match catalogue.require(id) {
                            Ok(statement) => statement,
                            Err(unknown) => {
                                errors.push(problem(unknown));
                                continue;
                            }
                        };
                        if let Some(first) = self.statements.get(id) {
                            let first = Place::new(&self.pages[first.page].file, first.line);
                            let id = id.clone();
                            errors.push(problem(Problem::StatedTwice { id, first }));
                            continue;
                        }
                        let number = if statement.kind == Kind::Figure {
                            *figures += 1;
                            let number = format!("{first}.{figures}");
                            shared = Some(number.clone());
                            number
                        } else {
                            shared = None;
                            *statements += 1;
                            format!("{first}.{statements}")
                        };
                        self.statements.insert(id.clone(), written(number));
                    }
                    Action::Close(super::directive::Block::Statement) => shared = None,
                    Action::Figure { id } if !self.figures.contains_key(id) => {
                        let number = shared.take().unwrap_or_else(|| {
                            *figures += 1;
                            format!("{first}.{figures}")
                        });
                        self.figures.insert(id.clone(), written(number));
                    }
                    _ => {}
                }
            }
        }
    }
}

/// The table of contents.
const SUMMARY: &str = "book/src/SUMMARY.md";

/// The pages that the table of contents lists, each with its line there.
fn summary(root: &Path, errors: &mut Vec<BookError>) -> Vec<(PathBuf, usize)> {
    let text = match std::fs::read_to_string(root.join(SUMMARY)) {
        Ok(text) => text,
        Err(e) => {
            let reason = e.to_string();
            errors.push(BookError::new(SUMMARY, 1, Problem::Unreadable { reason }));
            return Vec::new();
        }
    };
    Parser::new_ext(&text, Options::empty())
        .into_offset_iter()
        .filter_map(|(event, span)| match event {
            Event::Start(Tag::Link { dest_url, .. }) if !dest_url.is_empty() => {
                let file = Path::new("book/src").join(&*dest_url);
                Some((file, line_of(&text, span.start)))
            }
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_statement_shares_the_number_of_its_figure() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let catalogue = Catalogue::load(root).expect("the catalogue loads");
        let text = "{{#statement bezier-blossom}}\n{{#figure bezier-blossom}}\n{{/statement}}\n\
                    {{#statement bezier-figure-convex-hull}}\n{{#figure bezier-figure-convex-hull}}\n{{/statement}}\n\
                    {{#statement bezier-convex-hull}}\n{{#figure bezier-blossom}}\n{{/statement}}\n";
        let mut errors = Vec::new();
        let sources = vec![("book/src/bezier/x.md".into(), text.to_owned())];
        let manuscript = Manuscript::new(sources, &catalogue, &mut errors);
        assert_eq!(errors, []);
        let number = |id: &str| manuscript.statements[id].number.clone();
        assert_eq!(number("bezier-blossom"), "4.1");
        assert_eq!(number("bezier-figure-convex-hull"), "4.2");
        assert_eq!(number("bezier-convex-hull"), "4.2");
        assert_eq!(manuscript.figures["bezier-blossom"].number, "4.1");
        assert_eq!(
            manuscript.figures["bezier-figure-convex-hull"].number,
            "4.2"
        );
        assert_eq!(manuscript.figures["bezier-blossom"].line, 2);
    }
}
