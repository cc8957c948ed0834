//! Figures of the section on areas.

use cagd::affine::{
    LatticePoint, LatticePolygon, Location, Point, SimplePolygon, figures, laws, signed_area,
};
use cagd::figure::{BoxError, Place, Plot};

use crate::support::{Checked, ensure, figure_test, near};

/// The triangle is half of the parallelogram, the arrows are its sides, and the text has the signed area.
#[test]
fn figure_triangle_area() {
    figure_test(figures::figure_triangle_area(), |plot| {
        let triangle = plot.polygon("triangle")?;
        let [r, p, q] = [triangle[0], triangle[1], triangle[2]];
        for (name, tip) in [("v", p), ("w", q)] {
            let [from, to] = plot.segment(name)?;
            near(name, from, r, 0.0)?;
            near(name, to, tip, 0.0)?;
        }
        let around = SimplePolygon::new(plot.polygon("parallelogram")?.iter().copied())?;
        let area = signed_area(&r, &p, &q);
        // A few roundings of products of at most 9.
        ensure((around.signed_area() - 2.0 * area).abs() <= 1e-14, || {
            format!("{} is not twice {area}", around.signed_area())
        })?;
        let text = plot.text("area")?;
        let expected = format!("[R P Q] = {area:.2}");
        ensure(text == expected, || format!("{text} should be {expected}"))
    })
    .rejects("a parallelogram that is too large", |plot| {
        plot.scaled("parallelogram", 1.1)
    })
    .rejects("an arrow elsewhere", |plot| plot.shifted("w", [0.1, 0.0]))
    .rejects("another area", |plot| {
        plot.rewritten("area", "[R P Q] = 6.48")
    })
    .snapshot();
}

/// The lattice points with the coordinates of these places.
fn lattice_points(places: &[Place]) -> Vec<LatticePoint> {
    places.iter().map(|p| [p[0] as i64, p[1] as i64]).collect()
}

/// The marks are the lattice points inside and on the boundary, the law of Pick holds for them, and the text has their numbers.
#[test]
fn figure_pick() {
    figure_test(figures::figure_pick(), |plot| {
        let vertices = lattice_points(plot.polygon("triangle")?);
        let triangle = LatticePolygon::new(vertices)?;
        let marked = |name: &str| -> Result<Vec<LatticePoint>, BoxError> {
            let mut points = lattice_points(plot.points(name)?);
            points.sort_unstable();
            Ok(points)
        };
        let located = |wanted: Location| -> Vec<LatticePoint> {
            let box_points = (-1..=4).flat_map(|x| (-1..=4).map(move |y| [x, y]));
            let place = |[x, y]: LatticePoint| Point::new([x as f64, y as f64]);
            box_points
                .filter(|&point| triangle.polygon().locate(&place(point)) == wanted)
                .collect()
        };
        for (name, location) in [
            ("inside", Location::Inside),
            ("boundary", Location::Boundary),
            ("lattice", Location::Outside),
        ] {
            ensure(marked(name)? == located(location), || {
                format!("wrong points: {name}")
            })?;
        }
        laws::figure_pick::<f64>(LatticePolygon::count, &triangle).judge()?;
        let text = plot.text("count")?;
        let expected = "I = 2\nR = 3\nI + R/2 - 1 = 2.5\n\\text{determinant}/2 = 2.5";
        ensure(text == expected, || format!("{text} should be {expected}"))
    })
    .rejects("a point beside the lattice", |plot| {
        plot.shifted("inside", [1.0, 0.0])
    })
    .rejects("inside and boundary exchanged", |plot| {
        plot.swapped("inside", "boundary")
    })
    .rejects("another triangle", |plot| {
        plot.shifted("triangle", [0.0, 1.0])
    })
    .rejects("other numbers", |plot| {
        plot.rewritten("count", "I = 3\nR = 3")
    })
    .snapshot();
}

/// In each panel the points are where their colour says, and the text has their share, scaled.
fn shares(plot: &Plot, panel: &str, factor: f64, contains: impl Fn(&Place) -> bool) -> Checked {
    let hits = plot.points(&format!("{panel}/hits"))?;
    let misses = plot.points(&format!("{panel}/misses"))?;
    let right = hits.iter().all(&contains) && !misses.iter().any(contains);
    ensure(right, || format!("{panel}: a point has the wrong colour"))?;
    ensure(hits.len() + misses.len() == 200, || {
        format!("{panel}: points are missing")
    })?;
    let share = hits.len() as f64 / 200.0;
    let error = factor * libm::sqrt(share * (1.0 - share) / 200.0);
    let text = plot.text(&format!("{panel}/estimate"))?;
    let expected = format!("= {} \\pm {error:.3}\n", factor * share);
    ensure(text.contains(&expected), || {
        format!("{text} should contain {expected}")
    })
}

#[test]
fn figure_monte_carlo() {
    figure_test(figures::figure_monte_carlo(), |plot| {
        for point in plot.polyline("arc")? {
            // The cosine and the sine are rounded.
            ensure((point.from_origin().norm() - 1.0).abs() <= 1e-15, || {
                format!("{point} is off the circle")
            })?;
        }
        shares(plot, "quarter disc", 4.0, |x| x.from_origin().norm() <= 1.0)?;
        let leaf = SimplePolygon::new(plot.polygon("leaf")?.iter().copied())?;
        shares(plot, "leaf", 1.0, |x| leaf.contains(x))?;
        let text = plot.text("leaf/estimate")?;
        let truth = format!("in truth }}{:.3}", leaf.area());
        ensure(text.contains(&truth), || {
            format!("{text} should contain {truth}")
        })
    })
    .rejects("hits and misses exchanged", |plot| {
        plot.swapped("leaf/hits", "leaf/misses")
    })
    .rejects("points that are moved", |plot| {
        plot.shifted("quarter disc/hits", [0.2, 0.2])
    })
    .rejects("another estimate", |plot| {
        plot.rewritten("quarter disc/estimate", "4h/N = 3.142 \\pm 0.001\n")
    })
    .snapshot();
}
