//! Properties of uniform splines.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::bspline::UniformSpline;
use cagd::subdivision::laws;
use proptest::prelude::*;

use super::polygons::{MAX_DEGREE, PlanePolygon, PlaneSpline, polygons, splines};
use crate::generators::for_all;
use crate::support::mutants::subdivision::corner_cutting as averaging;
use crate::support::mutants::subdivision::uniform_splines as mutants;
use crate::support::{holds, rejects};

type Segment = fn(&PlaneSpline, usize) -> BezierCurve<Point<f64, 2>>;
type Refine = fn(&PlaneSpline) -> PlaneSpline;
type Step = fn(&PlanePolygon) -> PlanePolygon;
type Averaging = fn(&PlanePolygon, usize) -> PlanePolygon;

#[test]
fn uniform_splines() {
    let law = |segment: Segment, refine: Refine| {
        // A place in a segment that f64 holds exactly, so that no rounding moves it to another segment.
        let place = (0i32..64).prop_map(|t| f64::from(t) / 64.0);
        let input = (1..=MAX_DEGREE).prop_flat_map(splines);
        for_all(
            (input, any::<prop::sample::Index>(), place),
            |(spline, index, t)| {
                let index = index.index(spline.segment_count());
                laws::uniform_splines(segment, refine, spline, index, *t)
            },
        )
    };
    holds(law(mutants::segment, UniformSpline::refined));
    let refined: Refine = UniformSpline::refined;
    rejects(
        "Bézier points",
        law(mutants::control_points_as_bezier_points, refined),
    );
    rejects("the next segment", law(mutants::next_segment, refined));
    rejects("over [0, 1]", law(mutants::on_unit_interval, refined));
    rejects("not refined", law(mutants::segment, mutants::not_refined));
    rejects(
        "midpoints only",
        law(mutants::segment, mutants::midpoints_inserted),
    );
}

#[test]
fn uniform_degree_zero_one() {
    let law = |implementation: Refine| {
        for_all((0..=1usize).prop_flat_map(splines), |spline| {
            laws::uniform_degree_zero_one(implementation, spline)
        })
    };
    holds(law(UniformSpline::refined));
    rejects("no factor 1/2, as printed", law(mutants::without_one_half));
    rejects("always doubled", law(mutants::only_doubled));
    rejects("always midpoints", law(mutants::midpoints_inserted));
    rejects("in the opposite order", law(mutants::reversed));
}

#[test]
fn uniform_degree_two() {
    let law = |implementation: Refine| {
        for_all(splines(2), |spline| {
            laws::uniform_degree_two(implementation, spline)
        })
    };
    holds(law(UniformSpline::refined));
    rejects("midpoints", law(mutants::midpoints_inserted));
    rejects("averaged once more", law(mutants::averaged_once_more));
}

#[test]
fn uniform_degree_three() {
    let law = |implementation: Refine| {
        for_all(splines(3), |spline| {
            laws::uniform_degree_three(implementation, spline)
        })
    };
    holds(law(UniformSpline::refined));
    rejects("midpoints", law(mutants::midpoints_inserted));
    rejects("averaged once more", law(mutants::averaged_once_more));
}

#[test]
fn midpoint_relation() {
    let law = |implementation: Refine| {
        let input = (0..MAX_DEGREE).prop_flat_map(|n| (polygons(n + 2, 1), Just(n)));
        for_all(input, |(polygon, degree)| {
            laws::midpoint_relation(implementation, polygon, *degree)
        })
    };
    holds(law(UniformSpline::refined));
    rejects("midpoints", law(mutants::midpoints_inserted));
    rejects("in the opposite order", law(mutants::reversed));
    rejects("not refined", law(mutants::not_refined));
}

#[test]
fn lane_riesenfeld_convergence() {
    let law = |implementation: Averaging| {
        let input = (1..=MAX_DEGREE).prop_flat_map(|n| (polygons(n + 1, 1), Just(n), 0usize..=3));
        for_all(input, |(polygon, degree, steps)| {
            laws::lane_riesenfeld_convergence(implementation, polygon, *degree, *steps)
        })
    };
    holds(law(|polygon, n| {
        polygon.lane_riesenfeld(n).expect("n + 1 vertices")
    }));
    rejects("averaged n + 1 times", law(averaging::averaged_once_more));
    rejects("averaged n − 1 times", law(averaging::averaged_once_less));
    rejects("not doubled", law(averaging::not_doubled));
}

#[test]
fn cubic_curve() {
    let law = |implementation: Step| {
        for_all(polygons(4, 1), |polygon| {
            laws::cubic_curve(implementation, polygon)
        })
    };
    holds(law(|polygon| polygon.cubic_step().expect("four vertices")));
    rejects(
        "the weights of the limit",
        law(mutants::limit_weights_in_the_step),
    );
    rejects("the weights 1/4, 1/2, 1/4", law(mutants::quarter_weights));
    rejects("the vertices stay", law(mutants::vertices_kept));
}
