//! Statements, proofs and errata: the boxes of the book, and the quiet lines under them.

use pulldown_cmark::{Event, Parser, TagEnd};

use super::Expansion;
use super::code::code_anchor;
use super::figure::figure_anchor;
use crate::book::catalogue::Need;
use crate::book::directive::Directive;
use crate::book::error::Place;
use crate::book::page::{InnerBlock, StatementBlock, markdown};
use crate::book::site::{escape, link, title_html};

impl Expansion<'_> {
    /// The statement around a directive.
    fn around(&self, directive: &Directive) -> Option<&StatementBlock> {
        self.page
            .statements
            .iter()
            .find(|statement| statement.span.contains(&directive.span.start))
    }

    /// Opens the section of a statement: its name, number and title.
    pub(super) fn open_statement(&self, id: &str) -> String {
        // What is not listed or stated twice was reported when the manuscript was numbered.
        let (Some(statement), Some(written)) = (
            self.site.catalogue.get(id),
            self.site.manuscript.statements.get(id),
        ) else {
            return String::new();
        };
        let kind = statement.kind;
        let found: Vec<&str> = self
            .evidence(id)
            .into_iter()
            .map(|(need, _)| need.name())
            .collect();
        format!(
            "\n\n<section id=\"{id}\" class=\"{kind}\" data-evidence=\"{}\">\n<h3 class=\"statement-head\" id=\"{id}--title\"><span class=\"statement-number\">{}</span> <span class=\"statement-title\">{}</span> <a class=\"permalink\" href=\"#{id}\" aria-label=\"Link to this {kind}\"></a></h3>\n\n",
            found.join(" "),
            self.site.numbered(statement, written),
            title_html(&statement.title),
        )
    }

    /// Closes the section of a statement: its sources and evidence.
    pub(super) fn close_statement(&self, directive: &Directive) -> String {
        let block = self
            .page
            .statements
            .iter()
            .find(|statement| statement.span.end == directive.span.end);
        let Some(block) = block else {
            return String::new();
        };
        let Some(statement) = self.site.catalogue.get(&block.id) else {
            return String::new();
        };
        let mut lines = Vec::new();
        let evidence: Vec<String> = self
            .evidence(&block.id)
            .into_iter()
            .map(|(need, places)| self.evidence_links(block, need, places))
            .collect();
        let laws: Vec<String> = self
            .site
            .laws
            .of(statement, &block.options)
            .into_iter()
            .map(|(name, place)| {
                let href = link(self.address, &self.site.source(&place));
                format!("<a href=\"{href}\"><code>{name}</code></a>")
            })
            .collect();
        if !laws.is_empty() {
            let name = if laws.len() == 1 { "Law" } else { "Laws" };
            lines.push(format!(
                "<span class=\"laws\"><b>{name}</b> {}</span>",
                laws.join(", ")
            ));
        }
        if !evidence.is_empty() {
            lines.push(format!(
                "<span class=\"evidence\"><b>Verified by</b> {}</span>",
                evidence.join(", ")
            ));
        }
        if !statement.sources.is_empty() {
            lines.push(format!(
                "<span class=\"sources\"><b>In the notes</b> {}</span>",
                escape(&statement.sources.join("; "))
            ));
        }
        format!(
            "\n\n<footer class=\"statement-foot\">{}</footer>\n\n</section>\n\n",
            lines.join(" ")
        )
    }

    /// The evidence found for a statement, by kind.
    fn evidence(&self, id: &str) -> Vec<(Need, &[Place])> {
        let Some(evidence) = self.site.evidence.wait().get(id) else {
            return Vec::new();
        };
        Need::ALL
            .into_iter()
            .map(|need| (need, evidence.of(need)))
            .filter(|(_, places)| !places.is_empty())
            .collect()
    }

    /// One kind of evidence: its name links to the first place, numbers to the others.
    fn evidence_links(&self, block: &StatementBlock, need: Need, places: &[Place]) -> String {
        let name = need.name().replace('_', " ");
        let links: Vec<String> = places
            .iter()
            .enumerate()
            .map(|(index, place)| {
                let href = self.evidence_address(block, place);
                let text = match index {
                    0 => name.clone(),
                    _ => (index + 1).to_string(),
                };
                format!("<a href=\"{href}\">{text}</a>")
            })
            .collect();
        links.join("\u{a0}")
    }

    /// The link to a piece of evidence: an anchor of this page or a line of a source page.
    fn evidence_address(&self, block: &StatementBlock, place: &Place) -> String {
        if let Some(exercise) = self.site.exercises.iter().find(|e| e.file() == place.file) {
            return link(self.address, &self.site.exercise_address(exercise));
        }
        if place
            .file
            .extension()
            .is_some_and(|extension| extension == "rs")
        {
            return link(self.address, &self.site.source(place));
        }
        let id = &block.id;
        let figure = block.figures.iter().find(|(_, line)| *line == place.line);
        let anchor = if block.proofs.iter().any(|proof| proof.line == place.line) {
            format!("{id}--proof")
        } else if let Some((figure, _)) = figure
            && let Some(first) = self.site.manuscript.figures.get(figure)
            && self.site.registry.draws(figure)
        {
            // A figure that is shown twice has its anchor where it stands first.
            let address = format!(
                "{}#{}",
                self.site.address(first.page),
                figure_anchor(figure)
            );
            return link(self.address, &address);
        } else if block
            .code
            .iter()
            .any(|&code| self.page.code[code].line == place.line)
        {
            code_anchor(id, place.line - block.line)
        } else {
            id.clone()
        };
        format!("#{anchor}")
    }

    /// Opens a proof. It is open when the page is, and can be folded away by who wants to find it alone.
    pub(super) fn open_proof(&self, directive: &Directive) -> String {
        let anchor = match self.around(directive) {
            Some(statement)
                if !self.repeated
                    && statement
                        .proofs
                        .first()
                        .is_some_and(|proof| proof.span.start == directive.span.start) =>
            {
                format!(" id=\"{}--proof\"", statement.id)
            }
            _ => String::new(),
        };
        format!("\n\n<details class=\"proof\"{anchor} open>\n<summary>Proof</summary>\n\n")
    }

    /// Closes a proof with its end mark: in the last sentence where there is one, else on a line of its own.
    pub(super) fn close_proof(&self, directive: &Directive) -> String {
        let body = self.around(directive).and_then(|statement| {
            let ends = |proof: &&InnerBlock| proof.span.end == directive.span.end;
            let proof = statement.proofs.iter().find(ends)?;
            Some(&self.page.text[proof.body.clone()])
        });
        let sentence = body.is_some_and(ends_in_paragraph);
        let mark = "<span class=\"qed\" title=\"end of the proof\">∎</span>";
        if sentence {
            format!("{mark}\n\n</details>\n\n")
        } else {
            format!("\n\n<p class=\"qed-line\">{mark}</p>\n\n</details>\n\n")
        }
    }

    /// Opens what the lecture notes have wrong.
    pub(super) fn open_errata(&self, directive: &Directive) -> String {
        let anchor = match self.around(directive) {
            Some(statement) if !self.repeated => {
                let number = statement
                    .errata
                    .iter()
                    .position(|errata| errata.span.start == directive.span.start)
                    .unwrap_or_default();
                format!(" id=\"{}\"", errata_anchor(&statement.id, number))
            }
            _ => String::new(),
        };
        format!(
            "\n\n<aside class=\"errata\"{anchor}>\n<p class=\"errata-head\">What the notes have wrong</p>\n\n"
        )
    }
}

/// The anchor of the erratum `number`, counted from 0, of a statement.
pub(crate) fn errata_anchor(id: &str, number: usize) -> String {
    match number {
        0 => format!("{id}--errata"),
        _ => format!("{id}--errata-{}", number + 1),
    }
}

/// Whether Markdown ends in a paragraph that stands by itself, not in a list, a table or a display formula.
fn ends_in_paragraph(body: &str) -> bool {
    let last = Parser::new_ext(body, markdown()).last();
    matches!(last, Some(Event::End(TagEnd::Paragraph)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_mark_stands_in_the_last_sentence_only_if_there_is_one() {
        assert!(ends_in_paragraph("\nSo $a = b$.\n"));
        assert!(!ends_in_paragraph("\nSo\n\n- a\n- b\n"));
        assert!(!ends_in_paragraph("\nSo\n\n```math\na\n```\n"));
    }
}
