//! A verdict as HTML, for the page of the exercise.

use super::picture;
use super::told::{Failure, Told};
use crate::book::site::escape;
use crate::workbook::checking::verdict::{Diagnostic, Verdict};

/// The result of a check as HTML: the words of the terminal, and the picture of what is wrong.
///
/// Everything that comes from the answer is escaped: it cannot become part of the page.
pub fn described(verdict: &Verdict, title: &str) -> String {
    let told = Told::of(verdict);
    let mut html = format!(
        "<p class=\"verdict-summary\">{} <span class=\"verdict-time\">{:.1} s</span></p>\n",
        escape(&told.summary),
        verdict.seconds
    );
    if let Some(warnings) = &told.warnings {
        html.push_str(&paragraph("verdict-warnings", warnings));
    }
    for diagnostic in &told.diagnostics {
        html.push_str(&rendered(diagnostic));
    }
    if let Some(more) = &told.more_diagnostics {
        html.push_str(&paragraph("verdict-more", more));
    }
    if let Some(failure) = &told.failure {
        html.push_str(&failed(failure));
        if let Some(svg) = picture::of(verdict, title) {
            html.push_str(&format!(
                "<figure class=\"verdict-picture\">{svg}</figure>\n"
            ));
        }
    }
    if let Some(misconception) = &told.misconception {
        html.push_str(&paragraph("verdict-misconception", misconception));
    }
    for line in &told.others {
        html.push_str(&paragraph("verdict-more", line));
    }
    if !told.printed.is_empty() {
        let lines: Vec<String> = told
            .printed
            .iter()
            .chain(&told.more_printed)
            .map(|line| escape(line))
            .collect();
        html.push_str(&format!(
            "<p class=\"verdict-more\">Your answer printed:</p>\n<pre class=\"verdict-printed\">{}</pre>\n",
            lines.join("\n")
        ));
    }
    html
}

fn paragraph(class: &str, text: &str) -> String {
    format!("<p class=\"{class}\">{}</p>\n", escape(text))
}

/// The words of the compiler; a click on them leads to the line in the editor.
fn rendered(diagnostic: &Diagnostic) -> String {
    let line = diagnostic
        .line
        .map(|line| format!(" data-line=\"{line}\""))
        .unwrap_or_default();
    let text = diagnostic.rendered.trim_end();
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!(
        "<pre class=\"verdict-compiler {}\"{line}><strong>{}</strong>\n{}</pre>\n",
        escape(&diagnostic.level),
        escape(first),
        escape(rest)
    )
}

/// The test that failed first, and what it has found.
fn failed(failure: &Failure) -> String {
    let rows: Vec<String> = failure
        .rows
        .iter()
        .map(|row| {
            let class = match row.is_right {
                Some(true) => " class=\"right\"",
                Some(false) => " class=\"wrong\"",
                None => "",
            };
            format!(
                "<dt>{}</dt><dd{class}>{}</dd>",
                row.name,
                escape(&row.text).replace('\n', "<br>")
            )
        })
        .collect();
    format!(
        "<p class=\"verdict-test\"><strong>{}</strong> {}</p>\n<dl class=\"verdict-finding\">{}</dl>\n",
        escape(&failure.test),
        escape(failure.ending),
        rows.concat()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workbook::checking::Outcome;
    use crate::workbook::checking::verdict::{
        Misconception, PictureStroke, TestOutcome, TestResult,
    };

    fn verdict() -> Verdict {
        Verdict {
            exercise: "bezier/a".parse().expect("a name"),
            outcome: Outcome::Failed,
            diagnostics: Vec::new(),
            tests: vec![TestResult {
                test: "both_ends".into(),
                outcome: TestOutcome::Rejected,
                message: "no".into(),
                claim: Some("p(0) & p(1)".into()),
                input: Some("a = 1\nb = 2".into()),
                expected: Some("1".into()),
                found: Some("<script>alert(1)</script>".into()),
                picture: Some(vec![PictureStroke {
                    role: "found".into(),
                    points: vec![[0.0, 0.0], [1.0, 1.0]],
                }]),
            }],
            misconception: Some(Misconception {
                mutant: "m".into(),
                text: "a < b.".into(),
            }),
            checklist: None,
            output: "</pre><b>".into(),
            seconds: 0.25,
        }
    }

    #[test]
    fn what_an_answer_says_stays_text() {
        let html = described(&verdict(), "A <title>");
        for part in [
            "None of the 1 tests passed yet.",
            "<strong>both ends</strong> failed",
            "p(0) &amp; p(1)",
            "a = 1<br>b = 2",
            "<dd class=\"right\">1</dd>",
            "&lt;script&gt;",
            "It looks as if you think: a &lt; b.",
            "&lt;/pre&gt;&lt;b&gt;",
            "<svg",
        ] {
            assert!(html.contains(part), "`{part}` is not in {html}");
        }
        assert!(!html.contains("<script") && !html.contains("<title>A <"));
    }

    #[test]
    fn the_compiler_names_the_line() {
        let mut verdict = verdict();
        verdict.outcome = Outcome::DoesNotCompile;
        verdict.diagnostics = vec![Diagnostic {
            level: "error".into(),
            message: "no".into(),
            line: Some(7),
            rendered: "error[E0308]: `Vec<T>`\n --> answer.rs:7:1\n".into(),
        }];
        let html = described(&verdict, "t");
        assert!(
            html.contains("class=\"verdict-compiler error\" data-line=\"7\"><strong>error[E0308]: `Vec&lt;T&gt;`</strong>"),
            "{html}"
        );
        assert!(!html.contains("<svg"), "no test has run: {html}");
    }
}
