//! The library's bound, compared with a growing tolerance.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::bezier::bounds::maximum_norm;
use cagd::scalar::OrderedScalar;

/// The least number of halvings after which the chord bound of every piece is at most `tolerance`, which is positive.
pub fn depth<T: OrderedScalar>(b: &[Point<T, 2>], tolerance: T) -> usize {
    let curve = BezierCurve::new(b.to_vec()).expect("at least one point");
    let bound = curve.chord_bound(maximum_norm);
    let reached = |reach: &T| *reach < bound;
    std::iter::successors(Some(tolerance), |reach| {
        Some(reach.clone() * T::from_integer(4))
    })
    .take_while(reached)
    .count()
}
