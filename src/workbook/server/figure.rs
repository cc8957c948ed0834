//! A figure is drawn with the reader's values, as the wasm build does on a site without a server.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};

use crate::live;

/// Answers a question of the page.
pub(super) async fn figure(question: String) -> Response {
    match tokio::task::spawn_blocking(move || live::answer(&question)).await {
        Ok(answer) => answer.into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}
