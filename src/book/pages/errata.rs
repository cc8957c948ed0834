//! The errata: what the lecture notes have wrong, each with its counterexample.

use super::Generated;
use crate::book::expand::{Expansion, Lines, errata_anchor};
use crate::book::site::{Site, escape, title_html};

/// Address of the page.
const ADDRESS: &str = "errata.html";

/// The page: every erratum in reading order, then what is known to be wrong in parts that are still to come.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let mut content = String::from(
        "# Errata of the lecture notes\n\n\
         Where the notes are wrong, this book says so, and a counterexample shows it.\n\
         Each counterexample below is a Rust block that `cargo test` compiles and runs.\n\n",
    );
    let mut count = 0;
    for page in &site.manuscript.pages {
        for block in &page.statements {
            let (Some(statement), Some(written)) = (
                site.catalogue.get(&block.id),
                site.manuscript.statements.get(&block.id),
            ) else {
                continue;
            };
            for (number, errata) in block.errata.iter().enumerate() {
                count += 1;
                let id = errata_anchor(&block.id, number);
                let href = format!("{}#{id}", site.address(written.page));
                let sources = escape(&statement.sources.join("; "));
                let part = Expansion {
                    site,
                    page,
                    address: ADDRESS,
                    repeated: true,
                    lines: Lines::Same,
                };
                content.push_str(&format!(
                    "<section class=\"erratum\">\n<h2 id=\"{id}\"><a href=\"{href}\">{}</a> {}</h2>\n<p class=\"sources\">{sources}</p>\n\n{}\n\n</section>\n\n",
                    site.numbered(statement, written),
                    title_html(&statement.title),
                    part.expand(errata.body.clone()),
                ));
            }
        }
    }
    if count == 0 {
        content.push_str("None is written yet.\n\n");
    }
    let to_come: Vec<_> = site
        .catalogue
        .statements()
        .iter()
        .filter(|s| s.errata && !site.manuscript.statements.contains_key(&s.id))
        .collect();
    if !to_come.is_empty() {
        content.push_str("## To come\n\n");
        content.push_str(
            "The notes have something wrong about these as well; the chapters that say what are still to be written.\n\n",
        );
        for statement in to_come {
            content.push_str(&format!(
                "- {} ({})\n",
                title_html(&statement.title),
                escape(&statement.sources.join("; "))
            ));
        }
    }
    Generated::new("Errata of the notes", "errata.md", content)
}
