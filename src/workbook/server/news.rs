//! What the open pages hear: that the book changed, or that its sources have an error.

use std::time::Duration;

use axum::extract::{Query, State as Shared};
use axum::response::Json;
use serde::{Deserialize, Serialize};

use super::Site;

/// How long a browser's question for news stays open before it asks again.
///
/// Shorter than the 30 s after which common proxies and browsers begin to give up on a silent answer.
const LONGEST_WAIT: Duration = Duration::from_secs(20);

/// What the server knows about the book.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct State {
    /// Changes with every build that succeeded, also across restarts of the server.
    pub version: String,
    /// Changes with every build, whether it succeeded or not.
    pub news: String,
    /// Whether there is a book to serve at all.
    pub ready: bool,
    /// What is wrong with the sources as they are now; the book that is served is the last good one.
    pub error: Option<String>,
}

/// What the page has heard last; empty for a page that has just been opened.
#[derive(Deserialize)]
pub(super) struct Heard {
    #[serde(default)]
    news: String,
}

/// Answers when there are news that the page has not heard, or after [`LONGEST_WAIT`].
pub(super) async fn news(
    Shared(mut site): Shared<Site>,
    Query(heard): Query<Heard>,
) -> Json<State> {
    tokio::select! {
        _ = site.state.wait_for(|state| state.news != heard.news) => {}
        _ = site.stopped.changed() => {}
        () = tokio::time::sleep(LONGEST_WAIT) => {}
    }
    let state = site.state.borrow().clone();
    Json(state)
}
