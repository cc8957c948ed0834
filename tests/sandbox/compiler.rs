//! The compiler inside.

use std::path::PathBuf;
use std::process::Command;

use cagd::workbook::sandbox::{Ending, Job, Limits};

use super::support::{assert_ending, everywhere, said, trial};

fn sysroot() -> PathBuf {
    let output = Command::new("rustc")
        .args(["--print", "sysroot"])
        .output()
        .expect("rustc starts");
    PathBuf::from(String::from_utf8(output.stdout).expect("UTF-8").trim())
}

/// A run of the compiler on `source`, the content of `answer.rs`.
fn compile(source: &str) -> super::support::Trial {
    let mut trial = trial(&[]);
    let sysroot = sysroot();
    let scratch = trial.scratch.path();
    std::fs::write(scratch.join("answer.rs"), source).expect("a file");
    let host = std::fs::read_dir(sysroot.join("lib/rustlib"))
        .expect("libraries")
        .flatten()
        .find(|entry| entry.path().join("bin/rust-lld").is_file());
    let mut arguments: Vec<std::ffi::OsString> = ["--test", "answer.rs", "-o", "answer"]
        .map(Into::into)
        .into();
    // As `Job::needs_system` says: the wrapper around `lld` needs `/proc`, `lld` itself does not.
    if let Some(host) = host {
        let linker = host.path().join("bin/rust-lld");
        std::os::unix::fs::symlink(linker, scratch.join("ld.lld")).expect("a link");
        arguments.push("-Clinker-features=-lld".into());
        arguments.push("-Clink-arg=-fuse-ld=lld".into());
        arguments.push(format!("-Clink-arg=-B{}", scratch.display()).into());
    }
    trial.job = Job {
        program: sysroot.join("bin/rustc"),
        arguments,
        environment: vec![("PATH".into(), "/usr/bin:/bin".into())],
        readable: vec![sysroot],
        needs_system: true,
        limits: Limits::compiler(),
        ..trial.job
    };
    trial
}

#[test]
fn an_answer_is_compiled_and_run() {
    everywhere(|sandbox| {
        let mut trial = compile("#[test] fn sum() { assert_eq!(1 + 1, 2); }");
        let run = trial.run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        trial.job.program = trial.scratch.path().join("answer");
        trial.job.arguments = Vec::new();
        trial.job.needs_system = false;
        trial.job.limits = Limits::answer();
        let run = trial.run(sandbox);
        assert_ending(&run, Ending::Exited(0));
        assert!(said(&run).contains("1 passed"), "{run:?}");
    });
}

#[test]
fn the_compiler_does_not_read_what_is_hidden() {
    everywhere(|sandbox| {
        let secret = tempfile::NamedTempFile::new().expect("a file");
        std::fs::write(secret.path(), "41").expect("it can be written");
        let source = format!(
            "#[test] fn stolen() {{ assert_eq!(include!({:?}), 41); }}",
            secret.path()
        );
        let run = compile(&source).run(sandbox);
        let expected = if sandbox.isolation().is_complete() {
            1
        } else {
            0
        };
        assert_ending(&run, Ending::Exited(expected));
    });
}
