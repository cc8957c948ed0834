//! Convex hulls over rationals.

use cagd::affine::{Point, laws};
use cagd::scalar::BigRational;

use crate::inputs::{at, for_each, integer};
use crate::support::mutants::affine::convexity as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Place = Point<Exact, 2>;

/// Checked for all sets of one to four points of the 3 × 3 grid, with weights that include 0.
#[test]
fn convex_set_and_hull() {
    let grid = |i: usize| -> Place { at(&[(i % 3) as i64, (i / 3) as i64]) };
    let law = |implementation: fn(&[Place]) -> Vec<Place>| {
        let sets = (1..=4_u32).flat_map(|count| {
            (0..9_usize.pow(count))
                .step_by(count as usize)
                .map(move |choice| {
                    (0..count)
                        .map(|k| choice / 9_usize.pow(k) % 9)
                        .collect::<Vec<_>>()
                })
        });
        for_each(sets, |set| {
            let points: Vec<Place> = set.iter().map(|&i| grid(i)).collect();
            let weights: Vec<Exact> = (0..points.len())
                .map(|i| integer((3 * i as i64 + 1) % 4))
                .collect();
            laws::convex_set_and_hull(implementation, &points, &weights)
        })
    };
    holds(law(mutants::hull));
    rejects("the corners of the box", law(mutants::corners_of_the_box));
    rejects("one point left out", law(mutants::last_point_missing));
    rejects("the points as they are", law(mutants::as_given));
    rejects("clockwise", law(mutants::clockwise));
}
