//! Properties of parametric curves.

use cagd::affine::{Interval, Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::curves::{GaussLegendre, ParametricCurve, PlaneCurvature, SpaceCurvature};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{curves_and_parameters, for_all};
use crate::support::{holds, rejects};

/// The helix (r cos t, r sin t, h t), whose curvature and torsion are constant.
struct Helix {
    radius: f64,
    pitch: f64,
}

impl ParametricCurve for Helix {
    type Point = Point<f64, 3>;

    fn domain(&self) -> Interval<f64> {
        Interval::new(0.0, 10.0).expect("two different ends")
    }

    fn at(&self, t: f64) -> Point<f64, 3> {
        Point::new([self.radius * t.cos(), self.radius * t.sin(), self.pitch * t])
    }

    fn derivatives<const K: usize>(&self, t: f64) -> [Vector<f64, 3>; K] {
        let (mut x, mut y) = (self.radius * t.cos(), self.radius * t.sin());
        std::array::from_fn(|k| {
            (x, y) = (-y, x);
            Vector::from([x, y, if k == 0 { self.pitch } else { 0.0 }])
        })
    }
}

/// κ = r/(r² + h²) and τ = h/(r² + h²), for radii from tiny to huge.
#[test]
fn helix() {
    let inputs = || {
        (
            0.1..8.0,
            -8.0..8.0,
            0.0..10.0,
            prop_oneof![Just(1.0), Just(1e150), Just(1e-150)],
        )
    };
    let law = |torsion: fn(&Helix, f64) -> f64| {
        for_all(
            inputs(),
            |&(radius, pitch, t, scale): &(f64, f64, f64, f64)| {
                let helix = Helix {
                    radius: radius * scale,
                    pitch: pitch * scale,
                };
                let square = radius * radius + pitch * pitch;
                // Sine and cosine are right up to a rounding or two, and each formula to 16 (see its documentation); times
                // the scale the terms of κ and τ are at most 1/√(r² + h²), those of the determinant 3 times that.
                let rounding = Rounding::new(32, 3.0 / square.sqrt());
                Sides::new(format!("r = {radius}, h = {pitch}, t = {t}, scale {scale}"))
                    .equal(
                        "curvature",
                        [SpaceCurvature::curvature(&helix, t).expect("regular") * scale],
                        [radius / square],
                        rounding,
                    )
                    .equal(
                        "torsion",
                        [torsion(&helix, t) * scale],
                        [pitch / square],
                        rounding,
                    )
            },
        )
    };
    holds(law(|helix, t| helix.torsion(t).expect("curved")));
    rejects(
        "the other sign",
        law(|helix, t| -helix.torsion(t).expect("curved")),
    );
}

/// Scaling by a power of two divides the curvature by it, bit for bit: nothing overflows on the way.
#[test]
fn curvature_of_a_scaled_curve() {
    type Curvature = fn(&BezierCurve<Point<f64, 2>>, f64) -> Option<f64>;
    let law = |curvature: Curvature| {
        for_all(
            (curves_and_parameters(), -60..60),
            |((curve, u), exponent)| {
                let scale = 2f64.powi(*exponent);
                let points = curve.control_points().iter().map(|p| p.map(|x| x * scale));
                let scaled = BezierCurve::on(*curve.domain(), points).expect("finite points");
                Sides::new(format!("scale {scale:e}, u = {u}, {curve}"))
                    .equal(
                        "κ of the scaled curve, times the scale",
                        curvature(&scaled, *u).map(|k| k * scale),
                        curvature(curve, *u),
                        Rounding::none(),
                    )
                    .equal("one number is compared", [0.0], [0.0], Rounding::none())
            },
        )
    };
    holds(law(|curve, u| curve.curvature(u).ok()));
    rejects(
        "the formula without scaling",
        law(|curve, u| {
            let [first, second] = curve.derivatives(u);
            let cube = first.norm_squared() * first.norm_squared().sqrt();
            (cube != 0.0).then(|| (first[0] * second[1] - first[1] * second[0]) / cube)
        }),
    );
}

/// The osculating circle has the point, the tangent and the curvature of the curve.
#[test]
fn osculating_circle() {
    let law = |turn: f64| {
        for_all(curves_and_parameters(), |(curve, u)| {
            let sides = Sides::new(format!("u = {u}, {curve}"));
            let Ok(circle) = curve.osculating_circle(*u) else {
                return sides.equal("there is none", [0.0], [0.0], Rounding::none());
            };
            let curvature = curve.curvature(*u).expect("there is a circle");
            let point = curve.at(*u);
            let size = point[0].abs().max(point[1].abs()) + circle.radius();
            sides
                .equal(
                    "the circle touches the curve at its point",
                    circle.at(turn).coordinates().to_vec(),
                    point.coordinates().to_vec(),
                    Rounding::new(8, 2.0 * size),
                )
                .equal(
                    "its radius is 1/|κ|",
                    [circle.radius() * curvature.abs()],
                    [1.0],
                    Rounding::new(2, 1.0),
                )
        })
    };
    holds(law(0.0));
    rejects("the point on the other side", law(std::f64::consts::PI));
}

/// A rule with m nodes integrates xᵏ exactly for k < 2m: the integral over [−1, 1] is 2/(k + 1) or 0.
#[test]
fn gauss_legendre() {
    let law = |rule: fn(usize) -> GaussLegendre| {
        for_all(
            (1..=20usize).prop_flat_map(|m| (Just(m), 0..2 * m)),
            |&(m, k)| {
                let rule = rule(m);
                let sum: f64 = rule.nodes().iter().map(|(x, w)| w * x.powi(k as i32)).sum();
                let exact = if k % 2 == 0 {
                    2.0 / (k + 1) as f64
                } else {
                    0.0
                };
                // Nodes and weights are right up to 8 roundings of 1: that is what this test confirms. A shift of a node changes xᵏ
                // k times as much; powers and sum pass k + m more. The weights sum to 2.
                Sides::new(format!("{m} nodes, x^{k}")).equal(
                    "the integral of a power",
                    [sum],
                    [exact],
                    Rounding::new(8 + 8 * k + k + m, 2.0),
                )
            },
        )
    };
    holds(law(GaussLegendre::new));
    rejects("one node fewer", law(|m| GaussLegendre::new(m - 1)));
}
