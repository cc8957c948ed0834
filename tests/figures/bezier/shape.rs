//! Figures of the section on the shape of Bézier curves.

use cagd::affine::{ConvexHull, Point};
use cagd::bezier::figures;
use cagd::figure::Place;

use crate::support::{ensure, figure_test};

/// All plotted points of the curve lie in the plotted hull, whose corners are control points, all in the box.
#[test]
fn figure_convex_hull() {
    figure_test(figures::figure_convex_hull(), |plot| {
        let hull = ConvexHull::of(plot.polygon("hull")?)?;
        let corners = hull.vertices();
        let control_points = plot.polyline("control polygon")?;
        ensure(
            corners.iter().all(|corner| control_points.contains(corner)),
            || format!("a corner of the hull is no control point: {corners:?}"),
        )?;
        let outside = |points: &[Place]| points.iter().find(|p| !hull.contains(p)).copied();
        for name in ["curve", "control polygon"] {
            let found = outside(plot.polyline(name)?);
            ensure(found.is_none(), || {
                format!("{found:?} of the {name} is outside the hull")
            })?;
        }
        let bounds = ConvexHull::of(plot.polygon("box")?)?;
        ensure(corners.iter().all(|corner| bounds.contains(corner)), || {
            "the hull leaves the box".into()
        })
    })
    .rejects("a hull that leaves the curve out", |plot| {
        let corners = plot.polygon("hull")?.len();
        plot.replaced("hull", vec![Point::new([0.4, 1.0]); corners])
    })
    .rejects("a curve that leaves the hull", |plot| {
        plot.shifted("curve", [0.0, -0.5])
    })
    .rejects("a hull with a corner of its own", |plot| {
        plot.scaled("hull", 1.5)
    })
    .rejects("a box that is too small", |plot| plot.scaled("box", 0.9))
    .snapshot();
}
