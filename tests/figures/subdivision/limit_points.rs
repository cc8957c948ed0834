//! Figures of the section on limit points.

use cagd::bspline::UniformSpline;
use cagd::subdivision::figures;

use crate::support::{ensure, figure_test, near};

/// The points and arrows are those of the cubic spline, computed by the algorithm of de Boor.
#[test]
fn limit_stencils() {
    figure_test(figures::limit_stencils(), |plot| {
        let polygon = plot.polyline("polygon")?;
        let vertices = &polygon[..polygon.len() - 1];
        let spline = UniformSpline::periodic(3, vertices.iter().copied())?;
        let velocity = spline.derivative()?;
        let limits = plot.points("limit points")?;
        ensure(limits.len() == vertices.len(), || {
            format!("{} limit points", limits.len())
        })?;
        // Sums of three or four terms with coordinates up to 8, in another order of operations.
        let bound = cagd::law::gamma(24) * 4.0 * 8.0;
        for (i, limit) in limits.iter().enumerate() {
            // Over the knots ℤ the vertex i has its weight 4/6 at the parameter i + 2.
            let u = 3.0 + ((i + 5) % 6) as f64;
            near("a limit point", *limit, spline.at(u)?, bound)?;
            let [from, to] = plot.segment(&format!("tangent {i}"))?;
            near("a tangent begins", from, *limit, 0.0)?;
            near(
                "a tangent ends",
                to,
                from + velocity.at(u)? / 3.0,
                2.0 * bound,
            )?;
        }
        // Five steps: the points of the polygon are 1/6 of the second differences off, and those are a 4⁻⁵ of the first.
        let second = 16.0 / 1024.0;
        for limit in limits {
            let nearest = plot.polyline("curve")?.iter().map(|p| (*p - *limit).norm());
            let distance = nearest.fold(f64::INFINITY, f64::min);
            ensure(distance <= second, || {
                format!("the curve misses {limit} by {distance}")
            })?;
        }
        Ok(())
    })
    .rejects("limit points beside the curve", |plot| {
        plot.shifted("limit points", [0.1, 0.0])
    })
    .rejects("another derivative", |plot| plot.scaled("tangent 2", 1.2))
    .rejects("another curve", |plot| plot.shifted("curve", [0.3, 0.0]))
    .snapshot();
}
