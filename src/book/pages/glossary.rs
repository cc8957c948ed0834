//! The glossary: English and German terms.

use super::{Generated, introduced};
use crate::book::expand::data_fragment;
use crate::book::site::{Site, escape};

/// Where the terms are listed.
const FILE: &str = "book/glossary.toml";

/// The page: the terms in the order of the English ones, then the German ones as an index.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let mut terms: Vec<_> = site.data.terms.iter().collect();
    terms.sort_by_key(|(_, term)| term.english.to_lowercase());
    let mut content = String::from(
        "# Glossary\n\n\
         The lecture notes are partly German; these are the terms in both languages.\n\n\
         ## English to German\n\n<dl class=\"glossary\">\n\n",
    );
    for (key, term) in &terms {
        let definition = data_fragment(site, FILE, "glossary.html", term.definition.trim());
        let statement = introduced(site, "glossary.html", FILE, term.statement.as_deref());
        content.push_str(&format!(
            "<dt id=\"{key}\">{} <span class=\"german\" lang=\"de\">{}</span></dt>\n<dd>\n\n{definition} {statement}\n\n</dd>\n\n",
            escape(&term.english),
            escape(&term.german),
        ));
    }
    content.push_str("</dl>\n\n## German to English\n\n<ul class=\"german-index\">\n");
    terms.sort_by_key(|(_, term)| term.german.to_lowercase());
    for (key, term) in &terms {
        content.push_str(&format!(
            "<li><span lang=\"de\">{}</span>: <a href=\"#{key}\">{}</a></li>\n",
            escape(&term.german),
            escape(&term.english),
        ));
    }
    content.push_str("</ul>\n");
    Generated::new("Glossary", "glossary.md", content)
}
