//! Properties of arc lengths and nearest points: what is guaranteed, on random curves.

use std::num::NonZeroUsize;

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, Foot, Nearest, bernstein_product};
use cagd::curves::{ArcLength, Certainty, Rectifiable, polyline};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{
    MAX_DEGREE, curve, curves_and_parameters, for_all, local_parameter, point,
};
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;

/// The largest coordinate, or 1 if all are 0.
fn size(curve: &Curve) -> f64 {
    let coordinates = curve.control_points().iter().flat_map(|p| p.coordinates());
    let largest = coordinates.fold(0.0, |m: f64, x| m.max(x.abs()));
    if largest == 0.0 { 1.0 } else { largest }
}

fn norms<'a>(
    points: impl IntoIterator<Item = (&'a Point<f64, 2>, &'a Point<f64, 2>)>,
    size: f64,
) -> f64 {
    // Scaled, so that squares of huge and tiny differences stay in range.
    points
        .into_iter()
        .map(|(p, q)| ((*q - *p) / size).norm())
        .sum::<f64>()
        * size
}

/// The length of a polyline; in units of `size` it is right up to (3 + number of points) roundings.
fn polyline_length(points: &[Point<f64, 2>], size: f64) -> f64 {
    norms(std::iter::zip(points, &points[1..]), size)
}

/// A length with a guaranteed error: not shorter than inscribed polylines, not longer than subdivided
/// control polygons, and within its error of a length with a smaller one.
fn arc_length_is_enclosed(
    implementation: impl Fn(&Curve, f64) -> ArcLength,
    curve: &Curve,
) -> Sides<f64> {
    let size = size(curve);
    let rough = implementation(curve, 1e-3 * size);
    let fine = implementation(curve, 1e-10 * size);
    let segments = NonZeroUsize::new(64).expect("64 is not 0");
    let inscribed = polyline_length(&polyline(curve, segments), size);
    let mut pieces = vec![curve.control_points().to_vec()];
    for _ in 0..4 {
        pieces = pieces
            .iter()
            .flat_map(|points| {
                let piece = Curve::new(points.iter().copied()).expect("finite points");
                let triangle = piece.triangle(0.5);
                [
                    triangle.left_side().copied().collect::<Vec<_>>(),
                    triangle.right_side().copied().collect(),
                ]
            })
            .collect();
    }
    let circumscribed: f64 = pieces
        .iter()
        .map(|points| polyline_length(points, size))
        .sum();
    // Points of both pass at most 3n roundings of a size below 2·size; there are 64 segments, 16(n + 1) legs.
    let n = curve.degree();
    let rounding = Rounding::new(8 * n + 8, 200.0 * (n + 1) as f64 * size);
    Sides::new(curve)
        .at_most(
            "not shorter than a polyline",
            [inscribed],
            [fine.value + fine.error],
            rounding,
        )
        .at_most(
            "not longer than polygons",
            [fine.value - fine.error],
            [circumscribed],
            rounding,
        )
        .at_most(
            "two lengths differ by at most both errors",
            [(rough.value - fine.value).abs()],
            [rough.error + fine.error],
            Rounding::none(),
        )
        .at_most(
            "errors are at most the tolerance",
            [rough.error, fine.error],
            [1e-3 * size, 1e-10 * size],
            Rounding::none(),
        )
}

#[test]
fn arc_length() {
    let law = |implementation: fn(&Curve, f64) -> ArcLength| {
        for_all(curve(), |curve| {
            arc_length_is_enclosed(implementation, curve)
        })
    };
    let library: fn(&Curve, f64) -> ArcLength = |curve, tolerance| {
        curve
            .arc_length(tolerance)
            .expect("the tolerance is within reach")
    };
    holds(law(library));
    rejects(
        "the chord",
        law(|curve, _| ArcLength {
            value: polyline_length(
                &[
                    curve.at(curve.domain().start()),
                    curve.at(curve.domain().end()),
                ],
                size(curve),
            ),
            error: 0.0,
            certainty: Certainty::Guaranteed,
        }),
    );
    rejects(
        "the control polygon",
        law(|curve, _| ArcLength {
            value: polyline_length(curve.control_points(), size(curve)),
            error: 0.0,
            certainty: Certainty::Guaranteed,
        }),
    );
    rejects(
        "an error that promises too much",
        law(|curve, tolerance| {
            let right = curve
                .arc_length(tolerance)
                .expect("the tolerance is within reach");
            ArcLength {
                value: right.value + 1e-9 * size(curve),
                ..right
            }
        }),
    );
}

/// The length up to the parameter is the given share of the whole.
#[test]
fn parameter_at_length() {
    let law = |implementation: fn(&Curve, f64, f64) -> f64| {
        for_all((curve(), 0.0..=1.0), |(curve, share)| {
            let tolerance = 1e-8 * size(curve);
            let whole = curve.arc_length(0.1 * tolerance).expect("within reach");
            let target = share * whole.value;
            let u = implementation(curve, target, tolerance);
            let t = curve.domain().local(u);
            let triangle = curve.triangle(u);
            let left = Curve::new(triangle.left_side().copied()).expect("finite points");
            let reached = left.arc_length(0.1 * tolerance).expect("within reach");
            // The triangle rounds 3n times; t itself is the result of a division, so it counts n times more.
            let n = curve.degree();
            Sides::new(format!("share {share}, {curve}"))
                .at_most(
                    "inside the domain",
                    [0.0, t],
                    [t, 1.0],
                    Rounding::new(3, 1.0),
                )
                .at_most(
                    "the length up to the parameter is the given one",
                    [(reached.value - target).abs()],
                    [1.2 * tolerance],
                    Rounding::new(8 * n + 8, 4.0 * (n + 1) as f64 * size(curve)),
                )
        })
    };
    holds(law(|curve, length, tolerance| {
        curve
            .parameter_at_length(length, tolerance)
            .expect("a length of the curve")
    }));
    rejects(
        "proportional to the parameter",
        law(|curve, length, _| {
            let whole = curve
                .arc_length(1e-9 * size(curve))
                .expect("within reach")
                .value;
            curve
                .domain()
                .global(if whole == 0.0 { 0.0 } else { length / whole })
        }),
    );
}

/// The estimated length of a regular curve agrees with the guaranteed one.
///
/// Where the curve turns back, the estimate may be too small: on (0, 3), (0, 4), (0, −4), (0, 4) the error is
/// three times the tolerance. So the curves of this test always go to the right.
#[test]
fn estimated_arc_length() {
    let regular = || {
        curve().prop_map(|curve| {
            let size = size(&curve);
            let points = curve.control_points().iter().enumerate();
            let points = points.map(|(i, p)| Point::new([i as f64 * size, p[1]]));
            Curve::on(*curve.domain(), points).expect("finite points")
        })
    };
    let law = |implementation: fn(&Curve, f64) -> f64| {
        for_all(regular(), |curve| {
            let tolerance = 1e-9 * size(curve);
            let right = curve.arc_length(tolerance).expect("within reach");
            Sides::new(curve).at_most(
                "estimated and guaranteed length agree",
                [(implementation(curve, tolerance) - right.value).abs()],
                [2.0 * tolerance],
                Rounding::none(),
            )
        })
    };
    holds(law(|curve, tolerance| {
        Rectifiable::arc_length(curve, tolerance)
            .expect("within reach")
            .value
    }));
    rejects(
        "the chord",
        law(|curve, _| {
            polyline_length(
                &[
                    curve.at(curve.domain().start()),
                    curve.at(curve.domain().end()),
                ],
                size(curve),
            )
        }),
    );
}

/// A curve and a point of its size, often on the curve.
fn curves_and_points() -> impl Strategy<Value = (Curve, Point<f64, 2>)> {
    (curves_and_parameters(), point(1.0), 0..3).prop_map(|((curve, u), p, kind)| {
        let place = match kind {
            0 => curve.at(u),
            _ => Point::new([p[0] * size(&curve) / 8.0, p[1] * size(&curve) / 8.0]),
        };
        (curve, place)
    })
}

fn distance(p: &Point<f64, 2>, q: &Point<f64, 2>, size: f64) -> f64 {
    norms([(p, q)], size)
}

/// No sampled point is nearer, and every foot is as near as it says.
fn nearest_is_nearest(
    implementation: impl Fn(&Curve, &Point<f64, 2>, f64) -> Nearest<2>,
    curve: &Curve,
    p: &Point<f64, 2>,
) -> Sides<f64> {
    // Parameters outside the domain may throw p far away.
    let size = size(curve).max(p[0].abs()).max(p[1].abs());
    let tolerance = 1e-8 * size;
    let found = implementation(curve, p, tolerance);
    let segments = NonZeroUsize::new(200).expect("200 is not 0");
    let sampled = polyline(curve, segments)
        .iter()
        .map(|q| distance(p, q, size))
        .fold(f64::INFINITY, f64::min);
    let rounding = Rounding::new(6 * curve.degree() + 8, 4.0 * size);
    let feet = |value: fn(&Foot<2>) -> f64| found.feet.iter().map(value).collect::<Vec<_>>();
    let recomputed = found
        .feet
        .iter()
        .map(|foot| distance(p, &curve.at(foot.parameter), size));
    let limit = vec![found.distance + tolerance; found.feet.len()];
    Sides::new(format!("p = {p}, {curve}"))
        .at_most(
            "no sample is nearer",
            [found.distance],
            [sampled + tolerance],
            rounding,
        )
        .at_most(
            "every foot is a nearest point",
            feet(|foot| foot.distance),
            limit,
            rounding,
        )
        .equal(
            "distances of feet are those of their points",
            feet(|foot| foot.distance),
            recomputed,
            rounding,
        )
        .at_most(
            "parameters are in their ranges",
            feet(|foot| (foot.parameter - foot.range[0]).min(foot.range[1] - foot.parameter))
                .into_iter()
                .map(|x| -x),
            vec![0.0; found.feet.len()],
            Rounding::new(4, 200.0),
        )
        .at_most(
            "there is a foot",
            [1.0],
            [found.feet.len() as f64],
            Rounding::none(),
        )
}

fn library(curve: &Curve, p: &Point<f64, 2>, tolerance: f64) -> Nearest<2> {
    curve
        .nearest(p, tolerance)
        .expect("the tolerance is within reach")
}

#[test]
fn nearest() {
    let law = |implementation: fn(&Curve, &Point<f64, 2>, f64) -> Nearest<2>| {
        for_all(curves_and_points(), |(curve, p)| {
            nearest_is_nearest(implementation, curve, p)
        })
    };
    holds(law(library));
    rejects(
        "Newton's method from the middle",
        law(|curve, p, tolerance| {
            let mut u = curve.domain().global(0.5);
            for _ in 0..20 {
                let [first, second] = curve.derivatives(u);
                let offset = curve.at(u) - *p;
                let step = offset.dot(&first) / (first.dot(&first) + offset.dot(&second));
                u = if step.is_finite() {
                    (u - step).clamp(curve.domain().start(), curve.domain().end())
                } else {
                    u
                };
            }
            let size = size(curve).max(p[0].abs()).max(p[1].abs());
            let distance = distance(p, &curve.at(u), size);
            Nearest {
                distance,
                tolerance,
                feet: vec![Foot {
                    range: [u, u],
                    parameter: u,
                    point: curve.at(u),
                    distance,
                }],
            }
        }),
    );
}

/// A curve with an axis of symmetry has nearest points in pairs: none is missed.
#[test]
fn none_is_missed() {
    let symmetric = || {
        (prop::collection::vec(point(1.0), 1..=4), -8.0..8.0).prop_map(|(half, height)| {
            let mirrored: Vec<_> = half
                .iter()
                .rev()
                .map(|p| Point::new([-p[0], p[1]]))
                .collect();
            let points = half.into_iter().chain(mirrored);
            (
                Curve::new(points).expect("finite points"),
                Point::new([0.0, height]),
            )
        })
    };
    let law = |implementation: fn(&Curve, &Point<f64, 2>, f64) -> Nearest<2>| {
        for_all(symmetric(), |(curve, p)| {
            let found = implementation(curve, p, 1e-8);
            // The mirror image of a foot is as near up to rounding, so it is in some range up to the tolerance: the
            // parameters of the ranges are compared by the distance of their points.
            let missed = found.feet.iter().filter(|foot| {
                let mirror = 1.0 - foot.parameter;
                !found.feet.iter().any(|other| {
                    let [low, high] = other.range;
                    let at = mirror.clamp(low, high);
                    (curve.at(at) - curve.at(mirror)).norm() <= 1e-8
                })
            });
            Sides::new(format!("p = {p}, {curve}")).equal(
                "number of feet whose mirror image is missed",
                [missed.count() as f64],
                [0.0],
                Rounding::none(),
            )
        })
    };
    holds(law(library));
    rejects(
        "only the first",
        law(|curve, p, tolerance| {
            let mut found = library(curve, p, tolerance);
            found.feet.truncate(1);
            found
        }),
    );
}

/// The product of the coefficients is the product of the values.
#[test]
fn product_of_polynomials() {
    let polynomial = || prop::collection::vec(-8.0..8.0, 1..=MAX_DEGREE + 1);
    let law = |implementation: fn(&[f64], &[f64]) -> Vec<f64>| {
        for_all(
            (polynomial(), polynomial(), local_parameter()),
            |(f, g, t)| {
                let value = |coefficients: &[f64]| {
                    BezierCurve::new(coefficients.iter().copied())
                        .expect("finite")
                        .at(*t)
                };
                let degree = f.len() + g.len() - 2;
                // Each coefficient passes 4 roundings a term and a sum; evaluation 3 a level on both sides.
                let rounding = Rounding::new(
                    7 * degree + 8,
                    64.0 * (t.abs() + (1.0 - t).abs()).powi(degree as i32),
                );
                Sides::new(format!("f = {f:?}, g = {g:?}, t = {t}")).equal(
                    "(f·g)(t) = f(t)·g(t)",
                    [value(&implementation(f, g))],
                    [value(f) * value(g)],
                    rounding,
                )
            },
        )
    };
    holds(law(bernstein_product));
    rejects(
        "coefficients convolved without binomials",
        law(|f, g| {
            let mut product = vec![0.0; f.len() + g.len() - 1];
            for (i, x) in f.iter().enumerate() {
                for (j, y) in g.iter().enumerate() {
                    product[i + j] += x * y;
                }
            }
            product
        }),
    );
}

/// A point has one coordinate list; nothing here depends on the dimension.
#[test]
fn space_curves_have_lengths_and_nearest_points() {
    let law = |lift: fn(&Curve) -> BezierCurve<Point<f64, 3>>| {
        for_all(curve(), |curve| {
            let size = size(curve);
            let lifted = lift(curve);
            let tolerance = 1e-9 * size;
            let plane = curve.arc_length(tolerance).expect("within reach");
            let space = lifted.arc_length(tolerance).expect("within reach");
            Sides::new(curve).at_most(
                "a congruent curve in space has the same length",
                [(plane.value - space.value).abs()],
                [plane.error + space.error],
                Rounding::none(),
            )
        })
    };
    holds(law(|curve| {
        let points = curve.control_points().iter();
        BezierCurve::new(points.map(|p| Point::new([p[1], 0.0, p[0]]))).expect("finite points")
    }));
    rejects(
        "a stretched copy",
        law(|curve| {
            let points = curve.control_points().iter();
            BezierCurve::new(points.map(|p| Point::new([p[1], p[0], p[0]]))).expect("finite points")
        }),
    );
}
