//! Files, network and processes of others.

use std::net::TcpListener;
use std::os::unix::process::CommandExt;
use std::process::Command;

use cagd::workbook::sandbox::{Ending, Isolation};
use tempfile::TempDir;

use super::support::{assert_ending, everywhere, hostile, said, trial};

/// A folder of somebody else, with a file in it.
fn somebody_else() -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let secret = folder.path().join("secret");
    std::fs::write(&secret, "the solution").expect("a file");
    let secret = secret.display().to_string();
    (folder, secret)
}

#[test]
fn files_outside_cannot_be_read() {
    everywhere(|sandbox| {
        let (_folder, secret) = somebody_else();
        let run = trial(&["read", &secret]).run(sandbox);
        if sandbox.isolation().is_complete() {
            assert_ending(&run, Ending::Exited(7));
        } else {
            assert_eq!(said(&run), "the solution");
        }
    });
}

#[test]
fn files_outside_cannot_be_deleted_or_written() {
    everywhere(|sandbox| {
        let (folder, secret) = somebody_else();
        let new = folder.path().join("new");
        let new_path = new.display().to_string();
        for deed in [
            ["write", &secret],
            ["write", &new_path],
            ["delete", &folder.path().display().to_string()],
        ] {
            let run = trial(&deed).run(sandbox);
            let is_harmed = std::fs::read_to_string(&secret).ok().as_deref()
                != Some("the solution")
                || new.exists();
            assert_eq!(
                is_harmed,
                !sandbox.isolation().is_complete(),
                "{deed:?}: {run:?}"
            );
            assert_eq!(
                run.ending == Ending::Exited(0),
                is_harmed,
                "{deed:?}: {run:?}"
            );
        }
    });
}

#[test]
fn what_is_readable_can_be_read_and_not_written() {
    everywhere(|sandbox| {
        let (folder, secret) = somebody_else();
        let mut reading = trial(&["read", &secret]);
        reading.job.readable.push(folder.path().to_path_buf());
        assert_eq!(said(&reading.run(sandbox)), "the solution");
        let mut writing = trial(&["write", &secret]);
        writing.job.readable.push(folder.path().to_path_buf());
        writing.run(sandbox);
        let text = std::fs::read_to_string(&secret).expect("it is there");
        assert_eq!(text == "the solution", sandbox.isolation().is_complete());
    });
}

#[test]
fn the_scratch_folder_can_be_written_also_below_what_is_readable() {
    everywhere(|sandbox| {
        let mut trial = trial(&["write", "note"]);
        let above = trial.scratch.path().parent().expect("it has one");
        trial.job.readable.push(above.to_path_buf());
        assert_ending(&trial.run(sandbox), Ending::Exited(0));
        let note = std::fs::read_to_string(trial.scratch.path().join("note"));
        assert_eq!(note.expect("it was written"), "written");
    });
}

#[test]
fn nothing_but_what_is_given_is_there() {
    everywhere(|sandbox| {
        if !sandbox.isolation().is_complete() {
            return;
        }
        let home = std::env::var("HOME").unwrap_or_else(|_| "/root".to_owned());
        let house = env!("CARGO_MANIFEST_DIR");
        for place in [
            "/proc",
            "/proc/self",
            "/usr/bin",
            "/bin",
            "/etc",
            "/sys",
            &home,
            &format!("{house}/book"),
        ] {
            let run = trial(&["list", place]).run(sandbox);
            assert_ending(&run, Ending::Exited(7));
        }
        assert_eq!(said(&trial(&["list", "/dev"]).run(sandbox)), "null");
        // Nowhere else can be written: what is in memory would not be counted.
        for place in ["/new", "/dev/new", "/lib/new"] {
            let run = trial(&["write", place]).run(sandbox);
            assert_ending(&run, Ending::Exited(7));
        }
    });
}

#[test]
fn there_is_nothing_to_start() {
    everywhere(|sandbox| {
        let run = trial(&["spawn", "/bin/sh"]).run(sandbox);
        if sandbox.isolation().is_complete() {
            assert_ending(&run, Ending::Exited(7));
        } else {
            assert_ending(&run, Ending::Exited(0));
        }
    });
}

#[test]
fn the_network_is_out_of_reach() {
    everywhere(|sandbox| {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        let address = listener.local_addr().expect("an address").to_string();
        let run = trial(&["connect", &address]).run(sandbox);
        let expected = match sandbox.isolation() {
            Isolation::Bubblewrap | Isolation::Namespaces => Ending::Exited(7),
            _ => Ending::Exited(0),
        };
        assert_ending(&run, expected);
    });
}

#[test]
fn only_without_namespaces_can_the_supervisor_be_killed() {
    everywhere(|sandbox| {
        let mut trial = trial(&["kill-parent"]);
        trial.job.limits.time = std::time::Duration::from_millis(300);
        let run = trial.run(sandbox);
        let expected = match sandbox.isolation() {
            Isolation::Bubblewrap | Isolation::Namespaces => Ending::TooLong,
            _ => Ending::Lost,
        };
        assert_ending(&run, expected);
    });
}

/// The test starts itself again, with an open descriptor that is not closed on exec, and runs the program there.
#[test]
fn open_files_of_the_workbook_are_not_inherited() {
    const MARK: &str = "TEST_WITH_AN_OPEN_DESCRIPTOR";
    if std::env::var_os(MARK).is_some() {
        everywhere(|sandbox| {
            assert_eq!(said(&trial(&["is-open", "9"]).run(sandbox)), "closed");
        });
        // Without a sandbox it is open.
        let plain = Command::new(hostile()).args(["is-open", "9", ""]).output();
        assert_eq!(plain.expect("it runs").stdout, b"open\n");
        return;
    }
    let test = std::env::current_exe().expect("this test has a program");
    let error_or_status = Command::new("sh")
        .args(["-c", "exec \"$0\" --exact isolation::open_files_of_the_workbook_are_not_inherited 9</dev/null"])
        .arg(test)
        .env(MARK, "yes")
        .process_group(0)
        .output()
        .expect("sh starts");
    assert!(error_or_status.status.success(), "{error_or_status:?}");
}
