//! Lines, parabolas and cubics beside kurbo and lyon_geom, on random curves.
//!
//! Bounds: both sides compute with coordinates up to 8 and parameters in [0, 1]. A value of degree n ≤ 3 passes at most
//! 3n roundings by de Casteljau and as many in the power form used there; with derivatives a few more.
//! `ROUNDING` allows 64 roundings of 64, far above every sum of terms here and far below every mistake.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::curves::PlaneCurvature;
use cagd::law::Rounding;
use kurbo::{
    CubicBez, Line, ParamCurve, ParamCurveArclen, ParamCurveCurvature, ParamCurveDeriv,
    ParamCurveExtrema, ParamCurveNearest, QuadBez,
};
use lyon_geom::CubicBezierSegment;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

type Curve = BezierCurve<Point<f64, 2>>;

fn rounding() -> f64 {
    Rounding::new(64, 64.0).bound()
}

/// Tries a comparison on 256 inputs, the same in every run.
fn for_all<S: Strategy>(inputs: S, compare: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let config = Config {
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    if let Err(error) = TestRunner::new_with_rng(config, rng).run(&inputs, compare) {
        panic!("{error}");
    }
}

fn point() -> impl Strategy<Value = [f64; 2]> {
    prop_oneof![
        [-8.0..8.0, -8.0..8.0],
        [-8i32..=8, -8i32..=8].prop_map(|p| p.map(f64::from))
    ]
}

/// Coordinates of a cubic: general, and with repeated points.
fn cubic() -> impl Strategy<Value = [[f64; 2]; 4]> {
    ([point(), point(), point(), point()], 0..6).prop_map(|(mut p, kind)| {
        match kind {
            0 => p[1] = p[0],
            1 => p[3] = p[0],
            _ => {}
        }
        p
    })
}

fn ours<const N: usize>(points: [[f64; 2]; N]) -> Curve {
    Curve::new(points.map(Point::new)).expect("finite points")
}

fn kurbo_point([x, y]: [f64; 2]) -> kurbo::Point {
    kurbo::Point::new(x, y)
}

fn kurbo_cubic(points: [[f64; 2]; 4]) -> CubicBez {
    let [a, b, c, d] = points.map(kurbo_point);
    CubicBez::new(a, b, c, d)
}

fn lyon_cubic(points: [[f64; 2]; 4]) -> CubicBezierSegment<f64> {
    let [from, ctrl1, ctrl2, to] = points.map(|[x, y]| lyon_geom::point(x, y));
    CubicBezierSegment {
        from,
        ctrl1,
        ctrl2,
        to,
    }
}

/// The largest difference of the coordinates.
fn gap(ours: &[f64], theirs: [f64; 2]) -> f64 {
    (ours[0] - theirs[0]).abs().max((ours[1] - theirs[1]).abs())
}

#[track_caller]
fn close(what: &str, gap: f64, bound: f64) -> Result<(), TestCaseError> {
    prop_assert!(gap <= bound, "{what}: apart by {gap:e} > {bound:e}");
    Ok(())
}

#[test]
fn points() {
    for_all((cubic(), 0.0..=1.0), |(p, t)| {
        let ours_at = |curve: Curve| curve.at(t);
        let [a, b, c, _] = p;
        let line = Line::new(kurbo_point(a), kurbo_point(b)).eval(t);
        let parabola = QuadBez::new(kurbo_point(a), kurbo_point(b), kurbo_point(c)).eval(t);
        let cubic = kurbo_cubic(p).eval(t);
        let lyon = lyon_cubic(p).sample(t);
        close(
            "line",
            gap(ours_at(ours([a, b])).coordinates(), [line.x, line.y]),
            rounding(),
        )?;
        close(
            "parabola",
            gap(
                ours_at(ours([a, b, c])).coordinates(),
                [parabola.x, parabola.y],
            ),
            rounding(),
        )?;
        close(
            "cubic",
            gap(ours_at(ours(p)).coordinates(), [cubic.x, cubic.y]),
            rounding(),
        )?;
        close(
            "lyon",
            gap(ours_at(ours(p)).coordinates(), [lyon.x, lyon.y]),
            rounding(),
        )
    });
}

#[test]
fn derivatives() {
    for_all((cubic(), 0.0..=1.0), |(p, t)| {
        let [first, second] = ours(p).derivatives(t);
        let kurbo = kurbo_cubic(p);
        let theirs = kurbo.deriv().eval(t);
        let theirs_second = kurbo.deriv().deriv().eval(t);
        let lyon = lyon_cubic(p).derivative(t);
        close(
            "b′",
            gap(first.as_slice(), [theirs.x, theirs.y]),
            8.0 * rounding(),
        )?;
        close(
            "b″",
            gap(second.as_slice(), [theirs_second.x, theirs_second.y]),
            8.0 * rounding(),
        )?;
        close(
            "b′ of lyon",
            gap(first.as_slice(), [lyon.x, lyon.y]),
            8.0 * rounding(),
        )
    });
}

/// kurbo counts a right turn positive (version 0.13.1), against its own documentation's intention: the signs are opposite.
#[test]
fn curvature() {
    for_all((cubic(), 0.0..=1.0), |(p, t)| {
        let curve = ours(p);
        let [first, second] = curve.derivatives(t);
        let speed = first.norm();
        prop_assume!(speed > 0.1);
        let theirs = -kurbo_cubic(p).curvature(t);
        let found = curve.curvature(t).expect("regular");
        // An error ε of b′ and b″ changes κ by at most ε(‖b′‖ + 4‖b″‖)/‖b′‖³, the terms being at most ‖b″‖/‖b′‖².
        let bound = 8.0 * rounding() * (speed + 8.0 * second.norm()) / speed.powi(3);
        close("κ", (found - theirs).abs(), bound)
    });
}

/// kurbo's accuracy is an estimate; near a cusp it may be missed, so curves that nearly stop are left out.
#[test]
fn arc_length() {
    for_all(cubic(), |p| {
        let curve = ours(p);
        let slowest = (0..=100)
            .map(|k| {
                let [first] = curve.derivatives(f64::from(k) / 100.0);
                first.norm()
            })
            .fold(f64::INFINITY, f64::min);
        prop_assume!(slowest > 0.5);
        let found = curve.arc_length(1e-12).expect("within reach");
        let theirs = kurbo_cubic(p).arclen(1e-9);
        close("length", (found.value - theirs).abs(), found.error + 1e-9)?;
        let half = 0.5 * found.value;
        let parameter = curve
            .parameter_at_length(half, 1e-10)
            .expect("a length of the curve");
        let theirs = kurbo_cubic(p).inv_arclen(half, 1e-9);
        // The speed is at least 0.45 also between the samples: its derivative is at most 6·32·√2 < 300 and half a step 0.005
        // would lose 1.5; so the comparison is made along the curve and not in the parameter.
        let [left, _] = curve.split(theirs.clamp(1e-6, 1.0 - 1e-6)).expect("inside");
        let reached = left.arc_length(1e-12).expect("within reach");
        let [mine, _] = curve.split(parameter).expect("inside");
        let mine = mine.arc_length(1e-12).expect("within reach");
        close(
            "length up to the parameters",
            (reached.value - mine.value).abs(),
            1e-8,
        )
    });
}

/// Their box is that of the curve, ours that of the control points, which contains it.
#[test]
fn bounding_box() {
    for_all(cubic(), |p| {
        let ours = ours(p).bounding_box();
        let theirs = kurbo_cubic(p).bounding_box();
        let lyon = lyon_cubic(p).bounding_box();
        let (low, high) = (ours.low(), ours.high());
        for [x0, y0, x1, y1] in [
            [theirs.x0, theirs.y0, theirs.x1, theirs.y1],
            [lyon.min.x, lyon.min.y, lyon.max.x, lyon.max.y],
        ] {
            let outside = [low[0] - x0, low[1] - y0, x1 - high[0], y1 - high[1]];
            close("box", outside.into_iter().fold(0.0, f64::max), rounding())?;
        }
        Ok(())
    });
}

#[test]
fn nearest() {
    for_all((cubic(), point()), |(p, from)| {
        let found = ours(p)
            .nearest(&Point::new(from), 1e-10)
            .expect("within reach");
        let theirs = kurbo_cubic(p)
            .nearest(kurbo_point(from), 1e-10)
            .distance_sq
            .sqrt();
        // kurbo works on the approximation by parabolas: it may miss, but it must not be nearer.
        prop_assert!(
            found.distance <= theirs + 1e-10,
            "{} against {theirs}",
            found.distance
        );
        close("distance", theirs - found.distance, 1e-4)
    });
}

#[test]
fn subdivision() {
    for_all((cubic(), 0.0..=1.0), |(p, t)| {
        let (left, right) = lyon_cubic(p).split(t);
        let kurbo = kurbo_cubic(p).subsegment(0.0..t);
        let pieces = ours(p).subdivided(t);
        prop_assume!(pieces.is_ok());
        let [ours_left, ours_right] = pieces.expect("checked");
        for (found, theirs) in [(&ours_left, left), (&ours_right, right)] {
            let theirs = [theirs.from, theirs.ctrl1, theirs.ctrl2, theirs.to];
            for (found, theirs) in found.control_points().iter().zip(theirs) {
                close(
                    "lyon",
                    gap(found.coordinates(), [theirs.x, theirs.y]),
                    rounding(),
                )?;
            }
        }
        let theirs = [kurbo.p0, kurbo.p1, kurbo.p2, kurbo.p3];
        for (found, theirs) in ours_left.control_points().iter().zip(theirs) {
            close(
                "kurbo",
                gap(found.coordinates(), [theirs.x, theirs.y]),
                rounding(),
            )?;
        }
        Ok(())
    });
}
