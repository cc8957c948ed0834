//! The commands as a reader runs them: what they print, what they write, how they end.

mod house;
mod serving;
#[cfg(unix)]
mod subdivide;

use std::fs;
use std::net::TcpListener;

use house::{House, PAGE};
use serde_json::Value;

#[test]
fn build_writes_a_site() {
    let house = House::new();
    let out = house.path("site");
    let run = house.run(&["build", "--out", out.to_str().expect("UTF-8")]);
    run.assert_status(0);
    assert!(out.join("index.html").is_file(), "{run:?}");
}

#[test]
fn the_default_folder_is_target_book_from_wherever_it_is_called() {
    let house = House::new();
    house.run_in("book/src", &["build"]).assert_status(0);
    assert!(house.path("target/book/index.html").is_file());
}

#[test]
fn a_book_with_errors_names_all_of_them_and_leaves_the_last_good_site() {
    let house = House::new();
    house.run(&["build"]).assert_status(0);
    let before = fs::read(house.path("target/book/index.html")).expect("the page is there");
    let page = house.read(PAGE);
    house.write(
        PAGE,
        &format!("{page}\n{{{{#ref no-such-id}}}}\n\n{{{{#cite nobody1900}}}}\n"),
    );
    let lines = page.lines().count();
    let run = house.run(&["build"]);
    run.assert_status(1);
    run.assert_says(&format!("{PAGE}:{}", lines + 2));
    run.assert_says(&format!("{PAGE}:{}", lines + 4));
    let after = fs::read(house.path("target/book/index.html")).expect("the page is still there");
    assert!(before == after, "the site changed");
    house.assert_no_leftovers();
}

#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let house = House::new();
    house.write("file", "");
    let out = house.path("file/site");
    let run = house.run(&["build", "--out", out.to_str().expect("UTF-8")]);
    run.assert_status(2);
    run.assert_says("--out");
    house.assert_no_leftovers();
}

#[test]
fn a_folder_with_other_files_is_not_replaced() {
    let house = House::new();
    house.write("letters/thesis.md", "precious");
    let out = house.path("letters");
    let run = house.run(&["build", "--out", out.to_str().expect("UTF-8")]);
    run.assert_status(2);
    run.assert_says("--out");
    assert_eq!(house.read("letters/thesis.md"), "precious");
}

#[test]
fn outside_a_workbook_the_next_step_is_told() {
    let house = House::new();
    fs::remove_file(house.path("Cargo.toml")).expect("it is there");
    for arguments in [&["build"][..], &["coverage"], &[]] {
        let run = house.run(arguments);
        run.assert_status(2);
        run.assert_says("next step");
    }
}

#[test]
fn a_port_in_use_is_told_with_the_way_out() {
    let house = House::new();
    let taken = TcpListener::bind("127.0.0.1:0").expect("some port is free");
    let port = taken
        .local_addr()
        .expect("it has an address")
        .port()
        .to_string();
    let run = house.run(&["--port", &port]);
    run.assert_status(2);
    run.assert_says(&format!("port {port} is already in use"));
    run.assert_says("--port");
}

#[test]
fn unknown_arguments_end_with_status_2() {
    let house = House::new();
    for arguments in [
        &["coverage", "--chapter", "topology"][..],
        &["coverage", "--except", "luck"],
        &["start"],
        &["--port", "70000"],
    ] {
        house.run(arguments).assert_status(2);
    }
}

#[test]
fn coverage_has_the_promised_shape() {
    let house = House::new();
    let run = house.run(&["coverage", "--json", "--chapter", "bezier"]);
    run.assert_status(1);
    let entries: Value = serde_json::from_str(&run.stdout).expect("it prints JSON");
    let entries = entries.as_array().expect("it prints an array");
    assert_eq!(entries.len(), 72);
    for entry in entries {
        let keys: Vec<&str> = entry
            .as_object()
            .expect("an object")
            .keys()
            .map(String::as_str)
            .collect();
        let mut expected = [
            "id", "chapter", "kind", "title", "sources", "needs", "evidence", "missing",
        ];
        expected.sort_unstable();
        let mut keys = keys;
        keys.sort_unstable();
        assert_eq!(keys, expected, "{entry}");
        assert_eq!(entry["chapter"], "bezier");
        assert!(
            entry["sources"].is_array() && entry["needs"].is_array() && entry["missing"].is_array()
        );
        let evidence = entry["evidence"].as_object().expect("an object");
        for need in [
            "example",
            "property",
            "exact",
            "figure",
            "interactive",
            "exercise",
            "proof",
            "compile_fail",
        ] {
            let places = evidence
                .get(need)
                .and_then(Value::as_array)
                .expect("a list of places");
            for place in places {
                assert_is_place(&house, place.as_str().expect("a place is text"));
            }
        }
        assert_eq!(evidence.len(), 8, "{entry}");
    }
}

/// `path:line` of a line that exists.
#[track_caller]
fn assert_is_place(house: &House, place: &str) {
    let (path, line) = place
        .rsplit_once(':')
        .unwrap_or_else(|| panic!("`{place}` has no line"));
    let line: usize = line
        .parse()
        .unwrap_or_else(|_| panic!("`{place}` has no line"));
    let lines = house.read(path).lines().count();
    assert!(
        (1..=lines).contains(&line),
        "{path} has {lines} lines, not {line}"
    );
}

#[test]
fn what_is_excepted_is_not_missing() {
    let house = House::new();
    let everything =
        "statement,example,property,exact,figure,interactive,exercise,proof,compile_fail,errata";
    let run = house.run(&["coverage", "--chapter", "bezier", "--except", everything]);
    run.assert_status(0);
    run.assert_says("72 statements, nothing missing");
    let run = house.run(&[
        "coverage",
        "--json",
        "--chapter",
        "bezier",
        "--except",
        "exercise",
    ]);
    assert!(
        !run.stdout.contains("\"exercise\"\n      ]"),
        "{}",
        run.stdout
    );
}

#[test]
fn coverage_of_a_broken_book_could_not_run() {
    let house = House::new();
    house.write(PAGE, "# Broken\n\n{{#statement bezier-convex-hull}}\n");
    let run = house.run(&["coverage"]);
    run.assert_status(2);
    run.assert_says(&format!("{PAGE}:3"));
}

#[test]
fn the_preprocessor_answers_stock_mdbook() {
    let house = House::new();
    house
        .run(&["preprocessor", "supports", "html"])
        .assert_status(0);
    house
        .run(&["preprocessor", "supports", "epub"])
        .assert_status(1);
}
