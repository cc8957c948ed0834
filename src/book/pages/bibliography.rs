//! The bibliography, by key.

use super::Generated;
use crate::book::expand::data_fragment;
use crate::book::site::{Site, escape};

/// The page.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let mut content = String::from(
        "# Bibliography\n\n\
         The book and the documentation of the code cite these works by their keys.\n\n<dl class=\"bibliography\">\n\n",
    );
    for (key, work) in &site.data.works {
        let note = data_fragment(
            site,
            "book/bibliography.toml",
            "bibliography.html",
            work.note.trim(),
        );
        content.push_str(&format!(
            "<dt id=\"{key}\">{} <code>{key}</code></dt>\n<dd>\n\n{}: <cite>{}</cite>. {}, {}.\n{note}\n\n</dd>\n\n",
            escape(&work.short),
            escape(&work.authors),
            escape(&work.title),
            escape(&work.published),
            work.year,
        ));
    }
    content.push_str("</dl>\n");
    Generated::new("Bibliography", "bibliography.md", content)
}
