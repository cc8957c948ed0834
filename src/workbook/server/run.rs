//! A Rust block of a page is run.

use axum::extract::State as Shared;
use axum::http::StatusCode;
use axum::response::{IntoResponse, Json, Response};
use serde::Deserialize;
use thiserror::Error;

use super::{QueueError, Site};
use crate::workbook::checking::CheckingError;
use crate::workbook::checking::example::ExampleRun;

/// What the page asks.
#[derive(Debug, Deserialize)]
pub(super) struct Asked {
    /// The block as the reader has edited it, with its hidden lines.
    code: String,
}

/// Why there is nothing to show.
#[derive(Debug, Error)]
pub enum RunError {
    /// Its turn did not come.
    #[error(transparent)]
    Queue(#[from] QueueError),
    /// The compiler or the program could not be started.
    #[error(transparent)]
    Checking(#[from] CheckingError),
}

impl IntoResponse for RunError {
    fn into_response(self) -> Response {
        match self {
            Self::Queue(error) => error.into_response(),
            Self::Checking(error) => {
                (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response()
            }
        }
    }
}

/// Compiles and runs a block.
pub(super) async fn run(
    Shared(site): Shared<Site>,
    Json(asked): Json<Asked>,
) -> Result<Json<ExampleRun>, RunError> {
    let workbench = site.workbench.clone();
    let run = site
        .queue
        .run(move |stop| workbench.checker(stop)?.run_example(&asked.code))
        .await??;
    Ok(Json(run))
}
