//! Bad input: each mistake is told with file, line and remedy, and all mistakes at once.

use crate::fixture::Fixture;

/// The file of the fixture's page.
const PAGE: &str = "book/src/bezier/page.md";

/// Asserts that a page with this text has one error, in this line, whose message has these words.
#[track_caller]
fn refused(page: &str, line: usize, words: &str) {
    let errors = Fixture::new(page).errors();
    assert_eq!(errors.len(), 1, "{errors:#?}");
    told(&errors[0], PAGE, line, words);
}

/// Asserts that an error names file and line and has these words.
#[track_caller]
fn told(error: &str, file: &str, line: usize, words: &str) {
    assert!(error.starts_with(&format!("{file}:{line}: ")), "{error}");
    assert!(error.contains(words), "{error}");
}

#[test]
fn a_statement_that_is_stated_twice() {
    let page = "# P\n\n{{#statement bezier-hull}}\nA.\n{{/statement}}\n\n{{#statement bezier-hull}}\nB.\n{{/statement}}\n";
    refused(page, 7, "already stated at book/src/bezier/page.md:3");
}

#[test]
fn a_statement_that_is_listed_twice() {
    let list = "[[statement]]\nid = \"bezier-hull\"\nkind = \"lemma\"\ntitle = \"T\"\nsources = []\nneeds = []\n";
    let errors = Fixture::new("# P\n")
        .with_file("book/statements/bezier.toml", &list.repeat(2))
        .errors();
    told(
        &errors[0],
        "book/statements/bezier.toml",
        8,
        "already listed at book/statements/bezier.toml:2",
    );
}

#[test]
fn a_statement_or_reference_that_no_catalogue_lists() {
    refused(
        "# P\n\nSee {{#ref bezier-hul}}.\n",
        3,
        "did you mean `bezier-hull`?",
    );
    refused(
        "# P\n\n{{#statement bezier-none}}\n{{/statement}}\n",
        3,
        "no catalogue",
    );
}

#[test]
fn a_figure_that_nobody_draws() {
    refused(
        "# P\n\n{{#figure bezier-pictur}}\n",
        3,
        "did you mean `bezier-picture`?",
    );
}

#[test]
fn a_figure_without_a_description_or_a_title() {
    let errors = Fixture::new("# P\n\n{{#figure bezier-mute}}\n")
        .with_figure("bezier-mute", "Title", "  ")
        .errors();
    told(&errors[0], PAGE, 3, "no description");
    let errors = Fixture::new("# P\n\n{{#figure bezier-mute}}\n")
        .with_figure("bezier-mute", "", "Description.")
        .errors();
    told(&errors[0], PAGE, 3, "no title");
}

#[test]
fn a_formula_that_does_not_parse() {
    refused(
        "# P\n\nSo\n$\\frac{1}$.\n",
        4,
        "the formula `\\frac{1}` does not parse",
    );
    refused("# P\n\n```math\n\\nonsense x\n```\n", 3, "does not parse");
}

#[test]
fn dollar_signs_that_belong_to_no_formula() {
    refused("# P\n\n$$x$$\n", 3, "```math fence");
    refused("# P\n\nIt costs $ 5.\n", 3, "write `\\$`");
}

#[test]
fn a_listing_without_its_file_or_item() {
    refused(
        "# P\n\n{{#listing src/none.rs next}}\n",
        3,
        "cannot be read",
    );
    refused(
        "# P\n\n{{#listing src/lib.rs nxt}}\n",
        3,
        "did you mean `next`?",
    );
}

#[test]
fn a_page_that_the_table_of_contents_lists_and_nobody_wrote() {
    let errors = Fixture::new("# P\n")
        .with_file(
            "book/src/SUMMARY.md",
            "# Summary\n\n- [P](bezier/page.md)\n- [Q](bezier/none.md)\n",
        )
        .errors();
    told(&errors[0], "book/src/SUMMARY.md", 4, "none.md");
}

#[test]
fn mdbooks_own_include() {
    refused(
        "# P\n\n{{#include other.md}}\n",
        3,
        "there is no directive `#include`",
    );
}

#[test]
fn citations_terms_and_computed_texts_that_are_unknown() {
    refused(
        "# P\n\nSee {{#cite farin2022 §3}}.\n",
        3,
        "did you mean `farin2002`?",
    );
    refused(
        "# P\n\nThe {{#term blosom}}.\n",
        3,
        "did you mean `blossom`?",
    );
    refused(
        "# P\n\nIt is {{#computed bezier hlf}}.\n",
        3,
        "did you mean `half`?",
    );
    refused(
        "# P\n\nIt is ${{#computed bezier third}}$.\n",
        3,
        "computes no `third`",
    );
}

#[test]
fn directives_that_are_not_closed_or_not_opened() {
    refused("# P\n\n{{#statement bezier-hull}}\nA.\n", 3, "never closed");
    refused(
        "# P\n\n{{#statement bezier-hull}}\n{{#proof}}\n{{/statement}}\n",
        4,
        "write `{{/proof}}`",
    );
    refused("# P\n\n{{/statement}}\n", 3, "closes nothing");
    refused("# P\n\nSee {{#ref bezier-hull\n", 3, "no `}}` closes");
    refused("# P\n\n{{#proof}}\n{{/proof}}\n", 3, "it belongs between");
}

#[test]
fn a_block_directive_in_the_middle_of_a_line() {
    refused(
        "# P\n\nA {{#figure bezier-picture}}\n",
        3,
        "on a line of its own",
    );
}

#[test]
fn code_that_would_pass_unrun() {
    for (fence, words) in [
        ("```\nx\n```", "untagged"),
        ("    x", "indented"),
        ("```rust,ignore\nx\n```", "neither compiled nor run"),
        ("```rust,no_run\nx\n```", "never run"),
        ("```rust\n#[test]\nfn f() {}\n```", "never called"),
        ("```rust,compile_fail\nx\n```", "add the error code"),
        ("```rust,should_panic\npanic!();\n```", "say why"),
    ] {
        refused(&format!("# P\n\nText.\n\n{fence}\n"), 5, words);
    }
}

#[test]
fn a_data_file_that_does_not_parse() {
    let errors = Fixture::new("# P\n")
        .with_file("book/glossary.toml", "[a]\nenglish = \"a\"\n\n[b\n")
        .errors();
    told(
        &errors[0],
        "book/glossary.toml",
        4,
        "this is not what the file should hold",
    );
}

#[test]
fn all_errors_of_a_book_come_at_once_in_order() {
    let page = "# P\n\n{{#ref bezier-none}}\n\n$\\frac{1}$\n\n```\nx\n```\n\n{{#figure none}}\n\n{{#cite nobody}}\n";
    let errors = Fixture::new(page)
        .with_file("book/glossary.toml", "[a]\n")
        .errors();
    let lines: Vec<&str> = errors
        .iter()
        .map(|error| error.split(": ").next().unwrap_or_default())
        .collect();
    let page = |line: usize| format!("{PAGE}:{line}");
    assert_eq!(lines[0], "book/glossary.toml:1");
    assert_eq!(lines[1..], [page(3), page(5), page(7), page(11), page(13)]);
}
