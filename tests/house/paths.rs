//! The paths that a Rust source mentions, with `use` groups written out and `super` resolved.
//!
//! They are read from the tokens, so that what stands inside macros counts too.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// One path of a source.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Mention {
    /// The names; a path of our own crate begins with `crate`.
    pub(crate) names: Vec<String>,
    /// Whether `!` follows, as in a macro call.
    pub(crate) is_macro: bool,
    /// The line, counted from 1.
    pub(crate) line: usize,
}

/// All paths of `source`, the text of the module `module` (empty for the crate's root).
pub(crate) fn mentions(source: &str, module: &[String]) -> Vec<Mention> {
    let tokens: TokenStream = source
        .parse()
        .unwrap_or_else(|error| panic!("{} is no Rust: {error}", module.join("::")));
    let mut found = Vec::new();
    collect(tokens, module, &mut found);
    found
}

fn collect(tokens: TokenStream, module: &[String], found: &mut Vec<Mention>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at..] {
            [
                TokenTree::Ident(word),
                TokenTree::Ident(name),
                TokenTree::Group(body),
                ..,
            ] if word == "mod" => {
                let inner = [module, &[name.to_string()]].concat();
                collect(body.stream(), &inner, found);
                at += 3;
            }
            [TokenTree::Ident(_), ..] => at = path(&tokens, at, &[], module, found),
            [TokenTree::Group(group), ..] => {
                collect(group.stream(), module, found);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Reads the path that begins at `start`, after `prefix`, and returns the position behind it.
fn path(
    tokens: &[TokenTree],
    start: usize,
    prefix: &[String],
    module: &[String],
    found: &mut Vec<Mention>,
) -> usize {
    let line = tokens[start].span().start().line;
    let mut names = prefix.to_vec();
    names.push(tokens[start].to_string());
    let mut at = start + 1;
    while is_punct(tokens.get(at), ':') && is_punct(tokens.get(at + 1), ':') {
        match tokens.get(at + 2) {
            Some(TokenTree::Ident(name)) => {
                names.push(name.to_string());
                at += 3;
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                use_group(group.stream(), &names, module, found);
                return at + 3;
            }
            _ => break,
        }
    }
    let is_macro = is_punct(tokens.get(at), '!') && !is_punct(tokens.get(at + 1), '=');
    found.push(Mention {
        names: resolved(names, module),
        is_macro,
        line,
    });
    at
}

/// The members of `prefix::{…}`.
fn use_group(tokens: TokenStream, prefix: &[String], module: &[String], found: &mut Vec<Mention>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        at = match &tokens[at] {
            TokenTree::Ident(_) => path(&tokens, at, prefix, module, found),
            TokenTree::Punct(star) if star.as_char() == '*' => {
                found.push(Mention {
                    names: resolved(prefix.to_vec(), module),
                    is_macro: false,
                    line: star.span().start().line,
                });
                at + 1
            }
            _ => at + 1,
        };
    }
}

/// The names with leading `self` and `super` replaced by the path from the crate's root.
fn resolved(names: Vec<String>, module: &[String]) -> Vec<String> {
    let supers = names.iter().take_while(|name| *name == "super").count();
    let (skip, keep) = match names.first().map(String::as_str) {
        Some("self") if names.len() > 1 => (1, module.len()),
        Some("super") => (supers, module.len().saturating_sub(supers)),
        _ => return names,
    };
    let mut path = vec!["crate".to_owned()];
    path.extend_from_slice(&module[..keep]);
    path.extend_from_slice(&names[skip..]);
    path
}

fn is_punct(token: Option<&TokenTree>, character: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == character)
}

#[test]
fn groups_are_written_out_and_supers_resolved() {
    let module = ["bezier".to_owned(), "laws".to_owned()];
    let source = "use crate::{affine::{Point, Vector}, scalar::*};\n\
                  mod tests { use super::super::curve::BezierCurve; }\n\
                  fn f() { println!(\"{}\", std::f64::consts::PI != 3.0); }";
    let found: Vec<(String, bool, usize)> = mentions(source, &module)
        .into_iter()
        .map(|mention| (mention.names.join("::"), mention.is_macro, mention.line))
        .collect();
    for expected in [
        ("crate::affine::Point", false, 1),
        ("crate::affine::Vector", false, 1),
        ("crate::scalar", false, 1),
        ("crate::bezier::curve::BezierCurve", false, 2),
        ("println", true, 3),
        ("std::f64::consts::PI", false, 3),
    ] {
        let expected = (expected.0.to_owned(), expected.1, expected.2);
        assert!(
            found.contains(&expected),
            "{expected:?} is not in {found:?}"
        );
    }
}
