//! Every figure of the book.

use crate::figure::Figure;
use crate::{affine, bezier, subdivision};

/// Makes some figures of the gallery.
pub type Figures = fn() -> Vec<Figure>;

/// All figures by parts, in the order of the book; a chapter adds a line for each part of it.
///
/// Each part is compiled to wasm of its own, so that a page loads only the code of what it shows.
pub const PARTS: &[(&str, Figures)] = &[
    ("affine-combinations", affine::figures::combining),
    ("affine-maps", affine::figures::maps_and_areas),
    ("bezier-construction", bezier::figures::construction),
    ("bezier-shape", bezier::figures::shape_and_derivatives),
    ("bezier-distances", bezier::figures::distances),
    (
        "subdivision-polygons",
        subdivision::figures::polygons_and_meshes,
    ),
    (
        "subdivision-four-point",
        subdivision::figures::four_point_curves,
    ),
    ("subdivision-tension", subdivision::figures::tension),
    ("subdivision-masks", subdivision::figures::masks),
    ("subdivision-loop", subdivision::figures::loop_surfaces),
    (
        "subdivision-butterfly",
        subdivision::figures::butterfly_surfaces,
    ),
    (
        "subdivision-quadrilaterals",
        subdivision::figures::quadrilaterals,
    ),
    ("subdivision-eigenvalues", subdivision::figures::eigenvalues),
];

/// All figures, chapter by chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    PARTS.iter().flat_map(|(_, figures)| figures()).collect()
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

/// The figures of one part, chosen while compiling; nothing of the other parts gets into the program.
///
/// ```
/// const FIGURES: cagd::gallery::Figures = cagd::gallery::part("affine-maps");
/// assert!(FIGURES().iter().all(|figure| figure.id().starts_with("affine-")));
/// ```
///
/// # Panics
///
/// If there is no such part; in a constant that is an error of compilation.
#[must_use]
pub const fn part(name: &str) -> Figures {
    let mut i = 0;
    while i < PARTS.len() {
        let (known, figures) = PARTS[i];
        if same(known.as_bytes(), name.as_bytes()) {
            return figures;
        }
        i += 1;
    }
    panic!("the gallery has no part of this name")
}

/// `==` of slices is not yet to be had in constants.
const fn same(left: &[u8], right: &[u8]) -> bool {
    if left.len() != right.len() {
        return false;
    }
    let mut i = 0;
    while i < left.len() {
        if left[i] != right[i] {
            return false;
        }
        i += 1;
    }
    true
}
