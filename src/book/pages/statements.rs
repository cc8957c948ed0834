//! The index of all statements, to be searched by words, chapter and kind.

use super::{Generated, table};
use crate::book::catalogue::{CHAPTERS, Kind, Statement};
use crate::book::site::{Site, escape, title_html};

/// The index: one row for each statement of the catalogue, those to come included.
pub(super) fn page(site: &Site<'_>) -> Generated {
    let total = site.catalogue.statements().len();
    let written = site.manuscript.statements.len();
    let mut content = format!(
        "# Index of statements\n\n\
         All {total} statements of the workbook; {written} of them are written.\n\
         Chapters that have begun come first, then those to come in the order of the lecture notes.\n\n"
    );
    content.push_str(&filter());
    let mut rows = Vec::new();
    let mut html = String::new();
    let (begun, to_come): (Vec<&str>, Vec<&str>) = CHAPTERS
        .into_iter()
        .partition(|chapter| in_order(site, chapter).iter().any(|s| is_written(site, s)));
    for chapter in begun.into_iter().chain(to_come) {
        rows.clear();
        let statements = in_order(site, chapter);
        for statement in &statements {
            let name = match site.manuscript.statements.get(&statement.id) {
                Some(written) => format!(
                    "<a href=\"{}#{}\">{}</a>",
                    site.address(written.page),
                    statement.id,
                    site.numbered(statement, written)
                ),
                None => format!(
                    "<span class=\"to-come\">{} <small>(to come)</small></span>",
                    statement.kind.title()
                ),
            };
            rows.push(vec![
                name,
                title_html(&statement.title),
                escape(&statement.sources.join("; ")),
            ]);
        }
        if rows.is_empty() {
            continue;
        }
        let mut part = table("statements", &["Statement", "Title", "In the notes"], &rows);
        // Each row says what it is, for the filter.
        for statement in &statements {
            let row = format!("<tr data-kind=\"{}\">", statement.kind);
            part = part.replacen("<tr><td>", &format!("{row}<td>"), 1);
        }
        let title = chapter_title(chapter);
        html.push_str(&format!(
            "<section class=\"index-chapter\" data-chapter=\"{chapter}\">\n<h2 id=\"{chapter}\">{title}</h2>\n{part}</section>\n\n"
        ));
    }
    content.push_str(&html);
    Generated::new("Index of statements", "statements.md", content)
}

/// Whether a statement is written.
fn is_written(site: &Site<'_>, statement: &Statement) -> bool {
    site.manuscript.statements.contains_key(&statement.id)
}

/// The statements of a chapter: those that are written in their order, then the others.
fn in_order<'a>(site: &'a Site<'_>, chapter: &'a str) -> Vec<&'a Statement> {
    let mut statements: Vec<&Statement> = site.catalogue.chapter(chapter).collect();
    statements.sort_by_key(|statement| {
        let written = site.manuscript.statements.get(&statement.id);
        written.map_or((usize::MAX, 0), |written| (written.page, written.offset))
    });
    statements
}

/// The controls of the filter; a script shows them, since without it they do nothing.
fn filter() -> String {
    let mut chapters = String::new();
    for chapter in CHAPTERS {
        let title = chapter_title(chapter);
        chapters.push_str(&format!("<option value=\"{chapter}\">{title}</option>"));
    }
    let mut kinds = String::new();
    for kind in Kind::ALL {
        kinds.push_str(&format!(
            "<option value=\"{kind}\">{}</option>",
            kind.title()
        ));
    }
    format!(
        "<form id=\"statement-filter\" class=\"filter\" hidden=\"hidden\">\n\
         <label>Words <input type=\"search\" name=\"words\" placeholder=\"convex hull, Theorem 8\" /></label>\n\
         <label>Chapter <select name=\"chapter\"><option value=\"\">all</option>{chapters}</select></label>\n\
         <label>Kind <select name=\"kind\"><option value=\"\">all</option>{kinds}</select></label>\n\
         <output name=\"count\"></output>\n\
         </form>\n\n"
    )
}

/// What a chapter is called.
pub(super) fn chapter_title(chapter: &str) -> &str {
    match chapter {
        "affine" => "Affine geometry",
        "curves" => "Curves",
        "interpolation" => "Interpolation",
        "bezier" => "Bézier curves",
        "bspline" => "B-splines",
        "nurbs" => "NURBS",
        "surfaces" => "Surfaces",
        "subdivision" => "Subdivision",
        "moebius" => "Möbius geometry",
        other => other,
    }
}
