//! Flattening keeps its tolerance, and with few chords.

use cagd::affine::Point;
use cagd::bezier::bounds::segment_distance_squared;
use cagd::bezier::{BezierCurve, FlatteningError, Polyline};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{curve, for_all};
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Flatten = fn(&Curve, f64) -> Polyline<Point<f64, 2>>;

fn size(curve: &Curve) -> f64 {
    curve
        .control_points()
        .iter()
        .flat_map(|point| point.coordinates().to_vec())
        .fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

/// The largest distance of the curve from the chord of its arc, at 32 places an arc, and at its vertices from the curve.
///
/// The distances are charged to the tolerance inside the library with their rounding: no bound is needed here.
/// Coordinates are divided by the size, so that no square leaves the range.
fn keeps(implementation: Flatten, curve: &Curve, relative: f64) -> Sides<f64> {
    let size = size(curve);
    let polyline = implementation(curve, relative * size);
    let unit = |point: Point<f64, 2>| point.map(|x| x / size);
    let mut worst: f64 = 0.0;
    for (ends, parameters) in
        std::iter::zip(polyline.vertices.windows(2), polyline.parameters.windows(2))
    {
        let chord = [unit(ends[0]), unit(ends[1])];
        for k in 0..=32 {
            let share = f64::from(k) / 32.0;
            let u = parameters[0] * (1.0 - share) + parameters[1] * share;
            let point = unit(curve.at(u));
            worst = worst.max(segment_distance_squared(&point, &chord[0], &chord[1]));
        }
    }
    let ends = [
        polyline.parameters[0],
        *polyline.parameters.last().expect("a vertex"),
    ];
    let domain = curve.domain();
    Sides::new(curve)
        .at_most(
            "the polyline is near",
            [worst.sqrt()],
            [relative],
            Rounding::none(),
        )
        .equal(
            "it reaches from end to end",
            ends,
            [domain.start(), domain.end()],
            Rounding::none(),
        )
}

/// Curves that are more than the origin, and a tolerance relative to their size.
fn inputs() -> impl Strategy<Value = (Curve, f64)> {
    let tolerance = (1i32..=5, 1.0..10.0).prop_map(|(power, x): (i32, f64)| x * 10f64.powi(-power));
    let curves = curve().prop_filter("not all at the origin", |curve| size(curve) > 0.0);
    (curves, tolerance)
}

#[test]
fn uniform_flattening_keeps_the_tolerance() {
    let law = |implementation: Flatten| {
        for_all(inputs(), |(curve, relative)| {
            keeps(implementation, curve, *relative)
        })
    };
    holds(law(|curve, tolerance| {
        curve.flattened_uniformly(tolerance).expect("a tolerance")
    }));
    rejects(
        "half the chords",
        law(|curve, tolerance| {
            every_other(&curve.flattened_uniformly(tolerance).expect("a tolerance"))
        }),
    );
}

#[test]
fn flattening_keeps_the_tolerance() {
    let law = |implementation: Flatten| {
        for_all(inputs(), |(curve, relative)| {
            keeps(implementation, curve, *relative)
        })
    };
    holds(law(|curve, tolerance| {
        curve.flattened(tolerance).expect("a tolerance")
    }));
    rejects(
        "half the chords",
        law(|curve, tolerance| every_other(&curve.flattened(tolerance).expect("a tolerance"))),
    );
    rejects(
        "twice the tolerance",
        law(|curve, tolerance| curve.flattened(2.0 * tolerance).expect("a tolerance")),
    );
}

fn every_other(polyline: &Polyline<Point<f64, 2>>) -> Polyline<Point<f64, 2>> {
    let last = polyline.chords();
    let kept = (0..=last).filter(|i| i % 2 == 0 || *i == last);
    let (parameters, vertices) = kept
        .map(|i| (polyline.parameters[i], polyline.vertices[i]))
        .unzip();
    Polyline {
        parameters,
        vertices,
    }
}

/// Fewer chords than this are not possible: see the comments inside.
fn fewest(curve: &Curve, tolerance: f64) -> usize {
    // Any places on the curve would do; these stand about thirty to a chord, however fast the curve runs.
    let fine = curve.flattened(tolerance / 900.0).expect("a tolerance");
    let samples = fine.vertices;
    let last = samples.len() - 1;
    let fits = |from: usize, to: usize| {
        // Only samples are looked at, so this says yes more often than the truth.
        // The middle first, where most chords fail.
        let step = ((to - from) / 24).max(1);
        let near = |k: usize| {
            segment_distance_squared(&samples[k], &samples[from], &samples[to])
                <= tolerance * tolerance
        };
        near(usize::midpoint(from, to)) && (from..to).step_by(step).all(near)
    };
    let mut count = 0;
    let mut start = 0;
    while start < last {
        let mut end = start + 1;
        // The farthest vertex, even if nearer ones do not fit.
        for candidate in start + 1..=last {
            if fits(start, candidate) {
                end = candidate;
            }
        }
        // A true vertex lies between two of the grid: one step more for the one that follows.
        start = end + usize::from(end < last);
        count += 1;
    }
    count
}

/// At most 1.15 times the fewest chords, and one for the remainder at the end.
#[test]
fn flattening_takes_few_chords() {
    let cubics = prop::collection::vec([0.0..1000.0, 0.0..1000.0].prop_map(Point::new), 4);
    let law = |implementation: Flatten| {
        let inputs = cubics
            .clone()
            .prop_map(|points| BezierCurve::new(points).expect("finite"));
        for_all(inputs, |curve| {
            let chords = implementation(curve, 0.5).chords() as f64;
            let fewest = fewest(curve, 0.5) as f64;
            Sides::new(curve).at_most(
                "few chords",
                [chords],
                [(1.15 * fewest).ceil()],
                Rounding::none(),
            )
        })
    };
    holds(law(|curve, tolerance| {
        curve.flattened(tolerance).expect("a tolerance")
    }));
    rejects(
        "uniform parameters",
        law(|curve, tolerance| curve.flattened_uniformly(tolerance).expect("a tolerance")),
    );
}

#[test]
fn bad_input_is_a_typed_error() {
    let curve =
        BezierCurve::new([[0.0, 0.0], [1.0, 3.0], [2.0, 0.0]].map(Point::new)).expect("finite");
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(
            matches!(
                curve.flattened(tolerance),
                Err(FlatteningError::Tolerance(_))
            ),
            "{tolerance}"
        );
        assert!(
            matches!(
                curve.flattened_uniformly(tolerance),
                Err(FlatteningError::Tolerance(_))
            ),
            "{tolerance}"
        );
    }
    assert!(matches!(
        curve.flattened(1e-18),
        Err(FlatteningError::BelowRounding { .. })
    ));
    let huge = BezierCurve::new([[-1e308, 0.0], [1e308, 3.0], [-1e308, 0.0]].map(Point::new))
        .expect("finite");
    assert!(
        matches!(huge.flattened(1.0), Err(FlatteningError::Tolerance(_))),
        "the bound is infinite"
    );
}
