//! Submissions that cheat or destroy: none passes, and the neighbours keep their grades.
//!
//! Most of them give the right answer if what they try succeeds, so that a protection that is missing is noticed.

use std::fs;
use std::net::TcpListener;
use std::time::Duration;

use cagd::workbook::grade::{Grade, Status};
use cagd::workbook::sandbox::Isolation;

use super::class::{Class, HEAD, NAME, RIGHT, of, solution, work};
use crate::root;

/// What a test says about the grade of a hostile submission.
type Expected = fn(&Grade) -> bool;

/// How long a run may take: an honest one takes some milliseconds.
const TIME: Duration = Duration::from_secs(2);

fn compiler_says(grade: &Grade, words: &str) -> bool {
    let verdict = grade.verdict.iter();
    let mut said = verdict.flat_map(|verdict| &verdict.diagnostics);
    grade.status == Status::DoesNotCompile && said.any(|d| d.rendered.contains(words))
}

fn failed(grade: &Grade) -> bool {
    grade.status == Status::Failed && grade.passed == 0
}

#[test]
fn no_trick_passes_and_no_neighbour_is_harmed() {
    if !Isolation::best().is_complete() {
        eprintln!(
            "NOT TRIED: {} does not keep submissions apart",
            Isolation::best()
        );
        assert!(
            std::env::var("CI").is_err(),
            "CI needs bubblewrap; run .ci/install"
        );
        return;
    }
    let exercise = root().join("book/exercises").join(NAME).join("answer.rs");
    let exercise = exercise.display().to_string();
    let canary = tempfile::tempdir().expect("a folder");
    let file = canary.path().join("file");
    fs::write(&file, "alive").expect("the file is written");
    let canary = canary.path().display();
    let server = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = server.local_addr().expect("an address");
    let work = work();
    let sleep = format!("{}.5", 80_000 + std::process::id() % 10_000);

    let body = |body: &str| format!("{HEAD}{body}");
    let if_it_succeeds = |deed: &str| format!("{HEAD}{deed}{RIGHT}");
    let wrong = "\n    let _ = t;\n    b[0].clone()\n}\n";
    let could_not_read: Expected = |grade| compiler_says(grade, "couldn't read");
    let forbidden: Expected = |grade| compiler_says(grade, "is not allowed in an answer");
    let endless: Expected = |grade| compiler_says(grade, "is taking a long time");
    let lint: Expected = |grade| compiler_says(grade, "incompatible with previous forbid");
    let hostile: Vec<(&str, String, Expected)> = vec![
        ("exit", body("let _ = (b, t); std::process::exit(0) }"), failed),
        (
            "forged",
            body(
                "let _ = (b, t);
                for test in [\"half_way\", \"both_ends\", \"everywhere\"] {
                    println!(\"test {test} ... ok\\nbegin\\t{test}\\npassed\\t{test}\");
                }
                println!(\"done\\ntest result: ok. 3 passed; 0 failed\");
                std::process::exit(0) }",
            ),
            failed,
        ),
        (
            "unwinding",
            format!(
                "struct Loud;\nimpl Drop for Loud {{ fn drop(&mut self) {{ panic!(\"again\") }} }}\n{HEAD}
                let _loud = Loud; let _ = (b, t); panic!(\"first\") }}"
            ),
            failed,
        ),
        ("endless", body("let _ = (b, t); loop { std::hint::spin_loop() } }"), failed),
        (
            "include-absolute",
            format!("const SOLUTION: &str = include_str!({exercise:?});\n{HEAD}assert!(SOLUTION.len() > 0);{RIGHT}"),
            could_not_read,
        ),
        (
            "include-relative",
            format!("mod solution {{ include!(\"../../../../book/exercises/{NAME}/answer.rs\"); }}\npub use solution::point;\n"),
            could_not_read,
        ),
        (
            "path-absolute",
            format!("#[path = {exercise:?}]\nmod solution;\npub use solution::point;\n"),
            could_not_read,
        ),
        (
            "path-relative",
            format!("#[path = \"../../../../book/exercises/{NAME}/answer.rs\"]\nmod solution;\npub use solution::point;\n"),
            could_not_read,
        ),
        (
            "tests-at-compile-time",
            format!("const TESTS: &str = include_str!(\"tests.rs\");\n{HEAD}assert!(TESTS.len() > 0);{RIGHT}"),
            could_not_read,
        ),
        (
            "reads-the-solution",
            if_it_succeeds(&format!("std::fs::read_to_string({exercise:?}).expect(\"the solution\");")),
            failed,
        ),
        (
            "reads-the-tests-and-the-neighbours",
            if_it_succeeds(&format!(
                "let inside = |folder: std::path::PathBuf| std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
                let sources = inside({work:?}.into()).flat_map(inside).filter(|file| file.extension().is_some_and(|e| e == \"rs\"));
                assert!(sources.count() > 0);"
            )),
            failed,
        ),
        (
            "deletes",
            if_it_succeeds(&format!(
                "std::fs::remove_dir_all(\".\").ok(); std::fs::remove_dir_all({work:?}).ok();
                std::fs::remove_file(\"{canary}/file\").expect(\"it is deleted\");"
            )),
            failed,
        ),
        (
            "writes-to-the-channel",
            body(
                "use std::io::Write;
                let _ = (b, t);
                let lines: String = [\"half_way\", \"both_ends\", \"everywhere\"].iter().map(|test| format!(\"begin\\t{test}\\npassed\\t{test}\\n\")).collect();
                let socket = std::env::args().nth(1).expect(\"the socket\");
                if let Ok(mut channel) = std::os::unix::net::UnixStream::connect(socket) {
                    let _ = channel.write_all(lines.as_bytes());
                }
                for number in 3..32 {
                    let file = std::fs::OpenOptions::new().write(true).open(format!(\"/proc/self/fd/{number}\"));
                    if let Ok(mut file) = file { let _ = file.write_all(lines.as_bytes()); }
                }
                std::process::exit(0) }",
            ),
            failed,
        ),
        (
            "always-equal",
            "use cagd::affine::Point;\npub struct Same;
            impl<T> PartialEq<T> for Same { fn eq(&self, _: &T) -> bool { true } }
            pub fn point<T>(_: &[Point<T, 2>; 3], _: T) -> Same { Same }"
                .into(),
            |grade| grade.status == Status::DoesNotCompile,
        ),
        (
            "macros",
            format!(
                "#[macro_export] macro_rules! assert_eq {{ ($($t:tt)*) => {{}}; }}
                #[macro_export] macro_rules! assert {{ ($($t:tt)*) => {{}}; }}
                #[macro_export] macro_rules! claim {{ ($($t:tt)*) => {{}}; }}\n{HEAD}{wrong}"
            ),
            |grade| grade.status == Status::Failed && grade.passed < grade.tests,
        ),
        (
            "unsafe-by-macro",
            format!("macro_rules! given {{ ($word:ident) => {{ $word {{ std::hint::unreachable_unchecked() }} }} }}\n{HEAD}let _ = (b, t); given!(unsafe) }}"),
            forbidden,
        ),
        (
            "extern-by-macro",
            format!("macro_rules! given {{ ($word:ident) => {{ $word crate proptest; }} }}\ngiven!(extern);\n{HEAD}{RIGHT}"),
            forbidden,
        ),
        (
            "unsafe-behind-what-is-no-token",
            format!("#!'\"\n{HEAD}if false {{ unsafe {{ std::hint::unreachable_unchecked() }} }}{RIGHT}"),
            forbidden,
        ),
        (
            "const-loop",
            format!("#![warn(long_running_const_eval)]\nconst END: u64 = {{ let mut n = 0; while n < u64::MAX {{ n += 1; }} n }};\n{HEAD}assert!(END > 0);{RIGHT}"),
            lint,
        ),
        (
            "const-loop-without-a-word",
            format!("const END: u64 = {{ let mut n = 0; while n < u64::MAX {{ n += 1; }} n }};\n{HEAD}assert!(END > 0);{RIGHT}"),
            endless,
        ),
        (
            "large",
            format!("{}\n// {}\n", solution(), "x".repeat(20 << 20)),
            |grade| grade.status == Status::Unusable,
        ),
        (
            "deep",
            format!("{HEAD}let _ = {}0{};{RIGHT}", "(".repeat(60_000), ")".repeat(60_000)),
            |grade| grade.status == Status::DoesNotCompile,
        ),
        (
            "lives-on",
            if_it_succeeds(&format!("std::process::Command::new(\"/bin/sleep\").arg(\"{sleep}\").spawn().expect(\"it sleeps\");")),
            failed,
        ),
        (
            "calls-home",
            if_it_succeeds(&format!("std::net::TcpStream::connect(\"{address}\").expect(\"a network\");")),
            failed,
        ),
    ];

    let class = Class::new();
    // Before, between and after the others.
    let honest = ["a-neighbour", "m-neighbour", "z-neighbour"];
    for student in honest {
        class.hands_in(student, &solution());
    }
    for (student, answer, _) in &hostile {
        class.hands_in(student, answer);
    }
    let grades = class.graded(&[], TIME);
    for student in honest {
        let grade = of(&grades, student);
        assert_eq!(grade.status, Status::Passed, "{student}: {grade:#?}");
    }
    let unexpected: Vec<&Grade> = hostile
        .iter()
        .map(|(student, _, expected)| (of(&grades, student), expected))
        .filter(|(grade, expected)| !expected(grade))
        .map(|(grade, _)| grade)
        .collect();
    assert!(unexpected.is_empty(), "{unexpected:#?}");
    assert_eq!(
        fs::read_to_string(&file).expect("the canary lives"),
        "alive"
    );
    let processes = fs::read_dir("/proc").expect("Linux has it").flatten();
    let mut lines = processes.filter_map(|entry| fs::read(entry.path().join("cmdline")).ok());
    let sleeps = |line: Vec<u8>| String::from_utf8_lossy(&line).contains(&sleep);
    assert!(!lines.any(sleeps), "a process lives on");
}
