//! The book on a loopback address, with what a reader does on its pages.
//!
//! | module | is |
//! |---|---|
//! | [`address`] | where the server listens |
//! | `pages` | the pages as built, with the scripts of the server |
//! | `policy` | what the browser may do with a page |
//! | `news` | pages reload when the book changes, or show the error |
//! | `figure` | a figure is drawn with the reader's values |
//! | [`token`], `entrance` | the link that lets a reader in, exchanged for a cookie |
//! | [`guard`] | who may ask for what |
//! | [`exercise`] | what a reader does with an exercise |
//! | [`queue`] | two programs run at once, the others wait |
//! | [`workbench`] | the library against which programs are compiled |
//! | [`run`] | a Rust block of a page is run |
//!
//! ```text
//! every request ─ host ─┬─ pages, news                     anybody on this machine, to read
//!                       ├─ origin ─ figure                 the pages of the book
//!                       └─ token ─ origin ─ queue ─ run    the reader
//! ```
//!
//! **A new route** that runs code, writes a file or shows an answer is one more line in `routes_of_the_reader`, which
//! the guard stands before. Its handler gets the [`Site`] as state, and sends whatever compiles or runs a program
//! through the queue:
//!
//! ```text
//! async fn check(State(site): State<Site>, answer: String) -> Result<Json<Verdict>, RunError> {
//!     let workbench = site.workbench.clone();
//!     let verdict = site.queue.run(move |stop| workbench.checker(stop)?.check(…)).await??;
//!     Ok(Json(verdict))
//! }
//! ```
//!
//! The closure runs on a thread that may block. `stop` becomes true when the browser hangs up; what the checker runs
//! then ends, and the check is an error that nobody hears, so nothing is recorded.
//! A page knows by `window.workbookServer.mayRun` whether it may ask; other scripts inside pages than those that the
//! server or mdBook write are refused by the browser.

pub mod address;
mod entrance;
#[cfg(unix)]
pub mod exercise;
mod figure;
pub mod guard;
mod news;
mod pages;
mod policy;
pub mod queue;
#[cfg(unix)]
pub mod run;
pub mod token;
#[cfg(unix)]
pub mod workbench;

use std::path::PathBuf;
use std::sync::Arc;

use axum::Router;
use axum::extract::Request;
use axum::http::HeaderMap;
use axum::middleware::{self, Next};
use axum::response::Response;
use axum::routing::{get, post};
use tokio::net::TcpListener;
use tokio::sync::watch;
use tower_http::services::{ServeDir, ServeFile};

pub use address::{ServerError, listen};
pub use news::State;
pub use queue::{Queue, QueueError};
#[cfg(unix)]
pub use run::RunError;
pub use token::Token;
#[cfg(unix)]
pub use workbench::Workbench;

/// What is served.
#[derive(Debug, Clone)]
pub struct Book {
    /// The root of the workbook.
    pub root: PathBuf,
    /// The folder of the built pages.
    pub folder: PathBuf,
    /// The folder of the reader's answers.
    pub answers: PathBuf,
    /// What pages are told about it.
    pub state: watch::Receiver<State>,
    /// What lets a reader in.
    pub token: Token,
}

/// What every handler knows.
#[derive(Debug, Clone)]
pub struct Site {
    /// The root of the workbook.
    pub root: Arc<PathBuf>,
    /// Where programs wait for their turn.
    pub queue: Queue,
    /// The exercises and the reader's answers.
    #[cfg(unix)]
    pub desks: exercise::Desks,
    /// What compiles and runs programs.
    #[cfg(unix)]
    pub workbench: Workbench,
    state: watch::Receiver<State>,
    stopped: watch::Receiver<bool>,
    token: Token,
    port: u16,
    /// The names of this server in an address.
    hosts: Arc<[String]>,
}

impl Site {
    fn new(book: &Book, port: u16, stopped: watch::Receiver<bool>) -> Self {
        let hosts = ["127.0.0.1", "localhost"].map(|name| match port {
            // Browsers leave the usual port out.
            80 => name.to_owned(),
            _ => format!("{name}:{port}"),
        });
        Self {
            root: Arc::new(book.root.clone()),
            queue: Queue::new(stopped.clone()),
            #[cfg(unix)]
            desks: exercise::Desks::new(&book.root, &book.answers, &book.folder),
            #[cfg(unix)]
            workbench: Workbench::new(&book.root),
            state: book.state.clone(),
            stopped,
            token: book.token.clone(),
            port,
            hosts: Arc::new(hosts),
        }
    }

    /// The build of the book that is served; it changes with the sources.
    #[cfg(unix)]
    fn build(&self) -> String {
        self.state.borrow().news.clone()
    }

    /// Whether a request brings the token.
    fn knows(&self, headers: &HeaderMap) -> bool {
        self.token.is_in(headers, self.port)
    }
}

/// Serves a book until `end` is ready.
///
/// # Errors
///
/// [`ServerError::Stopped`] if the listening socket fails.
pub async fn serve(
    listener: TcpListener,
    book: Book,
    end: impl Future<Output = ()> + Send + 'static,
) -> Result<(), ServerError> {
    let (stop, stopped) = watch::channel(false);
    let site = Site::new(&book, listener.local_addr()?.port(), stopped);
    let application = routes(&site, &book);
    axum::serve(listener, application)
        .with_graceful_shutdown(async move {
            end.await;
            // Open questions for news, and programs, would otherwise keep the server alive.
            let _ = stop.send(true);
        })
        .await?;
    Ok(())
}

/// Becomes ready with Ctrl-C.
pub async fn ctrl_c() {
    // Without a handler for Ctrl-C the system's own behaviour, to end the process, remains.
    if tokio::signal::ctrl_c().await.is_err() {
        std::future::pending::<()>().await;
    }
}

/// What runs code, writes files or shows answers.
#[cfg(unix)]
fn routes_of_the_reader() -> Router<Site> {
    Router::new()
        .route("/__workbook/run", post(run::run))
        .merge(exercise::routes())
}

/// Programs are run on Unix alone; the page shows this answer.
#[cfg(not(unix))]
fn routes_of_the_reader() -> Router<Site> {
    let error = crate::workbook::sandbox::SandboxError::Unsupported.to_string();
    let answer = move || async move { (axum::http::StatusCode::NOT_IMPLEMENTED, error) };
    Router::new().route("/__workbook/run", post(answer))
}

fn routes(site: &Site, book: &Book) -> Router {
    let missing = ServeFile::new(book.folder.join("404.html"));
    let files = ServeDir::new(&book.folder).not_found_service(missing);
    let figure = Router::new().route("/__workbook/figure", post(figure::figure));
    let with_site = |state: &Site| state.clone();
    Router::new()
        .route("/__workbook/state", get(news::news))
        .merge(guard::for_our_pages(figure, site))
        .merge(guard::for_the_reader(routes_of_the_reader(), site))
        .fallback_service(files)
        // The last one is asked first.
        .layer(middleware::from_fn_with_state(
            with_site(site),
            pages::dress,
        ))
        .layer(middleware::from_fn_with_state(
            with_site(site),
            entrance::enter,
        ))
        .layer(middleware::from_fn_with_state(
            with_site(site),
            guard::ask_for_host,
        ))
        .layer(middleware::from_fn(harden))
        .with_state(site.clone())
}

/// Every answer says how a browser has to treat it.
async fn harden(request: Request, next: Next) -> Response {
    let mut response = next.run(request).await;
    policy::set_for_all(response.headers_mut());
    response
}
