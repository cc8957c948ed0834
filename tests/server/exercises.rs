//! What a reader does on a page: the files, the progress and the rules of the terminal.

use std::fs;

use cagd::bezier::tableaux;
use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::Exercises;
use serde_json::{Value, json};

use crate::support::{Server, with};

const NAME: &str = "bezier/parabola-point";
const TABLEAU: &str = "bezier/cubic-tableau";
const EXPLANATION: &str = "bezier/blossom-uniqueness";

/// What a page is told about an exercise.
#[track_caller]
fn standing(server: &Server, name: &str) -> Value {
    let line = format!("GET /__workbook/exercises?names={name}");
    let answer = server.ask(&line, &server.reader(), "");
    assert_eq!(answer.status, 200, "{answer:?}");
    let all: Value = serde_json::from_str(&answer.body).expect("it is JSON");
    all[0].clone()
}

/// Does something with an exercise.
#[track_caller]
fn post(server: &Server, name: &str, what: &str, body: &Value) -> Value {
    let line = format!("POST /__workbook/exercise/{name}/{what}");
    let answer = server.ask(&line, &server.reader(), &body.to_string());
    assert_eq!(answer.status, 200, "{answer:?}");
    serde_json::from_str(&answer.body).expect("it is JSON")
}

fn file(server: &Server, name: &str) -> std::path::PathBuf {
    server.answers().join(name)
}

fn exercises() -> Exercises {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let catalogue = Catalogue::load(root).expect("the catalogue loads");
    Exercises::load(root, &[], &catalogue).expect("the exercises load")
}

/// The names of the exercises of a chapter.
fn names(chapter: &str) -> Vec<String> {
    let exercises = exercises();
    let names = exercises.iter().map(|exercise| &exercise.name);
    names
        .filter(|name| name.chapter() == chapter)
        .map(|name| name.name().to_owned())
        .collect()
}

fn solution(name: &str) -> String {
    let exercises = exercises();
    let name = name.parse().expect("a name");
    let exercise = exercises.get(&name).expect("it is in the book");
    let tested = exercise.tested.as_ref().expect("it has tests");
    tested.answer.solution.clone()
}

#[test]
fn nobody_without_the_token_sees_or_changes_an_answer() {
    let server = Server::start();
    let visitor = with(&server.reader(), "Cookie", None);
    let lines = [
        format!("GET /__workbook/exercises?names={NAME}"),
        format!("POST /__workbook/exercise/{NAME}/save"),
        format!("POST /__workbook/exercise/{NAME}/check"),
        format!("POST /__workbook/exercise/{NAME}/reset"),
        format!("POST /__workbook/exercise/{NAME}/solution"),
    ];
    for line in lines {
        let answer = server.ask(&line, &visitor, "{\"text\":\"fn f() {}\"}");
        assert_eq!(answer.status, 403, "{line}: {answer:?}");
    }
    let answer = server.ask("GET /__workbook/state?answers=", &visitor, "");
    assert!(answer.body.contains("\"answers\":null"), "{answer:?}");
    assert!(!server.answers().exists(), "something was written");
    // A name is no path.
    for name in ["../secret", "bezier/..%2f..%2fsecret", "bezier/nothing"] {
        let line = format!("POST /__workbook/exercise/{name}/save");
        let answer = server.ask(&line, &server.reader(), "{\"text\":\"x\"}");
        assert!(matches!(answer.status, 404 | 405), "{name}: {answer:?}");
    }
    assert!(!server.answers().exists(), "something was written");
}

#[test]
fn a_save_that_has_not_seen_the_file_writes_nothing() {
    let server = Server::start();
    let fresh = standing(&server, NAME);
    assert_eq!(fresh["digest"], Value::Null);
    let first = json!({ "text": "// first\n", "base": null });
    let saved = post(&server, NAME, "save", &first);
    assert_eq!(saved["conflict"], false);
    let base = &saved["standing"]["digest"];
    let path = file(&server, "bezier/parabola-point.rs");
    assert_eq!(fs::read_to_string(&path).expect("a file"), "// first\n");

    // Another tab, which has not seen it, and an editor.
    let second = json!({ "text": "// second\n", "base": null });
    let refused = post(&server, NAME, "save", &second);
    assert_eq!(refused["conflict"], true);
    assert_eq!(refused["standing"]["text"], "// first\n");
    fs::write(&path, "// by the editor\n").expect("it is written");
    let stale = json!({ "text": "// third\n", "base": base });
    let refused = post(&server, NAME, "check", &stale);
    assert_eq!(refused["conflict"], true, "{refused}");
    assert_eq!(refused["verdict"], Value::Null, "nothing was checked");
    let there = fs::read_to_string(&path).expect("a file");
    assert_eq!(there, "// by the editor\n");

    // The reader wants his own: what was there is kept.
    let mine = json!({ "text": "// third\n", "base": base, "replace": true });
    let kept = post(&server, NAME, "save", &mine);
    let backup = kept["backup"].as_str().expect("a backup");
    assert!(backup.ends_with("parabola-point.1.rs"), "{backup}");
    let backup = file(&server, "backups/bezier/parabola-point.1.rs");
    assert_eq!(
        fs::read_to_string(backup).expect("a file"),
        "// by the editor\n"
    );
    assert_eq!(fs::read_to_string(&path).expect("a file"), "// third\n");
}

#[test]
fn of_many_tabs_that_save_at_once_one_writes_and_the_others_are_warned() {
    let server = Server::start();
    let first = post(&server, NAME, "save", &json!({ "text": "// first\n" }));
    let base = &first["standing"]["digest"];
    let replies: Vec<(String, Value)> = std::thread::scope(|scope| {
        let tabs: Vec<_> = (0..8)
            .map(|tab| {
                let server = &server;
                scope.spawn(move || {
                    let text = format!("// tab {tab}\n");
                    let body = json!({ "text": text, "base": base });
                    let reply = post(server, NAME, "save", &body);
                    (text, reply)
                })
            })
            .collect();
        tabs.into_iter()
            .map(|tab| tab.join().expect("it ends"))
            .collect()
    });
    let written: Vec<&String> = replies
        .iter()
        .filter(|(_, reply)| reply["conflict"] == false)
        .map(|(text, _)| text)
        .collect();
    assert_eq!(written.len(), 1, "{written:?}");
    let there = fs::read_to_string(file(&server, "bezier/parabola-point.rs"));
    assert_eq!(&there.expect("a file"), written[0]);
}

#[test]
fn a_check_saves_judges_and_remembers() {
    let server = Server::start();
    let page = "<section class=\"practice\" id=\"exercise--bezier--NAME\"></section>";
    let sections: String = names("bezier")
        .iter()
        .map(|name| page.replace("NAME", name))
        .collect();
    fs::write(server.path("bezier/practice.html"), sections).expect("a page");
    let begun = standing(&server, NAME);
    let starter = begun["text"].as_str().expect("a starter");
    let failed = post(&server, NAME, "check", &json!({ "text": starter }));
    assert_eq!(failed["verdict"]["outcome"], "failed", "{failed}");
    let html = failed["html"].as_str().expect("words");
    assert!(
        html.contains("verdict-test") && html.contains("<svg"),
        "{html}"
    );
    assert_eq!(failed["standing"]["checks"], 1);
    assert_eq!(failed["standing"]["solved"], false);

    let base = &failed["standing"]["digest"];
    let right = json!({ "text": solution(NAME), "base": base });
    let passed = post(&server, NAME, "check", &right);
    assert_eq!(passed["verdict"]["outcome"], "passed", "{passed}");
    assert_eq!(passed["standing"]["solved"], true);
    let address = passed["next"]["address"].as_str().expect("an address");
    assert!(
        address.starts_with("bezier/practice.html#exercise--bezier--"),
        "{address}"
    );
    let progress = fs::read_to_string(file(&server, "progress.json")).expect("a file");
    let progress: Value = serde_json::from_str(&progress).expect("it is JSON");
    assert_eq!(progress["begun_last"], NAME);
    assert_eq!(progress["exercises"][NAME]["checks"], 2);

    let base = &passed["standing"]["digest"];
    let broken = json!({ "text": "fn f() -> u8 { nothing }\n", "base": base });
    let broken = post(&server, NAME, "check", &broken);
    assert_eq!(broken["verdict"]["outcome"], "does_not_compile");
    assert!(
        broken["html"]
            .as_str()
            .is_some_and(|html| html.contains("data-line=\"1\""))
    );
    // What was solved stays solved.
    assert_eq!(broken["standing"]["solved"], true);
}

#[test]
fn hints_come_one_at_a_time_and_the_solution_when_asked_twice() {
    let server = Server::start();
    let nothing = json!({});
    for expected in [1, 2] {
        let reply = post(&server, NAME, "hint", &nothing);
        assert_eq!(reply["standing"]["hints"], expected);
    }
    let first = post(&server, NAME, "solution", &nothing);
    assert_eq!(first["solution"]["source"], Value::Null);
    assert_eq!(first["solution"]["hints_left"], 1);
    let second = post(&server, NAME, "solution", &nothing);
    assert_eq!(second["solution"]["source"], solution(NAME));
}

#[test]
fn a_reset_keeps_the_answer() {
    let server = Server::start();
    let line = format!("POST /__workbook/exercise/{NAME}/reset");
    let answer = server.ask(&line, &server.reader(), "{}");
    assert_eq!(answer.status, 422, "{answer:?}");
    post(&server, NAME, "save", &json!({ "text": "// mine\n" }));
    post(&server, NAME, "hint", &json!({}));
    let reply = post(&server, NAME, "reset", &json!({}));
    assert!(reply["backup"].is_string(), "{reply}");
    assert_eq!(reply["standing"]["hints"], 0);
    assert_ne!(reply["standing"]["text"], "// mine\n");
    let backup = file(&server, "backups/bezier/parabola-point.1.rs");
    assert_eq!(fs::read_to_string(backup).expect("a file"), "// mine\n");
}

#[test]
fn a_table_goes_into_the_file_of_the_terminal() {
    let server = Server::start();
    let begun = standing(&server, TABLEAU);
    let facts = begun["tableau"].as_str().expect("a table");
    assert!(facts.contains("cell\t1\t1\tb₀¹\topen\t\t"), "{facts}");
    let deal = tableaux::cubic(0);
    let mut fields = deal.fields(&deal.solved_file()).expect("its own file");

    // What cannot be read is told, and nothing is written.
    let right = std::mem::replace(&mut fields[2][1], "six".to_owned());
    let body = json!({ "fields": &fields, "round": 0 });
    let reply = post(&server, TABLEAU, "check", &body);
    assert_eq!(reply["verdict"], Value::Null);
    assert!(
        reply["tableau"]
            .as_str()
            .is_some_and(|facts| facts.contains("unreadable"))
    );
    let path = file(&server, "bezier/cubic-tableau.rs");
    assert!(!path.exists());

    fields[2][1] = right;
    let body = json!({ "fields": &fields, "round": 0 });
    let reply = post(&server, TABLEAU, "check", &body);
    assert_eq!(reply["verdict"]["outcome"], "passed", "{reply}");
    assert_eq!(
        fs::read_to_string(&path).expect("a file"),
        deal.solved_file()
    );

    let reply = post(&server, TABLEAU, "fresh", &json!({}));
    assert!(reply["backup"].is_string(), "{reply}");
    let facts = reply["standing"]["tableau"].as_str().expect("a table");
    assert!(!facts.contains("round\t0\n"), "{facts}");
}

#[test]
fn an_explanation_is_judged_by_the_reader() {
    let server = Server::start();
    let mine = json!({ "text": "Because of the values at 0 and 1.\n" });
    let compared = post(&server, EXPLANATION, "check", &mine);
    assert_eq!(compared["standing"]["solved"], false);
    assert_eq!(compared["standing"]["may_see_solution"], true);
    let done = post(&server, EXPLANATION, "done", &json!({}));
    assert_eq!(done["standing"]["solved"], true);
    let path = file(&server, "bezier/blossom-uniqueness.md");
    let text = fs::read_to_string(path).expect("a file");
    assert_eq!(text, "Because of the values at 0 and 1.\n");
}

#[test]
fn the_pages_hear_of_a_change_in_the_terminal() {
    let server = Server::start();
    let hear = |heard: &str| -> Value {
        let line = format!("GET /__workbook/state?news=1&answers={heard}");
        let answer = server.ask(&line, &server.reader(), "");
        serde_json::from_str(&answer.body).expect("it is JSON")
    };
    let first = hear("")["answers"].clone();
    let first = first.as_str().expect("a stamp").to_owned();
    post(&server, NAME, "save", &json!({ "text": "// mine\n" }));
    let second = hear(&first)["answers"].clone();
    assert_ne!(second, first.as_str());
}

/// A reader may keep his answers elsewhere, and link to them.
#[test]
fn an_answer_that_is_a_link_stays_one() {
    let server = Server::start();
    let begun = post(&server, NAME, "save", &json!({ "text": "// first\n" }));
    let link = file(&server, "bezier/parabola-point.rs");
    let elsewhere = file(&server, "elsewhere.rs");
    fs::rename(&link, &elsewhere).expect("it is moved");
    std::os::unix::fs::symlink("../elsewhere.rs", &link).expect("a link");
    let base = &begun["standing"]["digest"];
    let saved = post(
        &server,
        NAME,
        "save",
        &json!({ "text": "// second\n", "base": base }),
    );
    assert_eq!(saved["conflict"], false, "{saved}");
    let text = |path: &std::path::Path| fs::read_to_string(path).expect("a file");
    assert!(link.is_symlink());
    assert_eq!(text(&elsewhere), "// second\n");

    // What has to make room is kept, whole and not as a link.
    let mine = json!({ "text": "// third\n", "base": null, "replace": true });
    assert!(post(&server, NAME, "save", &mine)["backup"].is_string());
    let backup = file(&server, "backups/bezier/parabola-point.1.rs");
    assert!(link.is_symlink() && !backup.is_symlink());
    assert_eq!(
        (text(&backup), text(&elsewhere)),
        ("// second\n".into(), "// third\n".into())
    );

    // After a reset there is a new file; the one behind the link is left alone.
    post(&server, NAME, "reset", &json!({}));
    assert!(!link.is_symlink());
    assert_ne!(text(&link), "// third\n");
    let backup = file(&server, "backups/bezier/parabola-point.2.rs");
    assert_eq!(
        (text(&backup), text(&elsewhere)),
        ("// third\n".into(), "// third\n".into())
    );
}

#[test]
fn an_exercise_with_mistakes_is_told_and_leaves_the_others_alone() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let workbook = tempfile::tempdir().expect("a folder");
    let here = workbook.path();
    let folder = here.join("book/exercises/bezier");
    fs::create_dir_all(folder.join("broken")).expect("folders");
    fs::write(folder.join("broken/exercise.md"), "no front matter\n").expect("a file");
    for shared in ["book/statements", "book/exercises/bezier/parabola-point"] {
        std::os::unix::fs::symlink(root.join(shared), here.join(shared)).expect("a link");
    }
    for needed in ["Cargo.toml", "Cargo.lock"] {
        fs::copy(root.join(needed), here.join(needed)).expect("a copy");
    }
    let server = Server::of(here);
    let line = format!("GET /__workbook/exercises?names=bezier/broken,{NAME},bezier/nothing");
    let answer = server.ask(&line, &server.reader(), "");
    assert_eq!(answer.status, 200, "{answer:?}");
    let all: Value = serde_json::from_str(&answer.body).expect("it is JSON");
    let problem = |index: usize| all[index]["problem"].as_str().unwrap_or_default();
    assert_eq!(all[0]["exercise"], "bezier/broken");
    for words in ["has mistakes", "next step", "bezier/broken/exercise.md:1"] {
        assert!(problem(0).contains(words), "{all}");
    }
    assert_eq!(all[1]["digest"], Value::Null, "{all}");
    assert_eq!(all[1]["problem"], Value::Null, "{all}");
    assert!(problem(2).contains("there is no exercise"), "{all}");

    let line = "POST /__workbook/exercise/bezier/broken/save";
    let answer = server.ask(line, &server.reader(), "{\"text\":\"x\"}");
    assert_eq!(answer.status, 422, "{answer:?}");
    assert!(
        answer.body.contains("bezier/broken/exercise.md:1"),
        "{answer:?}"
    );
    let saved = post(&server, NAME, "save", &json!({ "text": "// mine\n" }));
    assert_eq!(saved["conflict"], false, "{saved}");
}
