//! Formulas in their place: inline in the sentence, displayed on a line of their own.

use std::ops::Range;

use super::Expansion;
use crate::book::directive::Action;
use crate::book::error::Problem;
use crate::book::page::Formula;

/// What may not begin a line, and so stays on the line of the formula before it.
const CLOSING: [char; 9] = ['.', ',', ';', ':', '!', '?', ')', '’', '-'];

/// How many letters behind a formula and a hyphen stay on its line: those of “th” and “fold”.
const LONGEST_ENDING: usize = 4;

impl Expansion<'_> {
    /// What stands in the place of a formula, and of which bytes.
    ///
    /// A browser may break the line on both sides of a formula, even before a full stop.
    /// So the signs that touch a formula in a sentence are bound to it.
    pub(super) fn formula_in_its_place(
        &self,
        formula: &Formula,
        within: &Range<usize>,
    ) -> (Range<usize>, String) {
        let mathml = self.formula(formula);
        let span = formula.span.clone();
        if formula.display {
            return (span, mathml);
        }
        let before = &self.page.text[within.start..span.start];
        let after = &self.page.text[span.end..within.end];
        let opening = if before.ends_with('(') { "(" } else { "" };
        let rest = after.trim_start_matches(CLOSING);
        let mut closing = &after[..after.len() - rest.len()];
        if closing.ends_with('-') {
            // A short ending, as in “the j-th”, stays too; a word may go to the next line.
            let ending = rest.len() - rest.trim_start_matches(char::is_alphabetic).len();
            if ending <= LONGEST_ENDING {
                closing = &after[..closing.len() + ending];
            }
        }
        if opening.is_empty() && closing.is_empty() {
            return (span, mathml);
        }
        let bound = format!("<span class=\"bound\">{opening}{mathml}{closing}</span>");
        (span.start - opening.len()..span.end + closing.len(), bound)
    }

    /// The MathML of a formula.
    pub(super) fn formula(&self, formula: &Formula) -> String {
        let latex = self.with_computed(formula);
        let mathml = match self.site.formulas.mathml(&latex, formula.display) {
            Ok(mathml) => mathml,
            Err(reason) => {
                let formula_text = latex.split_whitespace().collect::<Vec<_>>().join(" ");
                let problem = Problem::Formula {
                    formula: formula_text,
                    reason,
                };
                self.report_line(formula.line, problem);
                return String::new();
            }
        };
        if !formula.display {
            return mathml;
        }
        // The fence may be indented, in a list item; what replaces it must stand in the same column.
        let text = &self.page.text[..formula.span.start];
        let indent = &text[text.rfind('\n').map_or(0, |at| at + 1)..];
        let indent: String = indent
            .chars()
            .map(|c| if c == '>' { c } else { ' ' })
            .collect();
        format!("\n{indent}<div class=\"formula\">{mathml}</div>\n{indent}")
    }

    /// The LaTeX of a formula, with `{{#computed …}}` replaced by what is computed.
    fn with_computed(&self, formula: &Formula) -> String {
        let mut latex = String::new();
        let mut rest = formula.latex.as_str();
        while let Some(at) = rest.find("{{#") {
            let Some(end) = rest[at..].find("}}").map(|end| at + end + 2) else {
                break;
            };
            latex.push_str(&rest[..at]);
            let source = &rest[at..end];
            let computed = match Action::parse(source) {
                Ok(Action::Computed { chapter, name }) => {
                    self.site.registry.computed(&chapter, &name)
                }
                Ok(_) => Err(Problem::Misplaced {
                    found: source.to_owned(),
                    rule: "only `{{#computed …}}` may stand in a formula",
                }),
                Err(problem) => Err(problem),
            };
            match computed {
                Ok(text) => latex.push_str(text.trim().trim_matches('$')),
                Err(problem) => self.report_line(formula.line, problem),
            }
            rest = &rest[end..];
        }
        latex.push_str(rest);
        latex
    }
}
