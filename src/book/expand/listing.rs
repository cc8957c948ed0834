//! Listings: code included from the source that the tests run.

use super::Expansion;
use crate::book::directive::Directive;
use crate::book::error::{Place, Problem};
use crate::book::site::{escape, link};

impl Expansion<'_> {
    /// The item `item` of the file `path`, with a link to its line.
    pub(super) fn listing(&self, path: &str, item: &str, directive: &Directive) -> String {
        match self.site.listings.find(self.site.root, path, item) {
            Ok(listing) => {
                let address = self.site.source(&Place::new(path, listing.line));
                let href = link(self.address, &address);
                let fence = "`".repeat(3.max(longest_run(&listing.code) + 1));
                format!(
                    "\n\n<div class=\"listing\">\n<p class=\"listing-head\"><span class=\"item\">{}</span> <a href=\"{href}\">{}</a></p>\n\n{fence}rust,noplayground\n{}{fence}\n\n</div>\n\n",
                    escape(item),
                    escape(path),
                    listing.code,
                )
            }
            Err(reason) => {
                let problem = Problem::Listing {
                    item: item.to_owned(),
                    path: path.to_owned(),
                    reason,
                };
                self.report(directive, problem);
                String::new()
            }
        }
    }
}

/// The length of the longest run of backticks.
fn longest_run(code: &str) -> usize {
    code.split(|c| c != '`').map(str::len).max().unwrap_or(0)
}
