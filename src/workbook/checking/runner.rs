//! How the compiler and the programs are run: kept apart, and until nobody waits for them any more.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::CheckingError;
use crate::workbook::sandbox::{Ending, Isolation, Job, Limits, Run, Sandbox};

/// Runs jobs in the sandbox.
#[derive(Debug, Clone)]
pub struct Runner {
    isolation: Isolation,
    stop: Arc<AtomicBool>,
    patience: u32,
}

impl Runner {
    /// Keeps programs apart in this way, and lets them run to their end.
    #[must_use]
    pub fn new(isolation: Isolation) -> Self {
        Self {
            isolation,
            stop: Arc::default(),
            patience: 1,
        }
    }

    /// The same, but what runs is ended as soon as `stop` is true.
    #[must_use]
    pub fn until(mut self, stop: Arc<AtomicBool>) -> Self {
        self.stop = stop;
        self
    }

    /// The same, but the compiler may take this many times as long.
    #[must_use]
    pub fn patiently(mut self, times: u32) -> Self {
        self.patience = times;
        self
    }

    /// What a run of the compiler may use.
    pub(super) fn for_the_compiler(&self) -> Limits {
        let mut limits = Limits::compiler();
        limits.time *= self.patience;
        limits
    }

    /// How programs are kept apart.
    #[must_use]
    pub fn isolation(&self) -> Isolation {
        self.isolation
    }

    /// Runs a job.
    ///
    /// # Errors
    ///
    /// It does not start, or was stopped before its end.
    pub(super) fn run(&self, job: &Job) -> Result<Run, CheckingError> {
        let run = Sandbox::of_the_workbook(self.isolation)
            .and_then(|sandbox| sandbox.run(job, &self.stop))
            .map_err(|e| CheckingError::Unsupported(e.to_string()))?;
        // A verdict on half a run would blame the answer.
        match run.ending {
            Ending::Stopped => Err(CheckingError::Stopped),
            _ => Ok(run),
        }
    }
}
