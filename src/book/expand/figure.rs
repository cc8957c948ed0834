//! Figures: drawn by the chapter's code, numbered and captioned here.

use super::Expansion;
use crate::book::directive::Directive;
use crate::book::error::Problem;
use crate::book::site::{escape, link, title_html};

impl Expansion<'_> {
    /// The figure `id` with its caption.
    ///
    /// A figure of a statement that the catalogue lists may be still to be drawn, as a statement may be still to be
    /// written; the coverage says that it is missing.
    pub(super) fn figure(&self, id: &str, directive: &Directive) -> String {
        if let Some(statement) = self.site.catalogue.get(id)
            && !self.site.registry.draws(id)
        {
            return format!(
                "\n\n<p class=\"to-come\">The figure to “{}” is to come.</p>\n\n",
                title_html(&statement.title)
            );
        }
        let svg = match self.site.registry.figure(id) {
            Ok(figure) => (figure.draw)().map_err(|reason| Problem::Undrawable {
                id: id.to_owned(),
                reason,
            }),
            Err(problem) => Err(problem),
        };
        let (drawing, figure) = match (svg, self.site.registry.figure(id)) {
            (Ok(drawing), Ok(figure)) => (drawing, figure),
            (Err(problem), _) | (_, Err(problem)) => {
                self.report(directive, problem);
                return String::new();
            }
        };
        // A blank line would end the block of HTML.
        let svg: String = drawing
            .svg
            .lines()
            .map(str::trim)
            .filter(|line| !line.is_empty())
            .collect::<Vec<_>>()
            .join("\n");
        let first = self.site.manuscript.figures.get(id);
        let here = first.is_some_and(|first| {
            !self.repeated
                && first.offset == directive.span.start
                && self.site.manuscript.pages[first.page].file == self.page.file
        });
        let svg = if here {
            svg
        } else {
            with_ids_of_its_own(&svg, id, directive.line)
        };
        let anchor = if here {
            format!(" id=\"{}\"", figure_anchor(id))
        } else {
            String::new()
        };
        let number = match first {
            Some(first) => {
                let address = format!("{}#{}", self.site.address(first.page), figure_anchor(id));
                let href = link(self.address, &address);
                format!(
                    "<a class=\"number\" href=\"{href}\">Figure\u{a0}{}</a> ",
                    first.number
                )
            }
            None => String::new(),
        };
        let live = match figure.live {
            Some(part) => format!(" data-figure=\"{id}\" data-part=\"{part}\""),
            None => String::new(),
        };
        let laws = match figure.live {
            Some(_) => self.names_of_laws(&drawing.laws, directive),
            None => String::new(),
        };
        let title = escape(figure.title.trim().trim_end_matches('.'));
        format!(
            "\n\n<figure class=\"drawing\"{anchor}{live}>\n{svg}\n<figcaption>{number}<span class=\"title\">{title}.</span></figcaption>{laws}\n</figure>\n\n"
        )
    }

    /// What the laws are called that the live figure shows, each a link to its statement, for the script to pick from.
    fn names_of_laws(&self, laws: &[String], directive: &Directive) -> String {
        let names: String = laws
            .iter()
            .map(|law| {
                let name = self.reference(law, false, directive);
                format!("<span data-law=\"{law}\">{name}</span>")
            })
            .collect();
        match names.as_str() {
            "" => names,
            _ => format!("<span hidden>{names}</span>"),
        }
    }
}

/// The picture of a figure that is shown again: its ids open with the figure's, and each may exist once in a page.
fn with_ids_of_its_own(svg: &str, id: &str, line: usize) -> String {
    ["\"", " ", "#"]
        .into_iter()
        .fold(svg.to_owned(), |svg, before| {
            svg.replace(
                &format!("{before}{id}-"),
                &format!("{before}{id}-again-{line}-"),
            )
        })
}

/// The anchor of a figure; a statement of the kind *figure* has the id itself.
pub(crate) fn figure_anchor(id: &str) -> String {
    format!("figure-{id}")
}
