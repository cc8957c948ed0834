//! The list of all exercises, to find one by chapter, kind and difficulty.

use super::statements::chapter_title;
use super::{Generated, table};
use crate::book::catalogue::CHAPTERS;
use crate::book::expand::{LIST, exercise_html};
use crate::book::site::{Site, link, title_html};

/// The page: a table for each chapter; below it the exercises whose statements no page states yet.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let total = site.exercises.iter().count();
    let mut content = format!(
        "# Exercises\n\n\
         {total} exercises, each at the end of the page that it belongs to.\n\
         Served by `cargo run`, each has an editor and is checked on its page.\n\
         In a terminal, `cargo run -- list` shows them with your progress, and `cargo run -- start NAME` begins one.\n\n"
    );
    let mut homeless = String::new();
    for chapter in CHAPTERS {
        let mut rows = Vec::new();
        for exercise in site
            .exercises
            .iter()
            .filter(|e| e.name.chapter() == chapter)
        {
            let to = link(LIST, &site.exercise_address(exercise));
            let difficulty = exercise.front.difficulty.min(5);
            let dots = format!(
                "<span class=\"difficulty\" role=\"img\" aria-label=\"{difficulty} of 5\">{}{}</span>",
                "●".repeat(difficulty.into()),
                "○".repeat((5 - difficulty).into())
            );
            rows.push(vec![
                format!(
                    "<a href=\"{to}\">{}</a><br /><code>{}</code>",
                    title_html(&exercise.front.title),
                    exercise.name
                ),
                exercise.front.kind.title().to_owned(),
                dots,
                format!("{}\u{a0}min", exercise.front.minutes),
            ]);
            if site.page_of(exercise).is_none() {
                homeless.push_str(&exercise_html(site, LIST, exercise));
            }
        }
        if !rows.is_empty() {
            let head = ["Exercise", "Kind", "Difficulty", "Time"];
            content.push_str(&format!(
                "<h2 id=\"{chapter}\">{}</h2>\n\n{}\n",
                chapter_title(chapter),
                table("exercises", &head, &rows)
            ));
        }
    }
    if !homeless.is_empty() {
        content.push_str("## Ahead of their chapters\n\n");
        content.push_str(&homeless);
    }
    Generated::new("Exercises", "exercises.md", content)
}
