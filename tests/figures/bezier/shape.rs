//! Figures of the section on the shape of Bézier curves.

use cagd::affine::{AffineBasis, AffineMap, ConvexHull, Line, Point};
use cagd::bezier::{BezierCurve, figures, laws, sign_changes};
use cagd::figure::{Place, Plot, PlotError};

use crate::support::{ensure, figure_test, near};

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

/// The map that takes three control points to their plotted images takes the fourth, each plotted point of
/// the curve, and b(t) to theirs.
///
/// Solving for the map passes some twenty roundings of numbers below 10, its condition is below 10.
#[test]
fn figure_affine_invariance() {
    const BOUND: f64 = 20.0 * 10.0 * 10.0 * f64::EPSILON;
    figure_test(figures::figure_affine_invariance(), |plot| {
        let [points, images] = [plot.polyline("polygon")?, plot.polyline("image polygon")?];
        let basis = AffineBasis::new(points[..3].iter().copied())?;
        let map = AffineMap::from_images(&basis, &images[..3])?;
        near("the image of b_3", map.point(&points[3]), images[3], BOUND)?;
        for (point, image) in std::iter::zip(plot.polyline("curve")?, plot.polyline("image")?) {
            near("a point of the image", map.point(point), *image, BOUND)?;
        }
        let image = plot.point("image of b(t)")?;
        near(
            "the image of b(t)",
            map.point(&plot.point("b(t)")?),
            image,
            BOUND,
        )?;
        let (_, on_image) = plot
            .samples("image")?
            .find(|(t, _)| *t == 0.4)
            .expect("96/240 is a sample");
        near("the point of the image", on_image, image, BOUND)
    })
    .rejects("an image that is moved", |plot| {
        plot.shifted("image", [0.1, 0.0])
    })
    .rejects("an image of another size", |plot| {
        plot.scaled("image", 1.01)
    })
    .rejects("a point beside the image", |plot| {
        plot.shifted("image of b(t)", [0.0, 0.05])
    })
    .snapshot();
}

/// The line through the two plotted points of the line.
fn plotted_line(plot: &Plot) -> Result<Line<f64>, PlotError> {
    let ends = plot.points("points of the line")?;
    Ok(Line::through(&ends[0], &ends[1]).expect("two different points"))
}

/// Each cross is on the line and on the curve, and there is one between any two samples on different sides.
///
/// A parameter is known to 2⁻⁵¹, the speed is below 30, the normal vector shorter than 10.
#[test]
fn line_intersections() {
    const BOUND: f64 = 30.0 * 10.0 * 2.0 * f64::EPSILON;
    figure_test(figures::line_intersections(), |plot| {
        let line = plotted_line(plot)?;
        let crosses = plot.points("intersections")?;
        for cross in crosses {
            let height = line.value(cross);
            ensure(height.abs() <= BOUND, || {
                format!("{cross} is off the line by {height}")
            })?;
        }
        let curve = plot.polyline("curve")?;
        let heights: Vec<f64> = curve.iter().map(|point| line.value(point)).collect();
        let changes = sign_changes(&heights);
        ensure(crosses.len() == changes && changes == 3, || {
            format!("{} crosses, {changes} changes of the side", crosses.len())
        })?;
        let near_curve = |cross: &Place| {
            // A chord of a sample step is 1/240 of a speed below 30.
            curve
                .iter()
                .any(|point| (*point - *cross).norm() <= 30.0 / 240.0)
        };
        ensure(crosses.iter().all(near_curve), || {
            "a cross is off the curve".into()
        })
    })
    .rejects("crosses beside the line", |plot| {
        plot.shifted("intersections", [0.0, 0.1])
    })
    .rejects("a curve somewhere else", |plot| {
        plot.shifted("curve", [0.0, 3.0])
    })
    .rejects("no crosses", |plot| {
        plot.replaced("intersections", [Point::new([9.0, 9.0]); 3])
    })
    .snapshot();
}

/// The numbers in the text are those of the sign changes along the plotted polygon and the plotted
/// curve, the law holds for them, and all marks are on the line.
///
/// The marks are off by the rounding of a parameter, 2⁻⁵¹ times a speed below 50 and a normal vector below 10.
#[test]
fn variation_diminishing() {
    const BOUND: f64 = 50.0 * 10.0 * 2.0 * f64::EPSILON;
    figure_test(figures::variation_diminishing(), |plot| {
        let line = plotted_line(plot)?;
        let changes = |name: &str| -> Result<usize, PlotError> {
            let points = plot.polyline(name)?.iter();
            Ok(sign_changes(
                &points.map(|point| line.value(point)).collect::<Vec<_>>(),
            ))
        };
        let (polygon, curve) = (changes("control polygon")?, changes("curve")?);
        let expected =
            format!("crossings of the polygon: {polygon}\ncrossings of the curve: {curve}");
        ensure(plot.text("crossings")? == expected, || {
            format!("the text should be {expected}")
        })?;
        for (name, count) in [
            ("crossings of the polygon", polygon),
            ("crossings of the curve", curve),
        ] {
            let marks = plot.points(name)?;
            let off = marks.iter().find(|mark| line.value(mark).abs() > BOUND);
            ensure(marks.len() == count && off.is_none(), || {
                format!("{name}: {} marks, {off:?} is off the line", marks.len())
            })?;
        }
        let samples: Vec<(f64, Place)> = plot.samples("curve")?.collect();
        let parameters: Vec<f64> = samples.iter().map(|(t, _)| *t).collect();
        let of_the_polygon = BezierCurve::new(plot.polyline("control polygon")?.to_vec())?;
        let plotted = |_: &BezierCurve<Place>, u: f64| {
            samples
                .iter()
                .find(|(t, _)| *t == u)
                .map_or(Point::origin(), |(_, point)| *point)
        };
        laws::variation_diminishing(plotted, &of_the_polygon, &line, &parameters).judge()?;
        Ok(())
    })
    .rejects("a wrong number", |plot| {
        plot.rewritten(
            "crossings",
            "crossings of the polygon: 5\ncrossings of the curve: 4",
        )
    })
    .rejects("marks beside the line", |plot| {
        plot.shifted("crossings of the curve", [0.0, 0.1])
    })
    .rejects("a curve somewhere else", |plot| {
        plot.shifted("curve", [0.0, 5.0])
    })
    .snapshot();
}
