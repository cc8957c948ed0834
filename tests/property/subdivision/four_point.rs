//! Properties of the four-point scheme.

use cagd::affine::Point;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{Closing, ControlPolygon, ControlPolygonError, LocalMatrix, Mask, laws};
use proptest::prelude::*;

use super::masks::data;
use crate::generators::{for_all, for_all_of, point, polygon, scale};
use crate::support::mutants::subdivision::four_point as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;
type Plane = ControlPolygon<Point<f64, 2>>;

/// Tensions: none, the usual one, inside and outside of what is smooth, negative ones.
fn tension() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0625),
        1 => Just(0.0),
        3 => 0.0..0.2,
        2 => -1.0..1.0,
    ]
}

/// Open and closed polygons with four points or more; also with repeated and collinear points.
fn polygons() -> impl Strategy<Value = Plane> {
    (polygon(), any::<bool>()).prop_filter_map("four points or more", |(points, closed)| {
        let closing = if closed {
            Closing::Closed
        } else {
            Closing::Open
        };
        (points.len() >= 4)
            .then(|| ControlPolygon::new(points, closing).ok())
            .flatten()
    })
}

#[test]
fn four_point_scheme() {
    type Step = fn(&Plane, f64) -> Result<Plane, ControlPolygonError>;
    let law = |implementation: Step| {
        for_all((polygons(), tension()), |(polygon, w)| {
            laws::four_point_scheme(implementation, polygon, *w)
        })
    };
    holds(law(ControlPolygon::four_point));
    rejects("the sign", law(mutants::sign_of_tension));
    rejects("always 1/16", law(mutants::always_a_sixteenth));
    rejects("midpoints", law(mutants::midpoints));
    rejects("one leg off", law(mutants::one_leg_off));
    rejects("old points moved", law(mutants::old_points_moved));
}

#[test]
fn four_point_convergence() {
    type Step = fn(&ControlPolygon<f64>, f64) -> Result<ControlPolygon<f64>, ControlPolygonError>;
    let law = |implementation: Step| {
        for_all(
            ([-4.0..4.0, -4.0..4.0, -4.0..4.0, -4.0..4.0], 0_u32..=6),
            |(cubic, steps)| laws::four_point_convergence(implementation, cubic, *steps),
        )
    };
    holds(law(ControlPolygon::four_point));
    rejects("the sign", law(mutants::sign_of_tension));
    rejects("midpoints", law(mutants::midpoints));
    rejects("one leg off", law(mutants::one_leg_off));
}

#[test]
fn four_point_tension() {
    let law = |implementation: fn(Q) -> Option<Mask<Q>>| {
        for_all_of(64, (1_i64..=200, 401_i64..=1000), |(p, q)| {
            laws::four_point_tension(implementation, &BigRational::from_ratio(*p, *q))
        })
    };
    holds(law(|w| Mask::four_point(w).ok()));
    rejects("the printed weights", law(mutants::printed_weights));
    rejects("half the tension", law(mutants::half_the_tension));
    rejects("the sign", law(mutants::negative_tension));
}

#[test]
fn four_point_analysis() {
    type Norm = fn(&Mask<Q>, usize) -> Q;
    type Matrix = fn(&Mask<Q>) -> LocalMatrix<Q>;
    let law = |norm: Norm, matrix: Matrix| {
        for_all_of(16, data(), |data| {
            laws::four_point_analysis(norm, matrix, data)
        })
    };
    holds(law(Mask::norm, LocalMatrix::of));
    rejects(
        "one step fewer",
        law(mutants::one_step_fewer, LocalMatrix::of),
    );
    rejects(
        "all rules",
        law(mutants::all_rules_together, LocalMatrix::of),
    );
    rejects(
        "another matrix",
        law(Mask::norm, mutants::matrix_of_differences),
    );
}

#[test]
fn linear_precision() {
    type Points = fn(&Mask<f64>, &[Point<f64, 2>]) -> Option<Vec<Point<f64, 2>>>;
    let masks = (0_usize..=6, tension()).prop_map(|(degree, w)| match degree {
        0 => Mask::four_point(w).expect("a finite tension"),
        _ => Mask::lane_riesenfeld(degree),
    });
    let lines = scale().prop_flat_map(|size| [point(size), point(size)]);
    let places = prop::collection::vec(-4.0..4.0, 1..9);
    let inputs = (masks, lines, places);
    let law = |implementation: Points| {
        for_all(&inputs, |(mask, line, places)| {
            let numbers = |mask: &Mask<f64>, places: &[f64]| mask.refine_closed(places).ok();
            laws::linear_precision(implementation, numbers, mask, line, places)
        })
    };
    holds(law(|mask, points| mask.refine_closed(points).ok()));
    rejects("one coordinate twice", law(mutants::first_coordinate_twice));
    rejects("pushed off", law(mutants::pushed_off));
    rejects("towards the origin", law(mutants::towards_the_origin));
}
