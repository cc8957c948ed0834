//! Each page with Rust blocks is part of the crate's documentation tests, so that its blocks run.

use std::path::Path;

use cagd::book::catalogue::Catalogue;
use cagd::book::manuscript::Manuscript;

#[test]
fn every_page_with_rust_blocks_is_run_by_cargo_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let catalogue = Catalogue::load(root).expect("the catalogue loads");
    let mut errors = Vec::new();
    let manuscript = Manuscript::load(root, &catalogue, &mut errors);
    assert_eq!(errors, []);
    for page in &manuscript.pages {
        if !page.code.iter().any(|block| block.is_rust()) {
            continue;
        }
        let chapter = page.chapter.unwrap_or_else(|| {
            panic!(
                "{} has Rust blocks; move them to a chapter, whose pages run",
                page.file.display()
            )
        });
        let module = format!("src/{chapter}/mod.rs");
        let source = std::fs::read_to_string(root.join(&module)).expect("the chapter has a module");
        let path = format!("include_str!(\"../../{}\")", page.file.display());
        assert!(
            source.contains(&path),
            "{} has Rust blocks which nobody runs; add `#[doc = {path}]` to `mod chapter` in {module}",
            page.file.display()
        );
    }
}
