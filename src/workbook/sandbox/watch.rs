//! The run from outside: output, time, memory, processes, files.

use std::ffi::OsString;
use std::fs;
use std::io::{self, Read};
use std::net::Shutdown;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use nix::errno::Errno;
use nix::poll::{PollFd, PollFlags, PollTimeout, poll};
use nix::sys::signal::Signal;

use super::supervisor::{Order, Report};
use super::{Ending, Isolation, Job, Limits, Run, Sandbox, SandboxError, scratch};

/// How often processes and memory are looked at: a program can fill some 100 MiB meanwhile.
const TICK: Duration = Duration::from_millis(20);

/// The scratch folder is looked at once in so many ticks: each look reads all its files.
const SCRATCH_TICKS: u32 = 5;

/// How long a supervisor may take to end everything; usually it takes some milliseconds.
const GRACE: Duration = Duration::from_secs(2);

/// Runs a job; see [`Sandbox::run`].
pub(super) fn run(sandbox: &Sandbox, job: &Job, stop: &AtomicBool) -> Result<Run, SandboxError> {
    check(job)?;
    let begin = Instant::now();
    let mut session = Session::start(sandbox, job)?;
    let forced = session.follow(job, stop, begin)?;
    if forced.is_some() {
        session.strike(&job.limits);
    }
    let report = session.finish()?;
    let duration = begin.elapsed();
    let (stdout, stderr) = (session.stdout.kept.clone(), session.stderr.kept.clone());
    let ending = match (forced, report) {
        (Some(ending), _) => ending,
        (None, None) => Ending::Lost,
        (None, Some(Report::NotStarted(reason))) => {
            let printed = String::from_utf8_lossy(&stderr);
            return Err(SandboxError::Refused {
                isolation: sandbox.isolation,
                said: format!("{reason} {}", printed.trim()).trim().to_owned(),
            });
        }
        _ if session.has_printed_too_much() => Ending::TooMuchOutput,
        _ if scratch::holds_more_than(&job.scratch, job.limits.scratch) => Ending::TooMuchWritten,
        (None, Some(Report::Exited(status))) => Ending::Exited(status),
        (None, Some(Report::Signalled(signal))) => ending_by(signal, &stderr),
    };
    Ok(Run {
        ending,
        stdout,
        stderr,
        duration,
    })
}

/// What a signal means that the system sends when one of its limits is reached.
fn ending_by(signal: i32, stderr: &[u8]) -> Ending {
    let is = |other: Signal| signal == other as i32;
    if is(Signal::SIGXCPU) {
        Ending::TooLong
    } else if is(Signal::SIGXFSZ) {
        Ending::TooMuchWritten
    } else if is(Signal::SIGABRT) && says_that_memory_ran_out(stderr) {
        Ending::TooMuchMemory
    } else {
        Ending::Signalled(signal)
    }
}

/// Rust's standard library prints this before it aborts. A program that only pretends gains nothing.
fn says_that_memory_ran_out(stderr: &[u8]) -> bool {
    String::from_utf8_lossy(stderr)
        .lines()
        .any(|line| line.starts_with("memory allocation of ") && line.ends_with(" bytes failed"))
}

fn check(job: &Job) -> Result<(), SandboxError> {
    if job.limits.memory < Limits::LEAST_MEMORY {
        return Err(SandboxError::TooLittleMemory {
            asked: job.limits.memory,
            least: Limits::LEAST_MEMORY,
        });
    }
    if !job.program.is_absolute() || !job.program.is_file() {
        return Err(SandboxError::NoProgram {
            program: job.program.clone(),
        });
    }
    for path in &job.readable {
        must_be_absolute(path)
            .and_then(|()| fs::metadata(path))
            .map_err(|source| SandboxError::Unreadable {
                path: path.clone(),
                source,
            })?;
    }
    // Whether it can be written is found out by writing.
    must_be_absolute(&job.scratch)
        .and_then(|()| tempfile::tempfile_in(&job.scratch))
        .map_err(|source| SandboxError::Scratch {
            path: job.scratch.clone(),
            source,
        })?;
    #[cfg(target_os = "linux")]
    super::processes::check().map_err(SandboxError::Unwatchable)?;
    Ok(())
}

fn must_be_absolute(path: &Path) -> io::Result<()> {
    if path.is_absolute() {
        Ok(())
    } else {
        Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            "the path is not absolute",
        ))
    }
}

/// The program and arguments of the first process, from the outermost wrapper to the program.
fn command_line(sandbox: &Sandbox, job: &Job) -> Result<Vec<OsString>, SandboxError> {
    let supervised = |bubblewrap: bool, command: Vec<OsString>| {
        let order = Order::new(&job.limits, bubblewrap, command);
        let mut line = vec![sandbox.supervisor.clone().into_os_string()];
        line.extend(order.arguments());
        line
    };
    let plain = || {
        let mut line = vec![job.program.clone().into_os_string()];
        line.extend(job.arguments.iter().cloned());
        line
    };
    Ok(match sandbox.isolation {
        #[cfg(target_os = "linux")]
        Isolation::Bubblewrap => {
            let mut line = vec![tool(Isolation::Bubblewrap, "bwrap", "bubblewrap")?.into()];
            line.extend(super::bubblewrap::arguments(job));
            supervised(true, line)
        }
        #[cfg(target_os = "linux")]
        Isolation::Namespaces => {
            let mut line = vec![tool(Isolation::Namespaces, "unshare", "util-linux")?.into()];
            let options = "--user --map-root-user --pid --net --ipc --fork --kill-child --";
            line.extend(options.split(' ').map(OsString::from));
            line.extend(supervised(false, plain()));
            line
        }
        #[cfg(not(target_os = "linux"))]
        Isolation::Bubblewrap | Isolation::Namespaces => return Err(SandboxError::Unsupported),
        Isolation::ProcessTree | Isolation::ProcessGroup => supervised(false, plain()),
    })
}

/// Looks for a tool on the PATH of the workbook, since the one of the job is another.
#[cfg(target_os = "linux")]
fn tool(
    isolation: Isolation,
    tool: &'static str,
    package: &'static str,
) -> Result<PathBuf, SandboxError> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path)
        .map(|folder| folder.join(tool))
        .find(|file| file.is_file())
        .ok_or(SandboxError::NoTool {
            isolation,
            tool,
            package,
        })
}

/// How many processes besides the program an isolation adds, each with one thread; a supervisor has two.
#[cfg(target_os = "linux")]
fn own_threads(isolation: Isolation) -> usize {
    match isolation {
        // The supervisor, `bwrap` outside and `bwrap` as the first process of the namespace.
        Isolation::Bubblewrap => 4,
        // `unshare` and the supervisor.
        Isolation::Namespaces => 3,
        Isolation::ProcessTree | Isolation::ProcessGroup => 2,
    }
}

/// One stream of the program's output.
struct Stream<R> {
    source: Option<R>,
    kept: Vec<u8>,
}

impl<R: Read> Stream<R> {
    /// Reads once, keeps at most `room` bytes, and says how many there were.
    fn read(&mut self, room: usize) -> io::Result<usize> {
        let mut buffer = [0; 16 * 1024];
        let Some(source) = &mut self.source else {
            return Ok(0);
        };
        match source.read(&mut buffer) {
            Ok(0) => {
                self.source = None;
                Ok(0)
            }
            Ok(count) => {
                self.kept.extend_from_slice(&buffer[..count.min(room)]);
                Ok(count)
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(0),
            Err(error) => Err(error),
        }
    }
}

/// A run that has begun.
struct Session {
    child: Child,
    isolation: Isolation,
    control: Stream<UnixStream>,
    stdout: Stream<ChildStdout>,
    stderr: Stream<ChildStderr>,
    /// The bytes printed so far.
    printed: usize,
    /// How many bytes may be printed.
    allowed: usize,
}

impl Session {
    fn start(sandbox: &Sandbox, job: &Job) -> Result<Self, SandboxError> {
        let line = command_line(sandbox, job)?;
        let (ours, theirs) = UnixStream::pair().map_err(SandboxError::Watch)?;
        let mut command = Command::new(&line[0]);
        command
            .args(&line[1..])
            .env_clear()
            .env("TMPDIR", &job.scratch)
            .envs(job.environment.iter().map(|(name, value)| (name, value)))
            .current_dir(&job.scratch)
            .stdin(OwnedFd::from(theirs))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|source| SandboxError::Start {
            program: PathBuf::from(&line[0]),
            source,
        })?;
        Ok(Session {
            control: Stream {
                source: Some(ours),
                kept: Vec::new(),
            },
            stdout: Stream {
                source: child.stdout.take(),
                kept: Vec::new(),
            },
            stderr: Stream {
                source: child.stderr.take(),
                kept: Vec::new(),
            },
            child,
            isolation: sandbox.isolation,
            printed: 0,
            allowed: job.limits.output,
        })
    }

    fn has_printed_too_much(&self) -> bool {
        self.printed > self.allowed
    }

    /// Follows the run until the supervisor has reported, or a limit is exceeded, which is returned.
    fn follow(
        &mut self,
        job: &Job,
        stop: &AtomicBool,
        begin: Instant,
    ) -> Result<Option<Ending>, SandboxError> {
        let mut next_look = begin + TICK;
        let mut looks: u32 = 0;
        loop {
            let now = Instant::now();
            let deadline = begin + job.limits.time;
            if stop.load(Ordering::Relaxed) {
                return Ok(Some(Ending::Stopped));
            }
            if now >= deadline {
                return Ok(Some(Ending::TooLong));
            }
            if now >= next_look {
                if let Some(ending) = self.look(&job.limits) {
                    return Ok(Some(ending));
                }
                looks += 1;
                if looks.is_multiple_of(SCRATCH_TICKS)
                    && scratch::holds_more_than(&job.scratch, job.limits.scratch)
                {
                    return Ok(Some(Ending::TooMuchWritten));
                }
                next_look = Instant::now() + TICK;
            }
            self.read_ready(next_look.min(deadline) - now)
                .map_err(SandboxError::Watch)?;
            if self.has_printed_too_much() {
                return Ok(Some(Ending::TooMuchOutput));
            }
            if self.control.source.is_none() {
                return Ok(None);
            }
        }
    }

    /// Counts processes and memory.
    #[cfg(target_os = "linux")]
    fn look(&mut self, limits: &Limits) -> Option<Ending> {
        let allowed = self.allowed_threads(limits);
        let census = super::processes::Census::of(self.root(), allowed);
        if census.threads > allowed {
            Some(Ending::TooManyProcesses)
        } else if census.memory > limits.memory {
            Some(Ending::TooMuchMemory)
        } else {
            None
        }
    }

    /// Only Linux has a list of the processes that could be counted.
    #[cfg(not(target_os = "linux"))]
    fn look(&mut self, _limits: &Limits) -> Option<Ending> {
        None
    }

    /// Kills what runs, without waiting for the supervisor to be given the processor by a program that has it all.
    ///
    /// What this misses, the supervisor ends.
    fn strike(&self, limits: &Limits) {
        #[cfg(target_os = "linux")]
        {
            let root = self.root();
            let census = super::processes::Census::of(root, self.allowed_threads(limits));
            super::processes::kill_all(&census.processes, root);
        }
        #[cfg(not(target_os = "linux"))]
        let _ = limits;
    }

    #[cfg(target_os = "linux")]
    fn allowed_threads(&self, limits: &Limits) -> usize {
        limits.processes + own_threads(self.isolation)
    }

    #[cfg(target_os = "linux")]
    fn root(&self) -> nix::unistd::Pid {
        nix::unistd::Pid::from_raw(self.child.id().cast_signed())
    }

    /// Waits at most `patience` for something to read, and reads from each stream that has something.
    fn read_ready(&mut self, patience: Duration) -> io::Result<()> {
        // Rounded up, or the last millisecond would be spent by asking again and again.
        let patience =
            PollTimeout::try_from(patience + Duration::from_millis(1)).unwrap_or(PollTimeout::MAX);
        let sources = [
            self.control.source.as_ref().map(AsFd::as_fd),
            self.stdout.source.as_ref().map(AsFd::as_fd),
            self.stderr.source.as_ref().map(AsFd::as_fd),
        ];
        let mut asked: Vec<PollFd> = sources
            .iter()
            .flatten()
            .map(|&source| PollFd::new(source, PollFlags::POLLIN))
            .collect();
        match poll(&mut asked, patience) {
            Ok(_) | Err(Errno::EINTR) => {}
            Err(error) => return Err(error.into()),
        }
        // An end or an error of a stream is found by reading as well.
        let mut answers = asked.iter().map(|asked| asked.any().unwrap_or(false));
        let [control, stdout, stderr] =
            sources.map(|source| source.is_some() && answers.next() == Some(true));
        let room = self.allowed.saturating_sub(self.printed);
        if stdout {
            self.printed += self.stdout.read(room)?;
        }
        let room = self.allowed.saturating_sub(self.printed);
        if stderr {
            self.printed += self.stderr.read(room)?;
        }
        if control {
            // A report is one short line.
            self.control.read(4096)?;
        }
        Ok(())
    }

    /// Ends what still runs, reads what is left, and returns the report of the supervisor, if it made one.
    fn finish(&mut self) -> Result<Option<Report>, SandboxError> {
        if self.control.source.is_none() && self.report().is_none() {
            // The supervisor is gone.
            self.end_by_force();
        }
        self.hang_up();
        if !self.drain(Instant::now() + GRACE)? {
            // It does not get on.
            self.end_by_force();
            self.drain(Instant::now() + GRACE)?;
        }
        let deadline = Instant::now() + GRACE;
        while self
            .child
            .try_wait()
            .map_err(SandboxError::Watch)?
            .is_none()
        {
            if Instant::now() > deadline {
                return Err(SandboxError::Stuck {
                    process: self.child.id(),
                });
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(self.report())
    }

    /// What the supervisor has told so far.
    fn report(&self) -> Option<Report> {
        Report::parse(&String::from_utf8_lossy(&self.control.kept))
    }

    /// Tells the supervisor that the run is over.
    fn hang_up(&self) {
        if let Some(control) = &self.control.source {
            // If it is gone already, there is nobody to tell.
            let _ = control.shutdown(Shutdown::Write);
        }
    }

    /// Reads until all streams have ended, which says that all their writers have; false if that takes too long.
    fn drain(&mut self, deadline: Instant) -> Result<bool, SandboxError> {
        while self.control.source.is_some()
            || self.stdout.source.is_some()
            || self.stderr.source.is_some()
        {
            let now = Instant::now();
            if now >= deadline {
                return Ok(false);
            }
            self.read_ready(deadline - now)
                .map_err(SandboxError::Watch)?;
        }
        Ok(true)
    }

    /// Ends the processes as far as they are known, without the help of the supervisor.
    fn end_by_force(&mut self) {
        #[cfg(target_os = "linux")]
        {
            let deadline = Instant::now() + GRACE;
            super::processes::end_descendants(self.root(), deadline);
            // Without a supervisor its children are no descendants any more, but most are still in its session.
            loop {
                let left = super::processes::of_session(self.root());
                super::processes::kill_all(&left, self.root());
                if left.iter().all(|&process| process == self.root()) || Instant::now() > deadline {
                    break;
                }
            }
        }
        // An error means that it has ended.
        let _ = self.child.kill();
    }
}

impl Drop for Session {
    /// After an error, too, nothing may be left.
    fn drop(&mut self) {
        if matches!(self.child.try_wait(), Ok(Some(_))) {
            return;
        }
        self.hang_up();
        let deadline = Instant::now() + GRACE;
        while matches!(self.child.try_wait(), Ok(None)) && Instant::now() < deadline {
            std::thread::sleep(Duration::from_millis(1));
        }
        self.end_by_force();
        let _ = self.child.try_wait();
    }
}
