//! The book on a loopback address.
//!
//! The files are served as they were built; only the answer to the browser carries a small script more.
//! It asks for the [`State`] of the book and waits until that changes: then the page reloads itself,
//! or shows what is wrong with the last edit.

use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::{Query, State as Shared};
use axum::http::{Request, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{Html, IntoResponse, Json, Response};
use axum::routing::{get, post};
use serde::{Deserialize, Serialize};
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::sync::watch;
use tower_http::services::{ServeDir, ServeFile};

use crate::live;

/// How long a browser's question for news stays open before it asks again.
///
/// Shorter than the 30 s after which common proxies and browsers begin to give up on a silent answer.
const LONGEST_WAIT: Duration = Duration::from_secs(20);

const RELOAD_SCRIPT: &str = include_str!("reload.html");

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

/// The server could not be started or had to stop.
#[derive(Debug, Error)]
pub enum ServerError {
    /// Another program listens on the port.
    #[error(
        "port {port} is already in use, perhaps by another `cargo run`\n\
         next step: stop that program or choose another port, for example `cargo run -- --port {}`",
        other_port(*port)
    )]
    PortInUse {
        /// The port that was asked for.
        port: u16,
    },
    /// The port cannot be had for another reason, for example because it is reserved.
    #[error(
        "cannot listen on 127.0.0.1:{port}: {source}\nnext step: choose another port with `--port`"
    )]
    Port {
        /// The port that was asked for.
        port: u16,
        /// What the system said.
        source: std::io::Error,
    },
    /// The connection broke down as a whole.
    #[error("the server stopped: {0}")]
    Stopped(#[from] std::io::Error),
}

/// A free-looking port to propose; the highest port has no successor.
fn other_port(port: u16) -> u16 {
    port.checked_add(1).unwrap_or(3000)
}

/// Listens on `127.0.0.1:port`; port 0 stands for any free port.
///
/// # Errors
///
/// [`ServerError::PortInUse`] or [`ServerError::Port`].
pub async fn listen(port: u16) -> Result<TcpListener, ServerError> {
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
    TcpListener::bind(address)
        .await
        .map_err(|source| match source.kind() {
            std::io::ErrorKind::AddrInUse => ServerError::PortInUse { port },
            _ => ServerError::Port { port, source },
        })
}

/// Serves `folder` until Ctrl-C.
///
/// # Errors
///
/// [`ServerError::Stopped`] if the listening socket fails.
pub async fn serve(
    listener: TcpListener,
    folder: PathBuf,
    state: watch::Receiver<State>,
) -> Result<(), ServerError> {
    let (stop, stopped) = watch::channel(false);
    let site = Site { state, stopped };
    let missing = ServeFile::new(folder.join("404.html"));
    let files = ServeDir::new(folder).not_found_service(missing);
    let application = Router::new()
        .route("/__workbook/state", get(news))
        .route("/__workbook/figure", post(figure))
        .fallback_service(files)
        .layer(middleware::from_fn_with_state(site.clone(), dress))
        .with_state(site);
    axum::serve(listener, application)
        .with_graceful_shutdown(async move {
            // Without a handler for Ctrl-C the system's own behaviour, to end the process, remains.
            if tokio::signal::ctrl_c().await.is_err() {
                std::future::pending::<()>().await;
            }
            // Open questions for news would otherwise keep the server alive.
            let _ = stop.send(true);
        })
        .await?;
    Ok(())
}

#[derive(Clone)]
struct Site {
    state: watch::Receiver<State>,
    stopped: watch::Receiver<bool>,
}

/// What the page has heard last; empty for a page that has just been opened.
#[derive(Deserialize)]
struct Heard {
    #[serde(default)]
    news: String,
}

/// Answers when there are news that the page has not heard, or after [`LONGEST_WAIT`].
async fn news(Shared(mut site): Shared<Site>, Query(heard): Query<Heard>) -> Json<State> {
    tokio::select! {
        _ = site.state.wait_for(|state| state.news != heard.news) => {}
        _ = site.stopped.changed() => {}
        () = tokio::time::sleep(LONGEST_WAIT) => {}
    }
    let state = site.state.borrow().clone();
    Json(state)
}

/// Draws a figure with the reader's values, as the wasm build does on a site without a server.
async fn figure(question: String) -> Response {
    match tokio::task::spawn_blocking(move || live::answer(&question)).await {
        Ok(answer) => answer.into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

/// Adds the reload script to pages, and answers with an error page while there is no book yet.
async fn dress(Shared(site): Shared<Site>, request: Request<Body>, next: Next) -> Response {
    let asks_for_news = request.uri().path() == "/__workbook/state";
    let state = site.state.borrow().clone();
    if !state.ready && !asks_for_news {
        return waiting_page(&state);
    }
    let mut response = next.run(request).await;
    // A browser must ask again each time: the same address changes with every edit.
    response.headers_mut().insert(
        header::CACHE_CONTROL,
        header::HeaderValue::from_static("no-cache"),
    );
    let is_page = response
        .headers()
        .get(header::CONTENT_TYPE)
        .is_some_and(|kind| kind.as_bytes().starts_with(b"text/html"));
    if !is_page {
        return response;
    }
    let (mut head, body) = response.into_parts();
    // The pages are files of our own, so there is no reason to cap their size.
    let Ok(bytes) = to_bytes(body, usize::MAX).await else {
        return StatusCode::INTERNAL_SERVER_ERROR.into_response();
    };
    // These describe the file, not the page with the script. A browser that kept an older script by them would find
    // another version at each question and reload without end.
    for name in [
        header::CONTENT_LENGTH,
        header::ACCEPT_RANGES,
        header::ETAG,
        header::LAST_MODIFIED,
    ] {
        head.headers.remove(name);
    }
    let page = String::from_utf8_lossy(&bytes);
    Response::from_parts(head, Body::from(with_script(&page, &state.version)))
}

/// The page with the reload script before its end.
fn with_script(page: &str, version: &str) -> String {
    let script = RELOAD_SCRIPT.replace("{{version}}", version);
    // Before any other script asks whether a server answers.
    let page = page.replacen(
        "<head>",
        "<head><script>window.workbookServer = true;</script>",
        1,
    );
    match page.rfind("</body>") {
        Some(end) => format!("{}{script}{}", &page[..end], &page[end..]),
        None => format!("{page}{script}"),
    }
}

/// Stands in for every page until a build has succeeded.
fn waiting_page(state: &State) -> Response {
    let page = "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <meta name=\"color-scheme\" content=\"light dark\"><title>No book yet</title></head>\
         <body style=\"font-family: system-ui, sans-serif\"><h1>The book cannot be built yet</h1>\
         <p>This page turns into the book as soon as the error below is mended.</p></body></html>";
    let status = StatusCode::SERVICE_UNAVAILABLE;
    (status, Html(with_script(page, &state.version))).into_response()
}
