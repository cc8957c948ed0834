//! The figures of this chapter, one module per section.

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod representation;
mod shape;
mod subdivision;

pub use bernstein::*;
pub use blossom::*;
pub use bounds::*;
pub use de_casteljau::*;
pub use derivatives::*;
pub use elevation::*;
pub use representation::*;
pub use shape::*;
pub use subdivision::*;

use crate::figure::Figure;

/// The figures on the construction of a curve and on its representations.
#[must_use]
pub fn construction() -> Vec<Figure> {
    joined([
        bernstein::all(),
        blossom::all(),
        de_casteljau::all(),
        elevation::all(),
        representation::all(),
    ])
}

/// The figures on the shape of a curve and on its derivatives.
#[must_use]
pub fn shape_and_derivatives() -> Vec<Figure> {
    joined([derivatives::all(), shape::all()])
}

/// The figures on distances and on subdivision.
#[must_use]
pub fn distances() -> Vec<Figure> {
    joined([bounds::all(), subdivision::all()])
}

fn joined<const N: usize>(sections: [Vec<Figure>; N]) -> Vec<Figure> {
    sections.into_iter().flatten().collect()
}
