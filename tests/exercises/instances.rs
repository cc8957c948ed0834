//! What the tests of exercises have in common is compiled once.
//!
//! Nothing would fail if it were not; every check would only take longer.

use std::fs;
use std::path::Path;
use std::process::Command;

use cagd::workbook::checking::Library;

use crate::{checker, exercises, tested};

/// Compiles a file with these arguments besides.
fn compile(library: &Library, folder: &Path, file: &str, arguments: &[String]) {
    let run = Command::new(&library.rustc)
        .args(["--edition=2024", "-Awarnings", "-Ccodegen-units=1"])
        .arg(format!("-Ldependency={}", library.dependencies.display()))
        .arg(format!("--extern=cagd={}", library.cagd.display()))
        .args(arguments)
        .arg(file)
        .current_dir(folder)
        .output()
        .expect("the compiler starts");
    assert!(
        run.status.success(),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
}

/// How many functions the compiler translates for these tests of the compiled answer.
fn functions(library: &Library, folder: &Path, tests: &str) -> usize {
    fs::write(folder.join("tests.rs"), tests).expect("a file");
    let arguments = [
        "--crate-type=bin".to_owned(),
        "--emit=llvm-ir=out.ll".to_owned(),
        "--extern=answer=libanswer.rlib".to_owned(),
        format!("--extern=proptest={}", library.proptest.display()),
        format!("--extern=instances={}", library.instances.display()),
    ];
    compile(library, folder, "tests.rs", &arguments);
    let text = fs::read_to_string(folder.join("out.ll")).expect("the translation");
    let functions = text.lines().filter(|line| line.starts_with("define "));
    functions.count()
}

/// Of the functions in the tests of the parabola, about a third is left to translate: 238 of 756 in November 2026.
///
/// Without the curves, the random input or the claims of `instances.rs` it was 280, 293 or 306; the bound lies between.
/// If this fails, `src/workbook/checking/instances.rs` does not call any more what tests call.
#[test]
fn most_of_a_test_program_is_there_already() {
    let exercises = exercises();
    let (_, tested) = tested(&exercises, "bezier/parabola-point");
    let library = checker().library().clone();
    let place = tempfile::tempdir().expect("a folder");
    let folder = place.path();
    fs::write(folder.join("answer.rs"), &tested.answer.solution).expect("a file");
    let is_library = ["--crate-type=rlib", "-olibanswer.rlib"].map(str::to_owned);
    compile(&library, folder, "answer.rs", &is_library);
    let tests = tested.tests.program();
    let alone = functions(&library, folder, &tests);
    let with_instances = format!("{tests}extern crate instances as _;\n");
    let left = functions(&library, folder, &with_instances);
    println!("{left} functions of {alone} are left");
    assert!(alone > 300, "only {alone} functions were counted");
    assert!(
        100 * left < 35 * alone,
        "{left} functions of {alone} are left"
    );
}
