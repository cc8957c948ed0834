//! Properties of the intersection algorithm, on curves whose intersections are planted.

use cagd::affine::{Interval, Point};
use cagd::bezier::intersection::{IntersectionError, Kind, Meeting, Range};
use cagd::bezier::{BezierCurve, PlaneCurve, laws};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::for_all;
use crate::support::mutants::bezier::intersection as mutants;
use crate::support::{holds, rejects};

type Planted = (PlaneCurve, PlaneCurve, Vec<(f64, f64)>);

/// Polygons with small whole coordinates, some of them repeated, collinear or a single place.
fn polygon() -> impl Strategy<Value = Vec<Point<f64, 2>>> {
    let whole = || (-8i32..=8).prop_map(f64::from);
    prop_oneof![
        6 => prop::collection::vec([whole(), whole()].prop_map(Point::new), 2..=5),
        1 => prop::collection::vec(whole().prop_map(|x| Point::new([x, 2.0 * x])), 2..=4),
        1 => (whole(), 1usize..=4).prop_map(|(x, count)| vec![Point::new([x, -x]); count]),
    ]
}

/// Two curves with p(s) = q(t) for s and t in eighths, exactly: all numbers have few binary digits.
fn crossing() -> impl Strategy<Value = Planted> {
    let eighth = || (0i32..=8).prop_map(|k| f64::from(k) / 8.0);
    let scale = prop_oneof![4 => Just(0), 1 => Just(480), 1 => Just(-480)];
    (polygon(), polygon(), eighth(), eighth(), scale).prop_map(|(p, q, s, t, power)| {
        let scale = 2f64.powi(power);
        let curve = |points: Vec<Point<f64, 2>>| BezierCurve::new(points).expect("finite points");
        let shift = curve(p.clone()).at(s) - curve(q.clone()).at(t);
        let scaled = |points: Vec<Point<f64, 2>>| {
            curve(points.iter().map(|p| p.map(|x| x * scale)).collect())
        };
        let moved = q.iter().map(|point| *point + shift).collect();
        (scaled(p), scaled(moved), vec![(s, t)])
    })
}

/// A curve and the piece of it over [1/4, 5/4], forwards or backwards.
fn overlapping() -> impl Strategy<Value = Planted> {
    (polygon(), any::<bool>()).prop_map(|(points, reversed)| {
        let curve = BezierCurve::new(points).expect("finite points");
        let ends = if reversed { (1.25, 0.25) } else { (0.25, 1.25) };
        let piece = Interval::new(ends.0, ends.1).expect("two different ends");
        let other = curve.restricted(piece).expect("small numbers");
        let other = other.reparametrised(Interval::unit());
        let partner = |s: f64| if reversed { 1.25 - s } else { s - 0.25 };
        let planted = [0.25, 0.5, 0.8125, 1.0].map(|s| (s, partner(s)));
        (curve, other, planted.to_vec())
    })
}

#[test]
fn intersection_algorithm() {
    let law = |implementation: fn(&PlaneCurve, &PlaneCurve) -> Vec<Meeting>| {
        let inputs = prop_oneof![4 => crossing(), 1 => overlapping()];
        for_all(inputs, |(first, second, planted)| {
            laws::intersection_algorithm(implementation, [first, second], planted)
        })
    };
    holds(law(mutants::intersections));
    rejects("chords only", law(mutants::chords_only));
    rejects("second curve backwards", law(mutants::second_reversed));
    rejects(
        "candidates are certain",
        law(mutants::candidates_are_certain),
    );
}

/// Curves with several planted intersections: a zigzag graph over a line, y = Π (x − xᵢ).
///
/// The roots are chosen first, and the polynomial is built from them.
#[test]
fn several_intersections() {
    let law = |implementation: fn(&PlaneCurve, &PlaneCurve) -> Vec<Meeting>| {
        let roots = prop::collection::btree_set(1i32..=15, 2..=4);
        for_all(roots, |roots| {
            let roots: Vec<f64> = roots.iter().map(|k| f64::from(*k) / 16.0).collect();
            let (graph, planted) = graph_with(&roots);
            let axis = BezierCurve::new([[0.0, 0.0], [12.0, 0.0]].map(Point::new));
            laws::intersection_algorithm(implementation, [&graph, &axis.expect("finite")], &planted)
        })
    };
    holds(law(mutants::intersections));
    rejects("only the first", law(mutants::first_only));
    rejects("second curve backwards", law(mutants::second_reversed));
}

/// The graph of Π (x − xᵢ) over [0, 1], and its intersections with the axis.
///
/// Control values of a product in Bernstein form: Σ over all ways to share i among the factors, which for linear
/// factors is repeated multiplication. The denominators C(n, i) are no powers of two, so the values are multiplied by
/// 12, their common multiple for n ≤ 4.
fn graph_with(roots: &[f64]) -> (PlaneCurve, Vec<(f64, f64)>) {
    let degree = roots.len();
    // Scaled Bernstein coefficients c[i]·C(n, i) multiply like polynomials.
    let mut scaled = vec![12.0];
    for root in roots {
        let mut product = vec![0.0; scaled.len() + 1];
        for (i, value) in scaled.iter().enumerate() {
            product[i] += value * -root;
            product[i + 1] += value * (1.0 - root);
        }
        scaled = product;
    }
    let points = scaled.iter().enumerate().map(|(i, value)| {
        let binomial: f64 = cagd::bezier::binomial(degree, i as i64);
        // 4·x is a whole number of thirds or quarters: the graph is stretched by 12 in x too.
        Point::new([12.0 * i as f64 / degree as f64, value / binomial])
    });
    let graph = BezierCurve::new(points).expect("finite points");
    (graph, roots.iter().map(|x| (*x, *x)).collect())
}

/// kurbo finds the intersections of a cubic and a line by solving for the roots; ours lie in boxes around them.
///
/// Near a touch kurbo's root of a nearly double zero is good to the root of its rounding, 10⁻⁷ or so; 10⁻⁵ is allowed.
#[test]
fn agrees_with_kurbo() {
    use kurbo::{CubicBez, Line, ParamCurve, PathSeg};

    let whole = || (-8i32..=8).prop_map(f64::from);
    let places = prop::collection::vec([whole(), whole()], 6);
    let law = |implementation: fn(&PlaneCurve, &PlaneCurve) -> Vec<Meeting>| {
        for_all(places.clone(), |places| {
            let (cubic, line) = (plane(&places[..4]), plane(&places[4..]));
            let p = |k: usize| kurbo::Point::new(places[k][0], places[k][1]);
            let segment = PathSeg::Cubic(CubicBez::new(p(0), p(1), p(2), p(3)));
            let chord = Line::new(p(4), p(5));
            let inside = |t: f64| 1e-5 < t && t < 1.0 - 1e-5;
            let theirs: Vec<(f64, f64)> = segment
                .intersect_line(chord)
                .into_iter()
                .filter(|hit| inside(hit.segment_t) && inside(hit.line_t))
                // A line along which the cubic runs gives parameters at which they do not meet.
                .filter(|hit| segment.eval(hit.segment_t).distance(chord.eval(hit.line_t)) < 1e-9)
                .map(|hit| (hit.segment_t, hit.line_t))
                .collect();
            let found = implementation(&cubic, &line);
            let away = theirs.iter().map(|&(s, t)| {
                let distance = |range: &Range, x: f64| (range.low() - x).max(x - range.high());
                found
                    .iter()
                    .map(|meeting| distance(&meeting.first, s).max(distance(&meeting.second, t)))
                    .fold(f64::INFINITY, f64::min)
            });
            let name = format!("{cubic} and {line}");
            let away: Vec<f64> = away.collect();
            let allowed = vec![1e-5; away.len()];
            Sides::new(name)
                .at_most(
                    "each of their roots is in a box",
                    away,
                    allowed,
                    Rounding::none(),
                )
                .equal("the input is read", [0.0], [0.0], Rounding::none())
        })
    };
    holds(law(mutants::intersections));
    rejects("second curve backwards", law(mutants::second_reversed));
    rejects("only the first", law(mutants::first_only));
}

fn plane(points: &[[f64; 2]]) -> PlaneCurve {
    BezierCurve::new(points.iter().copied().map(Point::new)).expect("finite points")
}

/// The example of the ledger: the chords (0, 0)(1, 0) and (1/2, h/2)(1/2, 2h) are disjoint, the curves cross.
#[test]
fn a_crossing_between_curve_and_chord() {
    for k in 0..30 {
        let h = 2f64.powi(-k);
        let arch = plane(&[[0.0, 0.0], [0.5, 2.0 * h], [1.0, 0.0]]);
        let post = plane(&[[0.5, 0.5 * h], [0.5, 2.0 * h]]);
        for tolerance in [h, 1e-3 * h] {
            if tolerance < 1e-12 {
                continue;
            }
            let found = arch.intersections(&post, tolerance).expect("little work");
            let [crossing] = found.meetings.as_slice() else {
                panic!("{} boxes for h = {h}", found.meetings.len());
            };
            assert_eq!(crossing.kind, Kind::Certain, "h = {h}");
            assert!(crossing.first.contains(0.5), "h = {h}: {crossing:?}");
            assert!(
                (crossing.second.middle() - 1.0 / 3.0).abs() < 1e-6,
                "h = {h}: {crossing:?}"
            );
        }
    }
}

/// The arch has the slope 1 at t = 1/4, in the point (1, 3/2); the lines are parallel to that tangent.
#[test]
fn near_misses_and_touches() {
    let arch = plane(&[[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]]);
    let kinds = |y: f64| {
        let line = plane(&[[0.0, y], [4.0, 4.0 + y]]);
        let found = arch.intersections(&line, 1e-9).expect("little work");
        found
            .meetings
            .iter()
            .map(|meeting| meeting.kind)
            .collect::<Vec<_>>()
    };
    assert_eq!(kinds(0.5 + 1e-6), [], "a thousand tolerances above");
    assert_eq!(
        kinds(0.5 + 1e-10),
        [Kind::Possible],
        "a tenth of the tolerance above"
    );
    assert_eq!(kinds(0.5), [Kind::Possible], "a touch");
    assert_eq!(kinds(0.5 - 1e-6), [Kind::Certain, Kind::Certain]);
}

#[test]
fn nine_crossings_of_two_cubics() {
    let first =
        plane(&[[0.0, 0.0], [9.0, 10.0], [-6.0, 10.0], [3.0, 0.0]].map(|[x, y]| [x, y * 0.6]));
    let second = plane(&[[-1.5, 2.0], [13.0, -2.0], [-10.0, 7.0], [4.5, 2.0]]);
    let found = first.intersections(&second, 1e-9).expect("little work");
    assert!(
        found.meetings.len() <= 9,
        "Bézout: at most 3·3, found {}",
        found.meetings.len()
    );
    assert!(
        found
            .meetings
            .iter()
            .all(|meeting| meeting.kind == Kind::Certain),
        "{found:?}"
    );
    // Dense sampling finds as many sign changes of the implicit test: polylines that cross.
    let polyline = |curve: &PlaneCurve| {
        (0..=400)
            .map(|k| curve.at(f64::from(k) / 400.0))
            .collect::<Vec<_>>()
    };
    let (a, b) = (polyline(&first), polyline(&second));
    let side = |p: &[Point<f64, 2>], q: &Point<f64, 2>| {
        let (along, offset) = (p[1] - p[0], *q - p[0]);
        along[0] * offset[1] - along[1] * offset[0]
    };
    let crossings = a
        .windows(2)
        .flat_map(|p| b.windows(2).map(move |q| (p, q)))
        .filter(|(p, q)| {
            side(p, &q[0]) * side(p, &q[1]) < 0.0 && side(q, &p[0]) * side(q, &p[1]) < 0.0
        });
    assert_eq!(crossings.count(), found.meetings.len());
}

#[test]
fn shared_arcs_are_overlaps() {
    let curve = plane(&[[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [4.0, 0.0]]);
    let piece = Interval::new(0.4, 1.2).expect("two ends");
    let other = curve.restricted(piece).expect("small numbers");
    let found = curve.intersections(&other, 1e-9).expect("little work");
    let [arc] = found.meetings.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(arc.kind, Kind::Overlap { reversed: false });
    assert!(
        (arc.first.low() - 0.4).abs() < 1e-4 && arc.first.high() == 1.0,
        "{arc:?}"
    );
    assert!(
        (arc.second.high() - 1.0).abs() < 1e-4,
        "parameters of the other domain: {arc:?}"
    );
    let elevated = curve.elevated_times(2);
    let found = elevated.intersections(&curve, 1e-9).expect("little work");
    assert!(
        matches!(found.meetings.as_slice(), [meeting] if meeting.kind == Kind::Overlap { reversed: false })
    );
}

#[test]
fn bad_input_is_a_typed_error() {
    let curve = plane(&[[0.0, 0.0], [1.0, 3.0]]);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = curve.intersections(&curve, tolerance);
        assert!(
            matches!(error, Err(IntersectionError::Tolerance(_))),
            "{tolerance}"
        );
    }
    let error = curve.intersections(&curve, 1e-17);
    assert!(matches!(
        error,
        Err(IntersectionError::BelowRounding { .. })
    ));
    let point = plane(&[[0.5, 1.5]]);
    let found = curve.intersections(&point, 1e-9).expect("little work");
    assert!(
        found.meetings[0].first.contains(0.5),
        "a curve of degree 0 that lies on the other"
    );
}
