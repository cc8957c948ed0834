//! Formulas: LaTeX in the manuscript, MathML in the book.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// The book's own commands.
///
/// Each stands for a notion of the book, so that its look can change in one place.
const MACROS: [(&str, &str); 8] = [
    ("R", r"\mathbb{R}"),
    ("N", r"\mathbb{N}"),
    ("Z", r"\mathbb{Z}"),
    ("Q", r"\mathbb{Q}"),
    ("conv", r"\operatorname{conv}"),
    ("norm", r"\left\lVert #1 \right\rVert"),
    ("abs", r"\left\lvert #1 \right\rvert"),
    ("dd", r"\mathrm{d}"),
];

/// Turns LaTeX into MathML.
#[derive(Debug)]
pub struct Formulas {
    converter: LatexToMathML,
}

impl Default for Formulas {
    fn default() -> Self {
        Self::new()
    }
}

impl Formulas {
    /// The converter with the book's commands: `\R \N \Z \Q \conv \norm{…} \abs{…} \dd`.
    pub fn new() -> Self {
        let config = MathCoreConfig {
            macros: MACROS
                .iter()
                .map(|&(name, meaning)| (name.to_owned(), meaning.to_owned()))
                .collect(),
            ..MathCoreConfig::default()
        };
        // The macros are constants, and a test converts each of them.
        let converter = LatexToMathML::new(config).unwrap_or_default();
        Self { converter }
    }

    /// The MathML of a formula, ready to stand in a paragraph of Markdown.
    ///
    /// # Errors
    ///
    /// What the parser says about a formula that it does not understand.
    ///
    /// # Examples
    ///
    /// ```
    /// let formulas = cagd::book::formula::Formulas::new();
    /// let mathml = formulas.mathml(r"B_i^n(t) \ge 0", false)?;
    /// assert!(mathml.starts_with("<math>"));
    /// assert!(formulas.mathml(r"\frac{1}", false).is_err());
    /// # Ok::<(), String>(())
    /// ```
    pub fn mathml(&self, latex: &str, display: bool) -> Result<String, String> {
        let display = if display {
            MathDisplay::Block
        } else {
            MathDisplay::Inline
        };
        let converted = self
            .converter
            .convert_with_local_state(latex, display)
            .map_err(|error| error.error_message())?;
        Ok(hide_from_markdown(&repair(&lower_primes(&lift_scripts(
            converted.mathml,
        )))))
    }
}

/// Mends two signs that browsers draw badly.
///
/// The dots of `\dot` and `\ddot` are lost when they are marked as accents, and the combining arrow of `\vec` is not in
/// the fonts; the plain arrow is.
fn repair(mathml: &str) -> String {
    let mut repaired = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(at) = rest.find("<mover accent=\"true\">") {
        let (before, over) = rest.split_at(at);
        repaired.push_str(before);
        let end = closing(over);
        let (over, after) = over.split_at(end);
        if over.contains(">\u{2d9}</mo>") || over.contains(">\u{a8}</mo>") {
            repaired.push_str(&over.replacen(" accent=\"true\"", "", 1));
        } else {
            // Nested accents are looked at again, one by one.
            let tag = "<mover accent=\"true\">";
            repaired.push_str(tag);
            rest = &rest[at + tag.len()..];
            continue;
        }
        rest = after;
    }
    repaired.push_str(rest);
    repaired.replace('\u{20d7}', "\u{2192}")
}

/// Gives back its size to a large parenthesis with an exponent, as in `\bigl(…\bigr)^n`.
///
/// Browsers do not stretch a sign that carries an exponent. So the sign comes before, and the exponent goes to an empty
/// base of the same height.
fn lift_scripts(mathml: String) -> String {
    let mut lifted = String::with_capacity(mathml.len());
    let mut rest = mathml.as_str();
    while let Some(at) = rest.find("<mo minsize=\"") {
        let (before, sign) = rest.split_at(at);
        let script = ["<msup>", "<msub>", "<msubsup>"]
            .into_iter()
            .find(|script| before.ends_with(script));
        let end = sign.find("</mo>").map(|end| end + "</mo>".len());
        let size = sign
            .split('"')
            .nth(1)
            .and_then(|size| size.strip_suffix("em"));
        let (Some(script), Some(end), Some(Ok(size))) = (script, end, size.map(str::parse::<f64>))
        else {
            lifted.push_str(&rest[..at + 1]);
            rest = &rest[at + 1..];
            continue;
        };
        // Delimiters are centred on the axis of the formula, a quarter of an em above its base line.
        let (height, depth) = (size / 2.0 + 0.25, size / 2.0 - 0.25);
        lifted.push_str(&before[..before.len() - script.len()]);
        lifted.push_str(&sign[..end]);
        lifted.push_str(&format!(
            "{script}<mspace width=\"0\" height=\"{height:.2}em\" depth=\"{depth:.2}em\"></mspace>"
        ));
        rest = &sign[end..];
    }
    lifted.push_str(rest);
    lifted
}

/// Takes primes out of the exponent: f′ and f″.
///
/// The sign ′ is high and small by itself; as an exponent, browsers raise and shrink it once more.
fn lower_primes(mathml: &str) -> String {
    const OPEN: &str = "<msup>";
    const CLOSE: &str = "</msup>";
    let mut lowered = mathml.to_owned();
    for prime in ['\u{2032}', '\u{2033}', '\u{2034}'] {
        let exponent = format!("<mo>{prime}</mo>{CLOSE}");
        while let Some(end) = lowered.find(&exponent) {
            // The exponent belongs to the last `<msup>` before it that is not closed.
            let mut unclosed = 1;
            let mut start = end;
            while unclosed > 0 {
                let before = &lowered[..start];
                let (open, close) = (before.rfind(OPEN), before.rfind(CLOSE));
                let Some(tag) = open.max(close) else {
                    return lowered;
                };
                unclosed += if close == Some(tag) { 1 } else { -1 };
                start = tag;
            }
            let base = &lowered[start + OPEN.len()..end];
            let row = format!("<mrow>{base}<mo lspace=\"0\" rspace=\"0\">{prime}</mo></mrow>");
            lowered.replace_range(start..end + exponent.len(), &row);
        }
    }
    lowered
}

/// Where the `<mover>` that opens the text ends.
fn closing(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while let Some(found) = text[at..].find('<') {
        let tag = &text[at + found..];
        at += found + 1;
        if tag.starts_with("<mover") {
            depth += 1;
        } else if tag.starts_with("</mover>") {
            depth -= 1;
            if depth == 0 {
                return at - 1 + "</mover>".len();
            }
        }
    }
    text.len()
}

/// Writes as entities what Markdown would read as its own: stars, underscores, quotes, dashes, …
fn hide_from_markdown(mathml: &str) -> String {
    let mut hidden = String::with_capacity(mathml.len() + 64);
    let mut in_tag = false;
    for letter in mathml.chars() {
        match letter {
            '<' => in_tag = true,
            '>' => in_tag = false,
            '\n' => continue,
            '*' | '_' | '`' | '[' | ']' | '\\' | '~' | '|' | '!' | '\'' | '"' | '-' | '.' | '$'
            | '^' | '{' | '}'
                if !in_tag =>
            {
                hidden.push_str(&format!("&#{};", u32::from(letter)));
                continue;
            }
            _ => {}
        }
        hidden.push(letter);
    }
    hidden
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primes_stand_beside_their_letter() {
        let row =
            |base: &str| format!("<mrow>{base}<mo lspace=\"0\" rspace=\"0\">\u{2032}</mo></mrow>");
        let power = "<msup><mi>x</mi><mn>2</mn></msup>";
        let prime = |base: &str| format!("<msup>{base}<mo>\u{2032}</mo></msup>");
        assert_eq!(lower_primes(&prime("<mi>b</mi>")), row("<mi>b</mi>"));
        let nested = prime(&format!("<mrow>{power}</mrow>"));
        assert_eq!(lower_primes(&nested), row(&format!("<mrow>{power}</mrow>")));
        assert_eq!(lower_primes(power), power);
    }

    #[test]
    fn the_commands_of_the_book_are_understood() {
        let formulas = Formulas::new();
        for latex in [
            r"\R",
            r"\N",
            r"\Z",
            r"\Q",
            r"\conv P",
            r"\norm{x}",
            r"\abs{x}",
            r"\dd t",
        ] {
            assert!(formulas.mathml(latex, false).is_ok(), "{latex}");
        }
    }

    #[test]
    fn markdown_finds_nothing_of_its_own() {
        let mathml = Formulas::new()
            .mathml(r"a*b_{*} \text{it's [a]-b} |x|", false)
            .expect("the formula parses");
        let mut in_tag = false;
        for letter in mathml.chars() {
            match letter {
                '<' => in_tag = true,
                '>' => in_tag = false,
                _ => assert!(in_tag || !"*_`[]'|-".contains(letter), "{mathml}"),
            }
        }
    }

    #[test]
    fn dots_and_arrows_are_repaired() {
        let formulas = Formulas::new();
        let dot = formulas.mathml(r"\dot{x}", false).expect("it parses");
        assert!(!dot.contains("accent"), "{dot}");
        let vec = formulas.mathml(r"\vec{v}", false).expect("it parses");
        assert!(
            vec.contains('\u{2192}') && !vec.contains('\u{20d7}'),
            "{vec}"
        );
        let hat = formulas.mathml(r"\hat{x}", false).expect("it parses");
        assert!(
            hat.contains("accent"),
            "other accents stay as they are: {hat}"
        );
    }

    #[test]
    fn a_large_parenthesis_keeps_its_size_under_an_exponent() {
        let mathml = Formulas::new()
            .mathml(r"\bigl(t + x\bigr)^n", false)
            .expect("it parses");
        assert!(!mathml.contains("<msup><mo"), "{mathml}");
        let sign = "<mo minsize=\"1.2em\" maxsize=\"1.2em\">)</mo>";
        let script = "<msup><mspace width=\"0\" height=\"0.85em\" depth=\"0.35em\"></mspace><mi>n</mi></msup>";
        assert!(mathml.contains(&format!("{sign}{script}")), "{mathml}");
    }
}
