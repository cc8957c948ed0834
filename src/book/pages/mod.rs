//! The pages that nobody writes: they are made from the catalogue, the data files and the pages that are written.

mod bibliography;
mod errata;
mod exercises;
mod glossary;
mod notation;
mod sources;
mod statements;

use super::site::Site;

/// A page that is made, not written.
pub(crate) struct Generated {
    /// Its name in the table of contents.
    pub(crate) name: String,
    /// Its path, as if it were a file below `book/src`.
    pub(crate) path: String,
    /// Its Markdown.
    pub(crate) content: String,
    /// The pages below it.
    pub(crate) below: Vec<Generated>,
}

impl Generated {
    /// A page with nothing below it.
    fn new(name: &str, path: &str, content: String) -> Self {
        Self {
            name: name.to_owned(),
            path: path.to_owned(),
            content,
            below: Vec::new(),
        }
    }
}

/// All generated pages, in the order of the table of contents.
///
/// The source pages come last, because the others link to them.
pub(crate) fn generate(site: &Site<'_>) -> Vec<Generated> {
    vec![
        statements::page(site),
        exercises::page(site),
        errata::page(site),
        notation::page(site),
        glossary::page(site),
        bibliography::page(site),
        sources::page(site),
    ]
}

/// Rows of a table as one block of HTML.
fn table(class: &str, head: &[&str], rows: &[Vec<String>]) -> String {
    let mut html = format!("<div class=\"table-wrapper\">\n<table class=\"{class}\">\n<thead><tr>");
    for cell in head {
        html.push_str(&format!("<th>{cell}</th>"));
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in rows {
        html.push_str("<tr>");
        for cell in row {
            html.push_str(&format!("<td>{cell}</td>"));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
    html
}

/// The link to the statement that introduces something, or nothing.
fn introduced(site: &Site<'_>, address: &str, file: &str, statement: Option<&str>) -> String {
    match statement {
        Some(id) => {
            let reference = format!("{{{{#ref {id} number}}}}");
            super::expand::data_fragment_at(site, file, address, &reference, id)
        }
        None => String::new(),
    }
}
