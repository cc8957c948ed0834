//! One sentence a line, and every block of the book runs.

use std::path::Path;

use super::{assert_none, files_below, read};

/// The pages that people write: the book's, and those that introduce the house.
fn pages() -> Vec<std::path::PathBuf> {
    let mut pages = files_below("book/src", "md");
    pages.extend(["README.md".into(), "CONTRIBUTING.md".into()]);
    pages
}

/// Words that end in a full stop without ending a sentence.
const ABBREVIATIONS: [&str; 12] = [
    "resp", "chap", "vol", "prop", "thm", "approx", "incl", "proc", "conf", "trans", "univ", "viz",
];

/// The lines on which a second sentence begins.
///
/// A sentence ends where a word of at least three letters, a bracket or a code span is followed by a full stop,
/// question or exclamation mark, a blank and a capital letter. Tables, headings, code and formulas are left out.
fn lines_with_two_sentences(page: &str) -> Vec<usize> {
    let mut fence: Option<&str> = None;
    let mut found = Vec::new();
    for (index, line) in page.lines().enumerate() {
        let text = line.trim_start();
        let mark = ["```", "~~~"]
            .into_iter()
            .find(|mark| text.starts_with(mark));
        match (fence, mark) {
            (None, Some(mark)) => fence = Some(mark),
            (Some(open), Some(mark)) if open == mark => fence = None,
            (None, None) if !text.starts_with(['|', '#', '<']) && has_two_sentences(text) => {
                found.push(index + 1);
            }
            _ => {}
        }
    }
    found
}

fn has_two_sentences(line: &str) -> bool {
    let line = without_spans(line);
    let letters: Vec<char> = line.chars().collect();
    letters.windows(3).enumerate().any(|(at, window)| {
        let [stop, ' ', next] = window else {
            return false;
        };
        if !matches!(stop, '.' | '!' | '?') || !next.is_uppercase() {
            return false;
        }
        let before: String = letters[..at].iter().collect();
        if before.ends_with([')', '`', '$', '"', '”']) {
            return true;
        }
        let word = before
            .rsplit(|c: char| !c.is_alphabetic())
            .next()
            .unwrap_or("");
        word.chars().count() >= 3
            && word.chars().all(char::is_lowercase)
            && !ABBREVIATIONS.contains(&word)
    })
}

/// The line with the insides of code spans and formulas taken out.
fn without_spans(line: &str) -> String {
    let mut kept = String::new();
    let mut inside: Option<char> = None;
    for letter in line.chars() {
        match inside {
            None => {
                kept.push(letter);
                inside = matches!(letter, '`' | '$').then_some(letter);
            }
            Some(open) if open == letter => {
                kept.push(letter);
                inside = None;
            }
            Some(_) => {}
        }
    }
    kept
}

#[test]
fn a_line_holds_one_sentence() {
    let violations: Vec<String> = pages()
        .iter()
        .flat_map(|page| {
            lines_with_two_sentences(&read(page))
                .into_iter()
                .map(move |line| format!("{}:{line}", page.display()))
        })
        .collect();
    assert_none(
        &violations,
        "break the line after each sentence, so that a diff shows the sentence that changed",
    );
}

#[test]
fn two_sentences_on_a_line_are_found() {
    let two = "The curve ends there. Its tangent does not.";
    assert_eq!(lines_with_two_sentences(two), [1]);
    assert_eq!(
        lines_with_two_sentences("We have $a = b$. So it holds (as before). Next."),
        [1]
    );
    for one in [
        "The curve ends there, see Fig. 3 and P. Bézier's paper.",
        "It holds for t > 1, i.e. Outside, resp. Inside.",
        "| a cell. Another | one |",
        "```rust\nlet a = 1.; // One. And another. Done here. Yes.\n```",
        "The code `x. Y` stays.",
    ] {
        assert!(lines_with_two_sentences(one).is_empty(), "{one}");
    }
}

/// Whether a page holds a fence that `cargo test` should run.
fn has_rust(page: &str) -> bool {
    page.lines()
        .any(|line| line.trim_start().starts_with("```rust"))
}

#[test]
fn every_page_with_rust_is_among_the_doctests() {
    let included: Vec<String> = files_below("src", "rs")
        .iter()
        .flat_map(|file| {
            let text = read(file);
            let below = file.parent().unwrap_or(Path::new("")).to_path_buf();
            text.split("include_str!")
                .skip(1)
                .filter_map(|rest| rest.split('"').nth(1).map(str::to_owned))
                .map(|path| normalised(&below.join(path)))
                .collect::<Vec<_>>()
        })
        .collect();
    let violations: Vec<String> = files_below("book/src", "md")
        .iter()
        .filter(|page| has_rust(&read(page)))
        .map(|page| page.display().to_string())
        .filter(|page| !included.contains(page))
        .collect();
    assert_none(
        &violations,
        "add `#[doc = include_str!(\"…\")]` beside the other pages, or its blocks are never run",
    );
}

/// The path without `..`, with `/` between its parts.
fn normalised(path: &Path) -> String {
    let mut parts: Vec<String> = Vec::new();
    for part in path.components() {
        match part.as_os_str().to_string_lossy().as_ref() {
            ".." => {
                parts.pop();
            }
            "." => {}
            name => parts.push(name.to_owned()),
        }
    }
    parts.join("/")
}
