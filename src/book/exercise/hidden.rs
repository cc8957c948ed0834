//! Hidden tests: more tests for an exercise, kept in a pack, that readers do not see.
//!
//! A folder `<chapter>/<name>/` of a pack that holds `tests.rs` and no `exercise.md` belongs to the exercise of that
//! name in the book or in another pack. Its tests are written as those of an exercise; `probes` is not needed.
//! `mutants/` may hold wrong answers that only they reject, by which `verify` sees what they are good for.

use std::path::{Path, PathBuf};

use super::collection::{entries, folders_of, mistake, variants};
use super::{ExerciseName, Exercises, Tested, TestsSource, Variant};
use crate::book::error::{BookError, BookErrors, Problem};

/// The hidden tests of one exercise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HiddenTests {
    /// The exercise.
    pub exercise: ExerciseName,
    /// The tests.
    pub tests: TestsSource,
    /// Wrong answers that pass the tests of the exercise, by name.
    pub mutants: Vec<Variant>,
}

impl HiddenTests {
    /// Reads the hidden tests of the packs.
    ///
    /// # Errors
    ///
    /// Everything that the schema does not allow, each with file, line and remedy: tests for no exercise or for an
    /// explanation, other files beside them, two folders for one exercise, and a name that a test of the exercise has.
    pub fn load(
        root: &Path,
        packs: &[PathBuf],
        exercises: &Exercises,
    ) -> Result<Vec<Self>, BookErrors> {
        let mut errors = Vec::new();
        let mut all: Vec<Self> = Vec::new();
        for pack in packs {
            // Names that are wrong were told when the exercises were read.
            for (name, folder) in folders_of(root, pack, &mut Vec::new()) {
                if !are_in(&root.join(&folder)) {
                    continue;
                }
                match read(root, &folder, &name, exercises, &all) {
                    Ok(hidden) => all.push(hidden),
                    Err(found) => errors.extend(found),
                }
            }
        }
        BookErrors::none_of(errors)?;
        Ok(all)
    }

    /// What a checker needs to run them: the exercise with these tests instead of its own, and no wrong answers.
    pub fn instead_of(&self, tested: &Tested) -> Tested {
        Tested {
            answer: tested.answer.clone(),
            tests: self.tests.clone(),
            mutants: Vec::new(),
            alternatives: Vec::new(),
        }
    }
}

/// Whether a folder of a pack holds hidden tests and no exercise.
pub(super) fn are_in(folder: &Path) -> bool {
    let has = |file: &str| folder.join(file).exists();
    has("tests.rs") && !has("exercise.md") && !has("answer.rs")
}

fn read(
    root: &Path,
    folder: &Path,
    name: &ExerciseName,
    exercises: &Exercises,
    others: &[HiddenTests],
) -> Result<HiddenTests, Vec<BookError>> {
    let file = folder.join("tests.rs");
    let Some(exercise) = exercises.get(name) else {
        let remedy = match exercises.similar(&name.to_string()) {
            Some(near) => format!("did you mean `{near}`? Then rename the folder"),
            None => "name the folder like an exercise, or write `exercise.md` as well".into(),
        };
        let found = format!("these hidden tests are for `{name}`, which is no exercise");
        return Err(vec![mistake(file, 1, found, remedy)]);
    };
    let Some(tested) = &exercise.tested else {
        let found = format!("`{name}` is an explanation");
        return Err(vec![mistake(file, 1, found, "no test can judge it")]);
    };
    let mut errors = Vec::new();
    for entry in entries(&root.join(folder)) {
        if !["tests.rs", "mutants"].contains(&entry.as_str()) {
            errors.push(mistake(
                folder.join(entry),
                1,
                "this does not belong here",
                "hidden tests are `tests.rs` and, if you like, `mutants/`; an exercise has `exercise.md` as well",
            ));
        }
    }
    if let Some(other) = others.iter().find(|other| other.exercise == *name) {
        let found = format!(
            "`{name}` already has hidden tests in {}",
            other.tests.file.display()
        );
        errors.push(mistake(&file, 1, found, "write them into one file"));
    }
    let text = std::fs::read_to_string(root.join(&file)).map_err(|e| {
        let reason = e.to_string();
        vec![BookError::new(&file, 1, Problem::Unreadable { reason })]
    })?;
    let tests = match TestsSource::parse(&file, &text) {
        Ok(tests) => tests,
        Err(found) => {
            errors.extend(found);
            return Err(errors);
        }
    };
    for test in &tests.tests {
        if tested.tests.tests.iter().any(|own| own.name == test.name) {
            let found = format!("the exercise has a test `{}` already", test.name);
            errors.push(mistake(&file, test.line, found, "rename the hidden one"));
        }
    }
    let mutants = variants(root, &folder.join("mutants"), true, &mut errors);
    if errors.is_empty() {
        Ok(HiddenTests {
            exercise: name.clone(),
            tests,
            mutants,
        })
    } else {
        Err(errors)
    }
}
