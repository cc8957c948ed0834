//! The notation: each sign, what it means, what the code calls it.

use super::{Generated, introduced};
use crate::book::expand::data_fragment;
use crate::book::site::Site;

/// Where the notation is listed.
const FILE: &str = "book/notation.toml";

/// The page.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let mut content = String::from(
        "# Notation\n\n\
         One notation runs through the whole book and its code.\n\n\
         | Sign | Meaning | In the code | Introduced in |\n|---|---|---|---|\n",
    );
    for sign in &site.data.signs {
        let code = match sign.code.as_str() {
            "" => String::new(),
            code => format!("`{code}`"),
        };
        let cell = |text: &str| data_fragment(site, FILE, "notation.html", text);
        let statement = introduced(site, "notation.html", FILE, sign.statement.as_deref());
        content.push_str(&format!(
            "| {} | {} | {code} | {statement} |\n",
            cell(&format!("${}$", sign.sign)),
            cell(&sign.meaning),
        ));
    }
    Generated::new("Notation", "notation.md", content)
}
