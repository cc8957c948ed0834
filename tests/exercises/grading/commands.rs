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

    let other = grade(class.path(), &["bezier/no-such-exercise"]);
    assert_eq!(other.status.code(), Some(2));
}
