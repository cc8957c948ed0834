//! The progress: never half written, never lost.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use cagd::book::exercise::ExerciseName;
use cagd::workbook::progress::{FILE, Store};

use super::{NAME, Reader, files_below};

/// Names the folder to the process that writes.
const FOLDER: &str = "WORKBOOK_TEST_FOLDER";

fn name() -> ExerciseName {
    NAME.parse().expect("a name")
}

/// Counts one further, and returns the count.
fn count(store: &Store) -> usize {
    let counted = store.update(|progress| {
        progress.entry(&name()).hints += 1;
        progress.of(&name()).hints
    });
    let (count, notice) = counted.expect("the progress can be written");
    assert_eq!(notice, None);
    count
}

/// What the process does that the test starts and kills.
fn write_until_killed(folder: &Path) -> ! {
    let store = Store::new(folder);
    let mut out = std::io::stdout();
    loop {
        let count = count(&store);
        writeln!(out, "\nwritten {count}").expect("somebody listens");
    }
}

#[test]
fn progress_survives_a_kill() {
    // The process that is killed is this very test, started with a folder.
    if let Some(folder) = std::env::var_os(FOLDER) {
        write_until_killed(Path::new(&folder));
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let store = Store::new(folder.path());
    let mut killed_while_writing = 0;
    for round in 0..60_u64 {
        let mut writer = Command::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "reader::progress::progress_survives_a_kill"])
            .args(["--nocapture", "--test-threads=1"])
            .env(FOLDER, folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        let lines = BufReader::new(writer.stdout.take().expect("it is piped")).lines();
        let mut written = lines.map_while(Result::ok).filter_map(|line| {
            let (_, count) = line.split_once("written ")?;
            count.parse::<usize>().ok()
        });
        let first = written.next().expect("it writes");
        // Another moment each time, spread over some rounds of writing.
        thread::sleep(Duration::from_micros(round * 137 % 4000));
        writer.kill().expect("it writes until it is ended");
        writer.wait().expect("it has ended");
        let last = written.last().unwrap_or(first);

        let new_is_there = folder.path().join(".progress.new").exists();
        killed_while_writing += usize::from(new_is_there);
        let (progress, notice) = store.read().expect("the progress can be read");
        assert_eq!(notice, None, "round {round}");
        let kept = progress.of(&name()).hints;
        // What was told as written is there; the one that was being written may be.
        assert!(
            (last..=last + 1).contains(&kept),
            "{last} was written, {kept} is there"
        );
    }
    assert!(
        killed_while_writing > 0,
        "no kill has met a process that writes"
    );
    count(&store);
    let files = [".progress.lock", FILE].map(str::to_owned);
    assert_eq!(files_below(folder.path()), files);
}

/// Commands are processes, so a lock inside of one would not do.
#[test]
fn commands_at_once_lose_nothing() {
    const EACH: usize = 25;
    if let Some(folder) = std::env::var_os(FOLDER) {
        let store = Store::new(Path::new(&folder));
        (0..EACH).for_each(|_| {
            count(&store);
        });
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let commands: Vec<_> = (0..4)
        .map(|_| {
            Command::new(std::env::current_exe().expect("this program"))
                .args(["--exact", "reader::progress::commands_at_once_lose_nothing"])
                .env(FOLDER, folder.path())
                .stdout(Stdio::null())
                .spawn()
                .expect("it starts")
        })
        .collect();
    for mut command in commands {
        let status = command.wait().expect("it ends");
        assert!(status.success(), "a command could not count: {status}");
    }
    let (progress, _) = Store::new(folder.path()).read().expect("it can be read");
    assert_eq!(progress.of(&name()).hints, 4 * EACH);
}

#[test]
fn a_broken_or_newer_file_is_kept_aside() {
    let reader = Reader::begun();
    reader.write("// mine\n");
    for (text, kept) in [
        ("{\"version\": 1, \"exer", "progress.broken-1.json"),
        ("null", "progress.broken-2.json"),
        ("{\"version\": 7, \"new\": []}", "progress.version-7-1.json"),
    ] {
        fs::write(reader.path(FILE), text).expect("a file");
        let run = reader.run(&["list"]);
        run.assert_status(0)
            .assert_says(kept)
            .assert_says("next step");
        assert_eq!(reader.read(kept), text);
        assert!(!reader.path(FILE).exists());
        // The answer is there, so the exercise is begun.
        assert_eq!(reader.item()["state"], "begun");
        reader.run(&["start", NAME]).assert_status(0);
    }
    assert_eq!(reader.read("bezier/parabola-point.rs"), "// mine\n");
}

#[test]
fn progress_survives_an_update_of_the_book() {
    let reader = Reader::begun();
    assert_eq!(reader.item()["starter_changed"], false);
    let text = reader.read(FILE);
    let mut progress: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    progress["exercises"][NAME]["starter"] = "an older one".into();
    progress["exercises"]["bezier/gone"] = serde_json::json!({ "solved": 5 });
    progress["begun_last"] = "bezier/gone".into();
    fs::write(reader.path(FILE), progress.to_string()).expect("a file");

    assert_eq!(reader.item()["starter_changed"], true);
    let run = reader.run(&["list"]);
    run.assert_says("the starter has changed")
        .assert_says("bezier/gone");
    reader
        .run(&["check"])
        .assert_status(2)
        .assert_says("next step");
    reader.run(&["next"]).assert_status(0);
    let run = reader.run(&["check", NAME]);
    run.assert_status(1).assert_says("The starter has changed");
    run.assert_says("reset");
    reader.run(&["reset", NAME]).assert_status(0);
    assert_eq!(reader.item()["starter_changed"], false);
    let kept: serde_json::Value = serde_json::from_str(&reader.read(FILE)).expect("JSON");
    assert_eq!(kept["exercises"]["bezier/gone"]["solved"], 5);
}

#[test]
fn progress_goes_to_another_computer() {
    let here = Reader::begun();
    here.run(&["hint"]);
    let file = here.path("carried.json");
    let file = file.to_str().expect("UTF-8");
    here.run(&["progress", "export", file]).assert_status(0);
    here.run(&["progress", "export", file])
        .assert_status(2)
        .assert_says("next step");

    let there = Reader::begun();
    there.run(&["hint"]);
    there.run(&["hint"]);
    there.run(&["progress", "import", file]).assert_status(0);
    assert_eq!(there.item()["hints_shown"], 2);
    let fresh = Reader::new();
    fresh.run(&["progress", "import", file]).assert_status(0);
    assert_eq!(fresh.item()["hints_shown"], 1);
    fresh.run(&["start", NAME]).assert_status(0);
    let whole = fresh.read(FILE);
    for (text, said) in [
        (&whole[..whole.len() / 2], "it breaks off"),
        ("[package]", "line 1 is no JSON"),
        (
            "{\"version\": 1, \"exercises\": 5}",
            "line 1 does not fit a record of progress",
        ),
        ("", "it is empty"),
    ] {
        let file = fresh.path("broken.json");
        fs::write(&file, text).expect("a file");
        let run = fresh.run(&["progress", "import", file.to_str().expect("UTF-8")]);
        run.assert_status(2)
            .assert_says(said)
            .assert_says("next step");
    }
}
