//! Figures of the section on derivatives.

use cagd::affine::{Affine, Point};
use cagd::bezier::{BezierCurve, figures, laws};
use cagd::curves::PlaneCurvature;
use cagd::figure::{BoxError, Plot};

use crate::support::{ensure, figure_test, near};

/// The curve over the control polygon that was drawn.
fn drawn_curve(plot: &Plot, polygon: &str) -> Result<BezierCurve<Point<f64, 2>>, BoxError> {
    Ok(BezierCurve::new(plot.polyline(polygon)?.iter().copied())?)
}

/// The last segment is a third of the drawn derivative, which ends on the hodograph; b(t) lies on the segment.
#[test]
fn derivative_consequences() {
    figure_test(figures::derivative_consequences(), |plot| {
        let t = 0.4;
        let curve = drawn_curve(plot, "curve/control polygon")?;
        // The plotted control vectors stand for the implementation that the law judges.
        let vectors = plot.polyline("hodograph/control vectors")?.to_vec();
        let hodograph = |curve: &BezierCurve<Point<f64, 2>>| {
            let vectors = vectors.iter().map(Point::from_origin);
            BezierCurve::on(*curve.domain(), vectors).unwrap_or_else(|_| curve.derivative())
        };
        laws::derivative_consequences(hodograph, &curve, t).judge()?;
        let [from, to] = plot.segment("curve/last segment")?;
        let [origin, tip] = plot.segment("hodograph/b'(t)")?;
        // Coordinates below 6, derivatives below 18, a few roundings each: 2⁻⁴⁴ allows for 32 of them.
        let bound = 2f64.powi(-44);
        near("b'(t)", origin + (to - from) * 3.0, tip, bound)?;
        near("b(t)", from.lerp(&to, t), plot.point("curve/b(t)")?, bound)?;
        let on_hodograph = plot.samples("hodograph/hodograph")?.find(|(s, _)| *s == t);
        ensure(on_hodograph.is_some_and(|(_, p)| p == tip), || {
            format!("{tip} is not on the hodograph")
        })
    })
    .rejects("an arrow that ends off the hodograph", |plot| {
        plot.shifted("hodograph/b'(t)", [0.0, 0.1])
    })
    .rejects("a hodograph without the factor n", |plot| {
        plot.scaled("hodograph/control vectors", 1.0 / 3.0)
    })
    .rejects("a last segment that is no tangent", |plot| {
        plot.swapped("curve/last segment", "curve/level 1")
    })
    .snapshot();
}

/// The drawn levels are those of the worked example, and the tangent runs through level 2.
#[test]
fn de_casteljau_worked_example() {
    figure_test(figures::de_casteljau_worked_example(), |plot| {
        let curve = drawn_curve(plot, "control polygon")?;
        laws::de_casteljau_worked_example(|_, t| curve.triangle(t)).judge()?;
        let triangle = curve.triangle(0.6);
        for (level, name) in [(1, "level 1"), (2, "level 2")] {
            ensure(plot.polyline(name)? == triangle.column(level), || {
                format!("{name} is not that of the triangle")
            })?;
        }
        near("b(t)", plot.point("b(t)")?, *triangle.tip(), 0.0)?;
        let [from, to] = plot.segment("tangent")?;
        let [first] = curve.derivatives(0.6);
        // The drawn line may be longer than the segment; its direction is that of b′(0.6), with coordinates below 30.
        let direction = to - from;
        let area = direction[0] * first[1] - direction[1] * first[0];
        ensure(area.abs() <= 2f64.powi(-40) * direction.norm(), || {
            format!("the line has the direction {direction}, the curve {first}")
        })
    })
    .rejects("a point off the curve", |plot| {
        plot.shifted("b(t)", [0.006, 0.0])
    })
    .rejects("another polygon", |plot| {
        plot.scaled("control polygon", 1.01)
    })
    .snapshot();
}

/// The drawn circle touches the curve at b₀ and has its curvature there, whatever b₃ is.
#[test]
fn end_curvature() {
    figure_test(figures::end_curvature(), |plot| {
        let curve = drawn_curve(plot, "control polygon")?;
        let (centre, radius) = plot.circle("osculating circle")?;
        let start = curve.control_points()[0];
        // Coordinates below 6; the radius passes a few dozen roundings.
        let bound = 2f64.powi(-44);
        let offset = start - centre;
        ensure((offset.norm() - radius).abs() <= bound, || {
            format!(
                "b_0 is {} from the centre, the radius is {radius}",
                offset.norm()
            )
        })?;
        let [leg] = curve.derivatives(0.0);
        ensure(offset.dot(&leg).abs() <= 16.0 * bound, || {
            "the circle does not touch the first leg".into()
        })?;
        // The law compares the plotted curvature with the formula of the three control points, at both ends.
        let sides = laws::end_curvature(
            |curve, u| {
                let at_start = u == curve.domain().start();
                let curvature = if at_start {
                    1.0 / radius
                } else {
                    curve.curvature(u).ok()?
                };
                Some(curvature * curvature.abs())
            },
            &curve,
        );
        sides.judge()?;
        let mut points = curve.control_points().to_vec();
        points[3] = Point::new([-3.0, 0.5]);
        let moved = BezierCurve::new(points)?.osculating_circle(0.0)?;
        near("centre with another b_3", moved.centre(), centre, bound)
    })
    .rejects("a circle through another point", |plot| {
        plot.shifted("osculating circle", [0.05, 0.0])
    })
    .rejects("a circle of another radius", |plot| {
        plot.scaled("osculating circle", 1.1)
    })
    .snapshot();
}

/// All that is drawn of the curve has y = x² in the coordinates of its affine map; the arrow has the axis direction.
#[test]
fn quadratic_parabola() {
    figure_test(figures::quadratic_parabola(), |plot| {
        let curve = drawn_curve(plot, "control polygon")?;
        // The law asks for points of the image of the parabola: the plotted samples are such points.
        for name in ["before", "curve", "after"] {
            let samples: Vec<_> = plot.samples(name)?.collect();
            for (t, point) in samples {
                let map = cagd::bezier::ParabolaMap::of(&curve)?;
                let (x, y) = map
                    .preimage(&point)
                    .ok_or("the control points are collinear")?;
                // The determinant is about 36 and coordinates are below 8: errors of a few dozen roundings.
                ensure((x - t).abs() <= 2f64.powi(-44), || {
                    format!("{name}: {x} at {t}")
                })?;
                ensure((y - x * x).abs() <= 2f64.powi(-44), || {
                    format!("{name}: ({x}, {y})")
                })?;
            }
        }
        let [foot, tip] = plot.segment("half axis direction")?;
        let axis = (tip - foot) * 2.0;
        let vertex = plot.point("vertex")?;
        let apply = |curve: &BezierCurve<Point<f64, 2>>, x: f64, y: f64| {
            let points = curve.control_points();
            points[0] + (points[1] - points[0]) * (2.0 * x) + axis * y
        };
        laws::quadratic_parabola(apply, &curve, 0.3).judge()?;
        let [from, to] = plot.segment("axis")?;
        let direction = to - from;
        let offset = vertex - from;
        let bound = 2f64.powi(-40) * direction.norm() * (1.0 + offset.norm());
        for vector in [axis, offset] {
            let area = direction[0] * vector[1] - direction[1] * vector[0];
            ensure(area.abs() <= bound, || {
                format!("{vector} is not along the axis")
            })?;
        }
        Ok(())
    })
    .rejects("an arrow to the other side", |plot| {
        plot.scaled("half axis direction", 0.5)
    })
    .rejects("a curve beside the parabola", |plot| {
        plot.shifted("curve", [0.0, 0.02])
    })
    .rejects("a vertex beside the axis", |plot| {
        plot.shifted("vertex", [0.1, 0.0])
    })
    .snapshot();
}
