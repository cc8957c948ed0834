//! The four-point scheme over rationals.

use cagd::affine::Point;
use cagd::scalar::BigRational;
use cagd::subdivision::{
    Closing, ControlPolygon, ControlPolygonError, LaurentPolynomial, LocalMatrix, Mask, laws,
};

use crate::inputs::{at, for_each, integer, ratio};
use crate::support::mutants::subdivision::four_point as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;
type Step = fn(&ControlPolygon<Q>, Q) -> Result<ControlPolygon<Q>, ControlPolygonError>;

fn tensions() -> [Q; 5] {
    [(0, 1), (1, 16), (1, 8), (17, 100), (-1, 3)].map(|(p, q)| ratio(p, q))
}

/// Polygons of 4 to 9 points with a single 1 among zeros; both sides are linear in the points and in w.
#[test]
fn four_point_scheme() {
    let polygons: Vec<(ControlPolygon<Q>, Q)> = (4..=9_i64)
        .flat_map(|count| (0..count).map(move |one| (count, one)))
        .flat_map(|(count, one)| {
            [Closing::Open, Closing::Closed].map(|closing| {
                let values = (0..count).map(|i| integer(i64::from(i == one)));
                ControlPolygon::new(values, closing).expect("four points or more")
            })
        })
        .flat_map(|polygon| tensions().map(|w| (polygon.clone(), w)))
        .collect();
    let law = |implementation: Step| {
        for_each(&polygons, |(polygon, w)| {
            laws::four_point_scheme(implementation, polygon, w.clone())
        })
    };
    holds(law(ControlPolygon::four_point));
    rejects("the sign", law(mutants::sign_of_tension));
    rejects("always 1/16", law(mutants::always_a_sixteenth));
    rejects("midpoints", law(mutants::midpoints));
    rejects("one leg off", law(mutants::one_leg_off));
    rejects("old points moved", law(mutants::old_points_moved));
}

/// Every monomial up to degree 3 and every number of steps up to 8.
#[test]
fn four_point_convergence() {
    let inputs: Vec<([Q; 4], u32)> = (0..4)
        .flat_map(|one| (0..=8).map(move |steps| (one, steps)))
        .map(|(one, steps)| {
            let coefficient = |k: usize| integer(i64::from(k == one));
            (std::array::from_fn(coefficient), steps)
        })
        .collect();
    let law = |implementation: Step| {
        for_each(&inputs, |(cubic, steps)| {
            laws::four_point_convergence(implementation, cubic, *steps)
        })
    };
    holds(law(ControlPolygon::four_point));
    rejects("the sign", law(mutants::sign_of_tension));
    rejects("midpoints", law(mutants::midpoints));
    rejects("one leg off", law(mutants::one_leg_off));
}

/// On (0, 1/8] and on [1/8, 1/2) both sides are polynomials in w: the norm of degree 2, the determinant of degree 8.
/// Twelve values in either interval prove the equations.
#[test]
fn four_point_tension() {
    let inputs = || (1..=48).map(|k| ratio(k, 97));
    let law = |implementation: fn(Q) -> Option<Mask<Q>>| {
        for_each(inputs(), |w| laws::four_point_tension(implementation, w))
    };
    assert!(inputs().filter(|w| *w < ratio(1, 8)).count() >= 12);
    holds(law(|w| Mask::four_point(w).ok()));
    rejects("the printed weights", law(mutants::printed_weights));
    rejects("half the tension", law(mutants::half_the_tension));
    rejects("the sign", law(mutants::negative_tension));
}

#[test]
fn four_point_analysis() {
    type Norm = fn(&Mask<Q>, usize) -> Q;
    type Matrix = fn(&Mask<Q>) -> LocalMatrix<Q>;
    let data = [
        LaurentPolynomial::one(),
        LaurentPolynomial::new(-2, [1, -1, 1, -1].map(integer)),
    ];
    let law = |norm: Norm, matrix: Matrix| {
        for_each(&data, |data| laws::four_point_analysis(norm, matrix, data))
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

/// Both sides are affine in the line and linear in the places, of which one is 1 and the others are 0.
#[test]
fn linear_precision() {
    type Points = fn(&Mask<Q>, &[Point<Q, 2>]) -> Option<Vec<Point<Q, 2>>>;
    let lines: [[Point<Q, 2>; 2]; 3] = [
        [at(&[0, 0]), at(&[1, 0])],
        [at(&[1, -2]), at(&[1, 5])],
        [at(&[3, 1]), at(&[-4, 2])],
    ];
    let masks = super::symbols::schemes();
    let inputs: Vec<_> = masks
        .iter()
        .flat_map(|mask| lines.iter().map(move |line| (mask, line)))
        .flat_map(|(mask, line)| {
            (0..7_i64).map(move |one| {
                let places: Vec<Q> = (0..7).map(|j| integer(i64::from(j == one))).collect();
                (mask, line, places)
            })
        })
        .collect();
    let law = |implementation: Points| {
        for_each(&inputs, |(mask, line, places)| {
            let numbers = |mask: &Mask<Q>, places: &[Q]| mask.refine_closed(places).ok();
            laws::linear_precision(implementation, numbers, mask, line, places)
        })
    };
    holds(law(|mask, points| mask.refine_closed(points).ok()));
    rejects("one coordinate twice", law(mutants::first_coordinate_twice));
    rejects("pushed off", law(mutants::pushed_off));
    rejects("towards the origin", law(mutants::towards_the_origin));
}
