//! Exercises as the pages show them: the task, and folded below it starter, hints and solution.

use std::path::Path;

use super::{Lines, fragment_of};
use crate::book::error::{BookError, Problem};
use crate::book::exercise::{Document, Exercise, ExerciseName, Section, Tested};
use crate::book::page::Page;
use crate::book::site::{Site, escape, link, title_html};

/// The page for exercises whose statements no page states yet.
pub(crate) const LIST: &str = "exercises.html";

/// The anchor of an exercise in its page: `exercise--bezier--parabola-point`.
pub(crate) fn exercise_anchor(name: &ExerciseName) -> String {
    format!("exercise--{}--{}", name.chapter(), name.name())
}

impl Site<'_> {
    /// The index of the page that shows an exercise: the one that states the first statement it trains.
    pub(crate) fn page_of(&self, exercise: &Exercise) -> Option<usize> {
        let first = exercise.front.statements.first()?;
        Some(self.manuscript.statements.get(first)?.page)
    }

    /// The address of an exercise, from the top of the site.
    pub(crate) fn exercise_address(&self, exercise: &Exercise) -> String {
        let page = self
            .page_of(exercise)
            .map_or_else(|| LIST.to_owned(), |page| self.address(page));
        format!("{page}#{}", exercise_anchor(&exercise.name))
    }
}

/// The exercises of a page, below everything else on it; nothing if there are none.
pub(crate) fn exercises_of_page(site: &Site<'_>, page: usize) -> String {
    let address = site.address(page);
    let shown: Vec<String> = site
        .exercises
        .iter()
        .filter(|exercise| site.page_of(exercise) == Some(page))
        .map(|exercise| exercise_html(site, &address, exercise))
        .collect();
    if shown.is_empty() {
        return String::new();
    }
    let plural = if shown.len() == 1 {
        "Exercise"
    } else {
        "Exercises"
    };
    format!("\n\n## {plural}\n\n{}", shown.concat())
}

/// One exercise.
pub(crate) fn exercise_html(site: &Site<'_>, address: &str, exercise: &Exercise) -> String {
    let file = exercise.file();
    let markdown = |section: &Section| section_html(site, &file, address, section);
    let Document {
        task,
        hints,
        afterwards,
        model_answer,
        checklist,
    } = &exercise.document;
    let anchor = exercise_anchor(&exercise.name);
    let mut html = format!(
        "<section class=\"practice\" id=\"{anchor}\" data-exercise=\"{}\" data-kind=\"{}\"{}>\n\
         <h3 class=\"practice-head\" id=\"{anchor}--title\">{} <a class=\"permalink\" href=\"#{anchor}\" aria-label=\"Link to this exercise\"></a></h3>\n\
         {}\n\n{}\n\n",
        exercise.name,
        exercise.front.kind.name(),
        tableau(exercise),
        title_html(&exercise.front.title),
        facts(site, address, exercise),
        markdown(task),
    );
    if let Some(tested) = &exercise.tested {
        html.push_str(&folded(
            "starter",
            "What you begin with",
            &source(&tested.answer.starter),
        ));
    }
    for (index, hint) in hints.iter().enumerate() {
        let title = format!("Hint {}", index + 1);
        html.push_str(&folded("hint", &title, &markdown(hint)));
    }
    if site.with_solutions {
        if let Some(tested) = &exercise.tested {
            html.push_str(&folded("solution", "Solution", &solution(tested)));
        }
        if let Some(model_answer) = model_answer {
            let title = "Model answer";
            html.push_str(&folded("model solution", title, &markdown(model_answer)));
        }
        if let Some(afterwards) = afterwards {
            let title = "Afterwards";
            html.push_str(&folded("afterwards solution", title, &markdown(afterwards)));
        }
    }
    if let Some(checklist) = checklist {
        html.push_str(&folded(
            "checklist",
            "What a good answer says",
            &markdown(checklist),
        ));
    }
    html.push_str("</section>\n\n");
    html
}

/// The tableau that a script makes a table of, for a reader who computes by hand.
fn tableau(exercise: &Exercise) -> String {
    let name = exercise.front.tableau.as_ref();
    name.map_or_else(String::new, |name| {
        format!(" data-tableau=\"{} {name}\"", exercise.name.chapter())
    })
}

/// The lines under the title: what kind, how hard, how long, what it trains, how to begin.
fn facts(site: &Site<'_>, address: &str, exercise: &Exercise) -> String {
    let front = &exercise.front;
    let difficulty = usize::from(front.difficulty.min(5));
    let dots = format!("{}{}", "●".repeat(difficulty), "○".repeat(5 - difficulty));
    let mut facts = vec![
        front.kind.title().to_owned(),
        format!(
            "<span class=\"difficulty\" role=\"img\" aria-label=\"difficulty {difficulty} of 5\">{dots}</span>"
        ),
        format!("{}\u{a0}min", front.minutes),
    ];
    if exercise.front.kind.is_tested() {
        facts.push(format!("<code>cargo run -- start {}</code>", exercise.name));
    }
    let mut lines = vec![format!(
        "<span class=\"facts\">{}</span>",
        facts.join(" <span aria-hidden=\"true\">·</span> ")
    )];
    let trains: Vec<String> = front
        .statements
        .iter()
        .filter_map(|id| {
            let statement = site.catalogue.get(id)?;
            let title = title_html(&statement.title);
            Some(match site.manuscript.statements.get(id) {
                Some(written) => {
                    let to = format!("{}#{id}", site.address(written.page));
                    format!("<a href=\"{}\">{title}</a>", link(address, &to))
                }
                None => title,
            })
        })
        .collect();
    lines.push(format!("<span><b>Trains</b> {}</span>", trains.join(", ")));
    let before: Vec<String> = front
        .prerequisites
        .iter()
        .filter_map(|name| site.exercises.get(name))
        .map(|needed| {
            let to = link(address, &site.exercise_address(needed));
            format!("<a href=\"{to}\">{}</a>", title_html(&needed.front.title))
        })
        .collect();
    if !before.is_empty() {
        lines.push(format!("<span><b>After</b> {}</span>", before.join(", ")));
    }
    format!("<p class=\"practice-facts\">{}</p>", lines.join(" "))
}

/// What is seen only when the reader asks for it.
fn folded(class: &str, title: &str, body: &str) -> String {
    format!(
        "<details class=\"fold {class}\">\n<summary>{title}</summary>\n\n{}\n\n</details>\n\n",
        body.trim()
    )
}

/// Source code; blank lines are harmless in `pre`, where Markdown reads HTML up to the closing tag.
fn source(text: &str) -> String {
    format!(
        "<pre><code class=\"language-rust noplayground\">{}</code></pre>",
        escape(text).replace('\'', "&#39;")
    )
}

/// The solution, and other right answers.
fn solution(tested: &Tested) -> String {
    let mut html = source(&tested.answer.solution);
    for alternative in &tested.alternatives {
        html.push_str("\n\nAnother right answer:\n\n");
        html.push_str(&source(&alternative.text));
    }
    html
}

/// A section of `exercise.md`, expanded; errors name its lines.
fn section_html(site: &Site<'_>, file: &Path, address: &str, section: &Section) -> String {
    let mut errors = Vec::new();
    let page = Page::parse(file, "", &mut errors);
    let parsed = Page::parse(file, &section.text, &mut errors);
    for block in &parsed.code {
        let found = match &block.info {
            None => "an indented code block",
            Some(info) if info.trim().is_empty() => "a code block without a tag",
            Some(_) if block.is_rust() => "a Rust block that nothing compiles",
            Some(_) => continue,
        };
        let problem = Problem::Exercise {
            found: found.to_owned(),
            remedy: "tag its fence as `text`".to_owned(),
        };
        let line = section.line + block.line - 1;
        site.report(BookError::new(file, line, problem));
    }
    fragment_of(
        site,
        &page,
        address,
        Lines::From(section.line),
        &section.text,
    )
}
