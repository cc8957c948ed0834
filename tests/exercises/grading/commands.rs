//! `grade` as an instructor runs it.

use std::path::Path;
use std::process::{Command, Output};

use cagd::workbook::sandbox::Isolation;

use super::class::{Class, solution};
use crate::root;

fn grade(folder: &Path, options: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
    command.current_dir(root()).arg("grade").arg(folder);
    if !Isolation::best().is_complete() {
        command.arg("--unsafe");
    }
    command.args(options).output().expect("the workbook starts")
}

#[test]
fn the_status_says_how_it_went() {
    let class = Class::new();
    let empty = grade(class.path(), &[]);
    assert_eq!(empty.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&empty.stderr).contains("no student"));

    class.hands_in("anna", &solution());
    let csv = class.path().with_extension("csv");
    let passed = grade(class.path(), &["--csv", csv.to_str().expect("UTF-8")]);
    assert_eq!(passed.status.code(), Some(0), "{passed:?}");
    let table = std::fs::read_to_string(&csv).expect("the table is written");
    assert_eq!(
        table,
        "student,bezier/parabola-point,passed\nanna,passed,1\n"
    );
    std::fs::remove_file(csv).expect("it goes away");

    class.hands_in("ben", "pub fn point(");
    let one_fails = grade(class.path(), &["--json"]);
    assert_eq!(one_fails.status.code(), Some(1), "{one_fails:?}");
    let json: serde_json::Value = serde_json::from_slice(&one_fails.stdout).expect("JSON");
    let ben = &json["students"][1]["exercises"][0];
    assert_eq!(ben["status"], "does_not_compile");
    assert_eq!(ben["verdict"]["exercise"], "bezier/parabola-point");

    let nobody = grade(class.path(), &["bezier/de-casteljau"]);
    let said = String::from_utf8_lossy(&nobody.stderr);
    assert!(
        said.contains("nobody has handed in an answer to `bezier/de-casteljau`"),
        "{said}"
    );

    let other = grade(class.path(), &["bezier/no-such-exercise"]);
    assert_eq!(other.status.code(), Some(2));
}

/// The workbook where neither bubblewrap nor `unshare` is in the search path, so that nothing keeps programs apart.
fn without_isolation(arguments: &[&str]) -> Output {
    let cargo = Path::new(env!("CARGO"));
    let toolchain = cargo.parent().expect("cargo stands in a folder");
    assert!(!toolchain.join("bwrap").exists() && !toolchain.join("unshare").exists());
    Command::new(env!("CARGO_BIN_EXE_workbook"))
        .current_dir(root())
        .args(arguments)
        .env("PATH", toolchain)
        .output()
        .expect("the workbook starts")
}

#[test]
fn without_isolation_grade_refuses_unless_told() {
    let class = Class::new();
    class.hands_in("anna", &solution());
    let folder = class.path().to_str().expect("UTF-8");
    let refused = without_isolation(&["grade", folder]);
    assert_eq!(refused.status.code(), Some(2), "{refused:?}");
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(
        said.contains("--unsafe") && said.contains("bubblewrap"),
        "{said}"
    );
    assert!(refused.stdout.is_empty(), "{refused:?}");

    let told = without_isolation(&["grade", folder, "--unsafe"]);
    assert_eq!(told.status.code(), Some(0), "{told:?}");
    let said = String::from_utf8_lossy(&told.stderr);
    assert!(
        said.contains("warning: The program runs as you do"),
        "{said}"
    );
}

#[test]
fn a_file_that_cannot_be_written_is_told_before_the_work() {
    let class = Class::new();
    let bad = class.path().join("no-folder/results.xml");
    let bad = bad.to_str().expect("UTF-8");
    let folder = class.path().to_str().expect("UTF-8");
    for arguments in [
        ["verify", "--junit", bad].as_slice(),
        &["grade", folder, "--junit", bad],
        &["grade", folder, "--csv", bad],
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        let run = command.current_dir(root()).args(arguments).output();
        let run = run.expect("the workbook starts");
        assert_eq!(run.status.code(), Some(2), "{run:?}");
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(said.contains("cannot be written"), "{said}");
        assert!(run.stdout.is_empty(), "{run:?}");
    }
}
