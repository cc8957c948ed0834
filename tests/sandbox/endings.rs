//! How a run ends, and what it is given.

use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixListener;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use cagd::workbook::sandbox::{Ending, Isolation, Limits, Sandbox, SandboxError};

use super::support::{assert_ending, everywhere, said, trial};

const SIGABRT: i32 = 6;

#[test]
fn a_program_that_ends_by_itself_keeps_its_status_and_output() {
    everywhere(|sandbox| {
        let run = trial(&["say", "hello"]).run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        assert_eq!(said(&run), "hello");
        for status in [0, 1, 101] {
            let run = trial(&["exit", &status.to_string()]).run(sandbox);
            assert_ending(&run, Ending::Exited(status));
        }
    });
}

#[test]
fn a_panic_while_unwinding_is_a_signal() {
    everywhere(|sandbox| {
        for deed in ["panic-while-unwinding", "abort"] {
            let run = trial(&[deed]).run(sandbox);
            assert_ending(&run, Ending::Signalled(SIGABRT));
        }
    });
}

#[test]
fn standard_input_is_empty() {
    everywhere(|sandbox| {
        let run = trial(&["stdin"]).run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        assert_eq!(said(&run), "");
    });
}

#[test]
fn the_environment_is_the_one_given() {
    everywhere(|sandbox| {
        let mut trial = trial(&["environment"]);
        trial.job.environment = vec![("COLOUR".into(), "blue".into())];
        let run = trial.run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        let text = said(&run);
        let mut names: Vec<&str> = text
            .lines()
            .filter_map(|line| line.split('=').next())
            .filter(|name| !name.is_empty() && *name != "PWD")
            .collect();
        names.sort_unstable();
        assert_eq!(names, ["COLOUR", "TMPDIR"], "{text}");
    });
}

#[test]
fn the_scratch_folder_is_the_current_one() {
    everywhere(|sandbox| {
        let trial = trial(&["folder"]);
        assert_eq!(
            said(&trial.run(sandbox)),
            trial.scratch.path().display().to_string()
        );
    });
}

#[test]
fn the_caller_can_talk_through_a_socket_in_the_scratch_folder() {
    everywhere(|sandbox| {
        let mut trial = trial(&["talk"]);
        let path = trial.scratch.path().join("socket");
        trial.job.arguments.insert(1, path.clone().into());
        let listener = UnixListener::bind(path).expect("a listener");
        let answering = std::thread::spawn(move || {
            let (mut socket, _) = listener.accept().expect("a caller");
            let mut question = String::new();
            BufReader::new(socket.try_clone().expect("a copy"))
                .read_line(&mut question)
                .expect("a question");
            socket.write_all(b"answer").expect("it listens");
            question
        });
        let run = trial.run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        assert_eq!(said(&run), "answer");
        assert_eq!(answering.join().expect("no panic"), "question\n");
    });
}

#[test]
fn the_caller_can_end_a_run_early() {
    everywhere(|sandbox| {
        let trial = trial(&["sleep"]);
        let stop = AtomicBool::new(false);
        let begin = Instant::now();
        let run = std::thread::scope(|scope| {
            let run = scope.spawn(|| sandbox.run(&trial.job, &stop));
            std::thread::sleep(Duration::from_millis(200));
            assert!(!run.is_finished());
            stop.store(true, Ordering::Relaxed);
            run.join().expect("no panic")
        });
        assert_ending(&run.expect("it ran"), Ending::Stopped);
        assert!(begin.elapsed() < Duration::from_secs(2));
        assert_eq!(trial.processes(), Vec::<String>::new());
    });
}

#[test]
fn what_cannot_begin_is_an_error_with_a_next_step() {
    everywhere(|sandbox| {
        let mut missing = trial(&["say", "hello"]);
        missing.job.program = "/no/such/program".into();
        let mut unreadable = trial(&["say", "hello"]);
        unreadable.job.readable.push("/no/such/folder".into());
        let mut unwritable = trial(&["say", "hello"]);
        unwritable.job.scratch = "/no/such/scratch".into();
        let mut relative = trial(&["say", "hello"]);
        relative.job.scratch = "scratch".into();
        let mut starved = trial(&["say", "hello"]);
        starved.job.limits.memory = Limits::LEAST_MEMORY - 1;
        let mut text = trial(&["say", "hello"]);
        text.job.program = text.scratch.path().join("text");
        std::fs::write(&text.job.program, "no program").expect("a file");
        type IsExpected = fn(&SandboxError) -> bool;
        let cases: [(_, IsExpected); 6] = [
            (missing, |error| {
                matches!(error, SandboxError::NoProgram { .. })
            }),
            (unreadable, |error| {
                matches!(error, SandboxError::Unreadable { .. })
            }),
            (unwritable, |error| {
                matches!(error, SandboxError::Scratch { .. })
            }),
            (relative, |error| {
                matches!(error, SandboxError::Scratch { .. })
            }),
            (starved, |error| {
                matches!(error, SandboxError::TooLittleMemory { .. })
            }),
            (text, |error| matches!(error, SandboxError::Refused { .. })),
        ];
        for (trial, is_expected) in cases {
            let error = trial.try_run(sandbox).expect_err("it cannot begin");
            assert!(is_expected(&error), "{error:?}");
            assert!(error.to_string().contains("next step"), "{error}");
        }
    });
}

#[test]
fn a_program_cannot_pretend_that_bubblewrap_failed() {
    everywhere(|sandbox| {
        let run = trial(&["read", "/bwrap: no such thing"]).run(sandbox);
        assert_ending(&run, Ending::Exited(7));
    });
}

#[test]
fn the_smallest_memory_is_enough() {
    everywhere(|sandbox| {
        let mut trial = trial(&["say", "hello"]);
        trial.job.limits.memory = Limits::LEAST_MEMORY;
        assert_ending(&trial.run(sandbox), Ending::Exited(0));
    });
}

#[test]
fn a_supervisor_that_is_not_there_is_told() {
    let sandbox = Sandbox::new(PathBuf::from("/no/such/workbook"), Isolation::ProcessTree);
    let error = trial(&["say", "hello"])
        .try_run(&sandbox)
        .expect_err("it cannot begin");
    assert!(matches!(error, SandboxError::Start { .. }), "{error:?}");
}

#[test]
fn the_best_isolation_is_the_first_that_works() {
    let best = Isolation::best();
    assert_eq!(best, super::support::sandboxes()[0].isolation());
    assert!(!best.describe().is_empty());
}
