//! Figures of the section on the modified Butterfly scheme.

use cagd::affine::{Affine, Point};
use cagd::figure::{Place, View};
use cagd::subdivision::{figures, solids};

use crate::support::{ensure, figure_test, near};

/// The new point is the mean of the eight points with the weights that are written at them.
#[test]
fn figure_butterfly() {
    figure_test(figures::figure_butterfly(), |plot| {
        let weights = [8.0, 8.0, 2.0, 2.0, -1.0, -1.0, -1.0, -1.0].map(|w: f64| w / 16.0);
        let mut terms = vec![];
        for (i, weight) in weights.into_iter().enumerate() {
            terms.push((weight, plot.point(&format!("new point {i}"))?));
        }
        let mean = Place::affine_combination(terms)?;
        // Eight products and seven sums of numbers up to 2.
        near(
            "new point",
            plot.point("new point")?,
            mean,
            cagd::law::gamma(16) * 4.0,
        )?;
        let wings = plot.labels().filter(|(text, _)| *text == "-1/16").count();
        ensure(wings == 4, || format!("{wings} wings"))
    })
    .rejects("a wing elsewhere", |plot| {
        plot.shifted("new point 7", [0.5, 0.0])
    })
    .snapshot();
}

/// The new point is the mean of the star with the weights that are written at its points.
#[test]
fn figure_butterfly_special() {
    figure_test(figures::figure_butterfly_special(), |plot| {
        let mut terms = vec![(0.75, plot.point("new point 0")?)];
        for j in 0..5 {
            let turn = std::f64::consts::TAU / 5.0 * f64::from(j);
            let weight = (0.25 + turn.cos() + (2.0 * turn).cos() / 2.0) / 5.0;
            terms.push((weight, plot.point(&format!("new point {}", j + 1))?));
        }
        let mean = Place::affine_combination(terms)?;
        // Six products and five sums of numbers up to 1, and the roundings of the weights.
        near(
            "new point",
            plot.point("new point")?,
            mean,
            cagd::law::gamma(40),
        )
    })
    .rejects("the middle of the edge", |plot| {
        plot.replaced("new point", [[0.45, 0.0]])
    })
    .snapshot();
}

/// The marked vertices are those of the icosahedron that look towards us.
#[test]
fn figure_butterfly_result() {
    figure_test(figures::figure_butterfly_result(), |plot| {
        let view = View::degrees(25.0, 25.0);
        let icosahedron = solids::icosahedron::<f64>();
        let seen = |point: &&Point<f64, 3>| view.seen(point)[2] > 0.0;
        let expected = icosahedron
            .points()
            .iter()
            .filter(seen)
            .map(|p| view.place(p));
        let expected: Vec<Place> = expected.collect();
        let marked = plot.points("vertices")?;
        ensure(marked == expected, || {
            format!("{marked:?}, expected {expected:?}")
        })?;
        let surface = plot.surface("surface")?;
        // The refined body has these vertices, too.
        let kept = expected.iter().all(|place| surface.places.contains(place));
        ensure(kept, || "a vertex was moved".into())
    })
    .rejects("a body that misses its vertices", |plot| {
        plot.scaled("surface", 1.01)
    })
    .snapshot();
}
