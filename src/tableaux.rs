//! Every tableau that deals fresh numbers for computing by hand.

use crate::check::tableau::Dealer;

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
