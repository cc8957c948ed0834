//! What a page is told after it has done something.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use serde::Serialize;

use super::desks::Table;
use crate::book::exercise::Exercise;
use crate::workbook::checking::{CheckingError, Verdict};
use crate::workbook::practice::next::next;
use crate::workbook::practice::standing::Standing;
use crate::workbook::practice::{Desk, PracticeError};

/// What came of it; most parts are there only where they belong.
#[derive(Debug, Serialize)]
pub(super) struct Reply {
    /// How the reader stands now.
    pub(super) standing: Standing,
    /// Whether nothing was written, since the file holds what the reader has not seen; `standing` has it.
    pub(super) conflict: bool,
    /// Where a text is kept that had to make room.
    pub(super) backup: Option<String>,
    /// The verdict, as `check --json` prints it.
    pub(super) verdict: Option<Verdict>,
    /// The verdict in words, and the picture.
    pub(super) html: Option<String>,
    /// What the cells of the table are worth.
    pub(super) tableau: Option<String>,
    /// What comes of asking for the solution.
    pub(super) solution: Option<SolutionReply>,
    /// What to do next, when this is solved.
    pub(super) next: Option<Next>,
}

/// What comes of asking for the solution.
#[derive(Debug, Serialize)]
pub(super) struct SolutionReply {
    pub(super) hints_left: usize,
    /// None when it is asked for the first time.
    pub(super) source: Option<String>,
}

/// The exercise to do next.
#[derive(Debug, Serialize)]
pub(super) struct Next {
    title: String,
    minutes: u32,
    /// Its address, from the top of the site.
    address: Option<String>,
}

impl Reply {
    pub(super) fn new(table: &Table, exercise: &Exercise) -> Result<Self, PracticeError> {
        Ok(Self {
            standing: Standing::of(&table.desk, exercise)?,
            conflict: false,
            backup: None,
            verdict: None,
            html: None,
            tableau: None,
            solution: None,
            next: None,
        })
    }
}

impl Next {
    /// None when everything is solved.
    pub(super) fn of(table: &Table) -> Result<Option<Self>, PracticeError> {
        let desk: &Desk = &table.desk;
        let progress = desk.progress()?;
        Ok(next(desk, &progress).map(|exercise| Self {
            title: exercise.front.title.clone(),
            minutes: exercise.front.minutes,
            address: table.addresses.get(&exercise.name.to_string()).cloned(),
        }))
    }
}

/// How the reader stands with an exercise, or why that cannot be said.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Looked {
    Standing(Box<Standing>),
    /// One exercise that cannot be worked at keeps nobody from the others of its page.
    Problem {
        exercise: String,
        problem: String,
    },
}

impl Looked {
    pub(super) fn at(desk: &Desk, name: &str) -> Self {
        let standing = desk
            .exercise(name)
            .and_then(|exercise| Standing::of(desk, exercise));
        match standing {
            Ok(standing) => Self::Standing(Box::new(standing)),
            Err(error) => Self::Problem {
                exercise: name.to_owned(),
                problem: in_words(&error),
            },
        }
    }
}

/// Why nothing came of it.
#[derive(Debug)]
pub(super) enum Refused {
    /// It cannot be done.
    Practice(PracticeError),
    /// The workbook broke down over it.
    Broken,
}

impl From<PracticeError> for Refused {
    fn from(error: PracticeError) -> Self {
        Self::Practice(error)
    }
}

impl IntoResponse for Refused {
    fn into_response(self) -> Response {
        let (status, text) = match self {
            Self::Practice(error) => (status_of(&error), in_words(&error)),
            Self::Broken => (
                StatusCode::INTERNAL_SERVER_ERROR,
                "the workbook broke down over this request\n\
                 next step: look into the terminal in which it runs"
                    .to_owned(),
            ),
        };
        (status, text).into_response()
    }
}

/// The error, with the mistakes of an exercise, which the terminal tells with every command.
fn in_words(error: &PracticeError) -> String {
    let mut text = error.to_string();
    if let PracticeError::HasMistakes { mistakes, .. } = error {
        for mistake in mistakes {
            text.push_str(&format!("\n{mistake}"));
        }
    }
    text
}

fn status_of(error: &PracticeError) -> StatusCode {
    match error {
        PracticeError::UnknownExercise { .. } | PracticeError::LeftTheBook { .. } => {
            StatusCode::NOT_FOUND
        }
        PracticeError::NotBegun { .. }
        | PracticeError::NothingBegun
        | PracticeError::Unfit(_)
        | PracticeError::HasMistakes { .. }
        | PracticeError::Book(_) => StatusCode::UNPROCESSABLE_ENTITY,
        // Nobody waits for this answer any more.
        PracticeError::Checking(CheckingError::Stopped) => StatusCode::SERVICE_UNAVAILABLE,
        _ => StatusCode::INTERNAL_SERVER_ERROR,
    }
}
