//! The process between the workbook and the program: it sets the limits that the system keeps, starts the program,
//! and ends every descendant before it ends itself.
//!
//! It is the workbook's own program with the hidden command `supervise`.
//! Its standard input is a socket to the workbook.
//! It reads there until the workbook closes it, which means: end the run.
//! It writes there one line when the program has ended.

use std::ffi::OsString;
use std::io::{self, Read, Write};
use std::os::fd::AsFd;
use std::os::unix::net::UnixStream;
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};
use std::time::Duration;

use clap::Args;
use nix::errno::Errno;
use nix::sys::resource::{Resource, getrlimit, rlim_t, setrlimit};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::{Pid, close, getpid, setsid};

/// Files that one process may have open: the linker opens some hundred libraries of a program at once.
const OPEN_FILES: rlim_t = 1024;

/// What the supervisor is told to do.
#[derive(Debug, Clone, PartialEq, Eq, Args)]
pub struct Order {
    /// The address space of each process, in bytes
    #[arg(long)]
    memory: u64,
    /// The size of one file, in bytes
    #[arg(long)]
    file_size: u64,
    /// The processor time of each process, in seconds
    #[arg(long)]
    seconds: u64,
    /// The command is bubblewrap, which tells by itself how its program ended
    #[arg(long)]
    bubblewrap: bool,
    /// The program and its arguments
    #[arg(last = true, required = true)]
    command: Vec<OsString>,
}

impl Order {
    /// The arguments with which the workbook's program carries out this order.
    #[must_use]
    pub(super) fn arguments(&self) -> Vec<OsString> {
        let mut arguments: Vec<OsString> = vec!["supervise".into()];
        for (option, value) in [
            ("--memory", self.memory),
            ("--file-size", self.file_size),
            ("--seconds", self.seconds),
        ] {
            arguments.extend([option.into(), value.to_string().into()]);
        }
        if self.bubblewrap {
            arguments.push("--bubblewrap".into());
        }
        arguments.push("--".into());
        arguments.extend(self.command.iter().cloned());
        arguments
    }
}

impl Order {
    /// The order for a run within these limits.
    pub(super) fn new(limits: &super::Limits, bubblewrap: bool, command: Vec<OsString>) -> Self {
        let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get() as u64);
        Order {
            memory: limits.memory,
            file_size: limits.file_size,
            // The watch ends a run by the clock; this is for what it should fail to end.
            seconds: (limits.time.as_secs() + 1) * cores,
            bubblewrap,
            command,
        }
    }
}

/// How the program ended, as it is told on the socket.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Report {
    Exited(i32),
    Signalled(i32),
    /// It could not be started, with the reason if it is known.
    NotStarted(String),
}

impl Report {
    fn line(&self) -> String {
        match self {
            Report::Exited(status) => format!("exited {status}\n"),
            Report::Signalled(signal) => format!("signalled {signal}\n"),
            Report::NotStarted(reason) => format!("not-started {}\n", reason.replace('\n', " ")),
        }
    }

    /// The report that a whole line holds; a supervisor that was killed may have written none, or a part.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let (kind, value) = text.strip_suffix('\n')?.split_once(' ')?;
        match kind {
            "exited" => value.parse().ok().map(Report::Exited),
            "signalled" => value.parse().ok().map(Report::Signalled),
            "not-started" => Some(Report::NotStarted(value.to_owned())),
            _ => None,
        }
    }
}

/// Carries out an order, as the command `supervise`.
pub fn supervise(order: &Order) {
    let socket = match io::stdin().as_fd().try_clone_to_owned() {
        Ok(descriptor) => UnixStream::from(descriptor),
        // There is no way to tell anybody; the missing report does.
        Err(_) => return,
    };
    close_all_but(&socket);
    let report = run(order, &socket).unwrap_or_else(|error| Report::NotStarted(error.to_string()));
    // If nobody listens any more, nobody misses the report.
    let _ = (&socket).write_all(report.line().as_bytes());
}

fn run(order: &Order, socket: &UnixStream) -> io::Result<Report> {
    prepare(order)?;
    set_limits(order)?;
    let (program, arguments) = order
        .command
        .split_first()
        .ok_or_else(|| io::Error::from(io::ErrorKind::InvalidInput))?;
    let mut command = Command::new(program);
    // A group of its own, so that a signal to its group does not reach the supervisor.
    command.args(arguments).process_group(0);
    let status = if order.bubblewrap {
        let (reader, writer) = io::pipe()?;
        command.stdin(writer);
        Some(reader)
    } else {
        command.stdin(Stdio::null());
        None
    };
    let child = command.spawn()?;
    // The command holds the writing end of the pipe.
    drop(command);
    let child = Pid::from_raw(i32::try_from(child.id()).map_err(io::Error::other)?);
    let hung_up = socket.try_clone()?;
    std::thread::Builder::new().spawn(move || end_when_closed(hung_up, child))?;
    let ended = wait_for(child)?;
    end_everything(child);
    Ok(match (ended, status) {
        (WaitStatus::Signaled(_, signal, _), _) => Report::Signalled(signal as i32),
        (WaitStatus::Exited(_, status), None) => Report::Exited(status),
        (WaitStatus::Exited(_, status), Some(mut told)) => {
            let mut text = String::new();
            told.read_to_string(&mut text)?;
            if !text.contains("\"exit-code\"") {
                Report::NotStarted(String::new())
            } else if (129..=192).contains(&status) {
                Report::Signalled(status - 128)
            } else {
                Report::Exited(status)
            }
        }
        (other, _) => Report::NotStarted(format!("it ended as {other:?}")),
    })
}

/// Closes what the workbook may have inherited itself and passed on.
fn close_all_but(socket: &UnixStream) {
    use std::os::fd::AsRawFd;
    let Ok(entries) = std::fs::read_dir("/dev/fd") else {
        return;
    };
    let numbers: Vec<i32> = entries
        .flatten()
        .filter_map(|entry| entry.file_name().to_str()?.parse().ok())
        .collect();
    for number in numbers {
        if number > 2 && number != socket.as_raw_fd() {
            // The descriptor with which the list was read is closed already.
            let _ = close(number);
        }
    }
}

/// Makes this process the one to which orphans below it fall, out of reach of the terminal.
fn prepare(order: &Order) -> io::Result<()> {
    match setsid() {
        // It leads a session already.
        Ok(_) | Err(Errno::EPERM) => {}
        Err(error) => return Err(error.into()),
    }
    #[cfg(target_os = "linux")]
    {
        nix::sys::prctl::set_child_subreaper(true)?;
        if !order.bubblewrap {
            // A program with the set-uid bit would leave the limits behind. Bubblewrap, which may be such a program,
            // does the same for what it starts.
            nix::sys::prctl::set_no_new_privs()?;
        }
    }
    #[cfg(not(target_os = "linux"))]
    let _ = order;
    Ok(())
}

/// Sets the limits of this process, which all descendants inherit and cannot raise.
fn set_limits(order: &Order) -> io::Result<()> {
    let limits = [
        #[cfg(not(any(target_os = "freebsd", target_os = "netbsd", target_os = "openbsd")))]
        (Resource::RLIMIT_AS, order.memory),
        (Resource::RLIMIT_DATA, order.memory),
        (Resource::RLIMIT_FSIZE, order.file_size),
        (Resource::RLIMIT_CPU, order.seconds),
        (Resource::RLIMIT_CORE, 0),
        (Resource::RLIMIT_NOFILE, u64::from(OPEN_FILES as u32)),
    ];
    for (resource, wanted) in limits {
        let wanted = rlim_t::try_from(wanted).unwrap_or(rlim_t::MAX);
        let (_, most) = getrlimit(resource)?;
        let wanted = wanted.min(most);
        setrlimit(resource, wanted, wanted)?;
    }
    Ok(())
}

/// Waits until the program has ended, and for what falls to this process meanwhile.
fn wait_for(child: Pid) -> io::Result<WaitStatus> {
    loop {
        match waitpid(None, None) {
            Ok(status @ (WaitStatus::Exited(..) | WaitStatus::Signaled(..)))
                if status.pid() == Some(child) =>
            {
                return Ok(status);
            }
            Ok(_) | Err(Errno::EINTR) => {}
            Err(error) => return Err(error.into()),
        }
    }
}

/// Ends the run as soon as the workbook closes the socket or dies.
fn end_when_closed(mut socket: UnixStream, child: Pid) {
    let mut nothing = [0];
    loop {
        match socket.read(&mut nothing) {
            Ok(0) => break,
            Err(error) if error.kind() != io::ErrorKind::Interrupted => break,
            _ => {}
        }
    }
    if is_init() {
        std::process::exit(0);
    }
    // The main thread sees the program end, and ends the process.
    loop {
        kill_descendants(child);
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// Ends all descendants and waits for them; only when the system knows none, there is none.
fn end_everything(child: Pid) {
    // With the first process of a namespace the system ends all others.
    while !is_init() {
        kill_descendants(child);
        loop {
            match waitpid(None, Some(WaitPidFlag::WNOHANG)) {
                Err(Errno::ECHILD) => return,
                Ok(WaitStatus::StillAlive) | Err(_) => break,
                Ok(_) => {}
            }
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Whether this process is the first of a namespace.
fn is_init() -> bool {
    getpid().as_raw() == 1
}

#[cfg(target_os = "linux")]
fn kill_descendants(_child: Pid) {
    let soon = std::time::Instant::now() + Duration::from_millis(100);
    super::processes::end_descendants(getpid(), soon);
}

/// Without a list of children there is only the group.
#[cfg(not(target_os = "linux"))]
fn kill_descendants(child: Pid) {
    let _ = nix::sys::signal::killpg(child, nix::sys::signal::Signal::SIGKILL);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_survives_the_socket() {
        for report in [
            Report::Exited(3),
            Report::Signalled(9),
            Report::NotStarted("no\nsuch file".into()),
        ] {
            let line = report.line();
            assert_eq!(line.matches('\n').count(), 1, "{line:?}");
            let read = Report::parse(&line).expect("a report");
            assert_eq!(read.line(), line);
        }
        for broken in ["", "exited 1", "exited x\n", "passed 0\n"] {
            assert_eq!(Report::parse(broken), None, "{broken:?}");
        }
    }
}
