//! Two programs run at once; the others wait, up to a limit.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use thiserror::Error;
use tokio::sync::{Semaphore, watch};

/// How many programs run at once: a reader has one page in front of him, and another tab may check an answer meanwhile.
pub const AT_ONCE: usize = 2;

/// How many more may wait: at half a second each, the last one of them waits four seconds.
pub const WAITING: usize = 16;

/// Why a request was not run.
#[derive(Debug, Error, Clone, Copy, PartialEq, Eq)]
pub enum QueueError {
    /// Too many wait already.
    #[error(
        "{AT_ONCE} programs run and {WAITING} more wait already\nnext step: try again in a moment"
    )]
    Full,
    /// The work broke down; that is a fault of the workbook.
    #[error(
        "the workbook broke down over this request\nnext step: look into the terminal in which it runs"
    )]
    Broken,
}

impl IntoResponse for QueueError {
    fn into_response(self) -> Response {
        let status = match self {
            Self::Full => StatusCode::SERVICE_UNAVAILABLE,
            Self::Broken => StatusCode::INTERNAL_SERVER_ERROR,
        };
        let mut response = (status, self.to_string()).into_response();
        if self == Self::Full {
            let soon = HeaderValue::from_static("1");
            response.headers_mut().insert(header::RETRY_AFTER, soon);
        }
        response
    }
}

/// Becomes true when nobody waits for the result any more.
pub type Stop = Arc<AtomicBool>;

/// Hands out the places in which programs run.
#[derive(Debug, Clone)]
pub struct Queue {
    running: Arc<Semaphore>,
    places: Arc<Semaphore>,
    closing: watch::Receiver<bool>,
}

impl Queue {
    /// A queue that ends what runs as soon as `closing` changes.
    #[must_use]
    pub fn new(closing: watch::Receiver<bool>) -> Self {
        Self {
            running: Arc::new(Semaphore::new(AT_ONCE)),
            places: Arc::new(Semaphore::new(AT_ONCE + WAITING)),
            closing,
        }
    }

    /// Does `work` when its turn comes, on a thread that may block.
    ///
    /// The work is told by [`Stop`] to end when the client hangs up, which drops this future, or when the server ends.
    /// Its place is free only after it has ended.
    ///
    /// # Errors
    ///
    /// [`QueueError`], which is an answer to the browser.
    pub async fn run<T, W>(&self, work: W) -> Result<T, QueueError>
    where
        T: Send + 'static,
        W: FnOnce(Stop) -> T + Send + 'static,
    {
        let place = Arc::clone(&self.places)
            .try_acquire_owned()
            .map_err(|_| QueueError::Full)?;
        let turn = Arc::clone(&self.running)
            .acquire_owned()
            .await
            .map_err(|_| QueueError::Broken)?;
        let stop = Stop::default();
        let _hang_up = StopWhenDropped(Arc::clone(&stop));
        let told = Arc::clone(&stop);
        let mut task = tokio::task::spawn_blocking(move || {
            let result = work(told);
            drop((turn, place));
            result
        });
        let mut closing = self.closing.clone();
        let result = tokio::select! {
            result = &mut task => result,
            _ = closing.changed() => {
                stop.store(true, Ordering::Relaxed);
                task.await
            }
        };
        result.map_err(|_| QueueError::Broken)
    }
}

/// Ends the work when the request is given up.
struct StopWhenDropped(Stop);

impl Drop for StopWhenDropped {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
