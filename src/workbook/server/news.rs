//! What the open pages hear: that the book changed, or that its sources have an error.

use std::time::Duration;

use axum::extract::{Query, State as Shared};
use axum::http::HeaderMap;
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
    /// What it has heard of the reader's answers; none if it does not want to know.
    answers: Option<String>,
}

/// What a page hears.
#[derive(Serialize)]
pub(super) struct News {
    #[serde(flatten)]
    state: State,
    /// Changes with the reader's answers and his progress.
    answers: Option<String>,
}

/// Answers when there are news that the page has not heard, or after [`LONGEST_WAIT`].
pub(super) async fn news(
    Shared(mut site): Shared<Site>,
    Query(heard): Query<Heard>,
    headers: HeaderMap,
) -> Json<News> {
    // Who may not see the answers does not hear of them either.
    let answers = heard.answers.filter(|_| site.knows(&headers));
    let site_of_answers = site.clone();
    tokio::select! {
        _ = site.state.wait_for(|state| state.news != heard.news) => {}
        _ = site.stopped.changed() => {}
        () = change_of_answers(&site_of_answers, answers.as_deref()) => {}
        () = tokio::time::sleep(LONGEST_WAIT) => {}
    }
    let state = site.state.borrow().clone();
    let answers = answers.map(|_| stamp(&site));
    Json(News { state, answers })
}

/// Ready when the answers are others than the page has heard of; never if it does not want to know.
#[cfg(unix)]
async fn change_of_answers(site: &Site, heard: Option<&str>) {
    match heard {
        Some(heard) => site.desks.changed_since(heard).await,
        None => std::future::pending().await,
    }
}

#[cfg(not(unix))]
async fn change_of_answers(_site: &Site, _heard: Option<&str>) {
    std::future::pending().await
}

#[cfg(unix)]
fn stamp(site: &Site) -> String {
    site.desks.stamp()
}

#[cfg(not(unix))]
fn stamp(_site: &Site) -> String {
    String::new()
}
