//! Figures of the section on the four-point scheme.

use cagd::affine::Point;
use cagd::figure::Place;
use cagd::subdivision::{ControlPolygon, figures};

use crate::support::{ensure, figure_test, near};

const PANELS: [&str; 3] = ["closed", "two phantom points", "ends mirrored anew"];

/// The refined polygons pass through the given points at every sixteenth place, and the first new points are on cubics.
#[test]
fn figure_four_point() {
    figure_test(figures::figure_four_point(), |plot| {
        for panel in PANELS {
            let given = plot.polyline(&format!("{panel}/polygon"))?;
            let refined = plot.polyline(&format!("{panel}/refined"))?;
            ensure(refined.len() == 16 * (given.len() - 1) + 1, || {
                format!("{panel}: {} points", refined.len())
            })?;
            for (i, point) in given.iter().enumerate() {
                near(panel, refined[16 * i], *point, 0.0)?;
            }
            let new = plot.points(&format!("{panel}/new points"))?;
            ensure(new.len() == given.len() - 1, || {
                format!("{panel}: {} new points", new.len())
            })?;
            for i in 1..new.len() - 1 {
                let [a, b, c, d] = [given[i - 1], given[i], given[i + 1], given[i + 2]];
                // 1/16 of a few sums of coordinates up to 8.
                let middle =
                    Point::from([0, 1].map(|k| (9.0 * (b[k] + c[k]) - (a[k] + d[k])) / 16.0));
                near("a new point", new[i], middle, cagd::law::gamma(12) * 16.0)?;
                near("a refined point", refined[16 * i + 8], new[i], 0.0)?;
            }
        }
        Ok(())
    })
    .rejects("a curve that misses the points", |plot| {
        plot.shifted("closed/refined", [0.0, 0.05])
    })
    .rejects("new points off their cubics", |plot| {
        plot.shifted("ends mirrored anew/new points", [0.05, 0.0])
    })
    .snapshot();
}

/// The function interpolates the data, has the difference quotients that are drawn, and the second differences are on the line.
#[test]
fn four_point_convergence() {
    figure_test(figures::four_point_convergence(), |plot| {
        let limit = plot.polyline("limit/limit")?;
        let whole = limit.iter().filter(|p| p[0].fract() == 0.0);
        for p in whole.clone() {
            let expected = if p[0] == 0.0 { 1.0 } else { 0.0 };
            ensure(p[1] == expected, || {
                format!("at {} the value {}", p[0], p[1])
            })?;
        }
        ensure(whole.count() == 7, || "not all of −3 … 3".into())?;
        for (pair, slope) in limit.windows(2).zip(plot.polyline("limit/derivative")?) {
            let quotient = (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
            let place = [(pair[0][0] + pair[1][0]) / 2.0, quotient];
            near("a slope", *slope, Place::from(place), 0.0)?;
        }
        let [from, to] = plot.segment("second differences/line")?;
        for p in plot.points("second differences/second differences")? {
            let height = from[1] + (to[1] - from[1]) * (p[0] - from[0]) / (to[0] - from[0]);
            // Dyadic numbers with few digits.
            near("a second difference", *p, Place::from([p[0], height]), 0.0)?;
        }
        Ok(())
    })
    .rejects("another function", |plot| {
        plot.shifted("limit/limit", [0.0, 0.1])
    })
    .rejects("another derivative", |plot| {
        plot.scaled("limit/derivative", 1.1)
    })
    .rejects("a horizontal line", |plot| {
        plot.replaced("second differences/line", [[0.0, -2.0], [6.0, -2.0]])
    })
    .snapshot();
}

/// The norms of two steps cross 1 at the first line, those of eight steps do so between both lines.
#[test]
fn four_point_tension() {
    figure_test(figures::four_point_tension(), |plot| {
        let mark = |name: &str| {
            plot.segment(&format!("norms/{name}"))
                .map(|ends| ends[0][0])
        };
        let (two_steps, limit) = (mark("two steps")?, mark("limit")?);
        // Both defining equations, with the slopes 4 + 32w and 96w² + 4 below 9 and a root that is off by 2⁻²⁰.
        ensure(
            (16.0 * two_steps * two_steps + 4.0 * two_steps - 1.0).abs() < 1e-12,
            || format!("{two_steps} is not (√5 − 1)/8"),
        )?;
        ensure(
            (32.0 * limit.powi(3) + 4.0 * limit - 1.0).abs() < 1e-5,
            || format!("{limit} is not the root"),
        )?;
        for p in plot.polyline("norms/L = 2")? {
            let w = p[0];
            let formula = f64::max(1.0 - 4.0 * w, 4.0 * w + 16.0 * w * w);
            near(
                "the norm of two steps",
                *p,
                Place::from([w, formula]),
                1e-12,
            )?;
        }
        let contractive = |name: &str| -> Result<f64, cagd::figure::BoxError> {
            let norms = plot.polyline(&format!("norms/{name}"))?;
            let last = norms.iter().filter(|p| p[1] < 1.0).map(|p| p[0]);
            Ok(last.fold(0.0, f64::max))
        };
        let (two, four, eight) = (
            contractive("L = 2")?,
            contractive("L = 4")?,
            contractive("L = 8")?,
        );
        ensure(
            two < two_steps && two_steps < four && four < eight && eight < limit,
            || format!("contractive up to {two}, {four}, {eight}"),
        )?;
        let given = plot.polyline("curve/polygon")?;
        for name in ["curve/chosen curve", "curve/w = 1/16"] {
            let curve = plot.polyline(name)?;
            for (i, point) in given.iter().enumerate() {
                near("the curve interpolates", curve[32 * i], *point, 0.0)?;
            }
        }
        Ok(())
    })
    .rejects("a bound in the wrong place", |plot| {
        plot.shifted("norms/limit", [-0.02, 0.0])
    })
    .rejects("another norm", |plot| {
        plot.shifted("norms/L = 2", [0.0, 0.1])
    })
    .rejects("a curve beside the points", |plot| {
        plot.shifted("curve/chosen curve", [0.0, 0.1])
    })
    .snapshot();
}

/// The three rows of norms begin as they were computed by hand.
#[test]
fn four_point_analysis() {
    figure_test(figures::four_point_analysis(), |plot| {
        let tables: [&[f64]; 3] = [
            &[0.625],
            &[1.0, 0.75, 0.5, 0.3125, 0.1875, 0.109375],
            &[1.0; 8],
        ];
        for (order, table) in tables.into_iter().enumerate() {
            let norms = plot.polyline(&format!("order {order}"))?;
            ensure(norms.len() == 8, || format!("{} norms", norms.len()))?;
            for (k, expected) in table.iter().enumerate() {
                // Dyadic numbers with few digits.
                let place = Place::from([(k + 1) as f64, *expected]);
                near("a norm", norms[k], place, 0.0)?;
            }
        }
        Ok(())
    })
    .rejects("another order", |plot| plot.swapped("order 1", "order 2"))
    .snapshot();
}

/// Collinear points stay on the line; those of the circle leave it by what the example says.
#[test]
fn figure_precision() {
    figure_test(figures::figure_precision(), |plot| {
        let line = plot.polyline("line/refined")?;
        let given = plot.points("line/points")?;
        let direction = given[5] - given[0];
        for p in line {
            let v = *p - given[0];
            let area = direction[0] * v[1] - direction[1] * v[0];
            // Five steps of 5 roundings with coordinates up to 8, and two products.
            ensure(area.abs() <= cagd::law::gamma(40) * 128.0, || {
                format!("{p} is off the line")
            })?;
        }
        let corners = plot.points("circle/points")?;
        let square = ControlPolygon::closed(corners.iter().copied())?;
        let first = square.four_point(0.0625)?;
        let radius = first.vertices()[1].from_origin().norm();
        ensure((radius - 5.0 * 2.0_f64.sqrt() / 8.0).abs() < 1e-15, || {
            format!("radius {radius}")
        })?;
        let circle = plot.polyline("circle/refined")?;
        near("the first new point", circle[16], first.vertices()[1], 0.0)?;
        for (i, p) in plot
            .polyline("deviation/from the circle")?
            .iter()
            .enumerate()
        {
            let deviation = 1.0 - circle[i].from_origin().norm();
            ensure((p[1] - deviation).abs() < 1e-15, || {
                format!("the deviation {}", p[1])
            })?;
        }
        let flat = plot
            .polyline("deviation/from the line")?
            .iter()
            .all(|p| p[1] < 1e-14);
        ensure(flat, || "a deviation from the line".into())
    })
    .rejects("a curve off the line", |plot| {
        plot.shifted("line/refined", [0.0, 0.1])
    })
    .rejects("another deviation", |plot| {
        plot.shifted("deviation/from the circle", [0.0, 0.1])
    })
    .snapshot();
}
