//! That nothing is left, whatever happens; [`super::support::Trial::run`] looks for processes after every run.

use std::process::Command;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use cagd::workbook::sandbox::{Ending, Job};

use super::support::{Trial, assert_ending, everywhere, hostile, said, sandboxes, trial};

/// After this time the daemon writes its file.
const LATER: Duration = Duration::from_millis(700);

fn daemon() -> Trial {
    let mut trial = trial(&["daemon"]);
    let file = trial.scratch.path().join("later");
    let time = LATER.as_millis().to_string();
    trial.job.arguments.splice(1..1, [file.into(), time.into()]);
    trial
}

#[test]
fn a_daemon_does_not_outlive_the_run() {
    let trials: Vec<Trial> = sandboxes()
        .iter()
        .map(|sandbox| {
            let trial = daemon();
            let run = trial.run(sandbox);
            assert_ending(&run, Ending::Exited(0));
            assert_eq!(said(&run), "away");
            trial
        })
        .collect();
    // Without a sandbox it writes its file: the deed works.
    let free = daemon();
    let Job { arguments, .. } = &free.job;
    Command::new(hostile())
        .args(arguments)
        .output()
        .expect("it runs");
    std::thread::sleep(2 * LATER);
    assert!(free.scratch.path().join("later").exists());
    for trial in trials {
        assert!(!trial.scratch.path().join("later").exists());
    }
}

#[test]
fn a_run_dies_with_the_workbook() {
    // This test, started again, plays the workbook that is killed.
    const MARK: &str = "TEST_THAT_WILL_BE_KILLED";
    if let Some(number) = std::env::var_os(MARK) {
        let number: usize = number
            .to_str()
            .and_then(|text| text.parse().ok())
            .expect("a number");
        let trial = trial(&["sleep"]);
        println!("scratch {}", trial.scratch.path().display());
        let _ = sandboxes()[number].run(&trial.job, &AtomicBool::new(false));
        return;
    }
    for number in 0..sandboxes().len() {
        let test = std::env::current_exe().expect("this test has a program");
        let mut workbook = Command::new(test)
            .args([
                "--exact",
                "leftovers::a_run_dies_with_the_workbook",
                "--nocapture",
            ])
            .env(MARK, number.to_string())
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::null())
            .spawn()
            .expect("it starts");
        let lines = std::io::BufRead::lines(std::io::BufReader::new(
            workbook.stdout.take().expect("it is piped"),
        ));
        let scratch = lines
            .map_while(Result::ok)
            .find_map(|line| line.split_once("scratch ").map(|(_, path)| path.to_owned()))
            .expect("it names its scratch folder");
        let scratch = TempPath(scratch.into());
        let running = |count: &dyn Fn(usize) -> bool| {
            let deadline = Instant::now() + Duration::from_secs(5);
            while Instant::now() < deadline {
                if count(processes_with(&scratch.0)) {
                    return true;
                }
                std::thread::sleep(Duration::from_millis(10));
            }
            false
        };
        assert!(running(&|count| count >= 2), "it does not begin");
        workbook.kill().expect("it can be killed");
        workbook.wait().expect("it ends");
        assert!(
            running(&|count| count == 0),
            "something is left of {}",
            sandboxes()[number].isolation()
        );
    }
}

/// A folder that a killed process could not remove.
struct TempPath(std::path::PathBuf);

impl Drop for TempPath {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn processes_with(mark: &std::path::Path) -> usize {
    let mark = mark.as_os_str().as_encoded_bytes();
    std::fs::read_dir("/proc")
        .expect("/proc")
        .flatten()
        .filter_map(|entry| std::fs::read(entry.path().join("cmdline")).ok())
        .filter(|line| line.windows(mark.len()).any(|window| window == mark))
        .count()
}

#[test]
fn twenty_runs_at_once_keep_apart() {
    everywhere(|sandbox| {
        let runs: Vec<(usize, _)> = std::thread::scope(|scope| {
            let running: Vec<_> = (0..20)
                .map(|number| {
                    let name = number.to_string();
                    scope.spawn(move || {
                        let run = match number % 4 {
                            0 => trial(&["print"]).run(sandbox),
                            1 => trial(&["exit", &name]).run(sandbox),
                            2 => trial(&["abort"]).run(sandbox),
                            _ => trial(&["say", &name]).run(sandbox),
                        };
                        (number, run)
                    })
                })
                .collect();
            running
                .into_iter()
                .map(|run| run.join().expect("no panic"))
                .collect()
        });
        for (number, run) in runs {
            match number % 4 {
                0 => assert_ending(&run, Ending::TooMuchOutput),
                1 => assert_ending(&run, Ending::Exited(i32::try_from(number).expect("small"))),
                2 => assert_ending(&run, Ending::Signalled(6)),
                _ => assert_eq!(said(&run), number.to_string()),
            }
        }
    });
}
