//! What the tests of exercises have in common is compiled once.
//!
//! Nothing would fail if it were not; every check would only take longer.

use std::fs;
use std::path::Path;
use std::process::Command;

use cagd::workbook::checking::Library;

use crate::{checker, exercises, tested};

/// How many functions the compiler translates for a file; with `instances`, those are left out that it has.
fn functions(library: &Library, folder: &Path, file: &str, arguments: &[String]) -> usize {
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
    let text = fs::read_to_string(folder.join("out.ll")).unwrap_or_default();
    let functions = text.lines().filter(|line| line.starts_with("define "));
    functions.count()
}

/// Of the functions in the tests of the parabola, less than a half is left to translate: 261 of 824 in November 2026.
///
/// If this fails, `src/workbook/checking/instances.rs` does not call any more what tests call.
#[test]
fn most_of_a_test_program_is_there_already() {
    let exercises = exercises();
    let (_, tested) = tested(&exercises, "bezier/parabola-point");
    let library = checker().library().clone();
    let place = tempfile::tempdir().expect("a folder");
    let folder = place.path();
    let write = |file: &str, text: &str| fs::write(folder.join(file), text).expect("a file");
    write("answer.rs", &tested.answer.solution);
    write("alone.rs", &tested.tests.program());
    let with_instances = format!("{}extern crate instances as _;\n", tested.tests.program());
    write("with_instances.rs", &with_instances);
    let is_library = [
        "--crate-type=rlib",
        "--crate-name=answer",
        "-olibanswer.rlib",
    ];
    functions(
        &library,
        folder,
        "answer.rs",
        &is_library.map(str::to_owned),
    );
    let arguments = [
        "--crate-type=bin".to_owned(),
        "--emit=llvm-ir=out.ll".to_owned(),
        "--extern=answer=libanswer.rlib".to_owned(),
        format!("--extern=proptest={}", library.proptest.display()),
        format!("--extern=instances={}", library.instances.display()),
    ];
    let alone = functions(&library, folder, "alone.rs", &arguments);
    let left = functions(&library, folder, "with_instances.rs", &arguments);
    println!("{left} functions of {alone} are left");
    assert!(alone > 300, "only {alone} functions were counted");
    assert!(2 * left < alone, "{left} functions of {alone} are left");
}
