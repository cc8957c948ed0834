//! What the built pages hold: statements, figures, formulas, links that lead somewhere, nothing from outside.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use cagd::book::catalogue::Catalogue;
use cagd::book::manuscript::Manuscript;

use crate::fixture::{Fixture, files_below, the_book};

/// The values of an attribute in a page, in order.
fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
    html.split(&format!(" {attribute}=\""))
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect()
}

#[test]
fn a_statement_has_its_id_kind_number_title_and_sources() {
    let html =
        Fixture::new("# P\n\n{{#statement bezier-hull}}\nIt lies in it.\n{{/statement}}\n").page();
    assert!(
        html.contains("<section id=\"bezier-hull\" class=\"theorem\" data-evidence=\""),
        "{html}"
    );
    for part in [
        "Theorem\u{a0}4.1",
        "Convex hull property",
        "Compendium Theorem 8",
        "href=\"#bezier-hull\"",
    ] {
        assert!(html.contains(part), "{part} is missing in {html}");
    }
}

#[test]
fn an_example_is_evidence_and_links_to_its_block() {
    let page =
        "# P\n\n{{#statement bezier-hull}}\nSo.\n\n```rust\nassert!(true);\n```\n{{/statement}}\n";
    let html = Fixture::new(page).page();
    assert!(html.contains("data-evidence=\"example\""), "{html}");
    assert!(
        html.contains("<a href=\"#bezier-hull--code-3\">example</a>"),
        "{html}"
    );
    assert!(html.contains("id=\"bezier-hull--code-3\""), "{html}");
}

#[test]
fn a_proof_is_open_and_ends_in_its_mark() {
    let page =
        "# P\n\n{{#statement bezier-hull}}\nA.\n{{#proof}}\nClear.\n{{/proof}}\n{{/statement}}\n";
    let html = Fixture::new(page).page();
    assert!(
        html.contains("<details class=\"proof\" id=\"bezier-hull--proof\" open=\"\">"),
        "{html}"
    );
    assert!(
        html.contains("∎</span></p>"),
        "the mark stands in the last sentence: {html}"
    );
}

#[test]
fn references_give_number_and_title_or_say_that_it_is_to_come() {
    let page = "# P\n\n{{#statement bezier-hull}}\nA.\n{{/statement}}\n\n\
                By {{#ref bezier-hull}}, by {{#ref bezier-hull number}} and {{#ref bezier-later}}.\n";
    let html = Fixture::new(page).page();
    assert!(
        html.contains(
            "Theorem\u{a0}4.1 <span class=\"ref-title\">(Convex hull property)</span></a>"
        ),
        "{html}"
    );
    assert!(
        html.contains("title=\"Convex hull property\">Theorem\u{a0}4.1</a>"),
        "{html}"
    );
    assert!(
        html.contains("Lemma “A lemma for later” <small>(to come)</small>"),
        "{html}"
    );
}

#[test]
fn a_figure_has_a_number_and_a_caption() {
    let html = Fixture::new("# P\n\nText.\n{{#figure bezier-picture}}\nMore.\n").page();
    assert!(
        html.contains("<figure class=\"drawing\" id=\"figure-bezier-picture\">"),
        "{html}"
    );
    assert!(
        html.contains("Figure\u{a0}4.1</a> <span class=\"title\">A picture.</span>"),
        "{html}"
    );
    assert!(html.contains("<path d=\"M0 0L1 1\""), "{html}");
    assert!(html.contains("<p>More.</p>"), "{html}");
}

#[test]
fn formulas_become_mathml_that_markdown_has_not_touched() {
    let page = "# P\n\nWith $b_i^*$ and $c_i^*$, *so* $\\{a_1\\}$:\n\n```math\nx \\\\ y\n```\n\n- in a list:\n\n  ```math\n  z\n  ```\n\n  more\n";
    let html = Fixture::new(page).page();
    assert!(!html.contains('$'), "{html}");
    assert_eq!(
        html.matches("<em>").count(),
        1,
        "only `so` is emphasised: {html}"
    );
    assert_eq!(html.matches("<math").count(), 5);
    assert_eq!(
        html.matches("<div class=\"formula\"><math display=\"block\">")
            .count(),
        2
    );
    let list = html
        .split("<ul>")
        .nth(1)
        .and_then(|rest| rest.split("</ul>").next());
    assert!(
        list.is_some_and(|list| list.contains("formula") && list.contains("more")),
        "{html}"
    );
}

#[test]
fn the_signs_that_touch_a_formula_stay_on_its_line() {
    let page =
        "# P\n\nSo ($a$), the $b$-th, $h$-dimensional ($c$ and $d$) **$e$.** But $f$ (*g*).\n";
    let html = Fixture::new(page).page();
    let math = |letter| format!("<math><mi>{letter}</mi></math>");
    let bound = |text: String| format!("<span class=\"bound\">{text}</span>");
    let sentence = format!(
        "So {} the {}, {}dimensional {} and {} <strong>{}</strong> But {} (<em>g</em>).",
        bound(format!("({}),", math('a'))),
        bound(format!("{}-th", math('b'))),
        bound(format!("{}-", math('h'))),
        bound(format!("({}", math('c'))),
        bound(format!("{})", math('d'))),
        bound(format!("{}.", math('e'))),
        math('f'),
    );
    assert!(html.contains(&sentence), "{sentence}\n{html}");
}

#[test]
fn computed_texts_stand_in_sentences_and_in_formulas() {
    let html = Fixture::new(
        "# P\n\nIt is {{#computed bezier half}}, so $x = {{#computed bezier half}}$.\n",
    )
    .page();
    assert_eq!(
        html.matches("<mfrac><mn>1</mn><mn>2</mn></mfrac>").count(),
        2,
        "{html}"
    );
}

#[test]
fn a_listing_shows_the_item_and_links_to_its_source_page() {
    let fixture = Fixture::new("# P\n\n{{#listing src/lib.rs next}}\n");
    let (folder, report) = fixture.build_into("site");
    assert!(report.is_ok());
    let read = |path: &str| std::fs::read_to_string(folder.path().join("site").join(path));
    let page = read("bezier/page.html").expect("the page is built");
    assert!(
        page.contains("/// Adds one.\npub fn next(n: u8) -&gt; u8 {"),
        "{page}"
    );
    assert!(
        page.contains("href=\"../source/src/lib.rs.html#L1\""),
        "{page}"
    );
    let source = read("source/src/lib.rs.html").expect("the source page is built");
    assert!(source.contains("id=\"L1\""), "{source}");
    assert!(
        source.contains("/// More."),
        "the source page shows the whole file"
    );
}

#[test]
fn errata_are_collected_with_their_counterexample() {
    let page = "# P\n\n{{#statement bezier-hull}}\nA.\n{{#errata}}\nThe notes forget $n = 0$.\n\n```rust\nassert_ne!(1, 2);\n```\n{{/errata}}\n{{/statement}}\n";
    let (folder, report) = Fixture::new(page).build_into("site");
    assert!(report.is_ok());
    let errata = std::fs::read_to_string(folder.path().join("site/errata.html"));
    let errata = errata.expect("the page is built");
    assert!(errata.contains("The notes forget"), "{errata}");
    assert!(errata.contains("assert_ne!(1, 2);"), "{errata}");
    assert!(
        errata.contains("href=\"bezier/page.html#bezier-hull--errata\""),
        "{errata}"
    );
}

/// Each statement that is written has its id at the element that states it.
#[test]
fn every_written_statement_has_its_id() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let catalogue = Catalogue::load(root).expect("the catalogue loads");
    let mut errors = Vec::new();
    let manuscript = Manuscript::load(root, &catalogue, &mut errors);
    assert_eq!(errors, []);
    for (id, written) in &manuscript.statements {
        let file = &manuscript.pages[written.page].file;
        let page = file
            .strip_prefix("book/src")
            .expect("pages stand there")
            .with_extension("html");
        let html = std::fs::read_to_string(the_book().join(page)).expect("the page is built");
        let statement = catalogue.get(id).expect("the catalogue lists it");
        let section = format!(
            "<section id=\"{id}\" class=\"{}\" data-evidence=\"",
            statement.kind
        );
        assert_eq!(html.matches(&section).count(), 1, "{id}");
    }
}

/// Links between pages, anchors included, lead somewhere; no anchor exists twice in a page.
#[test]
fn every_link_leads_somewhere() {
    let site = the_book();
    let mut anchors: BTreeMap<PathBuf, BTreeSet<String>> = BTreeMap::new();
    let mut pages = BTreeMap::new();
    for path in files_below(site, "html") {
        let html = std::fs::read_to_string(site.join(&path)).expect("the page is read");
        let mut ids = BTreeSet::new();
        for id in values(&html, "id") {
            assert!(
                ids.insert(id.to_owned()),
                "{} has {id} twice",
                path.display()
            );
        }
        anchors.insert(path.clone(), ids);
        pages.insert(path, html);
    }
    let mut broken = Vec::new();
    for (path, html) in &pages {
        // The page for what is not found speaks of the top of a server.
        if path == Path::new("404.html") {
            continue;
        }
        for href in values(html, "href")
            .into_iter()
            .filter(|href| !href.contains(':'))
        {
            let (file, anchor) = href.split_once('#').unwrap_or((href, ""));
            let target = match file {
                "" => path.clone(),
                file => normal(&path.parent().unwrap_or(Path::new("")).join(file)),
            };
            let leads = match anchors.get(&target) {
                Some(ids) => anchor.is_empty() || ids.contains(anchor),
                None => site.join(&target).is_file(),
            };
            if !leads {
                broken.push(format!("{} → {href}", path.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// A path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                normal.pop();
            }
            other => normal.push(other),
        }
    }
    normal
}

/// Reading asks nothing of the outside: no page loads from another host, and none has a block that would ask for one.
#[test]
fn nothing_is_fetched_from_outside() {
    let site = the_book();
    for path in files_below(site, "html") {
        let html = std::fs::read_to_string(site.join(&path)).expect("the page is read");
        let loads = values(&html, "src")
            .into_iter()
            .chain(html.split("<link ").skip(1).flat_map(|link| {
                let tag = link.split('>').next().unwrap_or_default();
                tag.split("href=\"")
                    .skip(1)
                    .filter_map(|rest| rest.split('"').next())
            }));
        for address in loads {
            assert!(
                !address.contains("//"),
                "{} loads {address}",
                path.display()
            );
        }
        assert!(
            !html.contains("class=\"playground\""),
            "{} has a run button",
            path.display()
        );
    }
    for path in files_below(site, "css") {
        let css = std::fs::read_to_string(site.join(&path)).expect("the style is read");
        assert!(
            !css.contains("url(http") && !css.contains("url('http") && !css.contains("@import"),
            "{}",
            path.display()
        );
    }
}

/// The font of the formulas is part of the site, and small.
#[test]
fn the_fonts_are_bundled_with_their_licence() {
    let fonts: Vec<PathBuf> = files_below(&the_book().join("fonts"), "");
    let size = |part: &str| {
        let font = fonts
            .iter()
            .find(|font| font.to_string_lossy().contains(part));
        let font = font.unwrap_or_else(|| panic!("no font file {part} in {fonts:?}"));
        std::fs::metadata(the_book().join("fonts").join(font))
            .expect("the file is there")
            .len()
    };
    assert!(size("pagella-math") <= 300_000);
    assert!(size("GUST-FONT-LICENSE") > 0);
}
