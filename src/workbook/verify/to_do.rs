//! What an author has left open: the lines with `TODO`, as `new exercise` writes them.

use super::report::Shortcoming;
use crate::book::exercise::Exercise;

/// The mark of a line that is not finished.
const MARK: &str = "TODO";

/// A shortcoming for each line that still holds the mark.
pub fn list(exercise: &Exercise) -> Vec<Shortcoming> {
    let mut found = Vec::new();
    for (file, first_line, text) in texts(exercise) {
        for (number, line) in text.lines().enumerate() {
            let Some(at) = line.find(MARK) else {
                continue;
            };
            let words = line[at + MARK.len()..].trim_start_matches(':').trim();
            let place = exercise.folder.join(&file);
            let place = first_line.map_or_else(
                || place.display().to_string(),
                |first| format!("{}:{}", place.display(), first + number),
            );
            let shortcoming = Shortcoming {
                about: "to do".into(),
                found: words.to_owned(),
                remedy: format!("replace the line with `{MARK}` in `{place}`"),
                details: String::new(),
            };
            // Starter and solution share most lines.
            if !found.contains(&shortcoming) {
                found.push(shortcoming);
            }
        }
    }
    found
}

/// All texts of an exercise: the file below its folder, the line of the first letter where it is known, the text.
pub(super) fn texts(exercise: &Exercise) -> Vec<(String, Option<usize>, &str)> {
    let document = &exercise.document;
    let file = || "exercise.md".to_owned();
    let mut texts = vec![(file(), None, exercise.front.title.as_str())];
    let sections = std::iter::once(&document.task)
        .chain(&document.hints)
        .chain(&document.afterwards)
        .chain(&document.model_answer)
        .chain(&document.checklist);
    texts.extend(sections.map(|section| (file(), Some(section.line), section.text.as_str())));
    if let Some(tested) = &exercise.tested {
        let answer = &tested.answer;
        // The marks between them are gone, so their lines are not those of the file.
        texts.extend(
            [&answer.solution, &answer.starter]
                .map(|text| ("answer.rs".to_owned(), None, text.as_str())),
        );
        texts.push(("tests.rs".into(), Some(1), &tested.tests.text));
        for (folder, variants) in [
            ("mutants", &tested.mutants),
            ("alternatives", &tested.alternatives),
        ] {
            texts.extend(variants.iter().map(|variant| {
                let file = format!("{folder}/{}.rs", variant.name);
                (file, Some(1), variant.text.as_str())
            }));
        }
    }
    texts
}
