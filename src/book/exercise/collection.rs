//! All exercises, found in their folders and checked against the schema.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::document::{self, Document};
use super::front_matter::FrontMatter;
use super::hidden;
use super::marked::MarkedSource;
use super::tests_source::TestsSource;
use super::{Exercise, ExerciseKind, ExerciseName, Tested, Variant};
use crate::book::catalogue::{CHAPTERS, Catalogue};
use crate::book::error::{BookError, BookErrors, Problem, most_similar};
use crate::tableaux;

/// Where the exercises of the book stand, relative to the root of the package.
pub const FOLDER: &str = "book/exercises";

/// How many hints and wrong answers an exercise has at least.
const AT_LEAST: usize = 3;

/// All exercises of the book and of the packs that were named, in the order of the list.
#[derive(Debug, Clone, Default)]
pub struct Exercises {
    exercises: Vec<Exercise>,
}

impl Exercises {
    /// Reads the exercises below `root/book/exercises` and below each pack.
    ///
    /// # Errors
    ///
    /// Everything that the schema does not allow, each with file, line and remedy.
    pub fn load(root: &Path, packs: &[PathBuf], catalogue: &Catalogue) -> Result<Self, BookErrors> {
        let found = Found::read(root, packs, catalogue);
        BookErrors::none_of(found.errors)?;
        Ok(Self {
            exercises: found.exercises,
        })
    }

    /// As [`load`](Self::load), but an exercise with mistakes is left out, so that the others can be worked on.
    pub fn load_sound(root: &Path, packs: &[PathBuf], catalogue: &Catalogue) -> (Self, Mistakes) {
        let Found {
            mut exercises,
            errors,
            folders,
        } = Found::read(root, packs, catalogue);
        let Err(errors) = BookErrors::none_of(errors) else {
            return (Self { exercises }, Mistakes::default());
        };
        let is_in = |error: &BookError, folder: &Path| error.place.file.starts_with(folder);
        exercises.retain(|exercise| !errors.iter().any(|error| is_in(error, &exercise.folder)));
        let with_mistakes = folders.into_iter().filter_map(|(name, folder)| {
            let errors = errors.iter().filter(|error| is_in(error, &folder));
            let errors: Vec<BookError> = errors.cloned().collect();
            (!errors.is_empty()).then_some((name, errors))
        });
        let mistakes = Mistakes {
            exercises: with_mistakes.collect(),
            all: Some(errors),
        };
        (Self { exercises }, mistakes)
    }

    /// The exercises, chapter by chapter, each chapter in its order.
    pub fn iter(&self) -> impl Iterator<Item = &Exercise> {
        self.exercises.iter()
    }

    /// The exercise of this name.
    pub fn get(&self, name: &ExerciseName) -> Option<&Exercise> {
        self.exercises
            .iter()
            .find(|exercise| exercise.name == *name)
    }

    /// The name most similar to `text`, to suggest it.
    pub fn similar(&self, text: &str) -> Option<String> {
        let names: Vec<String> = self
            .iter()
            .map(|exercise| exercise.name.to_string())
            .collect();
        most_similar(text, names.iter().map(String::as_str))
    }
}

/// What the schema does not allow, in a book of which the rest is used.
#[derive(Debug, Clone, Default)]
pub struct Mistakes {
    /// The exercises with mistakes, which were left out.
    pub exercises: Vec<(ExerciseName, Vec<BookError>)>,
    /// All mistakes, also those that belong to no exercise.
    pub all: Option<BookErrors>,
}

/// What was found in the folders.
struct Found {
    /// The exercises that can be read, in the order of the list.
    exercises: Vec<Exercise>,
    /// What is wrong with them and with the others.
    errors: Vec<BookError>,
    /// The folders of all.
    folders: Vec<(ExerciseName, PathBuf)>,
}

impl Found {
    fn read(root: &Path, packs: &[PathBuf], catalogue: &Catalogue) -> Self {
        let mut errors = Vec::new();
        let mut exercises = Vec::new();
        let mut all = Vec::new();
        let folders = std::iter::once(PathBuf::from(FOLDER)).chain(packs.iter().cloned());
        for folder in folders {
            let is_pack = folder != Path::new(FOLDER);
            for (name, folder) in folders_of(root, &folder, &mut errors) {
                if is_pack && hidden::are_in(&root.join(&folder)) {
                    continue;
                }
                all.push((name.clone(), folder.clone()));
                match read(root, &folder, &name) {
                    Ok(exercise) => {
                        check(&exercise, catalogue, &mut errors);
                        exercises.push(exercise);
                    }
                    Err(found) => errors.extend(found),
                }
            }
        }
        let chapter_of = |name: &ExerciseName| {
            let place = CHAPTERS.iter().position(|&c| c == name.chapter());
            place.unwrap_or(CHAPTERS.len())
        };
        exercises.sort_by_key(|exercise: &Exercise| {
            (
                chapter_of(&exercise.name),
                exercise.front.order,
                exercise.name.clone(),
            )
        });
        check_names(&exercises, &all, &mut errors);
        Self {
            exercises,
            errors,
            folders: all,
        }
    }
}

pub(super) fn mistake(
    file: impl AsRef<Path>,
    line: usize,
    found: impl Into<String>,
    remedy: impl Into<String>,
) -> BookError {
    let (found, remedy) = (found.into(), remedy.into());
    BookError::new(file, line, Problem::Exercise { found, remedy })
}

/// The folders `<chapter>/<name>` below `folder`, sorted.
pub(super) fn folders_of(
    root: &Path,
    folder: &Path,
    errors: &mut Vec<BookError>,
) -> Vec<(ExerciseName, PathBuf)> {
    let mut found = Vec::new();
    for chapter in entries(&root.join(folder)) {
        for name in entries(&root.join(folder).join(&chapter)) {
            let path = folder.join(&chapter).join(&name);
            if !root.join(&path).is_dir() {
                continue;
            }
            match format!("{chapter}/{name}").parse::<ExerciseName>() {
                Ok(parsed) if CHAPTERS.contains(&chapter.as_str()) => found.push((parsed, path)),
                Ok(_) => errors.push(mistake(
                    path.join("exercise.md"),
                    1,
                    format!("`{chapter}` is no chapter"),
                    format!("the chapters are {}", CHAPTERS.join(", ")),
                )),
                Err(e) => errors.push(mistake(
                    path.join("exercise.md"),
                    1,
                    e.to_string(),
                    "rename the folder",
                )),
            }
        }
    }
    found
}

/// The names of what a folder holds, sorted; nothing if it is not there.
pub(super) fn entries(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .filter_map(|entry| entry.file_name().into_string().ok())
        .filter(|name| !name.starts_with('.'))
        .collect();
    names.sort();
    names
}

/// Reads the files of one exercise.
fn read(root: &Path, folder: &Path, name: &ExerciseName) -> Result<Exercise, Vec<BookError>> {
    let text = |file: &str| {
        let path = folder.join(file);
        std::fs::read_to_string(root.join(&path)).map_err(|e| {
            let reason = e.to_string();
            vec![BookError::new(path, 1, Problem::Unreadable { reason })]
        })
    };
    let task = folder.join("exercise.md");
    let (front, document) = document::parse(&task, &text("exercise.md")?)?;
    let mut errors = Vec::new();
    let known = [
        "exercise.md",
        "answer.rs",
        "tests.rs",
        "mutants",
        "alternatives",
    ];
    for entry in entries(&root.join(folder)) {
        let is_known = known.contains(&entry.as_str());
        if !is_known || (!front.kind.is_tested() && entry != "exercise.md") {
            let remedy = if front.kind.is_tested() {
                "the files of an exercise are `exercise.md`, `answer.rs`, `tests.rs`, `mutants/` and `alternatives/`"
            } else {
                "an explanation has `exercise.md` alone"
            };
            errors.push(mistake(
                folder.join(&entry),
                1,
                "this does not belong here",
                remedy,
            ));
        }
    }
    let tested = if front.kind.is_tested() {
        let answer = text("answer.rs").and_then(|text| {
            MarkedSource::parse(&folder.join("answer.rs"), &text).map_err(|e| vec![e])
        });
        let tests =
            text("tests.rs").and_then(|text| TestsSource::parse(&folder.join("tests.rs"), &text));
        let mutants = variants(root, &folder.join("mutants"), true, &mut errors);
        let alternatives = variants(root, &folder.join("alternatives"), false, &mut errors);
        match (answer, tests) {
            (Ok(answer), Ok(tests)) => Some(Tested {
                answer,
                tests,
                mutants,
                alternatives,
            }),
            (answer, tests) => {
                errors.extend(answer.err().into_iter().chain(tests.err()).flatten());
                None
            }
        }
    } else {
        None
    };
    if !errors.is_empty() {
        return Err(errors);
    }
    Ok(Exercise {
        name: name.clone(),
        folder: folder.to_path_buf(),
        front,
        document,
        tested,
    })
}

/// The `.rs` files of a folder.
pub(super) fn variants(
    root: &Path,
    folder: &Path,
    are_wrong: bool,
    errors: &mut Vec<BookError>,
) -> Vec<Variant> {
    let mut found = Vec::new();
    for entry in entries(&root.join(folder)) {
        let file = folder.join(&entry);
        let Some(name) = entry.strip_suffix(".rs") else {
            errors.push(mistake(
                &file,
                1,
                "this is no Rust source",
                "name it `….rs` or take it out",
            ));
            continue;
        };
        let text = match std::fs::read_to_string(root.join(&file)) {
            Ok(text) => text,
            Err(e) => {
                let reason = e.to_string();
                errors.push(BookError::new(&file, 1, Problem::Unreadable { reason }));
                continue;
            }
        };
        let misconception = misconception(&text);
        if are_wrong && misconception.is_empty() {
            errors.push(mistake(
                &file,
                1,
                "the wrong answer does not say what it stands for",
                "open it with `//! misconception: …`, what the one who writes this thinks",
            ));
        }
        found.push(Variant {
            name: name.to_owned(),
            file,
            text,
            misconception,
        });
    }
    found
}

/// The words behind `//! misconception:`, with the lines `//!` that go on.
fn misconception(text: &str) -> String {
    let mut lines = text
        .lines()
        .map_while(|line| line.strip_prefix("//!"))
        .map(str::trim);
    let Some(first) = lines
        .next()
        .and_then(|line| line.strip_prefix("misconception:"))
    else {
        return String::new();
    };
    let words: Vec<&str> = std::iter::once(first.trim()).chain(lines).collect();
    words.join(" ").trim().to_owned()
}

/// What one exercise must fulfil besides being readable.
fn check(exercise: &Exercise, catalogue: &Catalogue, errors: &mut Vec<BookError>) {
    let file = exercise.file();
    let FrontMatter {
        title,
        kind,
        statements,
        difficulty,
        minutes,
        tableau,
        ..
    } = &exercise.front;
    let mut front = |found: String, remedy: &str| errors.push(mistake(&file, 1, found, remedy));
    if title.trim().is_empty() {
        front(
            "the title is empty".into(),
            "say in a few words what the exercise is about",
        );
    }
    if !(1..=5).contains(difficulty) {
        front(
            format!("the difficulty is {difficulty}"),
            "choose 1 (first steps) to 5 (exam)",
        );
    }
    if *minutes == 0 {
        front("it takes 0 minutes".into(), "say how long a reader needs");
    }
    if statements.is_empty() {
        front(
            "it trains no statement".into(),
            "name at least one by its id in `statements`",
        );
    }
    for id in statements {
        if let Err(problem) = catalogue.require(id) {
            errors.push(BookError::new(&file, 1, problem));
        }
    }
    if tableau.is_some() != (*kind == ExerciseKind::Compute) {
        let found =
            "`tableau` belongs to exercises of the kind `compute`, and each of those has one";
        errors.push(mistake(
            &file,
            1,
            found,
            "name the tableau, or change the kind",
        ));
    }
    check_document(exercise.front.kind, &exercise.document, &file, errors);
    check_tableau(exercise, &file, errors);
    let Some(tested) = &exercise.tested else {
        return;
    };
    if tested.mutants.len() < AT_LEAST {
        let found = format!("there are {} wrong answers", tested.mutants.len());
        let remedy = format!(
            "write at least {AT_LEAST}, each a typical misconception, in `mutants/<name>.rs`"
        );
        errors.push(mistake(exercise.folder.join("mutants"), 1, found, remedy));
    }
    if !tested.tests.has_probes {
        let found = "there is no function `probes`";
        let remedy = "write `fn probes() -> Vec<String> { cagd::probes![answer::…, …] }`, by which a misconception is recognised";
        errors.push(mistake(exercise.folder.join("tests.rs"), 1, found, remedy));
    }
}

/// The tableau of a *compute* exercise is one that is dealt, and the folder shows its round 0.
fn check_tableau(exercise: &Exercise, file: &Path, errors: &mut Vec<BookError>) {
    let (Some(name), Some(tested)) = (&exercise.front.tableau, &exercise.tested) else {
        return;
    };
    let chapter = exercise.name.chapter();
    let Some(dealer) = tableaux::find(chapter, name) else {
        let known = tableaux::all();
        let known = known.iter().filter(|(of, _)| *of == chapter);
        let known: Vec<&str> = known.map(|(_, dealer)| dealer.name).collect();
        let remedy = match most_similar(name, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("add it to `all` in `src/{chapter}/tableaux.rs`"),
        };
        let found = format!("the chapter deals no tableau `{name}`");
        errors.push(mistake(file, 1, found, remedy));
        return;
    };
    let deal = (dealer.deal)(0);
    for (part, text, expected) in [
        ("starter", &tested.answer.starter, deal.answer_file()),
        ("solution", &tested.answer.solution, deal.solved_file()),
    ] {
        if *text != expected {
            let found = format!("the {part} is not what `{name}` deals in round 0");
            let remedy = format!("it must read\n{expected}");
            errors.push(mistake(exercise.folder.join("answer.rs"), 1, found, remedy));
        }
    }
}

fn check_document(
    kind: ExerciseKind,
    document: &Document,
    file: &Path,
    errors: &mut Vec<BookError>,
) {
    let mut at =
        |line: usize, found: String, remedy: &str| errors.push(mistake(file, line, found, remedy));
    if document.task.text.is_empty() {
        at(
            document.task.line,
            "the task is empty".into(),
            "say below the front matter what to do",
        );
    }
    if document.hints.len() < AT_LEAST {
        let remedy = "write at least three sections `## Hint`, from a nudge to all but the code";
        at(
            1,
            format!("there are {} hints", document.hints.len()),
            remedy,
        );
    }
    for (index, hint) in document.hints.iter().enumerate() {
        let number = index + 1;
        if hint.text.is_empty() {
            at(
                hint.line,
                format!("hint {number} is empty"),
                "write it or take it out",
            );
        } else if document.hints[..index]
            .iter()
            .any(|other| other.text == hint.text)
        {
            at(
                hint.line,
                format!("hint {number} repeats another"),
                "say more than the hints before it",
            );
        }
    }
    if let Some(last) = document.hints.last()
        && kind.is_tested()
        && !["`", "$"].iter().any(|sign| last.text.contains(sign))
    {
        let found = "the last hint has no formula and no code";
        at(
            last.line,
            found.into(),
            "say in it all that leaves only writing the code",
        );
    }
    let is_explain = !kind.is_tested();
    for (section, name) in [
        (&document.model_answer, "Model answer"),
        (&document.checklist, "Checklist"),
    ] {
        match section {
            None if is_explain => at(
                1,
                format!("there is no `## {name}`"),
                "an explanation needs one",
            ),
            Some(section) if !is_explain => at(
                section.line,
                format!("`## {name}` belongs to explanations only"),
                "take it out; the solution stands in `answer.rs`",
            ),
            Some(section) if section.text.is_empty() => {
                at(section.line, format!("`## {name}` is empty"), "write it");
            }
            _ => {}
        }
    }
}

/// Names are unique, and prerequisites are there and do not go round in circles.
fn check_names(
    exercises: &[Exercise],
    folders: &[(ExerciseName, PathBuf)],
    errors: &mut Vec<BookError>,
) {
    let mut by_name: BTreeMap<&ExerciseName, &Exercise> = BTreeMap::new();
    for exercise in exercises {
        if let Some(first) = by_name.insert(&exercise.name, exercise) {
            let found = format!(
                "`{}` is already in {}",
                exercise.name,
                first.folder.display()
            );
            errors.push(mistake(
                exercise.file(),
                1,
                found,
                "rename one of the two folders",
            ));
        }
    }
    for exercise in exercises {
        for needed in &exercise.front.prerequisites {
            // One that cannot be read is there all the same.
            if !folders.iter().any(|(name, _)| name == needed) {
                let found = format!("there is no exercise `{needed}`");
                errors.push(mistake(
                    exercise.file(),
                    1,
                    found,
                    "correct the name in `prerequisites`",
                ));
            }
        }
        let mut reached: Vec<&ExerciseName> = exercise.front.prerequisites.iter().collect();
        let mut next = 0;
        while next < reached.len() {
            let needs = by_name
                .get(reached[next])
                .map_or(&[][..], |e| &e.front.prerequisites);
            for need in needs {
                if !reached.contains(&need) {
                    reached.push(need);
                }
            }
            next += 1;
        }
        if reached.contains(&&exercise.name) {
            let found = "its prerequisites lead back to itself";
            errors.push(mistake(exercise.file(), 1, found, "take one of them out"));
        }
    }
}
