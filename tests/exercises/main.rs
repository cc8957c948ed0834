//! The exercises: their schema, and what checking an answer says.

mod compute;
mod grading;
mod hidden;
mod instances;
mod pack;
mod reader;
mod sabotage;
mod scaffold;
mod schema;
mod verified;

use std::path::{Path, PathBuf};

use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::{Exercise, Exercises, Tested};
use cagd::workbook::checking::check::Answer;
use cagd::workbook::checking::{Checker, Outcome};
use cagd::workbook::sandbox::Isolation;

/// The root of the package.
fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn exercises() -> Exercises {
    let catalogue = Catalogue::load(&root()).expect("the catalogue loads");
    Exercises::load(&root(), &[], &catalogue).unwrap_or_else(|errors| panic!("{errors}"))
}

fn checker() -> Checker {
    Checker::new(&root(), Isolation::best()).unwrap_or_else(|error| panic!("{error}"))
}

fn tested<'a>(exercises: &'a Exercises, name: &str) -> (&'a Exercise, &'a Tested) {
    let exercise = exercises
        .get(&name.parse().expect("a name"))
        .expect("the exercise is there");
    (exercise, exercise.tested.as_ref().expect("it has tests"))
}

fn answer(text: &str) -> Answer {
    Answer {
        shown_as: Path::new("answers/bezier/parabola-point.rs")
            .display()
            .to_string(),
        text: text.to_owned(),
    }
}

#[test]
fn a_solution_passes_and_a_starter_fails() {
    let exercises = exercises();
    let (exercise, tested) = tested(&exercises, "bezier/parabola-point");
    let checker = checker();
    let check = |text: &str| {
        let verdict = checker.check(exercise, tested, &answer(text), 1);
        verdict.unwrap_or_else(|error| panic!("{error}"))
    };
    let verdict = check(&tested.answer.solution);
    assert_eq!(verdict.outcome, Outcome::Passed, "{verdict:#?}");
    let verdict = check(&tested.answer.starter);
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict:#?}");
    let verdict = check(&tested.mutants[0].text);
    println!("{verdict:#?}");
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict:#?}");
    let misconception = verdict.misconception.expect("it is a mutant");
    assert_eq!(misconception.mutant, tested.mutants[0].name);
}
