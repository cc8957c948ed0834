//! A Rust block of a page is compiled against the library and run.

use serde_json::{Value, json};

use crate::support::{Answer, Server};

pub(crate) const RUN: &str = "POST /__workbook/run";

/// What the page sends for a block.
pub(crate) fn asking(code: &str) -> String {
    json!({ "code": code }).to_string()
}

#[track_caller]
fn run(server: &Server, code: &str) -> Value {
    let answer = server.ask(RUN, &server.reader(), &asking(code));
    assert_eq!(answer.status, 200, "{answer:?}");
    serde_json::from_str(&answer.body).expect("JSON")
}

#[track_caller]
fn assert_outcome(run: &Value, outcome: &str) {
    assert_eq!(run["outcome"], outcome, "{run:#}");
}

#[test]
fn a_block_runs_against_the_library_and_its_output_and_drawing_come_back() {
    let server = Server::start();
    let block = r#"use cagd::affine::Point;
use cagd::bezier::BezierCurve;
let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;
println!("the point is {:?}", curve.at(0.5)[1]);
println!("<svg viewBox='0 0 1 1'><path d='M0 0L1 1'/></svg>");
Ok::<(), cagd::bezier::BezierError>(())"#;
    let ran = run(&server, block);
    assert_outcome(&ran, "ran");
    assert_eq!(ran["output"], "the point is 1.0", "{ran:#}");
    let picture = ran["picture"].as_str().expect("a drawing");
    assert!(picture.starts_with("<svg") && picture.ends_with("</svg>"));
    let whole = run(&server, "fn main() { println!(\"{}\", 6 * 7); }");
    assert_eq!(whole["output"], "42\n", "{whole:#}");
}

#[test]
fn what_the_compiler_says_counts_the_lines_of_the_block() {
    let server = Server::start();
    let refused = run(
        &server,
        "use cagd::affine::Point;\nlet p = Point::new([0.0, 1.0]);\nlet q = p + p;\n",
    );
    assert_outcome(&refused, "does_not_compile");
    let error = &refused["diagnostics"][0];
    assert_eq!(error["line"], 3, "{refused:#}");
    let said = error["rendered"].as_str().expect("text");
    assert!(said.starts_with("error[E0308]"), "{said}");
    assert!(said.contains("--> example.rs:3:13"), "{said}");
    assert!(said.contains("\n3 | let q = p + p;"), "{said}");
}

#[test]
fn a_block_that_fails_says_why_and_where() {
    let server = Server::start();
    let panicked = run(&server, "let x = 1;\nassert_eq!(x, 2, \"one is not two\");");
    assert_outcome(&panicked, "failed");
    assert_eq!(panicked["reason"], "the program panicked", "{panicked:#}");
    let said = panicked["errors"].as_str().expect("text");
    assert!(said.contains("example.rs:2:1"), "{said}");
    assert!(said.contains("one is not two"), "{said}");
    let error = "\"x\".parse::<u8>()?;\nOk::<(), std::num::ParseIntError>(())";
    let returned = run(&server, error);
    assert_outcome(&returned, "failed");
    assert_eq!(returned["reason"], "the program returned an error");
    assert!(
        returned["errors"]
            .as_str()
            .expect("text")
            .contains("InvalidDigit")
    );
}

#[test]
fn an_endless_program_is_ended_and_the_book_is_read_meanwhile() {
    let server = Server::start();
    let sent = server.send(RUN, &server.reader(), &asking("loop {}"));
    for _ in 0..20 {
        server.assert_readable();
    }
    let answer = Answer::of(sent);
    let ended: Value = serde_json::from_str(&answer.body).expect("JSON");
    assert_outcome(&ended, "failed");
    let reason = ended["reason"].as_str().expect("text");
    assert!(reason.contains("took longer than"), "{reason}");
}

#[test]
fn a_program_without_measure_is_ended_by_the_limits() {
    let server = Server::start();
    let printing = run(&server, "loop { println!(\"{}\", \"x\".repeat(10_000)); }");
    assert_eq!(
        printing["reason"], "the program printed too much",
        "{}",
        printing["reason"]
    );
    let filling = "let mut all = Vec::new(); loop { all.push(vec![1u8; 1 << 26]); }";
    let filling = run(&server, filling);
    assert_eq!(
        filling["reason"], "the program asked for too much memory",
        "{}",
        filling["reason"]
    );
}

/// The names of all threads on this machine that are called so.
#[cfg(target_os = "linux")]
fn threads_called(name: &str) -> usize {
    let tasks = std::fs::read_dir("/proc").expect("a list of processes");
    tasks
        .flatten()
        .filter_map(|process| std::fs::read_dir(process.path().join("task")).ok())
        .flat_map(|tasks| tasks.flatten())
        .filter_map(|task| std::fs::read_to_string(task.path().join("comm")).ok())
        .filter(|comm| comm.trim() == name)
        .count()
}

#[cfg(target_os = "linux")]
#[test]
fn a_client_that_hangs_up_ends_its_program() {
    use std::time::{Duration, Instant};

    let server = Server::start();
    // Seen from outside, the program is known by the name of its thread.
    let name = format!("hang{}", server.address.port());
    let endless = format!(
        "let b = std::thread::Builder::new().name(\"{name}\".into());\n\
         b.spawn(|| loop {{ std::hint::spin_loop() }})?.join().ok();\nOk::<(), std::io::Error>(())"
    );
    let wait_for = |count: usize, patience: Duration| {
        let end = Instant::now() + patience;
        while threads_called(&name) != count {
            assert!(Instant::now() < end, "not {count} programs in {patience:?}");
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    let clients: Vec<_> = (0..2)
        .map(|_| server.send(RUN, &server.reader(), &asking(&endless)))
        .collect();
    wait_for(2, Duration::from_secs(120));
    drop(clients);
    // Half of what the limit of time allows them.
    wait_for(0, Duration::from_secs(5));
    // Both places are free again.
    assert_outcome(&run(&server, "println!(\"next\");"), "ran");
}
