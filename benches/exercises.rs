//! How long a reader waits: from saving an answer to its verdict, warm.
//!
//! What was measured, and how to read it, is in `README.md` beside this file.

use std::path::Path;
use std::process::Command;
use std::time::Duration;
use std::{fs, hint};

use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::Exercises;
use cagd::workbook::checking::check::Answer;
use cagd::workbook::checking::{Checker, Outcome};
use cagd::workbook::sandbox::Isolation;
use criterion::{Criterion, criterion_group, criterion_main};

fn verdict(c: &mut Criterion) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let catalogue = Catalogue::load(root).expect("the catalogue loads");
    let exercises =
        Exercises::load(root, &[], &catalogue).expect("the exercises follow the schema");
    let name = "bezier/parabola-point".parse().expect("a name");
    let exercise = exercises.get(&name).expect("the exercise is there");
    let tested = exercise.tested.as_ref().expect("it has tests");
    let checker = Checker::new(root, Isolation::best()).expect("the library compiles");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("parabola-point.rs");
    let judge = |checker: &Checker, text: &str, expected: Outcome| {
        fs::write(&file, text).expect("the answer is saved");
        let answer = Answer {
            shown_as: file.display().to_string(),
            text: fs::read_to_string(&file).expect("the answer is there"),
        };
        let verdict = checker.check(exercise, tested, &answer, 1);
        let verdict = verdict.expect("the answer is checked");
        assert_eq!(verdict.outcome, expected);
        hint::black_box(verdict);
    };

    let mut group = c.benchmark_group("from saving to the verdict");
    group
        .sample_size(20)
        .measurement_time(Duration::from_secs(15));
    group.bench_function("right answer, watched", |b| {
        b.iter(|| judge(&checker, &tested.answer.solution, Outcome::Passed));
    });
    group.bench_function("wrong answer, watched", |b| {
        b.iter(|| judge(&checker, &tested.mutants[0].text, Outcome::Failed));
    });
    // A command of its own is a new process, which reads the exercises and looks after the library first.
    let answers = folder.path().join("answers");
    let workbook = |arguments: &[&str]| {
        let run = Command::new(env!("CARGO_BIN_EXE_workbook"))
            .args(arguments)
            .arg("--answers")
            .arg(&answers)
            .current_dir(root)
            .output();
        run.expect("the workbook starts")
    };
    workbook(&["start", "bezier/parabola-point"]);
    let answer = answers.join("bezier/parabola-point.rs");
    fs::write(&answer, &tested.mutants[0].text).expect("the answer is saved");
    group.bench_function("wrong answer, new command", |b| {
        b.iter(|| {
            let run = workbook(&["check", "bezier/parabola-point", "--json"]);
            assert_eq!(run.status.code(), Some(1), "{run:?}");
        });
    });
    group.finish();

    let block = "use cagd::affine::Point;\n\
         use cagd::bezier::BezierCurve;\n\
         let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;\n\
         println!(\"{:?}\", curve.at(0.5)[1]);\n\
         Ok::<(), cagd::bezier::BezierError>(())";
    let mut group = c.benchmark_group("from Run to the output");
    group
        .sample_size(20)
        .measurement_time(Duration::from_secs(10));
    group.bench_function("an example of a page", |b| {
        b.iter(|| {
            let run = checker.run_example(block).expect("the example is run");
            assert_eq!(run.output, "1.0\n");
            hint::black_box(run);
        });
    });
    group.finish();
}

criterion_group!(benches, verdict);
criterion_main!(benches);
