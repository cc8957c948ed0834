//! A figure is drawn with the reader's values, and a tableau is judged, as the wasm build does on a site without a
//! server.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};

use crate::{live, tableaux};

/// Answers a question of the page.
pub(super) async fn figure(question: String) -> Response {
    match tokio::task::spawn_blocking(move || answer(&question)).await {
        Ok(answer) => answer.into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

fn answer(question: &str) -> String {
    match question.starts_with("tableau ") {
        true => tableaux::answer(question),
        false => live::answer(question),
    }
}
