//! Every tableau that deals fresh numbers for computing by hand.

use crate::check::tableau::{Deal, Dealer, sheet};

/// All tableaux, each with the chapter that it belongs to.
#[must_use]
pub fn all() -> Vec<(&'static str, Dealer)> {
    let of = |chapter| move |dealer| (chapter, dealer);
    crate::bezier::tableaux::all()
        .into_iter()
        .map(of("bezier"))
        .collect()
}

/// The tableau of this name in a chapter.
///
/// ```
/// let dealer = cagd::tableaux::find("bezier", "cubic").expect("it is dealt");
/// assert_eq!((dealer.deal)(3).round, 3);
/// assert!(cagd::tableaux::find("bezier", "nothing").is_none());
/// ```
#[must_use]
pub fn find(chapter: &str, name: &str) -> Option<Dealer> {
    let found = all()
        .into_iter()
        .find(|(of, dealer)| *of == chapter && dealer.name == name);
    found.map(|(_, dealer)| dealer)
}

/// Answers a question of a page; what is wrong with it is part of the answer.
///
/// A page asks with a text and is answered with a text, whether the answer comes from wasm or from the local server.
/// The question names the chapter, the tableau and the round; a line for each row follows, its fields between tabs (here ⇥).
/// Without rows it asks for the empty table.
///
/// ```text
/// tableau bezier cubic 0
/// (0, 0)
/// (8, 16)⇥(6, 12)
/// ```
///
/// The answer has one fact a line, its fields between tabs: those of [`sheet::described`], or `error` and why there is
/// no table.
///
/// # Examples
///
/// ```
/// use cagd::tableaux;
///
/// let answer = tableaux::answer("tableau bezier cubic 0");
/// assert!(answer.contains("cell\t1\t1\tb₀¹\topen\t\t\n"), "{answer}");
/// assert!(tableaux::answer("tableau bezier nothing 0").starts_with("error\t"));
/// ```
#[must_use]
pub fn answer(question: &str) -> String {
    let mut lines = question.lines();
    let asked = lines.next().unwrap_or_default();
    match asked_for(asked) {
        Some(deal) => {
            let rows = lines.map(|line| line.split('\t').map(str::to_owned).collect());
            sheet::described(&deal, &rows.collect())
        }
        None => format!("error\tthere is no `{asked}`; reload the page\n"),
    }
}

/// The deal that `tableau CHAPTER NAME ROUND` asks for.
fn asked_for(question: &str) -> Option<Deal> {
    let words: Vec<&str> = question.split(' ').collect();
    let ["tableau", chapter, name, round] = words.as_slice() else {
        return None;
    };
    Some((find(chapter, name)?.deal)(round.parse().ok()?))
}
