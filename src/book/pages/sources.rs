//! The source pages: each file that a page links to, with a link for each line.
//!
//! They are part of the site, so that a link to the very test works offline.

use std::collections::BTreeSet;

use super::Generated;
use crate::book::error::{BookError, Problem};
use crate::book::site::{Site, escape};

/// The list of source pages, with the pages below it.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let linked = site
        .linked
        .lock()
        .unwrap_or_else(|e| e.into_inner())
        .clone();
    let mut content = String::from(
        "# Source code\n\n\
         The statements link to the laws and tests that verify them; these are the files in which they stand.\n\n",
    );
    let mut below = Vec::new();
    for (path, lines) in &linked {
        match std::fs::read_to_string(site.root.join(path)) {
            Ok(source) => {
                content.push_str(&format!("- [{path}]({path}.html)\n"));
                below.push(Generated::new(
                    path,
                    &format!("source/{path}.md"),
                    source_page(path, &source, lines),
                ));
            }
            Err(e) => {
                let reason = e.to_string();
                site.report(BookError::new(path, 1, Problem::Unreadable { reason }));
            }
        }
    }
    Generated {
        name: "Source code".to_owned(),
        path: "source/index.md".to_owned(),
        content,
        below,
    }
}

/// The page of one file: line numbers beside the code, an anchor at each line that is linked to.
fn source_page(path: &str, source: &str, linked: &BTreeSet<usize>) -> String {
    let mut numbers = String::new();
    for line in 1..=source.lines().count() {
        if linked.contains(&line) {
            numbers.push_str(&format!("<a id=\"L{line}\" href=\"#L{line}\">{line}</a>\n"));
        } else {
            numbers.push_str(&format!("{line}\n"));
        }
    }
    // Blank lines are harmless in `pre`, where Markdown reads HTML up to the closing tag.
    format!(
        "# {}\n\n<div class=\"source\">\n\n<pre class=\"lines\" aria-hidden=\"true\">{numbers}</pre>\n\n<pre><code class=\"language-rust noplayground\">{}</code></pre>\n\n</div>\n",
        escape(path),
        escape(source).replace('\'', "&#39;"),
    )
}
