//! Formulas in their place: inline in the sentence, displayed on a line of their own.

use super::Expansion;
use crate::book::directive::Action;
use crate::book::error::Problem;
use crate::book::page::Formula;

impl Expansion<'_> {
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
