//! Properties of Loop's scheme.

use cagd::subdivision::{LatticeMask, box_spline_222, laws, loop_lattice_mask};
use proptest::prelude::*;

use crate::generators::for_all;
use crate::support::mutants::subdivision::loop_scheme as mutants;
use crate::support::{holds, rejects};

/// Places in and around the support of the box spline, often on its grid.
fn place() -> impl Strategy<Value = [f64; 2]> {
    let coordinate = || {
        prop_oneof![
            2 => (-5i32..=5).prop_map(|k| f64::from(k) / 2.0),
            3 => -2.5..2.5,
        ]
    };
    prop_oneof![
        4 => [coordinate(), coordinate()],
        1 => coordinate().prop_map(|x| [x, x]),
    ]
}

#[test]
fn loop_box_spline() {
    type Spline = fn(&[f64; 2]) -> f64;
    let law = |mask: LatticeMask<f64>, spline: Spline| {
        for_all(place(), |x| laws::loop_box_spline(&mask, spline, x))
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
