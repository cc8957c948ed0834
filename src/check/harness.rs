//! Runs the tests of an exercise and tells the verdict over a channel of its own.
//!
//! The workbook writes a `main` behind the tests that calls [`main`]. The verdict goes through a Unix socket, which is
//! opened before anything of the answer runs and is kept in a local variable: what the answer prints, or how it ends
//! the program, cannot pass for a result.

use std::cell::RefCell;
use std::io::{self, Write};
use std::os::unix::net::UnixStream;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo, catch_unwind};
use std::process::ExitCode;

use super::claim::take_last_finding;
use super::report::{Failure, Message};

/// The argument that asks for the probes.
pub const PROBES: &str = "--probes";

/// The argument that asks for the probes if a test before it has failed.
pub const PROBES_UNLESS_PASSED: &str = "--probes-unless-passed";

/// The variable that says which answer is meant, in a program with several: its number, counted from 0.
pub const ANSWER: &str = "WORKBOOK_ANSWER";

/// What there is to run for an answer: the tests with their names, and the probes.
pub type Entry = (&'static [(&'static str, fn())], fn() -> Vec<String>);

thread_local! {
    /// Where the last panic of this thread happened, and its words.
    static LAST_PANIC: RefCell<(String, String)> = const { RefCell::new((String::new(), String::new())) };
}

/// The entry point of a test program.
///
/// The first argument is the path of the socket, the others name the tests to run, in order; [`PROBES`] and
/// [`PROBES_UNLESS_PASSED`] stand for the probes.
///
/// # Panics
///
/// Never because of the answer; its panics are results.
#[must_use]
pub fn main(tests: &[(&str, fn())], probes: fn() -> Vec<String>) -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(socket) = arguments.next() else {
        eprintln!("this program is started by the workbook: `cargo run -- check`");
        return ExitCode::from(2);
    };
    match UnixStream::connect(&socket).and_then(|channel| run(channel, arguments, tests, probes)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("the workbook does not listen at `{socket}`: {error}");
            ExitCode::from(2)
        }
    }
}

/// The entry point of a program that tests several answers, one in each run.
///
/// The arguments are those of [`main`]; the variable [`ANSWER`] says which answer is meant.
#[must_use]
pub fn main_of(answers: &[Entry]) -> ExitCode {
    let number = std::env::var(ANSWER).ok().and_then(|n| n.parse().ok());
    match number.and_then(|number: usize| answers.get(number)) {
        Some((tests, probes)) => main(tests, *probes),
        None => {
            eprintln!("`{ANSWER}` names none of the {} answers", answers.len());
            ExitCode::from(2)
        }
    }
}

fn run(
    mut channel: UnixStream,
    names: impl Iterator<Item = String>,
    tests: &[(&str, fn())],
    probes: fn() -> Vec<String>,
) -> io::Result<()> {
    let mut tell = |message: &Message| {
        channel.write_all(message.to_line().as_bytes())?;
        channel.write_all(b"\n")
    };
    let mut all_passed = true;
    for name in names {
        // The answer may have set a hook of its own.
        panic::set_hook(Box::new(remember));
        if name == PROBES_UNLESS_PASSED && all_passed {
            continue;
        }
        if name == PROBES || name == PROBES_UNLESS_PASSED {
            let values = catch_unwind(probes).unwrap_or_default();
            tell(&Message::Probes(values))?;
            continue;
        }
        let Some((_, test)) = tests.iter().find(|(known, _)| *known == name) else {
            return Err(io::Error::other(format!("there is no test `{name}`")));
        };
        tell(&Message::Begin(name.clone()))?;
        let judgement = judge(*test);
        all_passed &= judgement.is_ok();
        tell(&match judgement {
            Ok(()) => Message::Passed(name),
            Err(failure) => Message::Failed(name, *failure),
        })?;
    }
    tell(&Message::Done)
}

/// Runs one test.
fn judge(test: fn()) -> Result<(), Box<Failure>> {
    take_last_finding();
    let Err(payload) = catch_unwind(AssertUnwindSafe(test)) else {
        return Ok(());
    };
    // The payload, not the hook, has the words: a property test panics anew with the smallest input.
    let message = payload
        .downcast_ref::<String>()
        .cloned()
        .or_else(|| payload.downcast_ref::<&str>().map(|&text| text.to_owned()));
    let (place, remembered) = LAST_PANIC.take();
    let message = message.unwrap_or(remembered);
    let mut finding = take_last_finding();
    if let Some(finding) = &mut finding
        && finding.input.is_empty()
    {
        finding.input = smallest_input(&message).unwrap_or_default();
    }
    Err(Box::new(Failure {
        message,
        place,
        finding,
    }))
}

/// Keeps the words and the place of a panic instead of printing them.
fn remember(panic: &PanicHookInfo<'_>) {
    let words = panic.payload_as_str().unwrap_or("a panic").to_owned();
    let place = panic
        .location()
        .map(|location| format!("{}:{}", location.file(), location.line()))
        .unwrap_or_default();
    LAST_PANIC.set((place, words));
}

/// The input in the words of proptest's panic.
fn smallest_input(message: &str) -> Option<String> {
    let (_, rest) = message.split_once("minimal failing input: ")?;
    let end = rest.find("\n\tsuccesses:").unwrap_or(rest.len());
    Some(rest[..end].trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_input_is_read_from_proptest() {
        let message = "Test failed: assertion failed.\nminimal failing input: t = 3, n = 2\n\tsuccesses: 4\n\tlocal rejects: 0\n";
        assert_eq!(smallest_input(message).as_deref(), Some("t = 3, n = 2"));
        assert_eq!(smallest_input("assertion failed"), None);
    }
}
