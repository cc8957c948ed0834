//! Figures of the section on blossoms.

use cagd::affine::{Interval, Point};
use cagd::bezier::{BezierCurve, figures, laws};

use crate::support::{ensure, figure_test, near};

/// The points are the blossom values that their labels name, and the sides of the triangle give two pieces of the curve.
#[test]
fn blossom_de_casteljau() {
    figure_test(figures::blossom_de_casteljau(), |plot| {
        let t = 0.4;
        let control_points = plot.polyline("construction/control polygon")?.to_vec();
        let curve = BezierCurve::new(control_points.clone())?;
        laws::blossom_de_casteljau(|curve, t| curve.blossom().triangle(t), &curve, t, 0.7)
            .judge()?;

        // Every label of the lower panel stands for the value at its arguments.
        let number = |name: &str| match name {
            "0" => 0.0,
            "1" => 1.0,
            _ => t,
        };
        let mut columns = vec![control_points];
        for level in 1..3 {
            columns.push(
                plot.polyline(&format!("construction/level {level}"))?
                    .to_vec(),
            );
        }
        columns.push(vec![plot.point("construction/p(t,t,t)")?]);
        for (level, column) in columns.iter().enumerate() {
            for (i, point) in column.iter().enumerate() {
                let label = plot.text(&format!("triangle/scheme[{level}][{i}]"))?;
                let arguments: Vec<f64> = label
                    .trim_start_matches("p(")
                    .trim_end_matches(')')
                    .split(',')
                    .map(number)
                    .collect();
                // The scheme takes its arguments in another order: 9 roundings a level on both sides,
                // of terms that a step with t in [0, 1] does not enlarge; no coordinate exceeds 10.
                let bound = cagd::law::gamma(2 * 9 * 3) * 10.0;
                near(label, *point, curve.blossom().at(&arguments)?, bound)?;
            }
        }

        // The upper side is the control polygon over [0, t].
        let side: Vec<Point<f64, 2>> = columns.iter().map(|column| column[0]).collect();
        let piece = BezierCurve::on(Interval::new(0.0, t)?, side)?;
        for (s, point) in plot.samples("construction/curve")? {
            if s <= t {
                near(
                    "the left piece",
                    piece.at(s),
                    point,
                    cagd::law::gamma(54) * 10.0,
                )?;
            }
        }
        ensure(plot.segment("triangle/scheme[0][0]->[0]").is_ok(), || {
            "the triangle has no arrows".into()
        })
    })
    .rejects("two labels exchanged", |plot| {
        plot.rewritten("triangle/scheme[1][0]", "p(0,t,1)")
    })
    .rejects("points of a level off their segments", |plot| {
        plot.shifted("construction/level 1", [0.05, 0.0])
    })
    .rejects("a curve that is not cut", |plot| {
        plot.scaled("construction/curve", 1.01)
    })
    .snapshot();
}
