//! Other people's programs, run with limits and out of reach of everything else.
//!
//! An answer, a submission and even the compiler that reads one are programs that somebody else controls.
//! [`Sandbox::run`] starts such a [`Job`], keeps it within its [`Limits`] and leaves no process of it behind.
//!
//! | module | is |
//! |---|---|
//! | [`limits`] | how much a run may use, and why that much |
//! | [`isolation`] | what keeps a run apart from the rest of the machine, and how far that goes |
//! | [`error`] | why a run could not begin or be judged |
//! | [`supervisor`] | the process between the workbook and the program, a hidden command of the workbook |
//! | `bubblewrap` | which files a run under bubblewrap sees |
//! | `watch` | the run from outside: output, time, memory, processes, files |
//! | `processes` | a tree of processes, read from `/proc` |
//! | `scratch` | how much a scratch folder holds |
//!
//! ```text
//! workbook ── supervisor ── bwrap ── init ── program ── …      bubblewrap
//! workbook ── unshare ── supervisor ── program ── …            namespaces
//! workbook ── supervisor ── program ── …                       process tree, process group
//! ```
//!
//! The workbook reads the output, watches the limits and says when it is over.
//! The supervisor sets the limits that the system itself keeps, and ends every descendant before it ends.
//! They talk through a socket; when the workbook dies, the socket closes and the supervisor ends the run.

#[cfg(target_os = "linux")]
mod bubblewrap;
pub mod error;
pub mod isolation;
pub mod limits;
#[cfg(target_os = "linux")]
mod processes;
#[cfg(unix)]
mod scratch;
#[cfg(unix)]
pub mod supervisor;
#[cfg(unix)]
mod watch;

use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

pub use error::SandboxError;
pub use isolation::Isolation;
pub use limits::Limits;

/// A program to run, and all that it gets.
#[derive(Debug, Clone)]
pub struct Job {
    /// The program, by an absolute path; it is readable without being listed.
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// Its environment; nothing else is inherited.
    pub environment: Vec<(OsString, OsString)>,
    /// A folder that it may write; it becomes the current folder and has the same path inside.
    ///
    /// The caller may listen at a Unix socket in it.
    /// What lies there after the run is not to be trusted: a name may have become a link to somewhere else.
    pub scratch: PathBuf,
    /// Files and folders that it may read, by absolute paths.
    pub readable: Vec<PathBuf>,
    /// Whether it sees the tools and libraries of the system: true for the compiler, which calls a linker; false for
    /// a test program, which then sees the shared libraries of a Rust program and nothing that it could start.
    ///
    /// `/proc` is missing under bubblewrap.
    /// The compiler finds its own libraries all the same, but its wrapper around the linker `lld` does not: give it
    /// the linker by a link, `ld.lld` in a folder that is named with `-Clink-arg=-B`.
    pub needs_system: bool,
    /// How much it may use.
    pub limits: Limits,
}

/// How a run ended, and what the program printed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// How it ended.
    pub ending: Ending,
    /// What it printed on standard output, cut at the limit.
    pub stdout: Vec<u8>,
    /// What it printed on standard error, cut at the limit.
    pub stderr: Vec<u8>,
    /// How long it ran.
    pub duration: Duration,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// The program ended with this status.
    Exited(i32),
    /// A signal with this number ended the program.
    ///
    /// Under bubblewrap a status from 129 to 192 counts as a signal, as a shell reports it.
    Signalled(i32),
    /// It ran longer than allowed, or used more processor time.
    TooLong,
    /// Its processes held more memory than allowed, or an allocation beyond the limit failed.
    TooMuchMemory,
    /// It printed more than allowed.
    TooMuchOutput,
    /// It had more processes and threads than allowed.
    TooManyProcesses,
    /// It wrote a file, or altogether more files, than allowed, or hid them from the watch.
    TooMuchWritten,
    /// The caller asked to end it.
    Stopped,
    /// The program ended its own supervisor; only without namespaces it can.
    Lost,
}

/// What a program did, to be read after its name: “took too long”.
impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Ending::Exited(status) => write!(f, "ended with status {status}"),
            Ending::Signalled(signal) => write!(f, "was ended by signal {signal}"),
            Ending::TooLong => f.write_str("took too long"),
            Ending::TooMuchMemory => f.write_str("asked for too much memory"),
            Ending::TooMuchOutput => f.write_str("printed too much"),
            Ending::TooManyProcesses => f.write_str("started too many processes or threads"),
            Ending::TooMuchWritten => f.write_str("wrote too much into files"),
            Ending::Stopped => f.write_str("was stopped"),
            Ending::Lost => f.write_str("ended the process that watched it"),
        }
    }
}

/// Runs a job to its end; see [`Sandbox::run`], which can also be stopped.
///
/// # Errors
///
/// As [`Sandbox::run`], and [`SandboxError::NoSupervisor`].
pub fn run(job: &Job, isolation: Isolation) -> Result<Run, SandboxError> {
    Sandbox::of_the_workbook(isolation)?.run(job, &AtomicBool::new(false))
}

/// Where to run: the program of the supervisor and the isolation.
///
/// A value can be used from several threads at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sandbox {
    /// The workbook's own program: its hidden command `supervise` is the supervisor.
    supervisor: PathBuf,
    isolation: Isolation,
}

impl Sandbox {
    /// A sandbox with this isolation, whether the system offers it or not.
    ///
    /// `supervisor` is the program of the workbook.
    #[must_use]
    pub fn new(supervisor: PathBuf, isolation: Isolation) -> Self {
        Sandbox {
            supervisor,
            isolation,
        }
    }

    /// A sandbox with the supervisor of the workbook that runs, or is tested, now.
    ///
    /// # Errors
    ///
    /// [`SandboxError::NoSupervisor`] if this process is neither the workbook nor a test beside it.
    pub fn of_the_workbook(isolation: Isolation) -> Result<Self, SandboxError> {
        let own = std::env::current_exe().unwrap_or_default();
        let name = format!("workbook{}", std::env::consts::EXE_SUFFIX);
        if own.file_name() == Some(name.as_ref()) {
            return Ok(Sandbox::new(own, isolation));
        }
        // Cargo puts a test into `deps`, and the programs of the package above it.
        let beside = own
            .parent()
            .and_then(Path::parent)
            .map(|above| above.join(name));
        match beside {
            Some(program) if program.is_file() => Ok(Sandbox::new(program, isolation)),
            _ => Err(SandboxError::NoSupervisor { program: own }),
        }
    }

    /// The isolation of this sandbox.
    #[must_use]
    pub fn isolation(&self) -> Isolation {
        self.isolation
    }

    /// Runs something harmless.
    ///
    /// # Errors
    ///
    /// What keeps this sandbox from working on this machine.
    pub fn try_out(&self) -> Result<(), SandboxError> {
        let scratch = tempfile::tempdir().map_err(|source| SandboxError::Scratch {
            path: std::env::temp_dir(),
            source,
        })?;
        let job = Job {
            program: self.supervisor.clone(),
            arguments: vec!["--version".into()],
            environment: Vec::new(),
            scratch: scratch.path().to_path_buf(),
            readable: Vec::new(),
            needs_system: false,
            limits: Limits::answer(),
        };
        let run = self.run(&job, &AtomicBool::new(false))?;
        if run.ending == Ending::Exited(0) {
            Ok(())
        } else {
            Err(SandboxError::Refused {
                isolation: self.isolation,
                said: format!(
                    "{:?}: {}",
                    run.ending,
                    String::from_utf8_lossy(&run.stderr).trim()
                ),
            })
        }
    }

    /// Runs the program to its end, which comes at the latest with the first limit that it exceeds.
    ///
    /// When this returns, no process of the run is left.
    /// As soon as `stop` is true, the run is ended; it is looked at about fifty times a second.
    ///
    /// # Errors
    ///
    /// A [`SandboxError`] if the program could not be started or not be ended.
    /// Whatever the program does is no error but an [`Ending`].
    #[cfg(unix)]
    pub fn run(&self, job: &Job, stop: &AtomicBool) -> Result<Run, SandboxError> {
        watch::run(self, job, stop)
    }

    /// There is no sandbox for this system.
    ///
    /// # Errors
    ///
    /// [`SandboxError::Unsupported`], always.
    #[cfg(not(unix))]
    pub fn run(&self, _job: &Job, _stop: &AtomicBool) -> Result<Run, SandboxError> {
        Err(SandboxError::Unsupported)
    }
}
