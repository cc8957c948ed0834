//! What the terminal can show.

use std::io::{IsTerminal, stdout};

/// Whether standard output is a terminal that knows the letters of Braille.
pub fn can_draw() -> bool {
    stdout().is_terminal() && is_unicode(|name| std::env::var(name).ok())
}

/// Whether colours belong on standard output: it is a terminal, and the reader has not refused them (`NO_COLOR`).
pub fn has_colours() -> bool {
    anstream::AutoStream::choice(&stdout()) != anstream::ColorChoice::Never
}

/// How many columns the terminal has; none if standard output is no terminal.
///
/// The variable `COLUMNS` has the first word, as with other commands.
pub fn columns() -> Option<usize> {
    let asked = std::env::var("COLUMNS").ok().and_then(|n| n.parse().ok());
    asked.or_else(|| {
        let (_, columns) = console::Term::stdout().size_checked()?;
        Some(usize::from(columns))
    })
}

/// The first of these variables that says something decides.
fn is_unicode(variable: impl Fn(&str) -> Option<String>) -> bool {
    ["LC_ALL", "LC_CTYPE", "LANG"]
        .into_iter()
        .filter_map(variable)
        .find(|value| !value.is_empty())
        .is_some_and(|value| {
            let value = value.to_lowercase();
            value.contains("utf-8") || value.contains("utf8")
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strongest_variable_decides() {
        let with = |all: &str, lang: &str| {
            is_unicode(|name| match name {
                "LC_ALL" => Some(all.to_owned()),
                "LANG" => Some(lang.to_owned()),
                _ => None,
            })
        };
        assert!(with("", "en_GB.UTF-8"));
        assert!(with("C.utf8", "C"));
        assert!(!with("C", "en_GB.UTF-8"));
        assert!(!is_unicode(|_| None));
    }
}
