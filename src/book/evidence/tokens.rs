//! What a piece of Rust mentions and calls, read from its tokens.
//!
//! Tokens rather than syntax trees, because half of a test stands inside `proptest!`, `assert!` and the like,
//! where a syntax tree ends at the macro's name.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A path such as `bezier::laws::convex_hull`, or a single name, in the order of the source.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Mention {
    /// The names, without the `::` between them and without generic arguments.
    pub(super) names: Vec<String>,
    /// Whether `(` follows (after a turbofish, if there is one).
    pub(super) called: bool,
    /// Whether `!` and a group follow.
    pub(super) macro_call: bool,
}

impl Mention {
    /// The last name of the path.
    pub(super) fn last(&self) -> &str {
        self.names.last().map_or("", String::as_str)
    }
}

/// All paths that the tokens mention, in the order of the source; `use` items are not mentions.
pub(super) fn mentions(tokens: TokenStream) -> Vec<Mention> {
    let mut found = Vec::new();
    collect(tokens, &mut found);
    found
}

fn collect(tokens: TokenStream, found: &mut Vec<Mention>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Ident(name) if name == "use" => {
                while at < tokens.len() && !is_punct(&tokens[at], ';') {
                    at += 1;
                }
            }
            TokenTree::Ident(_) => at = path(&tokens, at, found),
            TokenTree::Group(group) => {
                collect(group.stream(), found);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Reads the path that begins at `start` and returns the position after it.
fn path(tokens: &[TokenTree], start: usize, found: &mut Vec<Mention>) -> usize {
    let mut names = vec![tokens[start].to_string()];
    let mut at = start + 1;
    while is_double_colon(tokens, at) {
        match tokens.get(at + 2) {
            Some(TokenTree::Ident(name)) => {
                names.push(name.to_string());
                at += 3;
            }
            Some(opening) if is_punct(opening, '<') => at = after_generics(tokens, at + 2),
            _ => break,
        }
    }
    let called = is_group(tokens.get(at), Delimiter::Parenthesis);
    let macro_call = tokens.get(at).is_some_and(|token| is_punct(token, '!'))
        && matches!(tokens.get(at + 1), Some(TokenTree::Group(_)));
    found.push(Mention {
        names,
        called,
        macro_call,
    });
    at
}

/// The position after the generic arguments whose `<` stands at `open`.
fn after_generics(tokens: &[TokenTree], open: usize) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        if is_punct(token, '<') {
            depth += 1;
        } else if is_punct(token, '>') {
            depth = depth.saturating_sub(1);
            if depth == 0 {
                return at + 1;
            }
        }
    }
    tokens.len()
}

fn is_double_colon(tokens: &[TokenTree], at: usize) -> bool {
    let colon = |at: usize| tokens.get(at).is_some_and(|token| is_punct(token, ':'));
    colon(at) && colon(at + 1)
}

pub(super) fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

pub(super) fn is_group(token: Option<&TokenTree>, delimiter: Delimiter) -> bool {
    matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == delimiter)
}

#[cfg(test)]
mod tests {
    use super::mentions;

    fn of(source: &str) -> Vec<(String, bool, bool)> {
        mentions(source.parse().expect("the source is made of tokens"))
            .into_iter()
            .map(|mention| (mention.names.join("::"), mention.called, mention.macro_call))
            .collect()
    }

    #[test]
    fn sees_calls_inside_macros_and_behind_a_turbofish() {
        let found = of("assert!(holds(bezier::laws::convex_hull::<f64, Vec<f64>>(&curve)));");
        assert!(found.contains(&("assert".into(), false, true)));
        assert!(found.contains(&("holds".into(), true, false)));
        assert!(found.contains(&("bezier::laws::convex_hull".into(), true, false)));
    }

    #[test]
    fn an_import_is_no_mention() {
        assert!(of("use bezier::laws::convex_hull;").is_empty());
    }

    #[test]
    fn a_function_passed_by_name_is_mentioned_but_not_called() {
        let found = of("check(laws::convex_hull, 3)");
        assert!(found.contains(&("laws::convex_hull".into(), false, false)));
    }
}
