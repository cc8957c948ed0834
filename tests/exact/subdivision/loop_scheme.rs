//! Loop's scheme over rationals.

use cagd::scalar::BigRational;
use cagd::subdivision::{LatticeMask, box_spline_222, laws, loop_lattice_mask};

use crate::inputs::{for_each, ratio};
use crate::support::mutants::subdivision::loop_scheme as mutants;
use crate::support::{holds, rejects};

/// M(x) and the M(2x − j) are polynomials of degree 4 on the triangles of the half lattice, and a triangle with side 1/2
/// has 15 points with denominator 8 in it, which determine such a polynomial.
/// All of them in one square with side 4 that contains the support prove the refinement equation.
#[test]
fn loop_box_spline() {
    type Spline = fn(&[BigRational; 2]) -> BigRational;
    // M(−x) = M(x), so half of the square is enough.
    let places = (-16..=16).flat_map(|i| (0..=16).map(move |j| [ratio(i, 8), ratio(j, 8)]));
    let places: Vec<_> = places.collect();
    let law = |mask: LatticeMask<BigRational>, spline: Spline| {
        for_each(places.clone(), |x| laws::loop_box_spline(&mask, spline, x))
    };
    let mask = || loop_lattice_mask().expect("valence 6");
    holds(law(mask(), box_spline_222));
    rejects("linear", law(mutants::linear_mask(), box_spline_222));
    rejects(
        "edge weights swapped",
        law(mutants::edge_weights_swapped(), box_spline_222),
    );
    rejects("other diagonal", law(mask(), mutants::other_diagonal));
    rejects("not centred", law(mask(), mutants::not_centred));
    rejects("piecewise linear", law(mask(), mutants::hat));
}
