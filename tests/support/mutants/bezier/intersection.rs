//! Wrong searches for intersections.

use cagd::bezier::PlaneCurve;
use cagd::bezier::bounds::euclidean_norm;
use cagd::bezier::intersection::{IntersectionError, Kind, Meeting, Range};

/// The tolerance of the tests, relative to the size of the curves.
pub const RELATIVE: f64 = 1e-9;

pub fn tolerance(curves: [&PlaneCurve; 2]) -> f64 {
    let size = curves
        .iter()
        .flat_map(|curve| curve.control_points())
        .flat_map(|point| point.coordinates().to_vec())
        .fold(0.0, |largest: f64, x| largest.max(x.abs()));
    RELATIVE * size.max(f64::MIN_POSITIVE / RELATIVE)
}

/// The library's search; what it found so far if it gives up.
pub fn intersections(first: &PlaneCurve, second: &PlaneCurve) -> Vec<Meeting> {
    match first.intersections_within(second, tolerance([first, second]), 4000) {
        Ok(found) => found.meetings,
        Err(IntersectionError::TooMuchWork { found, .. }) => found.meetings,
        Err(other) => panic!("{other}"),
    }
}

/// Flattens both curves and intersects the chords: loses what crosses between curve and chord, and touches.
pub fn chords_only(first: &PlaneCurve, second: &PlaneCurve) -> Vec<Meeting> {
    let coarse = 1e6 * tolerance([first, second]);
    let depth = [first, second].map(|curve| {
        curve
            .subdivision_depth(&coarse, euclidean_norm)
            .expect("a positive tolerance")
    });
    let pairs = first.surviving_pairs(second, depth[0].max(depth[1]));
    let chord = |curve: &PlaneCurve, range: &Range| {
        [range.low(), range.high()].map(|t| curve.at(curve.domain().global(t)))
    };
    let parted = |line: &[_; 2], ends: &[_; 2]| {
        let side = |line: &[cagd::affine::Point<f64, 2>; 2],
                    point: &cagd::affine::Point<f64, 2>| {
            let (along, offset) = (line[1] - line[0], *point - line[0]);
            along[0] * offset[1] - along[1] * offset[0]
        };
        let [a, b] = [0, 1].map(|k| side(line, &ends[k]));
        (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)
    };
    pairs
        .into_iter()
        .filter(|[s, t]| {
            let [a, b] = [chord(first, s), chord(second, t)];
            parted(&a, &b) && parted(&b, &a)
        })
        .map(|[first, second]| Meeting {
            first,
            second,
            kind: Kind::Possible,
        })
        .collect()
}

/// Runs backwards along the second curve.
pub fn second_reversed(first: &PlaneCurve, second: &PlaneCurve) -> Vec<Meeting> {
    let domain = second.domain();
    let mirrored = |u: f64| domain.start() + domain.end() - u;
    let turn = |meeting: Meeting| Meeting {
        second: Range::new(
            mirrored(meeting.second.high()),
            mirrored(meeting.second.low()),
        ),
        ..meeting
    };
    intersections(first, second).into_iter().map(turn).collect()
}

/// Stops at the first intersection.
pub fn first_only(first: &PlaneCurve, second: &PlaneCurve) -> Vec<Meeting> {
    intersections(first, second).into_iter().take(1).collect()
}

/// Takes every candidate for an intersection: the boxes that survive six halvings.
pub fn candidates_are_certain(first: &PlaneCurve, second: &PlaneCurve) -> Vec<Meeting> {
    let mut found = intersections(first, second);
    for meeting in &mut found {
        meeting.kind = Kind::Certain;
    }
    found.extend(first.surviving_pairs(second, 3).into_iter().map(|[s, t]| {
        let [s, t] = [(first, s), (second, t)].map(|(curve, range)| {
            let u = curve.domain().global(range.middle());
            Range::new(u, u)
        });
        Meeting {
            first: s,
            second: t,
            kind: Kind::Certain,
        }
    }));
    found
}
