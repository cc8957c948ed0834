//! Formulas as text: `b_0^1 = \frac{1}{2}` becomes `b₀¹ = 1/2`.
//!
//! Only what a line of text can show well is changed. A formula with anything else stays as it was written.

/// The formula as text, or its source where that says more.
pub fn readable(latex: &str) -> String {
    let mut reader = Reader {
        letters: latex.trim().chars().collect(),
        at: 0,
    };
    let text = reader.sequence(false);
    match text {
        Some(text) if reader.at == reader.letters.len() => squeezed(&text),
        _ => latex.trim().to_owned(),
    }
}

/// Single blanks, none at the ends and none inside of brackets.
fn squeezed(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words
        .join(" ")
        .replace("( ", "(")
        .replace(" )", ")")
        .replace("[ ", "[")
        .replace(" ]", "]")
        .replace(" ,", ",")
        .replace(" .", ".")
}

struct Reader {
    letters: Vec<char>,
    at: usize,
}

impl Reader {
    fn next(&mut self) -> Option<char> {
        let letter = self.letters.get(self.at).copied();
        self.at += usize::from(letter.is_some());
        letter
    }

    fn peek(&self) -> Option<char> {
        self.letters.get(self.at).copied()
    }

    /// Reads up to the end, or in a group up to its closing brace.
    fn sequence(&mut self, in_group: bool) -> Option<String> {
        let mut text = String::new();
        while let Some(letter) = self.peek() {
            if letter == '}' {
                return in_group.then(|| {
                    self.at += 1;
                    text
                });
            }
            match letter {
                '_' | '^' => {
                    self.at += 1;
                    let script = squeezed(&self.argument()?);
                    text.truncate(text.trim_end().len());
                    text.push_str(&raised(letter, &script));
                }
                _ => text.push_str(&self.argument()?),
            }
        }
        (!in_group).then_some(text)
    }

    /// A letter, a command or a group.
    fn argument(&mut self) -> Option<String> {
        let letter = self.next()?;
        Some(match letter {
            '{' => self.sequence(true)?,
            '}' | '_' | '^' => return None,
            '\\' => return self.command(),
            '-' => "−".into(),
            '\'' => "′".into(),
            '~' => " ".into(),
            '&' => " ".into(),
            '=' | '<' | '>' | '+' => format!(" {letter} "),
            _ => letter.into(),
        })
    }

    fn command(&mut self) -> Option<String> {
        let mut name = String::new();
        while let Some(letter) = self.peek().filter(char::is_ascii_alphabetic) {
            name.push(letter);
            self.at += 1;
        }
        if name.is_empty() {
            return Some(match self.next()? {
                ',' | ';' | ':' | ' ' => " ".into(),
                '!' => String::new(),
                '\\' => "; ".into(),
                letter @ ('{' | '}' | '%' | '_' | '&' | '#' | '$') => letter.into(),
                '|' => "‖".into(),
                _ => return None,
            });
        }
        while self.peek().is_some_and(char::is_whitespace) {
            self.at += 1;
        }
        Some(match name.as_str() {
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (squeezed(&self.argument()?), squeezed(&self.argument()?));
                format!("{}/{}", factor(&above), factor(&below))
            }
            "binom" => {
                let (above, below) = (squeezed(&self.argument()?), squeezed(&self.argument()?));
                format!("({above} choose {below})")
            }
            "sqrt" if self.peek() != Some('[') => {
                format!("√{}", factor(&squeezed(&self.argument()?)))
            }
            "norm" => format!("‖{}‖", squeezed(&self.argument()?)),
            "abs" => format!("|{}|", squeezed(&self.argument()?)),
            "text" | "mathrm" | "operatorname" | "mathbf" | "boldsymbol" | "mathit" => {
                self.argument()?
            }
            "left" | "right" | "bigl" | "bigr" | "big" | "Big" | "Bigl" | "Bigr" => {
                if self.peek() == Some('.') {
                    self.at += 1;
                }
                String::new()
            }
            "quad" | "qquad" => "  ".into(),
            "conv" | "det" | "max" | "min" | "sin" | "cos" | "exp" | "ln" | "deg" | "lim" => {
                let next_is_word = self.peek().is_some_and(char::is_alphanumeric);
                format!("{name}{}", if next_is_word { " " } else { "" })
            }
            _ => symbol(&name)?.to_owned(),
        })
    }
}

/// Brackets around what a quotient or a root would tear apart.
fn factor(text: &str) -> String {
    let is_whole = text
        .chars()
        .all(|c| c.is_alphanumeric() || is_script(c) || c == '′');
    if is_whole {
        text.to_owned()
    } else {
        format!("({text})")
    }
}

const LOW: [(char, char); 30] = [
    ('0', '₀'),
    ('1', '₁'),
    ('2', '₂'),
    ('3', '₃'),
    ('4', '₄'),
    ('5', '₅'),
    ('6', '₆'),
    ('7', '₇'),
    ('8', '₈'),
    ('9', '₉'),
    ('+', '₊'),
    ('−', '₋'),
    ('=', '₌'),
    ('(', '₍'),
    (')', '₎'),
    ('a', 'ₐ'),
    ('e', 'ₑ'),
    ('h', 'ₕ'),
    ('i', 'ᵢ'),
    ('j', 'ⱼ'),
    ('k', 'ₖ'),
    ('l', 'ₗ'),
    ('m', 'ₘ'),
    ('n', 'ₙ'),
    ('p', 'ₚ'),
    ('r', 'ᵣ'),
    ('s', 'ₛ'),
    ('t', 'ₜ'),
    ('u', 'ᵤ'),
    ('x', 'ₓ'),
];

const HIGH: [(char, char); 30] = [
    ('0', '⁰'),
    ('1', '¹'),
    ('2', '²'),
    ('3', '³'),
    ('4', '⁴'),
    ('5', '⁵'),
    ('6', '⁶'),
    ('7', '⁷'),
    ('8', '⁸'),
    ('9', '⁹'),
    ('+', '⁺'),
    ('−', '⁻'),
    ('=', '⁼'),
    ('(', '⁽'),
    (')', '⁾'),
    ('a', 'ᵃ'),
    ('b', 'ᵇ'),
    ('d', 'ᵈ'),
    ('h', 'ʰ'),
    ('i', 'ⁱ'),
    ('j', 'ʲ'),
    ('k', 'ᵏ'),
    ('l', 'ˡ'),
    ('m', 'ᵐ'),
    ('n', 'ⁿ'),
    ('p', 'ᵖ'),
    ('r', 'ʳ'),
    ('s', 'ˢ'),
    ('t', 'ᵗ'),
    ('T', 'ᵀ'),
];

fn is_script(letter: char) -> bool {
    LOW.iter().chain(&HIGH).any(|&(_, script)| script == letter)
}

/// An index or an exponent; in braces where the signs for it are missing.
fn raised(sign: char, script: &str) -> String {
    if script == "′" {
        return script.to_owned();
    }
    let table = if sign == '_' { &LOW } else { &HIGH };
    let letters: Option<String> = script
        .chars()
        .filter(|c| *c != ' ')
        .map(|c| {
            let known = table.iter().find(|(plain, _)| *plain == c);
            known.map(|&(_, script)| script)
        })
        .collect();
    letters.unwrap_or_else(|| {
        if script.chars().count() == 1 {
            format!("{sign}{script}")
        } else {
            format!("{sign}{{{script}}}")
        }
    })
}

fn symbol(name: &str) -> Option<&'static str> {
    Some(match name {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "varepsilon" | "epsilon" => "ε",
        "eta" => "η",
        "theta" => "θ",
        "kappa" => "κ",
        "lambda" => "λ",
        "mu" => "μ",
        "nu" => "ν",
        "xi" => "ξ",
        "pi" => "π",
        "rho" => "ρ",
        "sigma" => "σ",
        "tau" => "τ",
        "varphi" | "phi" => "φ",
        "psi" => "ψ",
        "omega" => "ω",
        "Gamma" => "Γ",
        "Delta" => "Δ",
        "Phi" => "Φ",
        "Omega" => "Ω",
        "R" => "ℝ",
        "N" => "ℕ",
        "Z" => "ℤ",
        "Q" => "ℚ",
        "ell" => "ℓ",
        "le" | "leq" => " ≤ ",
        "ge" | "geq" => " ≥ ",
        "ne" | "neq" => " ≠ ",
        "approx" => " ≈ ",
        "equiv" => " ≡ ",
        "in" => " ∈ ",
        "notin" => " ∉ ",
        "subset" => " ⊂ ",
        "subseteq" => " ⊆ ",
        "cap" => " ∩ ",
        "cup" => " ∪ ",
        "to" | "rightarrow" => " → ",
        "mapsto" => " ↦ ",
        "implies" | "Rightarrow" => " ⇒ ",
        "iff" | "Leftrightarrow" => " ⇔ ",
        "cdot" => " · ",
        "times" => " × ",
        "pm" => "±",
        "mid" | "vert" => " | ",
        "dots" | "ldots" | "cdots" => "…",
        "infty" => "∞",
        "partial" => "∂",
        "sum" => "∑",
        "prod" => "∏",
        "int" => "∫",
        "circ" => "∘",
        "emptyset" => "∅",
        "forall" => "∀",
        "exists" => "∃",
        "prime" => "′",
        "dd" => "d",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_line_can_show_is_shown() {
        for (latex, text) in [
            ("b_0^1 = b_0 + t\\,(b_1 - b_0)", "b₀¹ = b₀ + t (b₁ − b₀)"),
            ("\\frac{1}{2}", "1/2"),
            ("\\frac{i + 1}{n}", "(i + 1)/n"),
            ("B_i^n(t)", "Bᵢⁿ(t)"),
            ("b_{i,j}", "b_{i,j}"),
            ("b_{n-1}", "bₙ₋₁"),
            ("[0, 1]", "[0, 1]"),
            ("t \\in \\R", "t ∈ ℝ"),
            ("0\\le t\\le1", "0 ≤ t ≤ 1"),
            ("\\binom{n}{i} t^i (1-t)^{n-i}", "(n choose i) tⁱ (1−t)ⁿ⁻ⁱ"),
            ("b'(0)", "b′(0)"),
            ("2 \\cdot 3", "2 · 3"),
            ("t\\cdot(b_1 - b_0)", "t · (b₁ − b₀)"),
            ("\\left(\\tfrac12\\right)", "(1/2)"),
            ("\\sqrt{x + 1}", "√(x + 1)"),
            ("\\{b_0, \\dots, b_n\\}", "{b₀, …, bₙ}"),
        ] {
            assert_eq!(readable(latex), text, "{latex}");
        }
    }

    #[test]
    fn anything_else_stays_as_it_is() {
        for latex in [
            "\\overline{ab}",
            "\\begin{matrix} a \\end{matrix}",
            "a_{b",
            "a}",
            "\\",
            "x^",
        ] {
            assert_eq!(readable(latex), latex);
        }
    }
}
