//! The text of `exercise.md`: the task, then sections with fixed headings.

use std::path::Path;

use super::front_matter::FrontMatter;
use crate::book::catalogue::{line_of, toml_error};
use crate::book::error::{BookError, Problem};

/// A piece of Markdown and where it stands.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Section {
    /// The text, without its heading and the empty lines around it.
    pub text: String,
    /// The line of its first letter in `exercise.md`, counted from 1.
    pub line: usize,
}

/// The text of an exercise.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Document {
    /// What to do.
    pub task: Section,
    /// The hints, from a nudge to all but the code: each `## Hint`.
    pub hints: Vec<Section>,
    /// What is worth knowing once it is solved: `## Afterwards`.
    pub afterwards: Option<Section>,
    /// For *explain*: `## Model answer`.
    pub model_answer: Option<Section>,
    /// For *explain*: `## Checklist`, a list of what a good answer says.
    pub checklist: Option<Section>,
}

/// Reads `exercise.md`.
///
/// # Errors
///
/// Each heading that is not known or comes twice, front matter that is missing or wrong.
pub fn parse(file: &Path, text: &str) -> Result<(FrontMatter, Document), Vec<BookError>> {
    let error = |line, found: &str, remedy: &str| {
        let (found, remedy) = (found.to_owned(), remedy.to_owned());
        BookError::new(file, line, Problem::Exercise { found, remedy })
    };
    let Some((front, body_start)) = split(text) else {
        return Err(vec![error(
            1,
            "the file has no front matter",
            "begin it with a line `+++`, the title and so on in TOML, and another line `+++`",
        )]);
    };
    let front_line = 2;
    // Empty lines in front keep the line numbers of the parser's errors right.
    let padded = format!("{}{front}", "\n".repeat(front_line - 1));
    let front: FrontMatter =
        toml::from_str(&padded).map_err(|e| vec![toml_error(file, &padded, &e)])?;

    let mut errors = Vec::new();
    let mut document = Document::default();
    for (heading, heading_line, section) in sections(text, body_start) {
        let twice = |there: bool| there.then(|| format!("there is a second `## {heading}`"));
        let problem = match heading.as_str() {
            "" => {
                document.task = section;
                None
            }
            "Hint" => {
                document.hints.push(section);
                None
            }
            "Afterwards" => twice(document.afterwards.replace(section).is_some()),
            "Model answer" => twice(document.model_answer.replace(section).is_some()),
            "Checklist" => twice(document.checklist.replace(section).is_some()),
            _ => Some(format!("no section is called `## {heading}`")),
        };
        if let Some(found) = problem {
            let remedy = "the sections are `## Hint` (three or more), `## Afterwards`, and for an explanation `## Model answer` and `## Checklist`";
            errors.push(error(heading_line, &found, remedy));
        }
    }
    if errors.is_empty() {
        Ok((front, document))
    } else {
        Err(errors)
    }
}

/// The front matter, and where the body begins.
fn split(text: &str) -> Option<(&str, usize)> {
    let rest = text.strip_prefix("+++\n")?;
    let end = if rest.starts_with("+++\n") {
        0
    } else {
        rest.find("\n+++\n")? + 1
    };
    Some((&rest[..end], "+++\n".len() + end + "+++\n".len()))
}

/// The sections of the body: heading, line of the heading, text. The task has no heading.
fn sections(text: &str, body_start: usize) -> Vec<(String, usize, Section)> {
    let mut found = Vec::new();
    let mut heading = (String::new(), line_of(text, body_start));
    let mut start = body_start;
    let mut at = body_start;
    let mut in_fence = false;
    for line in text[body_start..].split_inclusive('\n') {
        if line.trim_start().starts_with("```") {
            in_fence = !in_fence;
        }
        if let (false, Some(next)) = (in_fence, line.strip_prefix("## ")) {
            let (name, line_of_heading) = std::mem::take(&mut heading);
            found.push((name, line_of_heading, section(text, start, at)));
            heading = (next.trim().to_owned(), line_of(text, at));
            start = at + line.len();
        }
        at += line.len();
    }
    found.push((heading.0, heading.1, section(text, start, text.len())));
    found
}

fn section(text: &str, start: usize, end: usize) -> Section {
    let body = &text[start..end];
    // An empty section stands where its text would begin.
    let space = body.len() - body.trim_start().len();
    let first = if space == body.len() { 0 } else { space };
    Section {
        text: body.trim().to_owned(),
        line: line_of(text, start + first),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRONT: &str = "+++\ntitle = \"T\"\nkind = \"implement\"\nstatements = [\"bezier-blossom\"]\ndifficulty = 1\nminutes = 5\norder = 10\n+++\n";

    fn read(text: &str) -> Result<(FrontMatter, Document), Vec<BookError>> {
        parse(Path::new("exercise.md"), text)
    }

    #[test]
    fn task_and_hints_are_told_apart() {
        let text = format!(
            "{FRONT}\nDo it.\n\n```text\n## Hint\n```\n\n## Hint\n\nTry.\n\n## Hint\nMore.\n"
        );
        let (front, document) = read(&text).expect("the exercise is right");
        assert_eq!(front.title, "T");
        assert_eq!(document.task.text, "Do it.\n\n```text\n## Hint\n```");
        assert_eq!(document.task.line, 10);
        let hints: Vec<_> = document
            .hints
            .iter()
            .map(|h| (h.text.as_str(), h.line))
            .collect();
        assert_eq!(hints, [("Try.", 18), ("More.", 21)]);
    }

    #[test]
    fn mistakes_are_told_with_their_line() {
        let line = |text: &str| read(text).expect_err("a mistake")[0].place.line;
        assert_eq!(line("no front matter"), 1);
        assert_eq!(line(&FRONT.replace("minutes = 5", "minuets = 5")), 6);
        assert_eq!(line(&format!("{FRONT}Do.\n## Tip\n")), 10);
        assert_eq!(line(&format!("{FRONT}## Afterwards\n## Afterwards\n")), 10);
    }
}
