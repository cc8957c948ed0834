//! The package of answers: an editor can work in it, and no answer is overwritten.

use std::fs;
use std::process::Command;

use super::{NAME, Reader, Run, files_below, root, sources};

#[test]
fn an_answer_is_never_overwritten() {
    let reader = Reader::begun();
    reader.write("// mine\n");
    for arguments in [
        &["start", NAME][..],
        &["check"],
        &["list"],
        &["hint"],
        &["next"],
    ] {
        reader.run(arguments);
    }
    assert_eq!(reader.read("bezier/parabola-point.rs"), "// mine\n");
    reader.run(&["start", NAME]).assert_says("as you left it");
}

#[test]
fn reset_keeps_every_answer() {
    let reader = Reader::begun();
    for text in ["// first\n", "// second\n"] {
        reader.write(text);
        let run = reader.run(&["reset", NAME]);
        run.assert_status(0).assert_says("next step");
        assert_eq!(
            reader.read("bezier/parabola-point.rs"),
            sources().answer.starter
        );
    }
    assert_eq!(
        reader.read("backups/bezier/parabola-point.1.rs"),
        "// first\n"
    );
    assert_eq!(
        reader.read("backups/bezier/parabola-point.2.rs"),
        "// second\n"
    );
    assert_eq!(reader.item()["state"], "begun");
}

#[test]
fn the_folder_holds_what_it_should() {
    let reader = Reader::begun();
    reader.run(&["check"]).assert_status(1);
    let expected = [
        ".progress.lock",
        "Cargo.lock",
        "Cargo.toml",
        "bezier/parabola-point.rs",
        "pictures/bezier/parabola-point.svg",
        "progress.json",
    ];
    assert_eq!(files_below(&reader.path("")), expected);
}

/// What an editor asks Cargo for: the package compiles, and a broken answer does not hide the next.
#[test]
fn an_editor_can_work_in_the_package() {
    let reader = Reader::begun();
    fs::write(
        reader.path("bezier/broken.rs"),
        "fn f() -> u8 { missing }\n",
    )
    .expect("a file");
    // A command that adds an answer brings the manifest up to date.
    reader.run(&["start", NAME]).assert_status(0);
    let check = |arguments: &[&str]| {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo
            .args(["check", "--offline"])
            .args(arguments)
            .current_dir(reader.path(""))
            // Kept from run to run, since the library takes a while.
            .env("CARGO_TARGET_DIR", root().join("target/exercises/editor"));
        Run::of(&mut cargo)
    };
    check(&["--example", "bezier-parabola-point"]).assert_status(0);
    let run = check(&["--examples", "--keep-going"]);
    run.assert_status(101);
    run.assert_says("bezier/broken.rs:1:16");
    run.assert_silent_about(
        "error: could not compile `answers` (example \"bezier-parabola-point\")",
    );
    let lock = fs::read_to_string(reader.path("Cargo.lock")).expect("a lock file");
    let root_lock = fs::read_to_string(root().join("Cargo.lock")).expect("a lock file");
    let nalgebra = root_lock
        .split("\n\n")
        .find(|part| part.contains("name = \"nalgebra\""));
    assert!(
        lock.contains(nalgebra.expect("it is a dependency")),
        "{lock}"
    );
}
