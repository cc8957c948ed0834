//! Figures of the section on the Bernstein representation.

use crate::bezier::{BezierCurve, TrianglePaths, bernstein_basis, laws};
use crate::figure::{Figure, PointStyle, Scheme, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![
        de_casteljau_path_counting(),
        polynomial_curve_smooth(),
        centre_of_gravity(),
    ]
}

/// The scheme of degree 3 with all paths from b₁ to the tip, and how many paths lead to each point.
#[must_use]
pub fn de_casteljau_path_counting() -> Figure {
    Figure::new(
        "bezier-de-casteljau-path-counting",
        "The paths from a control point to the tip",
        "The triangular scheme of de Casteljau for a cubic. \
         Under each point stands the number of paths that lead to it from the control point of index 1. \
         The arrows of the three paths to the tip are heavier; each of the paths has one factor t and two factors 1 − t.",
    )
    .stepper("n", 1..=4, 3)
    .stepper("k", 0..=4, 1)
    .draw(|values, canvas| {
        let n = values.count("n")?;
        let k = values.count("k")?.min(n);
        let mut counts: Vec<Vec<usize>> = (0..=n).map(|level| vec![0; n + 1 - level]).collect();
        let mut arrows = std::collections::BTreeSet::new();
        for (level, column) in counts.iter_mut().enumerate() {
            for (i, count) in column.iter_mut().enumerate() {
                // The paths to b_i^j are those of the smaller scheme of degree j on b_i … b_{i+j}.
                *count = match k.checked_sub(i) {
                    Some(start) => TrianglePaths::new(level, start).count(),
                    None => 0,
                };
            }
        }
        for path in TrianglePaths::new(n, k) {
            for pair in path.points().windows(2) {
                arrows.insert((pair[0], pair[1].1));
            }
        }
        let columns = counts.iter().enumerate().map(|(level, column)| {
            let entries = column.iter().enumerate().map(|(i, count)| match level {
                0 => format!("b_{i}\n{count}"),
                _ => format!("b_{i}^{level}\n{count}"),
            });
            entries.collect::<Vec<_>>()
        });
        let scheme = arrows.into_iter().fold(
            Scheme::triangle(columns).weights("1-t", "t"),
            |scheme, ((level, index), target)| scheme.highlighted(level, index, target),
        );
        canvas.scheme("scheme", &scheme);
        let law = laws::de_casteljau_path_counting(|n, k| TrianglePaths::new(n, k).collect(), n, k, 0.4);
        canvas.law("bezier-de-casteljau-path-counting", &law);
        if values.count("k")? > n {
            canvas.remark("There is no control point of this index, as k is at most n; the paths are those of the last one.");
        } else if k == 0 || k == n {
            canvas.remark("From an end of the column a single path leads to the tip, along a side of the triangle.");
        }
        Ok(())
    })
}

/// A cubic with a cusp, and its derivative, which passes through the origin.
#[must_use]
pub fn polynomial_curve_smooth() -> Figure {
    Figure::new(
        "bezier-polynomial-curve-smooth",
        "A polynomial curve with a cusp",
        "On one side a cubic Bézier curve whose control polygon crosses itself; \
         the curve rises to a sharp tip, a cusp, and falls again. \
         On the other side its derivative, a parabola that passes through the origin: \
         at the cusp the velocity is zero. At another point the velocity is drawn as an arrow in both pictures.",
    )
    .handles_in(
        "curve",
        "b",
        [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]],
    )
    .slider("t", 0.0..=1.0, 0.2)
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let t = values.number("t")?;
        let derivative = curve.derivative();
        let (point, velocity) = (curve.at(t), derivative.at(t));
        canvas.panel("curve");
        canvas.caption("the curve $b$");
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        // A quarter of the velocity, so that the arrow stays in the picture.
        canvas.arrow("velocity", point, point + velocity * 0.25, Style::Tangent);
        canvas.point("b(1/2)", curve.at(0.5), PointStyle::OnCurve);
        canvas.label("b(1/2)", curve.at(0.5));
        canvas.point("b(t)", point, PointStyle::Result);
        canvas.label("b(t)", point);
        canvas.labels("b", curve.control_points());
        canvas.panel("derivative");
        canvas.caption("its derivative $b'$");
        canvas.curve(
            "derivative",
            0.0..=1.0,
            |t| derivative.at(t),
            Style::SecondCurve,
        );
        canvas.arrow("velocity", [0.0, 0.0], velocity, Style::Tangent);
        canvas.point("origin", [0.0, 0.0], PointStyle::OnCurve);
        canvas.label("0", [0.0, 0.0]);
        canvas.point("b'(t)", velocity, PointStyle::Result);
        canvas.label("b'(t)", velocity);
        canvas.panel("curve");
        canvas.law(
            "bezier-derivative",
            &laws::derivative(|curve, t| curve.derivative().at(t), &curve, t),
        );
        if velocity[0] == 0.0 && velocity[1] == 0.0 {
            canvas.remark(
                "The velocity is 0 here. The curve is differentiable as ever, but that it has a tangent needs b′(t) ≠ 0: \
                 it may turn sharply.",
            );
        }
        Ok(())
    })
}

/// The control points as discs whose areas are the masses Bᵢⁿ(t), and their centre of gravity.
#[must_use]
pub fn centre_of_gravity() -> Figure {
    Figure::new(
        "bezier-centre-of-gravity",
        "A curve point is the centre of gravity of the control points",
        "A cubic Bézier curve with its control polygon. \
         Around each control point is a disc whose area is proportional to the Bernstein polynomial at t, \
         the mass of the control point. The centre of gravity of the four masses is a point of the curve.",
    )
    .handles("b", [[0.0, 0.0], [1.0, 3.6], [5.4, 3.8], [7.0, 0.4]])
    .slider("t", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let t = values.number("t")?;
        let masses = bernstein_basis(curve.degree(), t);
        for (i, (point, mass)) in std::iter::zip(curve.control_points(), masses).enumerate() {
            // The area is π times the mass: the disc of the mass 1 has the radius 1.
            canvas.circle(&format!("mass {i}"), point, libm::sqrt(mass), Style::Disc);
        }
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.point("b(t)", curve.at(t), PointStyle::Result);
        canvas.label("b(t)", curve.at(t));
        canvas.labels("b", curve.control_points());
        canvas.law(
            "bezier-bernstein-representation",
            &laws::bernstein_representation(BezierCurve::at, &curve, t),
        );
        if t == 0.0 || t == 1.0 {
            canvas.remark("t is an end of the interval: the whole mass is in one control point, and the curve goes through it.");
        }
        Ok(())
    })
}
