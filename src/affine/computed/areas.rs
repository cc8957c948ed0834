//! Worked numbers of areas.

use super::Computed;
use crate::affine::{BoundingBox, LatticePoint, LatticePolygon, Point, monte_carlo};
use crate::book::tex;
use crate::scalar::BigRational;

pub(super) const ALL: &[Computed] = &[
    ("pick_polygons", pick_polygons),
    ("monte_carlo_pi", monte_carlo_pi),
];

/// Lattice polygons with their counts and both areas.
fn pick_polygons() -> String {
    let polygons: [&[LatticePoint]; 5] = [
        &[[0, 0], [1, 0], [0, 1]],
        &[[0, 0], [2, 1], [1, 3]],
        &[[0, 0], [3, 0], [3, 3], [0, 3]],
        &[[0, 0], [4, 0], [4, 3], [2, 5], [0, 3]],
        &[[0, 0], [6, 0], [6, 4], [5, 1], [3, 4], [1, 1], [0, 4]],
    ];
    let mut table = String::from(
        "| vertices | $I$ | $R$ | $I + R/2 - 1$ | area by determinants |\n|---|---|---|---|---|\n",
    );
    for vertices in polygons {
        let polygon = LatticePolygon::new(vertices.iter().copied()).expect("a simple polygon");
        let count = polygon.count();
        let names: Vec<String> = vertices
            .iter()
            .map(|[x, y]| format!("({x}, {y})"))
            .collect();
        table += &format!(
            "| ${}$ | {} | {} | ${}$ | ${}$ |\n",
            names.join(",\\ "),
            count.interior,
            count.boundary,
            tex::fraction(&count.pick_area::<BigRational>()),
            tex::fraction(&polygon.area::<BigRational>())
        );
    }
    table
}

/// Estimates of π by more and more points of one seed.
fn monte_carlo_pi() -> String {
    let square = BoundingBox::of(&[[0.0, 0.0], [1.0, 1.0]].map(Point::new)).expect("finite");
    let mut table =
        String::from("| $N$ | $4h/N$ | error | estimated standard error |\n|---|---|---|---|\n");
    for samples in [100, 1_000, 10_000, 100_000, 1_000_000] {
        let in_disc = |x: &Point<f64, 2>| x[0] * x[0] + x[1] * x[1] <= 1.0;
        let estimate = monte_carlo(&square, samples, 1, in_disc).expect("samples in a square");
        let pi = 4.0 * estimate.area();
        table += &format!(
            "| {samples} | {pi:.5} | {:.5} | {:.5} |\n",
            (pi - std::f64::consts::PI).abs(),
            4.0 * estimate.standard_error()
        );
    }
    table
}
