//! Uniform splines and their rules, proved for every degree up to a bound.

use cagd::bezier::BezierCurve;
use cagd::bspline::UniformSpline;
use cagd::scalar::BigRational;
use cagd::subdivision::laws;

use super::polygons::{MAX_DEGREE, Polygon, Spline, unit_polygons, unit_splines};
use crate::inputs::{for_each, ratio};
use crate::support::mutants::subdivision::corner_cutting as averaging;
use crate::support::mutants::subdivision::uniform_splines as mutants;
use crate::support::{holds, rejects};

type Segment = fn(&Spline, usize) -> BezierCurve<BigRational>;
type Refine = fn(&Spline) -> Spline;
type Step = fn(&Polygon) -> Polygon;
type Averaging = fn(&Polygon, usize) -> Polygon;

/// Every segment of the unit splines of degree 1 to 4, at n + 1 places: enough for polynomials of degree n.
fn segments_and_places() -> impl Iterator<Item = (Spline, usize, BigRational)> {
    (1..=4).flat_map(|degree| {
        unit_splines(degree).flat_map(move |spline| {
            (0..spline.segment_count()).flat_map(move |index| {
                let spline = spline.clone();
                (0..=degree as i64)
                    .map(move |k| (spline.clone(), index, ratio(k, degree as i64 + 1)))
            })
        })
    })
}

#[test]
fn uniform_splines() {
    let law = |segment: Segment, refine: Refine| {
        for_each(segments_and_places(), |(spline, index, t)| {
            laws::uniform_splines(segment, refine, spline, *index, t.clone())
        })
    };
    let refined: Refine = UniformSpline::refined;
    holds(law(mutants::segment, refined));
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
        for_each((0..=1).flat_map(unit_splines), |spline| {
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
        for_each(unit_splines(2), |spline| {
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
        for_each(unit_splines(3), |spline| {
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
        let input = (0..MAX_DEGREE).flat_map(|degree| {
            unit_polygons(degree + 2, degree + 4).map(move |polygon| (polygon, degree))
        });
        for_each(input, |(polygon, degree)| {
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
        let input = (1..=4).flat_map(|degree| {
            unit_polygons(degree + 1, degree + 3)
                .flat_map(move |polygon| [1, 2].map(|steps| (polygon.clone(), degree, steps)))
        });
        for_each(input, |(polygon, degree, steps)| {
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
        for_each(unit_polygons(4, 7), |polygon| {
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
