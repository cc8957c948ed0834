//! Figures of the section on the algorithm of de Casteljau.

use cagd::affine::{Affine, Point, Vector};
use cagd::bezier::{BezierCurve, figures};
use cagd::figure::BoxError;

use crate::support::{ensure, figure_test, near};

/// Each level divides the segments of the one before in the ratio t : (1 − t), and the last point is on the curve.
#[test]
fn figure_de_casteljau() {
    figure_test(figures::figure_de_casteljau(), |plot| {
        let t = 0.4;
        for n in 2..=4 {
            let item = |name: &str| format!("n = {n}/{name}");
            let mut level = plot.polyline(&item("control polygon"))?.to_vec();
            ensure(level.len() == n + 1, || {
                format!("degree {n} has {} control points", level.len())
            })?;
            for j in 1..=n {
                level = level
                    .windows(2)
                    .map(|pair| pair[0].lerp(&pair[1], t))
                    .collect();
                if j < n {
                    let drawn = plot.polyline(&item(&format!("level {j}")))?;
                    ensure(drawn == level, || {
                        format!("n = {n}: level {j} is {drawn:?}, expected {level:?}")
                    })?;
                }
            }
            // Drawn and computed here by the same operations in the same order: no rounding separates them.
            near("b(t)", plot.point(&item("b(t)"))?, level[0], 0.0)?;
            let on_curve = plot.samples(&item("curve"))?.find(|(s, _)| *s == t);
            ensure(on_curve.is_some_and(|(_, p)| p == level[0]), || {
                format!("n = {n}: b(t) is not on the curve")
            })?;
        }
        Ok(())
    })
    .rejects("a point of division that is off its segment", |plot| {
        plot.shifted("n = 3/level 2", [0.0, 0.05])
    })
    .rejects("a curve that misses b(t)", |plot| {
        plot.shifted("n = 4/curve", [0.05, 0.0])
    })
    .snapshot();
}

/// The arrows are the monomial coefficients of the curve whose control polygon is drawn beside them.
#[test]
fn motivation() {
    figure_test(figures::motivation(), |plot| {
        let start = plot.point("monomials/a_0")?;
        let mut coefficients = vec![];
        for k in 1..=3 {
            let [from, to] = plot.segment(&format!("monomials/a_{k}"))?;
            near("the foot of an arrow", from, start, 0.0)?;
            coefficients.push(to - from);
        }
        let control_points = plot.polyline("control points/control polygon")?;
        let curve = BezierCurve::new(control_points.to_vec())?;
        // A coefficient passes at most 3 differences, 3 factors, a division and a difference with the start, Horner's
        // scheme 6, de Casteljau 9; the terms are at most 64 = 8·8 (third differences of coordinates up to 8) each.
        let bound = cagd::law::gamma(8 + 6 + 9) * 3.0 * 64.0;
        for panel in ["monomials", "control points"] {
            for (t, point) in plot.samples(&format!("{panel}/curve"))? {
                let horner = coefficients
                    .iter()
                    .rev()
                    .fold(Vector::zeros(), |sum: Vector<f64, 2>, a| (sum + a) * t);
                near("the sum of monomials", start + horner, point, bound)?;
                near("the Bézier curve", curve.at(t), point, 0.0)?;
            }
        }
        Ok(())
    })
    .rejects("a coefficient of another curve", |plot| {
        plot.scaled("monomials/a_2", 1.1)
    })
    .rejects("a polygon of another curve", |plot| {
        plot.shifted("control points/control polygon", [0.1, 0.0])
    })
    .snapshot();
}

/// The dashed parts continue the curve, and each point of the construction is on the prolongation of a segment.
#[test]
fn parameter_range() {
    figure_test(figures::parameter_range(), |plot| {
        let t = 1.2;
        let mut column = plot.polyline("control polygon")?.to_vec();
        let curve = BezierCurve::new(column.clone())?;
        for part in ["before", "curve", "after"] {
            for (s, point) in plot.samples(part)? {
                near(part, point, curve.at(s), 0.0)?;
                let inside = (0.0..=1.0).contains(&s);
                ensure(inside == (part == "curve") || s == 0.0 || s == 1.0, || {
                    format!("t = {s} belongs to another part than {part}")
                })?;
            }
        }
        for level in 1..=3 {
            let next: Vec<_> = column.windows(2).map(|p| p[0].lerp(&p[1], t)).collect();
            for (i, point) in next.iter().enumerate() {
                let drawn = plot.segment(&format!("prolongation {level}.{i}"))?;
                near("the prolongation starts", drawn[0], column[i + 1], 0.0)?;
                near("the prolongation ends", drawn[1], *point, 0.0)?;
            }
            column = next;
        }
        near("b(t)", plot.point("b(t)")?, column[0], 0.0)
    })
    .rejects("a dashed part that does not continue the curve", |plot| {
        plot.shifted("after", [0.0, 0.1])
    })
    .rejects("a prolongation off its line", |plot| {
        plot.shifted("prolongation 2.1", [0.1, 0.0])
    })
    .snapshot();
}

/// The numbers in the triangle obey the recursion, and its tip is the point of the curve.
#[test]
fn de_casteljau_triangle() {
    figure_test(figures::de_casteljau_triangle(), |plot| {
        let t = 0.4;
        let entry = |level: usize, i: usize| -> Result<Point<f64, 2>, BoxError> {
            let text = plot.text(&format!("scheme[{level}][{i}]"))?;
            let (name, value) = text.split_once('\n').ok_or("an entry without a value")?;
            let expected = match level {
                0 => format!("b_{i}"),
                _ => format!("b_{i}^{level}"),
            };
            ensure(name == expected, || {
                format!("{name} in the place of {expected}")
            })?;
            let numbers = value.trim_matches(['(', ')']).replace('−', "-");
            let (x, y) = numbers.split_once(", ").ok_or("no pair of numbers")?;
            Ok(Point::new([x.parse()?, y.parse()?]))
        };
        for level in 1..=3 {
            for i in 0..=3 - level {
                let (upper, lower) = (entry(level - 1, i)?, entry(level - 1, i + 1)?);
                // Three decimals are shown: half a thousandth on either side of the equation.
                let expected = upper.lerp(&lower, t);
                near("an entry", entry(level, i)?, expected, 0.001)?;
            }
        }
        let control_points = (0..4).map(|i| entry(0, i)).collect::<Result<Vec<_>, _>>()?;
        let curve = BezierCurve::new(control_points)?;
        near("the tip", entry(3, 0)?, curve.at(t), 0.001)
    })
    .rejects("an entry computed with t and 1 − t exchanged", |plot| {
        plot.rewritten("scheme[1][0]", "b_0^1\n(0.6, 1.8)")
    })
    .rejects("two entries exchanged", |plot| {
        plot.swapped("scheme[2][0]", "scheme[2][1]")
    })
    .snapshot();
}
