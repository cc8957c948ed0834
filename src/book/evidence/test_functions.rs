//! The `#[test]` functions of a test binary, found in its sources.
//!
//! The search begins at `tests/<binary>/main.rs` and follows the `mod` declarations, as the compiler does:
//! a file that no `mod` names is not part of the binary, so its tests are no evidence.

use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::{Attribute, Item, ItemMod};

use super::tokens::{Mention, is_group, is_punct, mentions};
use crate::book::error::{BookError, Place, Problem};

/// One `#[test]` function.
#[derive(Debug, Clone)]
pub struct TestFunction {
    /// The binary: `property`, `exact` or `figures`.
    pub binary: String,
    /// The name that `--list` prints, for instance `bezier::shape::convex_hull`.
    pub path: String,
    /// Where `fn` stands.
    pub place: Place,
    body: Vec<Mention>,
}

impl TestFunction {
    /// The name of the function without its modules.
    pub fn name(&self) -> &str {
        self.path.rsplit("::").next().unwrap_or(&self.path)
    }

    /// Whether the test stands below `tests/<binary>/<chapter>`.
    pub fn is_in_chapter(&self, chapter: &str) -> bool {
        self.path.split("::").next() == Some(chapter)
    }

    /// Whether the body calls `<module>::<function>` (of the given chapter, where it says which).
    pub fn calls(&self, chapter: &str, module: &str, function: &str) -> bool {
        self.body.iter().any(|mention| {
            mention.called
                && match mention.names.as_slice() {
                    [before @ .., parent, name] => {
                        parent == module
                            && name == function
                            && before.last().is_none_or(|found| found == chapter)
                    }
                    _ => false,
                }
        })
    }

    /// Whether the body calls `rejects(…)`, the helper that demands that a wrong implementation falls.
    pub fn rejects_a_mutant(&self) -> bool {
        self.body
            .iter()
            .any(|mention| mention.called && mention.last() == "rejects")
    }
}

/// The tests of `tests/<binary>`, in the order of the sources; none if the folder does not exist.
///
/// A test with `#[ignore]` is left out, since `cargo test` does not run it.
///
/// # Errors
///
/// A source that cannot be read or that is no Rust, and a `mod` without its file.
pub fn tests_of_binary(root: &Path, binary: &str) -> Result<Vec<TestFunction>, BookError> {
    let main = Path::new("tests").join(binary).join("main.rs");
    let mut search = Search {
        root,
        binary,
        found: Vec::new(),
    };
    if root.join(&main).is_file() {
        let folder = Path::new("tests").join(binary);
        search.file(&main, &folder, "")?;
    }
    Ok(search.found)
}

struct Search<'a> {
    root: &'a Path,
    binary: &'a str,
    found: Vec<TestFunction>,
}

impl Search<'_> {
    /// Reads one file; `folder` is where the files of its `mod` declarations stand.
    fn file(&mut self, file: &Path, folder: &Path, module: &str) -> Result<(), BookError> {
        let source = std::fs::read_to_string(self.root.join(file)).map_err(|error| {
            let reason = error.to_string();
            BookError::new(file, 1, Problem::Unreadable { reason })
        })?;
        let parsed = syn::parse_file(&source).map_err(|error| {
            let reason = error.to_string();
            BookError::new(file, error.span().start().line, Problem::Data { reason })
        })?;
        self.items(&parsed.items, file, folder, module)
    }

    fn items(
        &mut self,
        items: &[Item],
        file: &Path,
        folder: &Path,
        module: &str,
    ) -> Result<(), BookError> {
        for item in items {
            match item {
                Item::Fn(function)
                    if is_test(&function.attrs) && !has(&function.attrs, "ignore") =>
                {
                    let body = quote_block(&function.block);
                    let line = function.sig.ident.span().start().line;
                    self.test(module, &function.sig.ident.to_string(), file, line, body);
                }
                Item::Mod(inner) => self.module(inner, file, folder, module)?,
                Item::Macro(call) if call.mac.path.is_ident("proptest") => {
                    self.generated(call.mac.tokens.clone(), file, module);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn module(
        &mut self,
        inner: &ItemMod,
        file: &Path,
        folder: &Path,
        module: &str,
    ) -> Result<(), BookError> {
        let name = inner.ident.to_string();
        let path = join(module, &name);
        if let Some((_, items)) = &inner.content {
            return self.items(items, file, &folder.join(&name), &path);
        }
        if let Some(written) = path_attribute(&inner.attrs) {
            // As for the compiler: relative to the folder of the file that says so.
            let beside = file.parent().unwrap_or(Path::new(""));
            let target = normalised(&beside.join(written));
            let below = target.parent().unwrap_or(Path::new("")).to_path_buf();
            return self.file(&target, &below, &path);
        }
        let below = folder.join(&name);
        let candidates = [folder.join(format!("{name}.rs")), below.join("mod.rs")];
        for candidate in &candidates {
            if self.root.join(candidate).is_file() {
                return self.file(candidate, &below, &path);
            }
        }
        let reason = format!(
            "`mod {name};` has no file; write `{}`",
            candidates[0].display()
        );
        let line = inner.ident.span().start().line;
        Err(BookError::new(file, line, Problem::Evidence { reason }))
    }

    /// The tests that `proptest! { #[test] fn name(input in strategy) { … } }` makes.
    fn generated(&mut self, tokens: TokenStream, file: &Path, module: &str) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut is_test = false;
        let mut ignored = false;
        let mut at = 0;
        while at < tokens.len() {
            if is_punct(&tokens[at], '#') && is_group(tokens.get(at + 1), Delimiter::Bracket) {
                let attribute = tokens[at + 1].to_string();
                let attribute = attribute.trim_matches(['[', ']', ' ']);
                is_test |= attribute == "test";
                ignored |= attribute.starts_with("ignore");
                at += 2;
                continue;
            }
            if let [
                TokenTree::Ident(keyword),
                TokenTree::Ident(name),
                TokenTree::Group(_),
                TokenTree::Group(body),
                ..,
            ] = &tokens[at..]
                && keyword == "fn"
                && body.delimiter() == Delimiter::Brace
            {
                if is_test && !ignored {
                    let line = name.span().start().line;
                    self.test(module, &name.to_string(), file, line, body.stream());
                }
                (is_test, ignored) = (false, false);
                at += 4;
                continue;
            }
            at += 1;
        }
    }

    fn test(&mut self, module: &str, name: &str, file: &Path, line: usize, body: TokenStream) {
        self.found.push(TestFunction {
            binary: self.binary.to_owned(),
            path: join(module, name),
            place: Place::new(file, line),
            body: mentions(body),
        });
    }
}

fn quote_block(block: &syn::Block) -> TokenStream {
    use quote::ToTokens;
    block.to_token_stream()
}

fn is_test(attributes: &[Attribute]) -> bool {
    has(attributes, "test")
}

fn has(attributes: &[Attribute], name: &str) -> bool {
    attributes
        .iter()
        .any(|attribute| attribute.path().is_ident(name))
}

fn path_attribute(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| {
        let syn::Meta::NameValue(pair) = &attribute.meta else {
            return None;
        };
        match &pair.value {
            syn::Expr::Lit(syn::ExprLit {
                lit: syn::Lit::Str(text),
                ..
            }) if pair.path.is_ident("path") => Some(text.value()),
            _ => None,
        }
    })
}

fn join(module: &str, name: &str) -> String {
    if module.is_empty() {
        name.to_owned()
    } else {
        format!("{module}::{name}")
    }
}

/// Resolves `..` without asking the file system, so that places read the same everywhere.
fn normalised(path: &Path) -> PathBuf {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            std::path::Component::ParentDir => {
                parts.pop();
            }
            std::path::Component::CurDir => {}
            other => parts.push(other),
        }
    }
    parts
}
