//! The expansion of a page: directives and formulas become the HTML and Markdown that mdBook renders.
//!
//! Each kind of directive has a file of its own here. An expansion never shifts what it does not replace: it cuts the
//! page at the bytes of directives and formulas and puts something else in their place.

mod code;
mod exercise;
mod figure;
mod formula;
mod listing;
mod reference;
mod statement;

pub(crate) use exercise::{LIST, exercise_html, exercises_of_page};
pub(crate) use statement::errata_anchor;

use std::ops::Range;

use super::catalogue::line_of;
use super::directive::{Action, Block, Directive};
use super::error::{BookError, Problem};
use super::page::Page;
use super::site::Site;

/// Which line of its file a line of a text is.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Lines {
    /// The text is the file.
    Same,
    /// All of the text is made from this line.
    At(usize),
    /// The text stands in the file from this line on.
    From(usize),
}

impl Lines {
    /// The line of the file for a line of the text, both counted from 1.
    fn of(self, line: usize) -> usize {
        match self {
            Self::Same => line,
            Self::At(at) => at,
            Self::From(first) => first + line - 1,
        }
    }
}

/// One page, or a part of it, on its way into the site.
pub(crate) struct Expansion<'a> {
    pub(crate) site: &'a Site<'a>,
    pub(crate) page: &'a Page,
    /// The address of the page it becomes part of.
    pub(crate) address: &'a str,
    /// Whether this repeats what stands elsewhere: then it carries no anchors, since each exists once.
    pub(crate) repeated: bool,
    /// The lines to which errors belong.
    pub(crate) lines: Lines,
}

impl Expansion<'_> {
    /// The bytes `range` of the page, expanded.
    pub(crate) fn expand(&self, range: Range<usize>) -> String {
        let inside = |span: &Range<usize>| range.start <= span.start && span.end <= range.end;
        let mut edits = Vec::new();
        // Formulas first: the evidence that the statements wait for is still being looked up.
        for formula in self.page.formulas.iter().filter(|f| inside(&f.span)) {
            edits.push(self.formula_in_its_place(formula, &range));
        }
        for directive in self.page.directives.iter().filter(|d| inside(&d.span)) {
            edits.push((directive.span.clone(), self.directive(directive)));
        }
        self.code_anchors(&mut edits);
        edits.retain(|(span, _)| inside(span));
        edits.sort_by_key(|(span, _)| (span.start, span.end));
        let mut expanded = String::with_capacity(2 * range.len());
        let mut at = range.start;
        for (span, replacement) in edits {
            expanded.push_str(&self.page.text[at..span.start]);
            expanded.push_str(&replacement);
            at = span.end;
        }
        expanded.push_str(&self.page.text[at..range.end]);
        expanded
    }

    /// What stands in the place of a directive.
    fn directive(&self, directive: &Directive) -> String {
        match &directive.action {
            Action::Statement { id, .. } => self.open_statement(id),
            Action::Close(Block::Statement) => self.close_statement(directive),
            Action::Proof => self.open_proof(directive),
            Action::Close(Block::Proof) => self.close_proof(directive),
            Action::Errata => self.open_errata(directive),
            Action::Close(Block::Errata) => "\n\n</aside>\n\n".to_owned(),
            Action::Figure { id } => self.figure(id, directive),
            Action::Listing { path, item } => self.listing(path, item, directive),
            Action::Ref { id, number_only } => self.reference(id, *number_only, directive),
            Action::Cite { key, locator } => self.citation(key, locator, directive),
            Action::Term { key } => self.term(key, directive),
            Action::Computed { chapter, name } => self.computed(chapter, name, directive),
        }
    }

    /// Reports a problem with a directive.
    fn report(&self, directive: &Directive, problem: Problem) {
        self.report_line(directive.line, problem);
    }

    /// Reports a problem in a line of the page.
    fn report_line(&self, line: usize, problem: Problem) {
        let line = self.lines.of(line);
        self.site
            .report(BookError::new(&self.page.file, line, problem));
    }

    /// The text that a function computes, itself expanded.
    fn computed(&self, chapter: &str, name: &str, directive: &Directive) -> String {
        match self.site.registry.computed(chapter, name) {
            Ok(text) => {
                let line = self.lines.of(directive.line);
                let text = text.trim();
                let expanded = fragment(self.site, self.page, self.address, line, text);
                if directive.alone && text.contains('\n') {
                    format!("\n\n{expanded}\n\n")
                } else {
                    expanded
                }
            }
            Err(problem) => {
                self.report(directive, problem);
                String::new()
            }
        }
    }
}

/// Markdown that is not a page, expanded; errors belong to the line `line` of `page`.
pub(crate) fn fragment(
    site: &Site<'_>,
    page: &Page,
    address: &str,
    line: usize,
    text: &str,
) -> String {
    fragment_of(site, page, address, Lines::At(line), text)
}

/// Markdown that is not a page, expanded; errors belong to the lines `lines` of `page`.
pub(crate) fn fragment_of(
    site: &Site<'_>,
    page: &Page,
    address: &str,
    lines: Lines,
    text: &str,
) -> String {
    let mut errors = Vec::new();
    let part = Page::parse(&page.file, text, &mut errors);
    for error in errors {
        let line = lines.of(error.place.line);
        site.report(BookError::new(&page.file, line, error.problem));
    }
    Expansion {
        site,
        page: &part,
        address,
        repeated: false,
        lines,
    }
    .expand(0..text.len())
}

/// Markdown of a data file, expanded; errors belong to the line that holds it.
pub(crate) fn data_fragment(site: &Site<'_>, file: &str, address: &str, text: &str) -> String {
    data_fragment_at(site, file, address, text, text)
}

/// Markdown made from `origin` in a data file, expanded; errors belong to the line that holds `origin`.
pub(crate) fn data_fragment_at(
    site: &Site<'_>,
    file: &str,
    address: &str,
    text: &str,
    origin: &str,
) -> String {
    let source = std::fs::read_to_string(site.root.join(file)).unwrap_or_default();
    let line = source.find(origin).map_or(1, |at| line_of(&source, at));
    let mut errors = Vec::new();
    let page = Page::parse(file, "", &mut errors);
    fragment(site, &page, address, line, text)
}
