//! A small language for labels, in the way of LaTeX, typeset as SVG text.
//!
//! | written | shown |
//! |---|---|
//! | `b_0^1(t)` | italic b with index 0 and exponent 1, upright (t) with an italic t |
//! | `B_{i+1}^{n-1}` | groups in braces |
//! | `\Delta b_0`, `\alpha`, `\kappa` | Greek letters, small ones italic |
//! | `1-t`, `a \le b`, `t \to 0` | a true minus sign and thin spaces around operators |
//! | `hull`, `max` | words of two or more letters stay upright |
//! | `the tangent at $b_0$` | with dollar signs, text outside and mathematics inside |

use std::fmt::Write;

use super::glyph::{Kind, advance, symbol};

/// The size of labels, in units of the picture: 11 CSS pixels on a telephone, 20 at the largest.
pub(super) const SIZE: f64 = 16.0;
/// The size of captions and of numbers at axes.
pub(super) const CAPTION_SIZE: f64 = 14.5;

/// The size of an index, relative to its base.
const SCRIPT: f64 = 0.72;
/// How far an index is lowered, and an exponent raised, in sizes of the base.
const LOWER: f64 = 0.24;
const RAISE: f64 = 0.38;

/// A piece of text in one size at one height.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    text: String,
    italic: bool,
    /// Size relative to the label's.
    scale: f64,
    /// Height of the base line above the label's, in sizes of the label.
    rise: f64,
    /// How far to step back before this run, in sizes of the label: an exponent above its index.
    back: f64,
}

/// A label that has been understood.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Label {
    runs: Vec<Run>,
    size: f64,
}

/// The room a label takes around its base line, in units of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extent {
    pub(super) width: f64,
    pub(super) ascent: f64,
    pub(super) descent: f64,
}

impl Label {
    /// Reads a label, or says what is wrong with it.
    pub(super) fn read(source: &str, size: f64) -> Result<Self, String> {
        let mut setter = Setter::default();
        if source.contains('$') {
            for (i, part) in source.split('$').enumerate() {
                if i % 2 == 0 {
                    setter.text(part);
                } else {
                    setter.mathematics(part)?;
                }
            }
            if source.matches('$').count() % 2 == 1 {
                return Err("a dollar sign is missing".into());
            }
        } else {
            setter.mathematics(source)?;
        }
        Ok(Label {
            runs: setter.merged(),
            size,
        })
    }

    pub(super) fn extent(&self) -> Extent {
        // What is tall: a capital or an ascender; what is deep: a descender or a parenthesis.
        const ASCENT: f64 = 0.73;
        const DESCENT: f64 = 0.24;
        let mut x: f64 = 0.0;
        let mut extent = Extent {
            width: 0.0,
            ascent: 0.5,
            descent: 0.0,
        };
        for run in &self.runs {
            x += run.width() - run.back;
            extent.width = extent.width.max(x);
            extent.ascent = extent.ascent.max(run.rise + ASCENT * run.scale);
            let deep = run.text.contains([
                'g', 'j', 'p', 'q', 'y', '(', ',', 'β', 'γ', 'μ', 'ρ', 'φ', 'ψ', 'ξ',
            ]);
            let descent = if deep { DESCENT } else { 0.02 };
            extent.descent = extent.descent.max(descent * run.scale - run.rise);
        }
        Extent {
            width: extent.width * self.size,
            ascent: extent.ascent * self.size,
            descent: extent.descent * self.size,
        }
    }

    /// Writes the inside of a `<text>` element.
    pub(super) fn write(&self, out: &mut String) {
        let mut rise = 0.0;
        for run in &self.runs {
            let mut attributes = String::new();
            if run.italic {
                attributes.push_str(" class=\"i\"");
            }
            if run.scale != 1.0 {
                let _ = write!(
                    attributes,
                    " font-size=\"{}\"",
                    tenths(run.scale * self.size)
                );
            }
            if run.back != 0.0 {
                let _ = write!(attributes, " dx=\"{}\"", tenths(-run.back * self.size));
            }
            if run.rise != rise {
                let _ = write!(
                    attributes,
                    " dy=\"{}\"",
                    tenths((rise - run.rise) * self.size)
                );
                rise = run.rise;
            }
            if attributes.is_empty() {
                escape(&run.text, out);
            } else {
                let _ = write!(out, "<tspan{attributes}>");
                escape(&run.text, out);
                out.push_str("</tspan>");
            }
        }
    }
}

impl Run {
    fn width(&self) -> f64 {
        self.text
            .chars()
            .map(|c| advance(c, self.italic))
            .sum::<f64>()
            * self.scale
    }
}

/// The distance of the base lines of a text of several lines, in sizes.
pub(super) const LEADING: f64 = 1.2;

/// Width and height of a text of one or more lines.
pub(super) fn block(text: &str, size: f64) -> [f64; 2] {
    let width = |line| Label::read(line, size).map_or(0.0, |label| label.extent().width);
    let lines = text.split('\n');
    [
        lines.clone().map(width).fold(0.0, f64::max),
        lines.count() as f64 * LEADING * size,
    ]
}

/// One decimal, without a trailing zero: type needs no more.
fn tenths(x: f64) -> String {
    super::decimal(x, 1)
}

/// Text as XML.
pub(super) fn escape(text: &str, out: &mut String) {
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
}

/// Collects runs at the current size and height.
#[derive(Debug, Default)]
struct Setter {
    runs: Vec<Run>,
    /// How deep in indices we are.
    depth: usize,
    rise: f64,
}

impl Setter {
    fn scale(&self) -> f64 {
        (0..self.depth).map(|_| SCRIPT).product()
    }

    fn push(&mut self, text: impl Into<String>, italic: bool) {
        let run = Run {
            text: text.into(),
            italic,
            scale: self.scale(),
            rise: self.rise,
            back: 0.0,
        };
        if !run.text.is_empty() {
            self.runs.push(run);
        }
    }

    fn text(&mut self, text: &str) {
        self.push(text.replace('\'', "’"), false);
    }

    fn mathematics(&mut self, source: &str) -> Result<(), String> {
        let mut rest = source;
        // Whether something stands before that an operator can be binary to.
        let mut operand = false;
        while let Some(c) = rest.chars().next() {
            let after = &rest[c.len_utf8()..];
            match c {
                '_' | '^' => {
                    if self.runs.is_empty() {
                        return Err(format!("nothing stands before `{c}`"));
                    }
                    rest = self.scripts(rest)?;
                    operand = true;
                    continue;
                }
                '\\' => {
                    let (name, remaining) = command(after)?;
                    rest = remaining;
                    if name == "text" {
                        let (inside, remaining) = group(rest)?;
                        self.text(inside);
                        rest = remaining;
                        operand = true;
                        continue;
                    }
                    let (symbol, kind) =
                        symbol(name).ok_or_else(|| format!("unknown command `\\{name}`"))?;
                    self.symbol(symbol, kind, &mut operand);
                    continue;
                }
                '{' => {
                    let (inside, remaining) = group(rest)?;
                    self.mathematics(inside)?;
                    rest = remaining;
                    operand = true;
                    continue;
                }
                '}' => return Err("a closing brace too many".into()),
                '-' => self.symbol("−", Kind::Binary, &mut operand),
                '+' => self.symbol("+", Kind::Binary, &mut operand),
                '=' => self.symbol("=", Kind::Relation, &mut operand),
                '<' => self.symbol("<", Kind::Relation, &mut operand),
                '>' => self.symbol(">", Kind::Relation, &mut operand),
                '\'' => self.symbol("′", Kind::Upright, &mut operand),
                ',' => {
                    self.push(if self.depth == 0 { ",\u{2009}" } else { "," }, false);
                    operand = false;
                    rest = after.trim_start();
                    continue;
                }
                ' ' => {
                    // Spaces beside operators are set by the operators.
                    let next = after.trim_start();
                    let operator = next
                        .strip_prefix('\\')
                        .and_then(|after| symbol(command(after).ok()?.0))
                        .is_some_and(|(_, kind)| matches!(kind, Kind::Binary | Kind::Relation));
                    let beside =
                        !operand || operator || next.starts_with(['+', '-', '=', '<', '>']);
                    if !beside {
                        self.push(" ", false);
                    }
                    rest = next;
                    continue;
                }
                c if c.is_ascii_alphabetic() => {
                    let end = rest
                        .find(|c: char| !c.is_ascii_alphabetic())
                        .unwrap_or(rest.len());
                    self.push(&rest[..end], end == 1);
                    rest = &rest[end..];
                    operand = true;
                    continue;
                }
                c => {
                    self.push(c, false);
                    operand = !"([".contains(c);
                }
            }
            rest = after;
        }
        Ok(())
    }

    fn symbol(&mut self, symbol: &str, kind: Kind, operand: &mut bool) {
        let spaced = self.depth == 0
            && match kind {
                Kind::Relation => true,
                Kind::Binary => *operand,
                _ => false,
            };
        if spaced {
            self.push(format!("\u{2009}{symbol}\u{2009}"), false);
        } else {
            self.push(symbol, kind == Kind::Italic);
        }
        *operand = matches!(kind, Kind::Upright | Kind::Italic);
    }

    /// Sets an index, an exponent, or both above each other, and returns what follows.
    fn scripts<'a>(&mut self, mut rest: &'a str) -> Result<&'a str, String> {
        let mut previous: Option<(char, f64)> = None;
        while let Some(mark @ ('_' | '^')) = rest.chars().next() {
            if previous.is_some_and(|(earlier, _)| earlier == mark) {
                return Err(format!("two `{mark}` in a row; use braces"));
            }
            let (inside, remaining) = argument(&rest[1..])?;
            let base = self.scale();
            let rise = self.rise;
            let start = self.runs.len();
            self.rise += base * if mark == '_' { -LOWER } else { RAISE };
            self.depth += 1;
            self.mathematics(inside)?;
            self.depth -= 1;
            self.rise = rise;
            let width: f64 = self.runs[start..]
                .iter()
                .map(|run| run.width() - run.back)
                .sum();
            if let (Some((_, earlier)), Some(run)) = (previous, self.runs.get_mut(start)) {
                // The second script starts where the first one did; what is wider decides where we go on.
                run.back += earlier;
                if width < earlier {
                    self.runs.push(Run {
                        text: "\u{200b}".into(),
                        italic: false,
                        scale: base,
                        rise,
                        back: width - earlier + advance('\u{200b}', false) * base,
                    });
                }
            }
            previous = Some((mark, width));
            rest = remaining;
        }
        Ok(rest)
    }

    /// Neighbours that look alike become one run.
    fn merged(self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for run in self.runs {
            match runs.last_mut() {
                Some(last)
                    if last.italic == run.italic
                        && last.scale == run.scale
                        && last.rise == run.rise
                        && run.back == 0.0 =>
                {
                    last.text.push_str(&run.text);
                }
                _ => runs.push(run),
            }
        }
        runs
    }
}

fn command(rest: &str) -> Result<(&str, &str), String> {
    let end = rest
        .find(|c: char| !c.is_ascii_alphabetic())
        .unwrap_or(rest.len());
    match end {
        0 => match rest.chars().next() {
            Some(c) => Ok(rest.split_at(c.len_utf8())),
            None => Err("a backslash at the end".into()),
        },
        _ => Ok((&rest[..end], rest[end..].trim_start_matches(' '))),
    }
}

/// The inside of the braces that `rest` begins with, and what follows.
fn group(rest: &str) -> Result<(&str, &str), String> {
    if !rest.starts_with('{') {
        return Err("an opening brace is missing".into());
    }
    let mut depth = 0;
    for (i, c) in rest.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Ok((&rest[1..i], &rest[i + 1..]));
        }
    }
    Err("a closing brace is missing".into())
}

/// What an index applies to: a group, a command or one character.
fn argument(rest: &str) -> Result<(&str, &str), String> {
    match rest.chars().next() {
        None => Err("an index is missing".into()),
        Some('{') => group(rest),
        Some('\\') => {
            let (name, remaining) = command(&rest[1..])?;
            Ok((&rest[..1 + name.len()], remaining))
        }
        Some(c) => Ok(rest.split_at(c.len_utf8())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(source: &str) -> String {
        let mut out = String::new();
        Label::read(source, 10.0).expect("a label").write(&mut out);
        out
    }

    #[test]
    fn an_exponent_stands_above_its_index() {
        assert_eq!(
            set("b_0^1(t)"),
            "<tspan class=\"i\">b</tspan><tspan font-size=\"7.2\" dy=\"2.4\">0</tspan>\
             <tspan font-size=\"7.2\" dx=\"-3.6\" dy=\"-6.2\">1</tspan><tspan dy=\"3.8\">(</tspan>\
             <tspan class=\"i\">t</tspan>)"
        );
    }

    #[test]
    fn words_are_upright_and_operators_spaced() {
        assert_eq!(set("max"), "max");
        assert_eq!(set("1-t"), "1\u{2009}−\u{2009}<tspan class=\"i\">t</tspan>");
        assert_eq!(set("-t"), "−<tspan class=\"i\">t</tspan>");
        assert_eq!(set("1 \\le 2"), "1\u{2009}≤\u{2009}2");
        assert_eq!(set("(-1, 2)"), "(−1,\u{2009}2)");
        assert_eq!(
            set("at $t<1$"),
            "at <tspan class=\"i\">t</tspan>\u{2009}&lt;\u{2009}1"
        );
    }

    #[test]
    fn what_cannot_be_set_is_refused_with_a_reason() {
        for (source, reason) in [
            ("\\foo", "unknown command `\\foo`"),
            ("b_{0", "a closing brace is missing"),
            ("b_", "an index is missing"),
            ("b_1_2", "two `_` in a row; use braces"),
            ("_1", "nothing stands before `_`"),
            ("a$b", "a dollar sign is missing"),
            ("a}", "a closing brace too many"),
        ] {
            assert_eq!(
                Label::read(source, 10.0),
                Err(reason.to_owned()),
                "{source}"
            );
        }
    }

    #[test]
    fn a_longer_label_is_wider() {
        let width = |source| Label::read(source, 10.0).expect("a label").extent().width;
        assert!(width("b_0^{n-1}") > width("b_0^n"));
        assert!(
            width("b_0^1(t)") < width("b_0 1(t)"),
            "scripts above each other share their room"
        );
    }
}
