//! Bézier curves.
//!
//! Read in this order:
//!
//! - [`curve`] — control points and domain,
//! - [`casteljau`] — evaluation and its triangle,
//! - [`paths`] — the paths through the triangle,
//! - [`cost`] — what de Casteljau's algorithm costs,
//! - [`bernstein`](mod@bernstein) — the basis,
//! - [`evaluation`] — evaluation in linear time,
//! - [`monomial`], [`matrix`] — to and from monomial form,
//! - [`batch`] — many points at once,
//! - [`derivative`], [`bernstein_derivative`](mod@bernstein_derivative) — hodographs, and derivatives of the basis,
//! - [`integral`] — means, integrals and antiderivatives,
//! - [`quadratic`] — parabolas and their degenerate cases,
//! - [`parametric`] — curvature and what else any parametric curve has,
//! - [`arc_length`], [`nearest`], [`product`] — lengths and nearest points with guaranteed errors,
//! - [`transform`] — affine images and reversal,
//! - [`bounding_box`], [`hull`] — where the curve lies,
//! - [`mod@sign_changes`], [`roots`] — zeros of polynomials in Bernstein form,
//! - [`line_intersection`] — where a curve meets a line,
//! - [`subdivision`] — pieces of a curve, and corner cutting,
//! - [`bounds`] — how far a curve is from its chord and its control polygon,
//! - [`flattening`] — polylines with a guaranteed distance,
//! - [`intersection`] — where two plane curves meet,
//! - [`blossom`], [`symmetric`] — the polar form of curves and of powers,
//! - [`elevation`] — more control points, the same curve,
//! - [`approximation`] — Bernstein approximation;
//!
//! the theorems are in [`laws`], what is computed by hand in [`tableaux`].

pub mod approximation;
pub mod arc_length;
pub mod batch;
pub mod bernstein;
pub mod bernstein_derivative;
pub mod blossom;
pub mod bounding_box;
pub mod bounds;
pub mod casteljau;
pub mod cost;
pub mod curve;
pub mod derivative;
pub mod elevation;
pub mod evaluation;
pub mod flattening;
pub mod hull;
pub mod integral;
pub mod intersection;
pub mod line_intersection;
pub mod matrix;
pub mod monomial;
pub mod nearest;
pub mod parametric;
pub mod paths;
pub mod product;
pub mod quadratic;
pub mod roots;
pub mod sign_changes;
mod square_free;
pub mod subdivision;
pub mod symmetric;
pub mod transform;

pub mod laws;
pub mod tableaux;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use approximation::polygon_at;
pub use bernstein::{
    BernsteinError, BernsteinMaximum, bernstein, bernstein_basis, bernstein_maximum, bernstein_on,
    binomial, factorial,
};
pub use bernstein_derivative::{bernstein_derivative, bernstein_higher_derivative};
pub use blossom::{Blossom, BlossomEntry, BlossomError, BlossomTriangle};
pub use casteljau::CasteljauTriangle;
pub use cost::{Cost, Counted, recursive_at};
pub use curve::{BezierCurve, BezierError, Hodograph, PlaneCurve};
pub use derivative::forward_differences;
pub use elevation::ReductionError;
pub use flattening::{FlatteningError, Polyline};
pub use line_intersection::LineIntersections;
pub use matrix::{bernstein_matrix, monomial_matrix};
pub use monomial::{MonomialCurve, MonomialError};
pub use nearest::{Foot, Nearest, NearestError};
pub use paths::{Step, TrianglePath, TrianglePaths};
pub use product::{bernstein_inner_product, bernstein_product};
pub use quadratic::{ParabolaMap, QuadraticError, QuadraticTrace};
pub use roots::{Root, RootKind, RootSearch, Roots};
pub use sign_changes::sign_changes;
pub use subdivision::{CornerCutting, SubdividedPolygon};
pub use symmetric::{elementary_symmetric, power_blossom};

/// The chapter's pages, so that `cargo test` runs each of their Rust blocks.
#[cfg(doctest)]
mod chapter {
    #[doc = include_str!("../../book/src/bezier/de-casteljau.md")]
    mod de_casteljau {}
    #[doc = include_str!("../../book/src/bezier/bernstein.md")]
    mod bernstein {}
    #[doc = include_str!("../../book/src/bezier/representation.md")]
    mod representation {}
    #[doc = include_str!("../../book/src/bezier/derivatives.md")]
    mod derivatives {}
    #[doc = include_str!("../../book/src/bezier/shape.md")]
    mod shape {}
    #[doc = include_str!("../../book/src/bezier/subdivision.md")]
    mod subdivision {}
    #[doc = include_str!("../../book/src/bezier/bounds.md")]
    mod bounds {}
    #[doc = include_str!("../../book/src/bezier/blossom.md")]
    mod blossom {}
    #[doc = include_str!("../../book/src/bezier/elevation.md")]
    mod elevation {}
}
