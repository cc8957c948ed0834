//! A run in a scratch folder of its own, and the isolations that work here.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use cagd::workbook::sandbox::{Ending, Isolation, Job, Limits, Run, Sandbox, SandboxError};
use tempfile::TempDir;

/// The program of the workbook, which is the supervisor.
pub(crate) fn workbook() -> PathBuf {
    PathBuf::from(env!("CARGO_BIN_EXE_workbook"))
}

/// The isolations that work on this machine; what is missing is told, and in CI bubblewrap must not be missing.
pub(crate) fn sandboxes() -> &'static [Sandbox] {
    static FOUND: OnceLock<Vec<Sandbox>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let mut found = Vec::new();
        for &isolation in Isolation::all() {
            let sandbox = Sandbox::new(workbook(), isolation);
            match sandbox.try_out() {
                Ok(()) => found.push(sandbox),
                Err(error) => {
                    eprintln!("NOT TRIED, {isolation}: {error}");
                    let in_ci = std::env::var("CI").is_ok_and(|value| value == "true");
                    assert!(
                        !(in_ci && isolation == Isolation::Bubblewrap),
                        "CI needs bubblewrap; run .ci/install\n{error}"
                    );
                }
            }
        }
        assert!(!found.is_empty(), "no isolation works here");
        found
    })
}

/// Calls `judge` with each isolation, and names it when a test fails.
pub(crate) fn everywhere(judge: impl Fn(&Sandbox)) {
    for sandbox in sandboxes() {
        eprintln!("with {}", sandbox.isolation());
        judge(sandbox);
    }
}

/// The program that misbehaves, compiled once.
pub(crate) fn hostile() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let new = folder.join(format!("hostile-{}", std::process::id()));
        let output = Command::new("rustc")
            .args(["--edition", "2024", "-Copt-level=1", "-o"])
            .arg(&new)
            .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/sandbox/hostile.rs"))
            .output()
            .expect("rustc starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{said}");
        // Another run of the tests may use the old one.
        let program = folder.join("hostile");
        std::fs::rename(new, &program).expect("it can be renamed");
        program
    })
}

/// A run of [`hostile`] that is about to begin.
pub(crate) struct Trial {
    pub(crate) job: Job,
    pub(crate) scratch: TempDir,
}

/// The limits of the trials: small, so that they are reached soon.
pub(crate) fn small() -> Limits {
    Limits {
        time: Duration::from_secs(5),
        memory: 512 << 20,
        output: 100_000,
        processes: 16,
        file_size: 4 << 20,
        scratch: 16 << 20,
    }
}

/// Prepares a deed of [`hostile`].
pub(crate) fn trial(deed: &[&str]) -> Trial {
    let scratch = tempfile::tempdir().expect("a scratch folder");
    let mut arguments: Vec<OsString> = deed.iter().map(OsString::from).collect();
    arguments.push(scratch.path().into());
    let job = Job {
        program: hostile().to_path_buf(),
        arguments,
        environment: Vec::new(),
        scratch: scratch.path().to_path_buf(),
        readable: Vec::new(),
        needs_system: false,
        limits: small(),
    };
    Trial { job, scratch }
}

impl Trial {
    /// Runs it and makes sure that no process is left.
    #[track_caller]
    pub(crate) fn run(&self, sandbox: &Sandbox) -> Run {
        self.try_run(sandbox)
            .unwrap_or_else(|error| panic!("{error}"))
    }

    #[track_caller]
    pub(crate) fn try_run(&self, sandbox: &Sandbox) -> Result<Run, SandboxError> {
        let run = sandbox.run(&self.job, &AtomicBool::new(false));
        let left = self.processes();
        assert!(
            left.is_empty(),
            "left behind: {} such as {:?}",
            left.len(),
            left[0]
        );
        run
    }

    /// The command lines of all processes that mention the scratch folder of this trial.
    pub(crate) fn processes(&self) -> Vec<String> {
        let mark = self.scratch.path().display().to_string();
        std::fs::read_dir("/proc")
            .expect("/proc")
            .flatten()
            .filter_map(|entry| std::fs::read(entry.path().join("cmdline")).ok())
            .map(|line| String::from_utf8_lossy(&line).replace('\0', " "))
            .filter(|line| line.contains(&mark))
            .collect()
    }
}

/// What a run printed on standard output, without the last line break.
pub(crate) fn said(run: &Run) -> String {
    String::from_utf8_lossy(&run.stdout)
        .trim_end_matches('\n')
        .to_owned()
}

#[track_caller]
pub(crate) fn assert_ending(run: &Run, ending: Ending) {
    assert!(
        run.ending == ending,
        "expected {ending:?}, found {:?} after {:?}\n{}\n{}",
        run.ending,
        run.duration,
        said(run).chars().take(500).collect::<String>(),
        String::from_utf8_lossy(&run.stderr)
            .chars()
            .take(2000)
            .collect::<String>(),
    );
}
