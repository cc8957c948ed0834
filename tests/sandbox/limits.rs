//! Time, memory, output, processes, files.

use std::time::Duration;

use cagd::workbook::sandbox::{Ending, Limits};

use super::support::{assert_ending, everywhere, said, trial};

#[test]
fn an_endless_loop_is_ended() {
    everywhere(|sandbox| {
        for deed in ["loop", "sleep"] {
            let mut trial = trial(&[deed]);
            trial.job.limits.time = Duration::from_millis(300);
            let run = trial.run(sandbox);
            assert_ending(&run, Ending::TooLong);
            assert!(run.duration >= Duration::from_millis(300), "{run:?}");
            assert!(run.duration < Duration::from_millis(1500), "{run:?}");
        }
    });
}

#[test]
fn a_huge_allocation_fails_at_once() {
    everywhere(|sandbox| {
        let run = trial(&["allocate", "10000"]).run(sandbox);
        assert_ending(&run, Ending::TooMuchMemory);
        assert!(run.duration < Duration::from_secs(2), "{run:?}");
        // A tenth of the limit is no problem.
        let run = trial(&["allocate", "50"]).run(sandbox);
        assert_ending(&run, Ending::Exited(0));
    });
}

#[test]
fn processes_cannot_share_out_what_one_must_not_hold() {
    everywhere(|sandbox| {
        let run = trial(&["share", "4", "200"]).run(sandbox);
        assert_ending(&run, Ending::TooMuchMemory);
    });
}

#[test]
fn endless_printing_is_cut() {
    everywhere(|sandbox| {
        for deed in ["print", "complain"] {
            let trial = trial(&[deed]);
            let run = trial.run(sandbox);
            assert_ending(&run, Ending::TooMuchOutput);
            let kept = run.stdout.len() + run.stderr.len();
            assert_eq!(kept, trial.job.limits.output);
        }
    });
}

#[test]
fn as_much_output_as_allowed_is_kept() {
    everywhere(|sandbox| {
        let mut trial = trial(&["say", "hello"]);
        trial.job.limits.output = "hello\n".len();
        let run = trial.run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        assert_eq!(said(&run), "hello");
        trial.job.limits.output -= 1;
        assert_ending(&trial.run(sandbox), Ending::TooMuchOutput);
    });
}

#[test]
fn a_fork_bomb_is_ended() {
    everywhere(|sandbox| {
        let run = trial(&["bomb"]).run(sandbox);
        assert_ending(&run, Ending::TooManyProcesses);
    });
}

#[test]
fn threads_count_as_processes() {
    everywhere(|sandbox| {
        let run = trial(&["threads"]).run(sandbox);
        assert_ending(&run, Ending::TooManyProcesses);
    });
}

#[test]
fn a_huge_file_is_cut() {
    everywhere(|sandbox| {
        let trial = trial(&["flood", "1", "100"]);
        assert_ending(&trial.run(sandbox), Ending::TooMuchWritten);
        let file = trial.scratch.path().join("file-0");
        let length = std::fs::metadata(file).expect("it was begun").len();
        assert_eq!(length, trial.job.limits.file_size);
    });
}

#[test]
fn many_files_are_too_much() {
    everywhere(|sandbox| {
        let run = trial(&["flood", "100", "1"]).run(sandbox);
        assert_ending(&run, Ending::TooMuchWritten);
        // Within the limit they are allowed.
        let mut few = trial(&["flood", "10", "1"]);
        few.job.limits.time = Duration::from_millis(500);
        assert_ending(&few.run(sandbox), Ending::TooLong);
    });
}

#[test]
fn empty_files_and_files_out_of_sight_are_too_much() {
    everywhere(|sandbox| {
        // Each empty file counts 4096 bytes.
        let mut flood = trial(&["flood", "300", "0"]);
        flood.job.limits.scratch = 256 * 4096;
        assert_ending(&flood.run(sandbox), Ending::TooMuchWritten);
        let run = trial(&["bury"]).run(sandbox);
        assert_ending(&run, Ending::TooMuchWritten);
        let mut hide = trial(&["hide", "1000", "1"]);
        hide.job.limits.memory = Limits::LEAST_MEMORY;
        assert_ending(&hide.run(sandbox), Ending::TooMuchMemory);
    });
}
