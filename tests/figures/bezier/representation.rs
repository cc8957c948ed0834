//! Figures of the section on the Bernstein representation.

use cagd::bezier::{binomial, figures};
use cagd::law::gamma;

use crate::support::{ensure, figure_test, near};

/// The numbers of paths follow Pascal's rule along the arrows, from 1 at b₁ to C(3, 1) at the tip.
#[test]
fn de_casteljau_path_counting() {
    figure_test(figures::de_casteljau_path_counting(), |plot| {
        let count = |column: usize, row: usize| -> Result<f64, cagd::figure::BoxError> {
            let text = plot.text(&format!("scheme[{column}][{row}]"))?;
            let number = text.lines().nth(1).ok_or("there is no number of paths")?;
            Ok(number.parse()?)
        };
        for row in 0..=3 {
            let expected = if row == 1 { 1.0 } else { 0.0 };
            ensure(count(0, row)? == expected, || {
                format!("b_{row} has a wrong number")
            })?;
        }
        for column in 1..=3_usize {
            for row in 0..=3 - column {
                let sum = count(column - 1, row)? + count(column - 1, row + 1)?;
                ensure(count(column, row)? == sum, || {
                    format!("row {row} of column {column} is not the sum of its neighbours")
                })?;
                // Both arrows are there, and end at the entry.
                let upper = plot.segment(&format!("scheme[{}][{row}]->[{row}]", column - 1))?;
                let lower =
                    plot.segment(&format!("scheme[{}][{}]->[{row}]", column - 1, row + 1))?;
                ensure(
                    upper[1][0] == lower[1][0] && upper[0][1] > lower[0][1],
                    || format!("the arrows to row {row} of column {column} do not meet"),
                )?;
            }
        }
        ensure(count(3, 0)? == binomial::<f64>(3, 1), || {
            "the tip has a wrong number".into()
        })
    })
    .rejects("a wrong number of paths", |plot| {
        plot.rewritten("scheme[2][0]", "b_0^2\n3")
    })
    .snapshot();
}

/// At t = 1/2 the derivative vanishes, and the curve turns back there: the point is its highest.
/// The two arrows for the velocity have the same direction.
#[test]
fn polynomial_curve_smooth() {
    figure_test(figures::polynomial_curve_smooth(), |plot| {
        let cusp = plot.point("b(1/2)")?;
        let curve: Vec<_> = plot.samples("curve/curve")?.collect();
        ensure(curve.contains(&(0.5, cusp)), || {
            format!("{cusp} is not on the curve")
        })?;
        ensure(
            curve.iter().all(|(t, p)| *t == 0.5 || p[1] < cusp[1]),
            || format!("{cusp} is not the highest point"),
        )?;
        let derivative: Vec<_> = plot.samples("derivative/derivative")?.collect();
        ensure(derivative.contains(&(0.5, plot.point("origin")?)), || {
            "at t = 1/2 the derivative does not vanish".into()
        })?;
        let [foot, head] = plot.segment("curve/velocity")?;
        let [origin, tip] = plot.segment("derivative/velocity")?;
        ensure(derivative.contains(&(0.2, tip)), || {
            format!("{tip} is not on the derivative")
        })?;
        // One rounding for the sum and one for its difference, of coordinates below 1.
        near(
            "velocity",
            foot + (tip - origin) * 0.25,
            head,
            2.0 * gamma(1),
        )
    })
    .rejects("a derivative that misses the origin", |plot| {
        plot.shifted("derivative/derivative", [0.1, 0.0])
    })
    .rejects("a point beside the cusp", |plot| {
        plot.shifted("b(1/2)", [0.0, -0.05])
    })
    .rejects("an arrow in another direction", |plot| {
        plot.shifted("derivative/velocity", [0.1, 0.0])
    })
    .snapshot();
}

/// The centres of the discs, weighted by their areas, have the curve point as their mean.
#[test]
fn centre_of_gravity() {
    figure_test(figures::centre_of_gravity(), |plot| {
        let mut moment = [0.0, 0.0];
        let mut total = 0.0;
        let vertices = plot.polyline("control polygon")?.to_vec();
        for (i, vertex) in vertices.iter().enumerate() {
            let (centre, radius) = plot.circle(&format!("mass {i}"))?;
            ensure(centre == *vertex, || {
                format!("disc {i} is not around b_{i}")
            })?;
            let mass = radius * radius;
            total += mass;
            moment = [moment[0] + mass * centre[0], moment[1] + mass * centre[1]];
        }
        // A mass passes 9 roundings, its root and its square 3 more, product and sum 5; the point
        // itself 9. The coordinates are at most 7.
        let allowed = 7.0 * gamma(26);
        ensure((total - 1.0).abs() <= gamma(16), || {
            format!("the masses sum to {total}")
        })?;
        near(
            "centre of gravity",
            plot.point("b(t)")?,
            moment.into(),
            allowed,
        )
    })
    .rejects("a disc that is too large", |plot| {
        plot.scaled("mass 2", 1.1)
    })
    .rejects("a centre that is not on the curve", |plot| {
        plot.shifted("b(t)", [0.0, 0.05])
    })
    .snapshot();
}
