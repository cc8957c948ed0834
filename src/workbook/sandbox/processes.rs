//! A tree of processes, read from `/proc`.
//!
//! Processes come and go while it is read: what has vanished is left out.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::time::{Duration, Instant};

use nix::sys::signal::{Signal, kill, killpg};
use nix::unistd::{Pid, getpgid, getpgrp, getsid};

use super::scratch::on_disk;

/// What the processes of a tree use together.
#[derive(Debug, Default)]
pub(super) struct Census {
    /// The processes, each after its parent.
    pub(super) processes: Vec<Pid>,
    /// Processes and their threads; one that has ended and was not waited for counts as well.
    pub(super) threads: usize,
    /// The memory that they hold, in bytes.
    pub(super) memory: u64,
}

impl Census {
    /// Counts `root` and everything below it, until there are more than `enough` threads.
    pub(super) fn of(root: Pid, enough: usize) -> Self {
        let mut census = Census::default();
        let mut open = vec![root];
        while let Some(process) = open.pop() {
            let children = children(process);
            census.threads += children.threads;
            open.extend(children.processes);
            census.memory += mapped(process) + unnamed(process);
            census.processes.push(process);
            if census.threads > enough {
                break;
            }
        }
        census
    }
}

/// Whether the kernel tells the children of a process.
pub(super) fn check() -> io::Result<()> {
    fs::read("/proc/thread-self/children").map(drop)
}

struct Children {
    threads: usize,
    processes: Vec<Pid>,
}

/// The children of all threads of a process.
fn children(parent: Pid) -> Children {
    let mut found = Children {
        threads: 0,
        processes: Vec::new(),
    };
    let Ok(threads) = fs::read_dir(format!("/proc/{parent}/task")) else {
        return found;
    };
    for thread in threads.flatten() {
        found.threads += 1;
        let numbers = fs::read_to_string(thread.path().join("children")).unwrap_or_default();
        let numbers = numbers
            .split_whitespace()
            .filter_map(|word| word.parse().ok());
        found.processes.extend(numbers.map(Pid::from_raw));
    }
    found
}

/// The value of a line `name: value` of `/proc/<process>/status`.
fn status_line<'a>(status: &'a str, name: &str) -> Option<&'a str> {
    status
        .lines()
        .find_map(|line| line.strip_prefix(name)?.strip_prefix(':'))
        .map(str::trim)
}

/// The memory that a process has mapped and that is in use, in bytes.
fn mapped(process: Pid) -> u64 {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let kibibytes = |name| -> u64 {
        status_line(&status, name)
            .and_then(|value| value.strip_suffix("kB")?.trim().parse().ok())
            .unwrap_or(0)
    };
    (kibibytes("VmRSS") + kibibytes("VmSwap")) * 1024
}

/// The bytes in open files without a name: they are in memory, or on the disk where no folder shows them.
fn unnamed(process: Pid) -> u64 {
    let Ok(files) = fs::read_dir(format!("/proc/{process}/fd")) else {
        return 0;
    };
    files
        .flatten()
        .filter(|file| {
            fs::read_link(file.path()).is_ok_and(|target| {
                target
                    .as_os_str()
                    .as_encoded_bytes()
                    .ends_with(b" (deleted)")
            })
        })
        .filter_map(|file| fs::metadata(file.path()).ok())
        .map(|data| on_disk(&data))
        .sum()
}

/// Whether a process still runs; one that has ended and was not waited for does not.
fn is_alive(process: Pid) -> bool {
    fs::read_to_string(format!("/proc/{process}/status")).is_ok_and(|status| {
        status_line(&status, "State").is_some_and(|state| !state.starts_with(['Z', 'X']))
    })
}

/// Kills everything below `root`, again and again until nothing is left, and says whether that was reached in time.
///
/// What is born while the others are killed is found in the next round: it has become a child of `root`, if `root`
/// is a supervisor, or of the first process of its namespace.
pub(super) fn end_descendants(root: Pid, deadline: Instant) -> bool {
    loop {
        let mut alive = Census::of(root, usize::MAX).processes;
        alive.retain(|&process| process != root && is_alive(process));
        if alive.is_empty() {
            return true;
        }
        kill_all(&alive, root);
        if Instant::now() > deadline {
            return false;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Kills processes below `root` and their groups, but neither the group of `root` nor that of the caller.
///
/// A whole group is killed at one stroke, during which nobody in it can start another process: one at a time would
/// lose against a program that starts copies of itself faster.
pub(super) fn kill_all(processes: &[Pid], root: Pid) {
    let spared = [Some(getpgrp()), getpgid(Some(root)).ok()];
    let groups: BTreeSet<Pid> = processes
        .iter()
        .filter_map(|&process| getpgid(Some(process)).ok())
        .filter(|&group| !spared.contains(&Some(group)))
        .collect();
    // An error says that it has ended by itself.
    for group in groups {
        let _ = killpg(group, Signal::SIGKILL);
    }
    for &process in processes.iter().filter(|&&process| process != root) {
        let _ = kill(process, Signal::SIGKILL);
    }
}

/// The processes of the session that `leader` began, whether it still runs or not.
pub(super) fn of_session(leader: Pid) -> Vec<Pid> {
    let Ok(entries) = fs::read_dir("/proc") else {
        return Vec::new();
    };
    entries
        .flatten()
        .filter_map(|entry| entry.file_name().to_str()?.parse().ok().map(Pid::from_raw))
        .filter(|&process| getsid(Some(process)) == Ok(leader))
        .collect()
}
