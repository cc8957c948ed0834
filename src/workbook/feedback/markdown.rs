//! Tasks and hints as text for a terminal.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::formula::readable;
use super::paint::{CODE, FAINT, STRONG, columns, padded, paint, wrapped};
use crate::book::catalogue::Catalogue;

/// How far code and formulas on lines of their own are moved in.
const INDENT: &str = "    ";

/// How long a formula in a sentence may be to stay on one line.
const UNBROKEN: usize = 24;

/// The Markdown of an exercise, with lines that fit into a terminal.
///
/// References become the titles of the statements.
pub fn rendered(text: &str, catalogue: &Catalogue) -> String {
    let text = without_directives(text, catalogue);
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_TASKLISTS;
    let mut page = Page::default();
    for event in Parser::new_ext(&text, options) {
        page.take(event);
    }
    page.flush();
    page.text.trim_end().to_owned() + "\n"
}

/// `{{#ref ID}}` becomes the title, `{{#cite key …}}` and `{{#term word}}` what they name.
fn without_directives(text: &str, catalogue: &Catalogue) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once("{{#") {
        plain.push_str(before);
        let Some((directive, after)) = behind.split_once("}}") else {
            plain.push_str("{{#");
            rest = behind;
            continue;
        };
        let (name, arguments) = directive.split_once(' ').unwrap_or((directive, ""));
        let id = arguments.split(' ').next().unwrap_or_default();
        match (name, catalogue.get(id)) {
            ("ref", Some(statement)) => plain.push_str(&format!("“{}”", statement.title)),
            _ => plain.push_str(arguments),
        }
        rest = after;
    }
    plain + rest
}

/// A page that grows.
#[derive(Default)]
struct Page {
    text: String,
    /// The paragraph that is being read.
    paragraph: String,
    /// The lists that are open; the number of the next item where they are counted.
    lists: Vec<Option<u64>>,
    /// What stands in front of the item that is being read, until it is written.
    bullet: Option<String>,
    /// Code that is being read; the word says its language.
    code: Option<(String, String)>,
    table: Vec<Vec<String>>,
}

impl Page {
    fn take(&mut self, event: Event<'_>) {
        match event {
            Event::Text(text) => match &mut self.code {
                Some((_, code)) => code.push_str(&text),
                None => self.paragraph.push_str(&text),
            },
            Event::Code(code) => self.paragraph.push_str(&paint(CODE, format!("`{code}`"))),
            Event::InlineMath(latex) => {
                let text = readable(&latex);
                self.paragraph.push_str(&if columns(&text) <= UNBROKEN {
                    text.replace(' ', "\u{a0}")
                } else {
                    text
                });
            }
            Event::DisplayMath(latex) => {
                self.flush();
                self.formula(&latex);
            }
            Event::SoftBreak => self.paragraph.push(' '),
            Event::HardBreak => self.paragraph.push('\n'),
            Event::TaskListMarker(done) => {
                self.bullet = Some(self.item(if done { "[x]" } else { "[ ]" }));
            }
            Event::Start(Tag::Strong | Tag::Heading { .. }) => {
                self.paragraph.push_str(&STRONG.render().to_string());
            }
            Event::End(TagEnd::Strong) => {
                self.paragraph.push_str(&STRONG.render_reset().to_string());
            }
            Event::End(TagEnd::Heading(_)) => {
                self.paragraph.push_str(&STRONG.render_reset().to_string());
                self.flush();
            }
            Event::Start(Tag::List(first)) => {
                self.flush();
                self.lists.push(first);
            }
            Event::End(TagEnd::List(_)) => {
                self.lists.pop();
                if self.lists.is_empty() {
                    self.text.push('\n');
                }
            }
            Event::Start(Tag::Item) => {
                let sign = match self.lists.last_mut() {
                    Some(Some(number)) => {
                        *number += 1;
                        format!("{}.", *number - 1)
                    }
                    _ => "•".into(),
                };
                self.bullet = Some(self.item(&sign));
            }
            Event::End(TagEnd::Item | TagEnd::Paragraph) => self.flush(),
            Event::Start(Tag::CodeBlock(kind)) => {
                self.flush();
                let language = match kind {
                    CodeBlockKind::Fenced(tag) => tag.split(',').next().unwrap_or("").to_owned(),
                    CodeBlockKind::Indented => String::new(),
                };
                self.code = Some((language, String::new()));
            }
            Event::End(TagEnd::CodeBlock) => {
                if let Some((language, code)) = self.code.take() {
                    match language.as_str() {
                        "math" => self.formula(&code),
                        _ => self.block(code.trim_end()),
                    }
                }
            }
            Event::Start(Tag::TableRow | Tag::TableHead) => self.table.push(Vec::new()),
            Event::End(TagEnd::TableCell) => {
                let cell = std::mem::take(&mut self.paragraph);
                if let Some(row) = self.table.last_mut() {
                    row.push(cell);
                }
            }
            Event::End(TagEnd::Table) => self.write_table(),
            _ => {}
        }
    }

    /// What stands in front of an item of the innermost list.
    fn item(&self, sign: &str) -> String {
        format!("{}{sign} ", "  ".repeat(self.lists.len()))
    }

    /// Ends the paragraph.
    fn flush(&mut self) {
        let paragraph = std::mem::take(&mut self.paragraph);
        if paragraph.trim().is_empty() {
            return;
        }
        let rest = "  ".repeat(self.lists.len() * 2);
        match self.bullet.take() {
            Some(bullet) => {
                let rest = " ".repeat(columns(&bullet));
                self.text.push_str(&wrapped(&paragraph, &bullet, &rest));
            }
            None => {
                self.text.push_str(&wrapped(&paragraph, &rest, &rest));
                if self.lists.is_empty() {
                    self.text.push('\n');
                }
            }
        }
    }

    /// Lines that are not broken.
    fn block(&mut self, lines: &str) {
        for line in lines.lines() {
            self.text.push_str(format!("{INDENT}{line}").trim_end());
            self.text.push('\n');
        }
        self.text.push('\n');
    }

    /// A formula on lines of its own.
    fn formula(&mut self, latex: &str) {
        let text = wrapped(&readable(latex), INDENT, &INDENT.repeat(2));
        self.text.push_str(&text);
        self.text.push('\n');
    }

    fn write_table(&mut self) {
        let rows = std::mem::take(&mut self.table);
        let count = rows.iter().map(Vec::len).max().unwrap_or_default();
        let widths: Vec<usize> = (0..count)
            .map(|column| {
                let cells = rows.iter().filter_map(|row| row.get(column));
                cells.map(|cell| columns(cell)).max().unwrap_or_default()
            })
            .collect();
        for (number, row) in rows.iter().enumerate() {
            let cells: Vec<String> = row
                .iter()
                .zip(&widths)
                .map(|(cell, &width)| padded(cell, width))
                .collect();
            let line = cells.join("  ");
            self.text.push_str(INDENT);
            if number == 0 {
                self.text.push_str(&paint(FAINT, line.trim_end()));
            } else {
                self.text.push_str(line.trim_end());
            }
            self.text.push('\n');
        }
        self.text.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::super::paint::{WIDTH, printable};
    use super::*;

    fn plain(text: &str) -> String {
        let text = printable(&rendered(text, &Catalogue::default()));
        anstream::adapter::strip_str(&text).to_string()
    }

    #[test]
    fn a_task_becomes_lines_of_text() {
        let text = plain(
            "Given is $b_0$,\nand `f`.\n\n- one\n- two:\n  1. *deep*\n\n```rust\nlet x = 1;\n```\n\n```math\nx = \\frac12\n```\n\n| a | b |\n|---|---|\n| 1 | $t^2$ |\n\nSee {{#ref nothing}}.\n",
        );
        let expected = "Given is b₀, and `f`.\n\n  • one\n  • two:\n    1. deep\n\n    let x = 1;\n\n    x = 1/2\n\n    a  b\n    1  t²\n\nSee nothing.\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn a_short_formula_stays_on_its_line() {
        let text = plain(&format!("{} $b_0 \\ne b_1$", "word ".repeat(14)));
        assert!(text.contains("b₀ ≠ b₁"), "{text}");
        let long = plain(
            "$$a + b + c + d + e + f + g + h + i + j + k + l + m + n + o + p + q + r + s + t + u + v + w$$",
        );
        assert!(long.lines().all(|line| columns(line) <= WIDTH), "{long}");
    }
}
