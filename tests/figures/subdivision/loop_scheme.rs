//! Figures of the section on Loop's scheme.

use cagd::affine::{Affine, Point};
use cagd::figure::{BoxError, Place, View};
use cagd::subdivision::{box_spline_222, figures};

use crate::support::{ensure, figure_test, near};

/// The new points are the weighted means of the stencils' points with the weights of the statement.
#[test]
fn figure_loop() {
    figure_test(figures::figure_loop(), |plot| {
        let at = |name: &str| plot.point(name);
        let weights = [3.0, 3.0, 1.0, 1.0].map(|eighths: f64| eighths / 8.0);
        let mut terms = vec![];
        for (i, weight) in weights.into_iter().enumerate() {
            terms.push((weight, at(&format!("edge point/edge point {i}"))?));
        }
        // Four products and three sums of numbers up to 2.
        let bound = cagd::law::gamma(8) * 2.0;
        let mean = Place::affine_combination(terms)?;
        near("edge point", at("edge point/edge point")?, mean, bound)?;
        near(
            "vertex point",
            at("vertex point/vertex point")?,
            Place::origin(),
            bound,
        )?;
        // 5/8 − (3/8 + cos(2π/5)/4)² is 0.4205 for five neighbours.
        let beta = plot.labels().filter(|(text, _)| *text == "0.084").count();
        ensure(beta == 5, || {
            format!("{beta} of 5 neighbours have the weight 0.084")
        })?;
        let faces = plot.surface("mesh/surface")?.faces.len();
        ensure((50..=78).contains(&faces), || {
            format!("{faces} of 128 faces look towards us")
        })
    })
    .rejects("a new point that is not the mean", |plot| {
        plot.shifted("edge point/edge point", [0.1, 0.0])
    })
    .snapshot();
}

/// Limit points are 24/55 of the way out, and normals point away from the centre.
#[test]
fn loop_limit() {
    figure_test(figures::loop_limit(), |plot| {
        let view = View::degrees(25.0, 25.0);
        let axes = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ];
        let mut seen = 0;
        for (v, axis) in axes.into_iter().enumerate() {
            let at = |factor: f64| view.place(&Point::new(axis.map(|x| factor * x)));
            let name = format!("normal at vertex {v}");
            if !plot.names().any(|(_, item)| item == name) {
                continue;
            }
            seen += 1;
            // Forty operations on numbers up to 1.
            let bound = cagd::law::gamma(40);
            let [foot, tip] = plot.segment(&name)?;
            near("foot", foot, at(24.0 / 55.0), bound)?;
            near("tip", tip, at(24.0 / 55.0 + 0.4), bound)?;
            near(
                "limit",
                plot.point(&format!("limit of vertex {v}"))?,
                foot,
                0.0,
            )?;
        }
        ensure(seen == 3, || format!("{seen} vertices are seen"))
    })
    .rejects("a limit off the surface", |plot| {
        plot.shifted("limit of vertex 4", [0.0, 0.1])
    })
    .rejects("a crooked normal", |plot| {
        plot.shifted("normal at vertex 4", [0.05, 0.0])
    })
    .snapshot();
}

/// The heights are three times the values of the box spline.
#[test]
fn loop_box_spline() {
    figure_test(figures::loop_box_spline(), |plot| -> Result<(), BoxError> {
        let view = View::degrees(20.0, 42.0);
        let places = plot.surface("graph")?.places;
        // Heights are sums with less than a hundred roundings of numbers up to 3.
        let bound = cagd::law::gamma(100) * 2300.0;
        let n = 8_i32;
        let mut found = 0;
        for i in -n..=n {
            for j in -n..=n {
                if (i - j).abs() > n {
                    continue;
                }
                let [x, y] = [i, j].map(|k| f64::from(k) / 4.0);
                // The directions (1, 0), (1, 1) and (0, 1) of the lattice are 60° apart in the picture.
                let at = [x - 0.5 * y, 0.75_f64.sqrt() * y];
                let height = 3.0 * box_spline_222(&[x, y]);
                let expected = view.place(&Point::new([at[0], at[1], height]));
                let near = places
                    .iter()
                    .filter(|place| (**place - expected).amax() <= bound);
                ensure(near.count() > 0, || format!("no vertex over ({x}, {y})"))?;
                found += 1;
            }
        }
        // The lattice points of a hexagon: its centre and rings of 6, 12, …, 6n.
        ensure(found == 1 + 3 * n * (n + 1), || {
            format!("{found} places were looked at")
        })?;
        ensure(places.len() == found as usize, || {
            format!("{} vertices", places.len())
        })?;
        near(
            "top",
            plot.point("top")?,
            view.place(&Point::new([0.0, 0.0, 1.5])),
            bound,
        )
    })
    .rejects("a lower hill", |plot| plot.scaled("graph", 0.9))
    .rejects("another top", |plot| plot.shifted("top", [0.0, 0.1]))
    .snapshot();
}
