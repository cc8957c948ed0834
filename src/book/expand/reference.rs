//! References to statements and figures, citations, terms.

use super::Expansion;
use super::figure::figure_anchor;
use crate::book::directive::Directive;
use crate::book::site::{escape_inline, link, title_html};

impl Expansion<'_> {
    /// A link to a statement or figure, by number and title.
    pub(super) fn reference(&self, id: &str, number_only: bool, directive: &Directive) -> String {
        let manuscript = self.site.manuscript;
        let statement = self.site.catalogue.get(id);
        if let (Some(statement), Some(written)) = (statement, manuscript.statements.get(id)) {
            let address = format!("{}#{id}", self.site.address(written.page));
            let href = link(self.address, &address);
            let number = self.site.numbered(statement, written);
            let title = title_html(&statement.title);
            return if number_only {
                format!("<a class=\"ref\" href=\"{href}\" title=\"{title}\">{number}</a>")
            } else {
                format!(
                    "<a class=\"ref\" href=\"{href}\">{number} <span class=\"ref-title\">({title})</span></a>"
                )
            };
        }
        if let Some(shown) = manuscript.figures.get(id)
            && self.site.registry.draws(id)
        {
            let address = format!("{}#{}", self.site.address(shown.page), figure_anchor(id));
            let href = link(self.address, &address);
            return format!(
                "<a class=\"ref\" href=\"{href}\">Figure\u{a0}{}</a>",
                shown.number
            );
        }
        match self.site.catalogue.require(id) {
            Ok(statement) => format!(
                "<span class=\"to-come\">{} “{}” <small>(to come)</small></span>",
                statement.kind.title(),
                title_html(&statement.title)
            ),
            Err(problem) => {
                self.report(directive, problem);
                String::new()
            }
        }
    }

    /// A link to the bibliography.
    pub(super) fn citation(&self, key: &str, locator: &str, directive: &Directive) -> String {
        match self.site.data.work(key) {
            Ok(work) => {
                let href = link(self.address, &format!("bibliography.html#{key}"));
                let locator = match locator {
                    "" => String::new(),
                    place => format!(", {}", escape_inline(place)),
                };
                format!(
                    "<a class=\"cite\" href=\"{href}\">{}{locator}</a>",
                    escape_inline(&work.short)
                )
            }
            Err(problem) => {
                self.report(directive, problem);
                String::new()
            }
        }
    }

    /// A term with its German name, linked to the glossary.
    pub(super) fn term(&self, key: &str, directive: &Directive) -> String {
        match self.site.data.term(key) {
            Ok(term) => {
                let href = link(self.address, &format!("glossary.html#{key}"));
                format!(
                    "<dfn><a href=\"{href}\">{}</a></dfn> <span class=\"german\" lang=\"de\">({})</span>",
                    escape_inline(&term.english),
                    escape_inline(&term.german)
                )
            }
            Err(problem) => {
                self.report(directive, problem);
                String::new()
            }
        }
    }
}
