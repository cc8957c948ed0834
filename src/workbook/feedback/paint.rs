//! Colours and lines of text.

use anstyle::{AnsiColor, Style};

use super::terminal;

/// How long a line may be, in columns; a terminal has 80.
pub const WIDTH: usize = 78;

/// How long a line may be on this terminal: less where it is narrower, never more than is easily read.
pub fn width() -> usize {
    terminal::columns().map_or(WIDTH, fitting)
}

/// How long a line may be where there are so many columns; below some it would hold hardly a word.
fn fitting(columns: usize) -> usize {
    columns.saturating_sub(2).clamp(20, WIDTH)
}

/// A title, or what is worth a look.
pub const STRONG: Style = Style::new().bold();
/// What is right.
pub const GOOD: Style = AnsiColor::Green.on_default().bold();
/// What is wrong.
pub const BAD: Style = AnsiColor::Red.on_default().bold();
/// What deserves attention.
pub const ATTENTION: Style = AnsiColor::Yellow.on_default();
/// Code, commands and files.
pub const CODE: Style = AnsiColor::Cyan.on_default();
/// What only helps.
pub const FAINT: Style = Style::new().dimmed();

/// The text in this style.
pub fn paint(style: Style, text: impl std::fmt::Display) -> String {
    format!("{style}{text}{style:#}")
}

/// How many columns a text takes; colours take none, and neither do signs that stand on the letter before.
pub fn columns(text: &str) -> usize {
    let mut count = 0;
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '\u{1b}' => {
                letters.by_ref().find(|&c| c == 'm');
            }
            '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}' => {}
            _ => count += 1,
        }
    }
    count
}

/// The text filled up with blanks.
pub fn padded(text: &str, width: usize) -> String {
    let blanks = width.saturating_sub(columns(text));
    format!("{text}{}", " ".repeat(blanks))
}

/// The text cut to a width, with a sign that it was.
pub fn cut(text: &str, width: usize) -> String {
    if columns(text) <= width {
        return text.to_owned();
    }
    let kept: String = text.chars().take(width.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}

/// Breaks a text into lines: the first begins with `first`, the others with `rest`.
///
/// A line break in the text stays one; a word that is longer than a line stands alone.
pub fn wrapped(text: &str, first: &str, rest: &str) -> String {
    let width = width();
    let mut lines: Vec<String> = Vec::new();
    let mut indent = first;
    for part in text.split('\n') {
        let mut line = String::from(indent);
        let mut is_empty = true;
        for word in part.split(' ').filter(|word| !word.is_empty()) {
            if !is_empty && columns(&line) + 1 + columns(word) > width {
                lines.push(line.trim_end().to_owned());
                line = String::from(rest);
                is_empty = true;
            }
            if !is_empty {
                line.push(' ');
            }
            line.push_str(word);
            is_empty = false;
        }
        lines.push(line.trim_end().to_owned());
        indent = rest;
    }
    lines.join("\n") + "\n"
}

/// The text as it is printed: blanks that must not break have done their work and are plain blanks.
///
/// A command that the reader copies must hold no others.
pub fn printable(text: &str) -> String {
    text.replace('\u{a0}', " ")
}

/// Lines of a name and what belongs to it, the latter aligned.
pub fn table(rows: &[(&str, String)], indent: &str) -> String {
    let width = rows.iter().map(|(name, _)| columns(name)).max();
    let width = width.unwrap_or_default() + 2;
    let rest = " ".repeat(columns(indent) + width);
    rows.iter()
        .map(|(name, text)| {
            let name = paint(FAINT, name);
            wrapped(text, &format!("{indent}{}", padded(&name, width)), &rest)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let text = "word ".repeat(20);
        let lines = wrapped(&text, "- ", "  ");
        assert!(lines.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(
            lines
                .lines()
                .nth(1)
                .is_some_and(|line| line.starts_with("  word"))
        );
        let long = "x".repeat(100);
        assert_eq!(wrapped(&long, "", ""), format!("{long}\n"));
        assert_eq!(wrapped("a\nb", "> ", "  "), "> a\n  b\n");
    }

    #[test]
    fn a_line_fits_the_terminal() {
        assert_eq!([200, 80, 60, 40, 3].map(fitting), [78, 78, 58, 38, 20]);
    }

    #[test]
    fn colours_take_no_room() {
        assert_eq!(columns(&paint(GOOD, "b⃗₀")), 2);
        assert_eq!(padded(&paint(BAD, "a"), 3).len(), paint(BAD, "a").len() + 2);
        assert_eq!(cut("a long title", 7), "a long…");
    }
}
