//! What refuses code blocks that `cargo test` would pass without running them.

use super::error::{BookError, Problem};
use super::page::{CodeBlock, Page};

/// Adds to `errors` each block of the page that would be unrun, or run without being meant to.
pub fn check(page: &Page, errors: &mut Vec<BookError>) {
    for block in &page.code {
        if let Some((what, remedy)) = fault(block) {
            let problem = Problem::Unrun { what, remedy };
            errors.push(BookError::new(&page.file, block.line, problem));
        }
    }
}

/// What is wrong with a block, and what to write instead.
fn fault(block: &CodeBlock) -> Option<(String, &'static str)> {
    let Some(info) = &block.info else {
        return Some((
            "an indented code block counts as Rust".to_owned(),
            "write a fence and tag it, as `rust` or as `text`",
        ));
    };
    if info.trim().is_empty() {
        return Some((
            "an untagged code block counts as Rust".to_owned(),
            "tag its fence, as `rust` or as `text`",
        ));
    }
    if !block.is_rust() {
        let counts = block.tags().find(|tag| {
            matches!(
                *tag,
                "ignore" | "no_run" | "should_panic" | "compile_fail" | "test_harness"
            ) || tag.starts_with("edition")
        });
        return counts.map(|tag| {
            (
                format!("a code block tagged `{tag}` alone counts as Rust"),
                "say so: tag it `rust` as well",
            )
        });
    }
    for tag in block.tags() {
        match tag {
            "no_run" => {
                return Some((
                    "a block tagged `no_run` is compiled and never run".to_owned(),
                    "take the tag out, or show it as `text`",
                ));
            }
            "test_harness" => {
                return Some((
                    "a block tagged `test_harness` runs tests only, and none if it has none"
                        .to_owned(),
                    "take the tag out and assert in the block itself",
                ));
            }
            tag if tag.starts_with("ignore") => {
                return Some((
                    format!("a block tagged `{tag}` is neither compiled nor run"),
                    "take the tag out, or show it as `text`",
                ));
            }
            _ => {}
        }
    }
    if block.tags().any(|tag| tag == "compile_fail") && block.compile_fail().is_none() {
        return Some((
            "a block tagged `compile_fail` passes on any error, a misspelt name included"
                .to_owned(),
            "add the error code: `rust,compile_fail,E0277`",
        ));
    }
    if block.tags().any(|tag| tag == "should_panic")
        && !block
            .code
            .lines()
            .any(|line| line.trim_start().starts_with("// Panics:"))
    {
        return Some((
            "a block tagged `should_panic` passes on any panic".to_owned(),
            "say why it panics in a line `// Panics: …`",
        ));
    }
    if block.code.contains("#[test]") {
        return Some((
            "a function marked `#[test]` inside a block is never called".to_owned(),
            "assert in the block itself",
        ));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The messages about a page with this text.
    fn faults(text: &str) -> Vec<String> {
        let mut errors = Vec::new();
        let page = Page::parse("book/src/bezier/x.md", text, &mut errors);
        check(&page, &mut errors);
        errors.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn what_runs_and_what_is_no_rust_passes() {
        let good = "```rust\nassert!(true);\n```\n\n```text\nx\n```\n\n```math\nx\n```\n\n\
                    ```rust,compile_fail,E0369\nlet x = ();\n```\n\n\
                    ```rust,should_panic\n// Panics: the index is out of range.\n[0][1];\n```\n";
        assert_eq!(faults(good), [""; 0]);
    }

    #[test]
    fn what_would_pass_unrun_is_refused_with_its_line() {
        for block in [
            "```\nx\n```\n",
            "    x\n",
            "```rust,ignore\nx\n```\n",
            "```rust,no_run\nx\n```\n",
            "```no_run\nx\n```\n",
            "```rust\n#[test]\nfn x() {}\n```\n",
            "```rust,compile_fail\nx\n```\n",
            "```rust,should_panic\nx\n```\n",
            "```rust,test_harness\nx\n```\n",
        ] {
            let faults = faults(&format!("Text.\n\n{block}"));
            assert_eq!(faults.len(), 1, "{block}: {faults:?}");
            assert!(
                faults[0].starts_with("book/src/bezier/x.md:3: "),
                "{faults:?}"
            );
        }
    }
}
