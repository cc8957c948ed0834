//! The reading order is the import order, and the mathematics knows nothing but mathematics.

use std::path::Path;

use cagd::book::catalogue::CHAPTERS;

use super::paths::{Mention, mentions};
use super::{assert_none, files_below, read};

/// The module of a source file: `src/bezier/laws/shape.rs` is `bezier::laws::shape`.
fn module_of(file: &Path) -> Vec<String> {
    let below_src = file.strip_prefix("src").expect("a source of the library");
    below_src
        .with_extension("")
        .components()
        .map(|part| part.as_os_str().to_string_lossy().into_owned())
        .filter(|name| name != "mod" && name != "lib")
        .collect()
}

/// The library's sources; the entry points in `src/bin` are crates of their own.
fn sources() -> Vec<(Vec<String>, std::path::PathBuf)> {
    files_below("src", "rs")
        .into_iter()
        .filter(|file| !file.starts_with("src/bin"))
        .map(|file| (module_of(&file), file))
        .collect()
}

/// The top-level modules that a module may import, besides its own.
fn may_import(module: &[String]) -> Vec<&'static str> {
    let part = module.get(1).map(String::as_str);
    let mathematics = |chapters: &[&'static str]| {
        let mut allowed = vec!["scalar", "law"];
        allowed.extend_from_slice(chapters);
        match part {
            Some("figures") => allowed.push("figure"),
            // Texts for the pages are written with the book's own notation for numbers and points.
            Some("computed") => allowed.push("book"),
            Some("tableaux") => allowed.push("check"),
            _ => {}
        }
        allowed
    };
    match module.first().map(String::as_str) {
        Some("scalar") => vec![],
        Some("law") => vec!["scalar"],
        Some("check") => vec!["scalar", "law", "affine"],
        // Every chapter draws with it, so it must not look into a chapter that comes after points and vectors.
        Some("figure") => vec!["scalar", "law", "affine"],
        Some("gallery") => [&["figure"], CHAPTERS.as_slice()].concat(),
        Some("live") => vec!["law", "figure", "gallery"],
        Some("tableaux") => [&["check"], CHAPTERS.as_slice()].concat(),
        Some("book") => [
            &["scalar", "law", "check", "tableaux", "figure", "gallery"],
            CHAPTERS.as_slice(),
        ]
        .concat(),
        // Möbius geometry begins anew at affine geometry.
        Some("moebius") => mathematics(&["affine"]),
        Some(chapter) if CHAPTERS.contains(&chapter) => {
            let before = CHAPTERS.iter().take_while(|other| **other != chapter);
            mathematics(&before.copied().collect::<Vec<_>>())
        }
        _ => [
            &[
                "scalar", "law", "check", "tableaux", "figure", "gallery", "live", "book",
                "workbook",
            ],
            CHAPTERS.as_slice(),
        ]
        .concat(),
    }
}

/// The imports of one source that lead where the module must not look.
fn forbidden_imports(module: &[String], source: &str) -> Vec<String> {
    let allowed = may_import(module);
    mentions(source, module)
        .into_iter()
        .filter_map(|mention| match mention.names.as_slice() {
            [root, target, ..] if root == "crate" => Some((target.clone(), mention.line)),
            _ => None,
        })
        .filter(|(target, _)| module.first() != Some(target) && !allowed.contains(&target.as_str()))
        .map(|(target, line)| format!("line {line}: `{}` imports `{target}`", module.join("::")))
        .collect()
}

#[test]
fn a_module_imports_only_what_the_reader_has_already_read() {
    let violations: Vec<String> = sources()
        .iter()
        .flat_map(|(module, file)| {
            forbidden_imports(module, &read(file))
                .into_iter()
                .map(|violation| format!("{}: {violation}", file.display()))
        })
        .collect();
    assert_none(
        &violations,
        "move the code to the later chapter, or what it needs to the earlier one",
    );
}

#[test]
fn an_import_against_the_reading_order_is_found() {
    let module = |path: &str| -> Vec<String> { path.split("::").map(str::to_owned).collect() };
    let bezier = module("bezier::laws::shape");
    assert!(forbidden_imports(&bezier, "use crate::affine::Point;").is_empty());
    assert!(forbidden_imports(&bezier, "use super::super::curve::BezierCurve;").is_empty());
    for (at, source) in [
        (
            "bezier::laws::shape",
            "use crate::{affine::Point, bspline::Knots};",
        ),
        (
            "bezier::laws::shape",
            "fn f() { println!(\"{}\", crate::nurbs::g()); }",
        ),
        ("bezier::curve", "use crate::figure::Canvas;"),
        ("moebius::circle", "use crate::bezier::BezierCurve;"),
        ("figure::canvas", "use super::super::bezier::BezierCurve;"),
        ("scalar", "use crate::law::Sides;"),
        ("book::pages", "use crate::workbook::server;"),
    ] {
        assert_eq!(
            forbidden_imports(&module(at), source).len(),
            1,
            "{at}: {source}"
        );
    }
    let figures = module("bezier::figures::shape");
    assert!(forbidden_imports(&figures, "use crate::figure::Canvas;").is_empty());
}

/// The crates that only features bring in, by the names that code uses.
fn optional_crates() -> Vec<String> {
    let manifest: toml::Table = read("Cargo.toml").parse().expect("Cargo.toml is TOML");
    let dependencies = manifest["dependencies"].as_table().expect("a table");
    dependencies
        .iter()
        .filter(|(_, entry)| entry.get("optional").and_then(toml::Value::as_bool) == Some(true))
        .map(|(name, _)| name.replace('-', "_"))
        .collect()
}

/// The parts of the standard library through which a program sees or changes the world outside.
const WORLD: [&str; 7] = ["env", "fs", "io", "net", "os", "process", "time"];

const PRINTING: [&str; 5] = ["print", "println", "eprint", "eprintln", "dbg"];

/// Whether a module is mathematics: the number types, the laws, the chapters without their figures and texts.
fn is_mathematics(module: &[String]) -> bool {
    let is_chapter = |name: &str| CHAPTERS.contains(&name);
    match module {
        [first] => first == "scalar" || first == "law" || is_chapter(first),
        [first, second, ..] => {
            (first == "scalar" || first == "law" || is_chapter(first))
                && second != "figures"
                && second != "computed"
        }
        [] => false,
    }
}

fn is_worldly(mention: &Mention, optional: &[String]) -> bool {
    match mention.names.as_slice() {
        [name] => mention.is_macro && PRINTING.contains(&name.as_str()),
        [root, part, ..] if root == "std" => {
            WORLD.contains(&part.as_str()) || PRINTING.contains(&part.as_str())
        }
        [root, ..] => optional.contains(root),
        [] => false,
    }
}

/// What a piece of mathematics mentions and must not.
fn worldly_mentions(module: &[String], source: &str, optional: &[String]) -> Vec<String> {
    mentions(source, module)
        .into_iter()
        .filter(|mention| is_worldly(mention, optional))
        .map(|mention| format!("line {}: `{}`", mention.line, mention.names.join("::")))
        .collect()
}

#[test]
fn the_mathematics_knows_no_plotting_no_book_and_no_input_or_output() {
    let optional = optional_crates();
    assert!(optional.contains(&"plotters".to_owned()), "{optional:?}");
    let violations: Vec<String> = sources()
        .iter()
        .filter(|(module, _)| is_mathematics(module))
        .flat_map(|(module, file)| {
            worldly_mentions(module, &read(file), &optional)
                .into_iter()
                .map(|violation| format!("{}: {violation}", file.display()))
        })
        .collect();
    assert_none(
        &violations,
        "the mathematics must run in a browser and inside a learner's answer; move this to figures, book or workbook",
    );
}

#[test]
fn input_and_output_in_the_mathematics_are_found() {
    let module = ["bezier".to_owned(), "curve".to_owned()];
    let optional = ["plotters".to_owned()];
    let found = |source: &str| worldly_mentions(&module, source, &optional).len();
    assert_eq!(found("use std::fmt; fn f() -> std::f64::consts::X { }"), 0);
    assert_eq!(found("use std::{fmt, fs};"), 1);
    assert_eq!(found("fn f() { println!(\"{}\", 1) }"), 1);
    assert_eq!(found("use plotters::prelude::*;"), 1);
    assert!(!is_mathematics(&[
        "bezier".to_owned(),
        "figures".to_owned()
    ]));
    assert!(is_mathematics(&module));
}

#[test]
fn the_map_lists_the_chapters_in_reading_order() {
    let declared: Vec<String> = read("src/lib.rs")
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'))
        .filter(|name| CHAPTERS.contains(name))
        .map(str::to_owned)
        .collect();
    assert_eq!(declared, in_reading_order(&declared));
}

#[test]
fn the_summary_lists_the_chapters_in_reading_order() {
    let mut listed: Vec<String> = Vec::new();
    for link in read("book/src/SUMMARY.md").split("](").skip(1) {
        let folder = link.split('/').next().unwrap_or_default().to_owned();
        if CHAPTERS.contains(&folder.as_str()) && listed.last() != Some(&folder) {
            listed.push(folder);
        }
    }
    assert!(!listed.is_empty(), "the summary links no chapter");
    assert_eq!(listed, in_reading_order(&listed));
}

/// The given chapters, each once, in the order that is fixed for all trees.
fn in_reading_order(chapters: &[String]) -> Vec<String> {
    CHAPTERS
        .iter()
        .filter(|chapter| chapters.iter().any(|listed| listed == *chapter))
        .map(|chapter| (*chapter).to_owned())
        .collect()
}
