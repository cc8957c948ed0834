//! Every figure of the book.

use crate::figure::Figure;

/// All figures, chapter by chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        crate::affine::figures::all(),
        crate::bezier::figures::all(),
        crate::subdivision::figures::all(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The figure with this id.
///
/// ```
/// let figure = cagd::gallery::find("bezier-figure-de-casteljau").expect("it is in the gallery");
/// assert_eq!(figure.title(), "The algorithm of de Casteljau for n = 2, 3, 4");
/// assert!(cagd::gallery::find("bezier-figure-of-nothing").is_none());
/// ```
#[must_use]
pub fn find(id: &str) -> Option<Figure> {
    all().into_iter().find(|figure| figure.id() == id)
}
