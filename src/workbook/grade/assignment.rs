//! The exercises that are graded, with their hidden tests.

use crate::book::exercise::{Exercise, Exercises, HiddenTests, Tested};

use super::GradeError;
use super::session::SEED;
use super::submissions::Submissions;
use crate::workbook::checking::{Answer, Checker};

/// An exercise that is graded.
#[derive(Debug, Clone)]
pub struct Assignment<'a> {
    /// The exercise.
    pub exercise: &'a Exercise,
    /// Its own program and tests.
    pub tested: &'a Tested,
    /// The exercise with the hidden tests instead of its own, if there are any.
    pub hidden: Option<Tested>,
}

impl<'a> Assignment<'a> {
    /// The exercises that `is_chosen`, or without a choice those that somebody has answered, in the order of the book.
    pub fn all(
        exercises: &'a Exercises,
        hidden: &[HiddenTests],
        submissions: &Submissions,
        is_chosen: Option<&dyn Fn(&Exercise) -> bool>,
    ) -> Vec<Self> {
        let is_graded = |exercise: &Exercise| match is_chosen {
            Some(is_chosen) => is_chosen(exercise),
            None => submissions
                .students
                .iter()
                .any(|student| student.answers.contains_key(&exercise.name)),
        };
        exercises
            .iter()
            .filter(|exercise| is_graded(exercise))
            .filter_map(|exercise| {
                let tested = exercise.tested.as_ref()?;
                let hidden = hidden.iter().find(|h| h.exercise == exercise.name);
                Some(Self {
                    exercise,
                    tested,
                    hidden: hidden.map(|hidden| hidden.instead_of(tested)),
                })
            })
            .collect()
    }

    /// How many tests there are, hidden ones included.
    pub fn tests(&self) -> usize {
        let hidden = self.hidden.as_ref();
        self.tested.tests.tests.len() + hidden.map_or(0, |hidden| hidden.tests.tests.len())
    }

    /// The hidden tests accept the solution that the exercise brings.
    ///
    /// # Errors
    ///
    /// They do not, or the check cannot run.
    pub fn accepts_the_solution(&self, checker: &Checker) -> Result<(), GradeError> {
        let Some(with_hidden) = &self.hidden else {
            return Ok(());
        };
        let solution = Answer {
            shown_as: self.exercise.folder.join("answer.rs").display().to_string(),
            text: self.tested.answer.solution.clone(),
        };
        let verdict = checker.check(self.exercise, with_hidden, &solution, SEED)?;
        if verdict.passed() {
            return Ok(());
        }
        let found = match verdict.first_failure() {
            Some(test) => format!("`{}` fails; {}", test.test, test.message),
            None => {
                let said = verdict.diagnostics.iter().map(|d| d.rendered.as_str());
                format!("they do not compile with it\n{}", said.collect::<String>())
            }
        };
        Err(GradeError::Hidden {
            exercise: self.exercise.name.to_string(),
            file: with_hidden.tests.file.clone(),
            found,
        })
    }
}
