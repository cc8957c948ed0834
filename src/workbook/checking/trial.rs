//! The program runs, and tells its results over a channel of its own.

use std::io::{BufRead, BufReader, Read};
use std::os::unix::net::UnixListener;
use std::path::Path;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use super::CheckingError;
use super::compile::Program;
use super::runner::Runner;
use super::verdict::{PictureStroke, TestOutcome, TestResult};
use crate::check::harness::{ANSWER, PROBES, PROBES_UNLESS_PASSED};
use crate::check::report::{Failure, Message};
use crate::check::{Picture, Role};
use crate::workbook::sandbox::{Ending, Job, Limits, Run};

/// What the tests of one program gave.
#[derive(Debug, Clone, Default)]
pub struct Results {
    /// A result for each test that was asked for, in this order.
    pub tests: Vec<TestResult>,
    /// What the answer printed.
    pub output: String,
    /// Whether the limit of time ended a run.
    pub took_too_long: bool,
    /// What the answer does on the probe inputs, if that was asked for.
    pub probes: Option<Vec<String>>,
}

/// Whether the probes are run behind the tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WithProbes {
    /// Never.
    No,
    /// If a test has failed: a right answer has no misconception.
    UnlessPassed,
    /// In any case.
    Always,
}

/// What happens to the other tests once one has run into the limit of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AfterTooLong {
    /// They are not run: a reader waits, and the loop that never ends has to go first.
    Stop,
    /// They run without it: an assertion of theirs may still reject the answer.
    RunTheOthers,
}

/// How often a program that ended early is started anew for the tests that have no result yet.
const RESTARTS: usize = 3;

/// The signal of a program that has used up its stack.
const SEGMENTATION_FAULT: i32 = 11;

/// How many bytes of the channel are read from one run; a picture has a few kilobytes.
const CHANNEL_LIMIT: u64 = 4 << 20;

/// Runs these tests; each has a result in the end.
///
/// A test that ends the program, or that a limit ends, has failed; the others run again without it.
/// Whether they do so after the limit of time, `after_too_long` says.
///
/// # Errors
///
/// The program does not start.
pub fn run_tests(
    program: &Program,
    tests: &[&str],
    seed: u64,
    limits: &Limits,
    runner: &Runner,
    after_too_long: AfterTooLong,
    with_probes: WithProbes,
) -> Result<Results, CheckingError> {
    let mut results: Vec<TestResult> = Vec::new();
    let mut probes = None;
    let asked = match with_probes {
        WithProbes::No => None,
        WithProbes::UnlessPassed => Some(PROBES_UNLESS_PASSED),
        WithProbes::Always => Some(PROBES),
    };
    let mut output = String::new();
    let mut took_too_long = false;
    let mut why_not_run = "the program ended before this test had a result";
    for _ in 0..RESTARTS {
        let mut open: Vec<&str> = tests
            .iter()
            .copied()
            .filter(|test| !results.iter().any(|result| result.test == *test))
            .collect();
        if open.is_empty() {
            break;
        }
        open.extend(asked);
        let (messages, run) = run_once(program, &open, seed, limits, runner)?;
        output.push_str(&String::from_utf8_lossy(&run.stdout));
        output.push_str(&String::from_utf8_lossy(&run.stderr));
        took_too_long |= run.ending == Ending::TooLong;
        let mut begun = None;
        for message in messages {
            match message {
                Message::Begin(test) => begun = Some(test),
                // Only the test that has begun can have a result, and only once.
                Message::Passed(test) if begun.take_if(|begun| *begun == test).is_some() => {
                    results.push(result(test, TestOutcome::Passed, String::new()));
                }
                Message::Failed(test, failure)
                    if begun.take_if(|begun| *begun == test).is_some() =>
                {
                    results.push(failed(test, failure));
                }
                Message::Probes(values) if begun.is_none() && !values.is_empty() => {
                    probes = Some(values);
                }
                _ => {}
            }
        }
        match begun {
            Some(test) => {
                let message = match run.ending {
                    // The reader's next step is to look for what does not end.
                    Ending::TooLong => format!(
                        "the program took longer than {} s; look for a loop or a recursion without end",
                        limits.time.as_secs()
                    ),
                    Ending::Signalled(SEGMENTATION_FAULT) => format!(
                        "the program {}; in safe Rust that is nearly always a recursion without end",
                        run.ending
                    ),
                    ending => format!("the program {ending}"),
                };
                results.push(result(test, TestOutcome::Ended, message));
            }
            // It ended between two tests, or before the first one: another start would do the same.
            None => break,
        }
        if took_too_long && after_too_long == AfterTooLong::Stop {
            why_not_run = "an earlier test took too long";
            break;
        }
    }
    let tests = tests.iter().map(|&test| {
        let known = results.iter().find(|result| result.test == test).cloned();
        known
            .unwrap_or_else(|| result(test.to_owned(), TestOutcome::NotRun, why_not_run.to_owned()))
    });
    Ok(Results {
        tests: tests.collect(),
        output,
        took_too_long,
        probes,
    })
}

/// Runs the probes; `None` if the program ended without them.
///
/// # Errors
///
/// The program does not start.
pub fn run_probes(
    program: &Program,
    limits: &Limits,
    runner: &Runner,
) -> Result<Option<Vec<String>>, CheckingError> {
    let (messages, _) = run_once(program, &[PROBES], 0, limits, runner)?;
    Ok(messages.into_iter().find_map(|message| match message {
        Message::Probes(values) if !values.is_empty() => Some(values),
        _ => None,
    }))
}

/// Starts the program once and reads its channel to the end.
fn run_once(
    program: &Program,
    names: &[&str],
    seed: u64,
    limits: &Limits,
    runner: &Runner,
) -> Result<(Vec<Message>, Run), CheckingError> {
    // A new folder for each run, beside that of the sources: the program sees neither the tests nor an earlier run.
    let work = program.folder.path().parent().unwrap_or(Path::new("."));
    let scratch = tempfile::Builder::new()
        .prefix("run-")
        .tempdir_in(work)
        .map_err(|e| CheckingError::file(work, &e))?;
    let socket = scratch.path().join("channel");
    let listener = UnixListener::bind(&socket).map_err(|e| CheckingError::file(&socket, &e))?;
    listener
        .set_nonblocking(true)
        .map_err(|e| CheckingError::file(&socket, &e))?;
    let (stop, stopped) = mpsc::channel::<()>();
    let path = socket.clone();
    let reader = thread::spawn(move || {
        // The first to come is the harness, before any code of the answer; nobody else is let in.
        let mut program_ended = false;
        let stream = loop {
            match listener.accept() {
                Ok((stream, _)) => break stream,
                Err(_) if program_ended => return Vec::new(),
                // A short program may come and end between the two questions, so accept has the last word.
                Err(_) => match stopped.recv_timeout(Duration::from_micros(300)) {
                    Err(mpsc::RecvTimeoutError::Timeout) => {}
                    _ => program_ended = true,
                },
            }
        };
        drop(listener);
        // The path leads nowhere any more, whether or not it is still there.
        let _ = std::fs::remove_file(&path);
        if stream.set_nonblocking(false).is_err() {
            return Vec::new();
        }
        BufReader::new(stream.take(CHANNEL_LIMIT))
            .lines()
            .map_while(Result::ok)
            .map_while(|line| Message::from_line(&line))
            .collect()
    });
    let job = Job {
        program: program.path.clone(),
        arguments: std::iter::once(socket.clone().into_os_string())
            .chain(names.iter().map(Into::into))
            .collect(),
        environment: vec![
            ("PROPTEST_RNG_SEED".into(), seed.to_string().into()),
            ("PROPTEST_DISABLE_FAILURE_PERSISTENCE".into(), "true".into()),
            ("RUST_BACKTRACE".into(), "0".into()),
        ]
        .into_iter()
        .chain(
            program
                .answer
                .map(|number| (ANSWER.into(), number.to_string().into())),
        )
        .collect(),
        scratch: scratch.path().to_path_buf(),
        readable: Vec::new(),
        needs_system: false,
        limits: limits.clone(),
    };
    let run = runner.run(&job);
    // A closed channel ends the reader; one that was never opened needs to be told.
    let _ = stop.send(());
    let messages = reader.join().unwrap_or_default();
    let _ = std::fs::remove_file(&socket);
    Ok((messages, run?))
}

fn result(test: String, outcome: TestOutcome, message: String) -> TestResult {
    TestResult {
        test,
        outcome,
        message,
        claim: None,
        input: None,
        expected: None,
        found: None,
        picture: None,
    }
}

/// The result of a test that panicked: by an assertion, or by a panic of the answer.
fn failed(test: String, failure: Failure) -> TestResult {
    // In a program with several answers, the tests stand in a folder for each.
    let in_tests = failure.place.starts_with("tests.rs") || failure.place.contains("/tests.rs");
    let by_assertion = failure.finding.is_some()
        || !failure.place.starts_with("answer.rs")
            && (in_tests || failure.place.contains("proptest"));
    let outcome = if by_assertion {
        TestOutcome::Rejected
    } else {
        TestOutcome::Panicked
    };
    // An index out of bounds says little without its place; the path is that of our scratch folder.
    let place = failure.place.strip_prefix("answer.rs:");
    let message = match place.filter(|_| outcome == TestOutcome::Panicked) {
        Some(line) => format!("{} (line {line} of your answer)", failure.message),
        None => failure.message,
    };
    let mut result = result(test, outcome, message);
    if let Some(finding) = failure.finding {
        let given = |text: String| Some(text).filter(|text| !text.is_empty());
        result.claim = given(finding.claim);
        result.input = given(finding.input);
        result.expected = Some(finding.expected);
        result.found = Some(finding.found);
        result.picture = finding.picture.map(strokes);
    }
    result
}

fn strokes(picture: Picture) -> Vec<PictureStroke> {
    picture
        .strokes
        .into_iter()
        .map(|stroke| PictureStroke {
            role: match stroke.role {
                Role::Given => "given",
                Role::Expected => "expected",
                Role::Found => "found",
            }
            .to_owned(),
            points: stroke.points,
        })
        .collect()
}
