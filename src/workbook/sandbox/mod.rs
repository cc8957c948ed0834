//! Running other people's programs.

use std::ffi::OsString;
use std::fmt;
use std::io::Read;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use thiserror::Error;

/// How much a program may use.
#[derive(Debug, Clone)]
pub struct Limits {
    /// How long it may run.
    pub time: Duration,
}

impl Limits {
    /// For a compiler.
    pub fn compiler() -> Self {
        Self {
            time: Duration::from_secs(30),
        }
    }

    /// For an answer.
    pub fn answer() -> Self {
        Self {
            time: Duration::from_secs(10),
        }
    }
}

/// How programs are kept apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Isolation {
    /// A process of its own.
    ProcessTree,
}

impl Isolation {
    /// The best that the system offers.
    pub fn best() -> Self {
        Self::ProcessTree
    }
}

/// A program to run.
#[derive(Debug, Clone)]
pub struct Job {
    /// The program.
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// Its environment; nothing else is inherited.
    pub environment: Vec<(OsString, OsString)>,
    /// The folder it may write; it begins there.
    pub scratch: PathBuf,
    /// What it may read besides.
    pub readable: Vec<PathBuf>,
    /// Whether it needs the tools of the system, as a compiler does.
    pub needs_system: bool,
    /// How much it may use.
    pub limits: Limits,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// By itself, with this status.
    Exited(i32),
    /// It took too long.
    TooLong,
    /// A signal ended it.
    Signalled,
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exited(status) => write!(f, "ended with status {status}"),
            Self::TooLong => f.write_str("took too long"),
            Self::Signalled => f.write_str("was ended by a signal"),
        }
    }
}

/// What a run gave.
#[derive(Debug, Clone)]
pub struct Run {
    /// How it ended.
    pub ending: Ending,
    /// What it printed.
    pub stdout: Vec<u8>,
    /// What it printed on standard error.
    pub stderr: Vec<u8>,
}

/// A program could not be run.
#[derive(Debug, Error)]
#[error("`{}` cannot be started: {reason}", program.display())]
pub struct SandboxError {
    program: PathBuf,
    reason: String,
}

/// Runs a job to its end.
///
/// # Errors
///
/// The program does not start.
pub fn run(job: &Job, _isolation: Isolation) -> Result<Run, SandboxError> {
    let failed = |e: std::io::Error| SandboxError {
        program: job.program.clone(),
        reason: e.to_string(),
    };
    let mut child = Command::new(&job.program)
        .args(&job.arguments)
        .env_clear()
        .envs(job.environment.iter().cloned())
        .current_dir(&job.scratch)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(failed)?;
    let read = |pipe: Option<Box<dyn Read + Send>>| {
        thread::spawn(move || {
            let mut bytes = Vec::new();
            if let Some(mut pipe) = pipe {
                let _ = pipe.read_to_end(&mut bytes);
            }
            bytes
        })
    };
    let stdout = read(child.stdout.take().map(|pipe| Box::new(pipe) as _));
    let stderr = read(child.stderr.take().map(|pipe| Box::new(pipe) as _));
    let start = Instant::now();
    let ending = loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status.code().map_or(Ending::Signalled, Ending::Exited);
        }
        if start.elapsed() > job.limits.time {
            let _ = child.kill();
            let _ = child.wait();
            break Ending::TooLong;
        }
        thread::sleep(Duration::from_millis(1));
    };
    Ok(Run {
        ending,
        stdout: stdout.join().unwrap_or_default(),
        stderr: stderr.join().unwrap_or_default(),
    })
}
