//! From the list to the solution, as a reader goes through it.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use cagd::workbook::checking::{Outcome, Verdict};
use cagd::workbook::sandbox::Limits;
use serde_json::Value;

use super::{NAME, Reader, Run, sources};

/// A pack with an explanation and nothing else.
const EXPLANATION: &str = r#"+++
title = "Why a curve stays near its polygon"
kind = "explain"
statements = ["bezier-convex-hull"]
difficulty = 4
minutes = 10
order = 900
+++

Explain it, see {{#ref bezier-convex-hull}}.

## Hint

One.

## Hint

Two.

## Hint

Three.

## Model answer

The weights $\lambda_i \ge 0$ sum to one.

## Checklist

- [ ] the weights are not negative
- [ ] they sum to one
"#;

#[test]
fn a_new_reader_comes_from_the_list_to_a_solved_exercise() {
    let reader = Reader::new();
    assert_eq!(reader.item()["state"], "open");
    reader
        .run(&["list"])
        .assert_status(0)
        .assert_says("parabola-point A point");

    let run = reader.run(&["start", "parabola-point"]);
    run.assert_status(0).assert_says("b₀, b₁, b₂");
    assert_eq!(
        reader.read("bezier/parabola-point.rs"),
        sources().answer.starter
    );
    assert_eq!(reader.item()["state"], "begun");
    assert_eq!(reader.json(&["next"])["exercise"], NAME);

    let run = reader.run(&["check"]);
    run.assert_status(1);
    for words in [
        "tested the point b(t)",
        "input b₀ = (0, 0), b₁ = (2, 4), b₂ = (6, 0), t = 1/2",
        "expected (5/2, 2)",
        "found (0, 0)",
        "next step",
    ] {
        run.assert_says(words);
    }

    reader.write(&sources().answer.solution);
    let run = reader.run(&["check", NAME]);
    run.assert_status(0);
    run.assert_says("Right. All 3 tests passed: half way, both ends, everywhere.");
    assert_eq!(reader.item()["state"], "solved");
    let next = reader.json(&["next"])["exercise"].to_string();
    assert_ne!(next, format!("\"{NAME}\""));
    assert!(
        next.starts_with("\"bezier/"),
        "{next} leads away from the chapter"
    );
}

#[test]
fn the_list_fits_a_narrow_terminal() {
    let reader = Reader::begun();
    for (width, title_is_below) in [(200, false), (80, false), (60, true), (40, true)] {
        let mut command = reader.command(&["list"]);
        let list = Run::of(command.env("COLUMNS", width.to_string()));
        list.assert_status(0);
        for line in list.stdout.lines() {
            assert!(line.chars().count() <= width, "{width}: {line}");
        }
        // Nothing is cut where the title has a place of its own.
        list.assert_says(NAME.trim_start_matches("bezier/"));
        let title = list.says("A point of a parabola");
        assert!(title || !title_is_below, "{list:#?}");
        let name = list.stdout.lines().find(|l| l.contains("parabola-point"));
        let has_more = name.is_some_and(|line| line.contains("min"));
        assert_eq!(has_more, !title_is_below, "{width}: {name:?}");
    }
}

#[test]
fn check_prints_one_verdict_as_json() {
    let reader = Reader::begun();
    let verdict = reader.json(&["check"]);
    assert_eq!(verdict["exercise"], NAME);
    assert_eq!(verdict["outcome"], "failed");
    assert_eq!(verdict["tests"][0]["found"], "(0, 0)");
    let parsed: Result<cagd::workbook::checking::Verdict, _> = serde_json::from_value(verdict);
    assert!(parsed.is_ok(), "{parsed:?}");
}

#[test]
fn a_misconception_is_told_and_the_picture_is_drawn() {
    let reader = Reader::begun();
    let mutant = &sources().mutants[0];
    reader.write(&mutant.text);
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says(&mutant.misconception);
    run.assert_says("pictures/bezier/parabola-point.svg");
    let picture = reader.read("pictures/bezier/parabola-point.svg");
    assert!(picture.starts_with("<svg"), "{picture}");
    // No terminal, no picture in letters and no colours.
    assert!(!run.stdout.contains('\u{1b}'), "{run:#?}");
    assert!(!run.stdout.contains('⠒'), "{run:#?}");
    reader.write(&sources().answer.solution);
    reader.run(&["check"]).assert_status(0);
    let picture = reader.path("pictures/bezier/parabola-point.svg");
    assert!(
        !picture.exists(),
        "the picture of the old mistake is still there"
    );
}

#[test]
fn colours_come_when_they_are_asked_for() {
    let reader = Reader::new();
    let mut command = reader.command(&["list"]);
    let forced = Run::of(command.env("CLICOLOR_FORCE", "1"));
    assert!(forced.stdout.contains('\u{1b}'), "{forced:#?}");
    let mut command = reader.command(&["list"]);
    let refused = Run::of(command.env("NO_COLOR", "1"));
    assert!(!refused.stdout.contains('\u{1b}'), "{refused:#?}");
}

#[test]
fn a_panic_of_the_answer_is_told_with_its_line() {
    let reader = Reader::begun();
    let starter = sources().answer.starter;
    let panics = starter.replace(
        "let _ = t;",
        "let _ = t; let no: Vec<u8> = vec![]; let _ = no[3];",
    );
    assert_ne!(panics, starter);
    let line = starter
        .lines()
        .position(|line| line.contains("let _ = t;"))
        .expect("the starter has this line");
    reader.write(&panics);
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says("your answer panicked");
    run.assert_says(&format!(
        "the index is 3 (line {} of your answer)",
        line + 1
    ));
}

#[test]
fn a_loop_without_end_costs_one_limit_of_time() {
    let reader = Reader::begun();
    let starter = sources().answer.starter;
    let endless = starter.replace("let _ = t;", "let _ = t; if b.len() == 3 { loop {} }");
    assert_ne!(endless, starter);
    reader.write(&endless);
    let verdict = reader.json(&["check"]);
    let outcomes: Vec<&Value> = verdict["tests"]
        .as_array()
        .expect("an array")
        .iter()
        .map(|test| &test["outcome"])
        .collect();
    // A second run, of the other tests or on the probe inputs, would make `ended` of the second test or double the time.
    assert_eq!(outcomes, ["ended", "not_run", "not_run"]);
    let seconds = verdict["seconds"].as_f64().expect("a number");
    let limit = Limits::answer().time.as_secs_f64();
    assert!(seconds < 1.9 * limit, "{seconds} s");
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says("a loop or a recursion");
    run.assert_says("Not reached: both ends, everywhere.");
}

#[test]
fn a_recursion_without_end_is_told_as_such() {
    let reader = Reader::begun();
    let starter = sources().answer.starter;
    let endless = starter.replace(
        "b[0].clone()\n",
        "point(b, t.clone()) + (b[1].clone() - b[0].clone())\n",
    );
    let endless = endless.replace("let _ = t;", "");
    assert_ne!(endless, starter);
    reader.write(&endless);
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says("a recursion without end");
}

#[test]
fn errors_of_the_compiler_point_into_the_readers_file() {
    let reader = Reader::begun();
    let starter = sources().answer.starter;
    reader.write(&starter.replace("b[0].clone()", "b[0].clones()"));
    let line = starter
        .lines()
        .position(|line| line.contains("b[0].clone()"))
        .expect("the starter has this line");
    let run = reader.run(&["check"]);
    run.assert_status(1);
    run.assert_says(&format!("{}:{}:", reader.file().display(), line + 1));
    run.assert_says("no method named `clones`");

    reader.write(&starter.replace("fn point<", "fn punkt<"));
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says("the tests cannot use it");

    // Every call says the same, and where the reader has written it.
    reader.write(&starter.replace("t: T)", "t: &T)"));
    let run = reader.run(&["check"]);
    run.assert_status(1)
        .assert_says("the first ones often cause");
    run.assert_says(&format!("{}:", reader.file().display()));
    let calls = run.stdout.matches("parabola-point/tests.rs:").count();
    assert!((1..=3).contains(&calls), "{run:#?}");
}

#[test]
fn what_an_answer_prints_cannot_paint_the_terminal() {
    let reader = Reader::begun();
    let starter = sources().answer.starter;
    let noisy = starter.replace("let _ = t;", "println!(\"\\u{1b}[2Jhello\"); let _ = t;");
    assert_ne!(noisy, starter);
    reader.write(&noisy);
    let run = reader.run(&["check"]);
    run.assert_status(1).assert_says("·[2Jhello");
    assert!(!run.stdout.contains('\u{1b}'), "{run:#?}");
}

#[test]
fn hints_come_one_at_a_time() {
    let reader = Reader::begun();
    let seen = |arguments: &[&str]| {
        let hints = reader.json(arguments);
        let texts = hints["hints"].as_array().expect("an array").len();
        (hints["shown"].as_u64(), texts)
    };
    assert_eq!(seen(&["hint"]), (Some(1), 1));
    assert_eq!(seen(&["hint"]), (Some(2), 1));
    assert_eq!(seen(&["hint", "--again"]), (Some(2), 2));
    assert_eq!(seen(&["hint", NAME]), (Some(3), 1));
    assert_eq!(seen(&["hint"]), (Some(3), 1));
    reader.run(&["hint"]).assert_says("These were all");
    assert_eq!(reader.item()["hints_shown"], 3);
    // Without its name the next hint would be about the exercise begun last.
    reader
        .run(&["hint", "bezier/de-casteljau"])
        .assert_says("cargo run -- hint bezier/de-casteljau");
    reader
        .run(&["solution", "bezier/de-casteljau"])
        .assert_says("cargo run -- hint bezier/de-casteljau");
}

#[test]
fn the_solution_is_shown_after_success_or_when_asked_twice() {
    let reader = Reader::begun();
    let run = reader.run(&["solution"]);
    run.assert_status(0).assert_says("ask once more");
    run.assert_silent_about("let between");
    reader.run(&["solution"]).assert_says("let between");

    let reader = Reader::begun();
    reader.write(&sources().answer.solution);
    reader.run(&["check"]).assert_status(0);
    let solution = reader.json(&["solution"]);
    assert_eq!(solution["solution"], sources().answer.solution);
}

#[test]
fn an_explanation_is_judged_by_the_reader() {
    let reader = Reader::new();
    let pack = reader.path("pack");
    let folder = pack.join("bezier/near-polygon");
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("exercise.md"), EXPLANATION).expect("a file");
    let pack = pack.to_str().expect("UTF-8");
    let run = |arguments: &[&str]| reader.run(&[arguments, &["--pack", pack]].concat());
    run(&["start", "near-polygon"]).assert_says("see “");
    let early = Reader::new();
    early
        .run(&["solution", "near-polygon", "--pack", pack])
        .assert_silent_about("λᵢ");
    let option = format!("--pack {pack}`");
    let named = run(&["check"]);
    named
        .assert_status(1)
        .assert_says("[ ] the weights are not negative")
        .assert_says(&format!("--done {option}"));
    // What is to be typed next finds the exercise again.
    run(&["start", "near-polygon"]).assert_says(&format!("check {option}"));
    run(&["hint"]).assert_says(&option);
    early
        .run(&["check", "near-polygon", "--pack", pack])
        .assert_status(2)
        .assert_says(&format!("start bezier/near-polygon {option}"));
    run(&["solution"]).assert_says("λᵢ ≥ 0");
    run(&["watch"]).assert_status(2).assert_says("next step");
    let verdict = || -> Verdict {
        let json = reader.json(&["check", "--pack", pack]);
        serde_json::from_value(json).expect("a verdict as of every other exercise")
    };
    assert_eq!(verdict().outcome, Outcome::Open);
    let file = reader.path("bezier/near-polygon.md");
    let sheet = std::fs::read_to_string(&file).expect("it was begun");
    for empty in ["", "\n", &sheet] {
        std::fs::write(&file, empty).expect("a file");
        run(&["check", "bezier/near-polygon", "--done"])
            .assert_status(2)
            .assert_says("no answer")
            .assert_says("next step");
    }
    std::fs::write(&file, "They are weights.").expect("a file");
    run(&["check", "bezier/near-polygon", "--done"]).assert_status(0);
    run(&["check"]).assert_status(0);
    assert_eq!(verdict().outcome, Outcome::SelfAssessed);
    let checklist = verdict().checklist.expect("an explanation has one");
    assert!(checklist.contains("they sum to one"), "{checklist}");
    // Without the pack, nothing is lost.
    reader.run(&["list"]).assert_says("bezier/near-polygon");
    reader
        .run(&["check"])
        .assert_status(2)
        .assert_says("--pack");
}

#[test]
fn a_tableau_has_fresh_numbers_for_each_seed() {
    let reader = Reader::new();
    let file = "bezier/cubic-tableau.rs";
    let start = |seed: &str| reader.json(&["start", "cubic-tableau", "--fresh", seed]);
    assert_eq!(start("7")["seed"], 7);
    let deal = cagd::bezier::tableaux::cubic(7);
    assert_eq!(reader.read(file), deal.answer_file());
    std::fs::write(reader.path(file), deal.solved_file()).expect("a file");
    reader.run(&["check"]).assert_status(0);
    let solution = reader.json(&["solution"]);
    assert_eq!(solution["solution"], deal.solved_file());

    let again = start("8");
    assert_ne!(reader.read(file), deal.answer_file());
    assert_eq!(
        reader.read("backups/bezier/cubic-tableau.1.rs"),
        deal.solved_file()
    );
    assert!(
        again["backup"]
            .as_str()
            .is_some_and(|file| file.ends_with(".1.rs"))
    );
    let any = reader.json(&["start", "cubic-tableau", "--fresh"]);
    let seed = any["seed"].as_u64().expect("a seed");
    assert_eq!(
        reader.read(file),
        cagd::bezier::tableaux::cubic(seed).answer_file()
    );
    // The former numbers are no reason to speak of a starter that has changed.
    reader
        .run(&["check"])
        .assert_silent_about("starter has changed");
}

#[test]
fn unknown_names_get_the_most_similar() {
    let reader = Reader::new();
    for name in ["bezier/parabola-pont", "parabola-pont"] {
        let run = reader.run(&["start", name]);
        run.assert_status(2);
        run.assert_says("did you mean `bezier/parabola-point`?");
    }
    reader
        .run(&["check"])
        .assert_status(2)
        .assert_says("next step");
    reader
        .run(&["check", NAME])
        .assert_status(2)
        .assert_says("next step");
    reader
        .run(&["reset", NAME])
        .assert_status(2)
        .assert_says("next step");
    let run = reader.run(&["list", "--statement", "bezier-convex-hul"]);
    run.assert_status(2).assert_says("bezier-convex-hull");
    let run = reader.run(&["start", NAME, "--fresh", "7"]);
    run.assert_status(2).assert_says("no fresh numbers");
}

#[test]
fn watch_checks_whenever_the_answer_is_saved() {
    let reader = Reader::begun();
    let mut child = reader
        .command(&["watch", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    let lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let (sender, verdicts) = mpsc::channel();
    std::thread::spawn(move || {
        for line in lines.map_while(Result::ok) {
            // The test may have ended.
            let _ = sender.send(line);
        }
    });
    // The first one may have to wait for the library.
    let next = || verdicts.recv_timeout(Duration::from_secs(120));
    let first = next();
    reader.write(&sources().answer.solution);
    let saved = Instant::now();
    let second = next();
    let seconds = saved.elapsed().as_secs_f64();
    child.kill().expect("it runs until it is ended");
    child.wait().expect("it has ended");
    assert!(first.is_ok_and(|line| line.contains("\"outcome\":\"failed\"")));
    assert!(second.is_ok_and(|line| line.contains("\"outcome\":\"passed\"")));
    println!("from saving to the verdict: {seconds:.2} s");
}

#[test]
fn an_empty_answer_is_one_error() {
    let reader = Reader::begun();
    for nothing in ["", "\n\n", "// nothing but words\n"] {
        reader.write(nothing);
        let verdict = reader.json(&["check"]);
        assert_eq!(verdict["outcome"], "does_not_compile");
        let errors = verdict["diagnostics"].as_array().expect("an array");
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert_eq!(errors[0]["message"], "the answer is empty");
        reader.run(&["check"]).assert_says("cargo run -- reset");
    }
}

#[test]
fn a_broken_exercise_leaves_the_others_alone() {
    let reader = Reader::new();
    let pack = reader.path("pack");
    for (name, text) in [("near-polygon", EXPLANATION), ("broken", "no front matter")] {
        let folder = pack.join("bezier").join(name);
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("exercise.md"), text).expect("a file");
    }
    let pack = pack.to_str().expect("UTF-8");
    let run = |arguments: &[&str]| reader.run(&[arguments, &["--pack", pack]].concat());
    for arguments in [
        ["list"].as_slice(),
        &["start", "near-polygon"],
        &["start", NAME],
        &["hint", "near-polygon"],
    ] {
        let run = run(arguments);
        run.assert_status(0);
        assert!(run.stderr.contains("broken/exercise.md:1"), "{run:#?}");
    }
    let one = run(&["start", "bezier/broken"]);
    one.assert_status(2)
        .assert_says("has mistakes of its own")
        .assert_says("next step");

    let verify = |name: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        let command = command.current_dir(crate::root());
        Run::of(command.args(["verify", name, "--json", "--pack", pack]))
    };
    let sound = verify("bezier/near-polygon");
    sound.assert_status(0);
    let broken = verify("bezier/broken");
    broken.assert_status(1);
    let reports: Value = serde_json::from_str(&broken.stdout).expect("JSON");
    assert_eq!(reports[0]["exercise"], "bezier/broken");
    assert_eq!(reports[0]["shortcomings"][0]["about"], "schema");
}
