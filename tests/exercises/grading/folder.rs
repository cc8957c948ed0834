//! What may lie in a folder of submissions.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;

use cagd::workbook::grade::{GradeError, Submissions};

use super::class::{Class, NAME, solution};
use crate::{exercises, root};

#[test]
fn what_is_no_answer_is_told_and_harms_nobody() {
    let class = Class::new();
    class.hands_in("anna", &solution());
    class.hands_in("latin", "");
    fs::write(class.file("latin"), b"// caf\xe9\n").expect("it is written");
    class.hands_in("link", "");
    fs::remove_file(class.file("link")).expect("it goes away");
    let secret = root().join("book/exercises").join(NAME).join("answer.rs");
    symlink(&secret, class.file("link")).expect("a link");
    symlink(
        secret.parent().expect("a folder"),
        class.path().join("linked"),
    )
    .expect("a link");
    class.hands_in("socket", "");
    fs::remove_file(class.file("socket")).expect("it goes away");
    let _socket = UnixListener::bind(class.file("socket")).expect("a socket");
    let strange = OsStr::from_bytes(b"\xff\x1b[2J, \"x\"\n");
    fs::create_dir_all(class.path().join(strange).join("bezier")).expect("a folder");
    let answer = class.path().join(strange).join(NAME).with_extension("rs");
    fs::write(answer, solution()).expect("it is written");
    fs::write(class.path().join("notes.txt"), "").expect("it is written");
    fs::write(class.file("anna").with_file_name("parabola-pont.rs"), "").expect("it is written");
    fs::create_dir_all(class.path().join("anna/homework")).expect("a folder");
    fs::create_dir_all(class.path().join("anna/target")).expect("a folder");
    fs::write(class.path().join("anna/Cargo.toml"), "").expect("it is written");

    let found = class.read();
    let name = NAME.parse().expect("a name");
    let of = |student: &str| {
        let student = found.students.iter().find(|of| of.name == student);
        let answers = &student.expect("the student is there").answers;
        answers[&name].source.clone()
    };
    assert_eq!(of("anna"), Ok(solution()));
    assert_eq!(of("latin"), Err("it is not written in UTF-8".into()));
    assert_eq!(
        of("link"),
        Err("it is a link, which is not followed".into())
    );
    assert_eq!(of("socket"), Err("it is no file".into()));
    assert_eq!(of("\u{fffd}\\u{1b}[2J, \"x\"\\u{a}"), Ok(solution()));
    assert_eq!(found.students.len(), 5);
    let remarks: Vec<&str> = found.remarks.iter().map(|r| r.file.as_str()).collect();
    assert_eq!(
        remarks,
        [
            "anna/bezier/parabola-pont.rs",
            "anna/homework",
            "linked",
            "notes.txt"
        ]
    );
    assert!(found.remarks[0].found.contains("bezier/parabola-point.rs"));
}

#[test]
fn a_folder_without_students_is_an_error() {
    let class = Class::new();
    let read = |folder: &std::path::Path| Submissions::read(folder, &exercises());
    assert!(matches!(read(class.path()), Err(GradeError::NoStudent(_))));
    let missing = class.path().join("missing");
    assert!(matches!(read(&missing), Err(GradeError::Folder { .. })));
}
