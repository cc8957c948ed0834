//! The figure of Kobbelt's scheme.

use super::catmull_clark::{edges, fraction};
use crate::figure::{Figure, Place, PointStyle, Style};
use crate::subdivision::{Kobbelt, SurfaceScheme, kobbelt_weights, laws, solids};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_kobbelt()]
}

/// The four-point rule on four points.
fn between(points: [Place; 4]) -> Place {
    let rule = kobbelt_weights::<f64>();
    Place::new([0, 1].map(|axis| (0..4).map(|i| rule[i] * points[i][axis]).sum::<f64>()))
}

/// The weights of a face point, and the two ways to it.
#[must_use]
pub fn figure_kobbelt() -> Figure {
    const WAYS: [&str; 2] = ["rows first", "columns first"];
    Figure::new(
        "subdivision-figure-kobbelt",
        "The face point of Kobbelt's scheme",
        "Three grids of four times four points. \
         On the first stand the 16 weights of the face point in the middle, in 256ths: \
         the products of −1, 9, 9, −1 for rows and columns. \
         On the second the four-point rule is applied to the four rows, \
         and to the four points that it gives; on the third to the columns first. \
         The last point is the same on both ways.",
    )
    .rows(&[&["weights"], &WAYS])
    .handles_in(
        WAYS[0],
        "p",
        (0..16).map(|at| {
            let [x, y] = [f64::from(at % 4), f64::from(at / 4)];
            [
                1.3 * x + 0.12 * (y - 1.5) * (y - 1.5),
                y + 0.1 * (x - 1.0) * (2.0 - x),
            ]
        }),
    )
    .draw(|values, canvas| {
        let grid = solids::grid::<f64>(3, 3);
        let mesh = grid.connectivity();
        let regular: Vec<Place> = grid
            .points()
            .iter()
            .map(|p| Place::new([1.5 * p[0], p[1]]))
            .collect();
        canvas.panel("weights");
        canvas.caption("weights in 256ths");
        edges(canvas, "edge", mesh, &regular);
        let rule = kobbelt_weights::<f64>();
        let stencil = (0..16).map(|at| {
            let weight = rule[at % 4] * rule[at / 4] * 256.0;
            (regular[at], fraction(weight, 1))
        });
        canvas.stencil("stencil", stencil, Place::new([2.25, 1.5]));
        let points = values.points("p")?;
        for (way, name) in WAYS.into_iter().enumerate() {
            let at = |along: usize, across: usize| match way {
                0 => points[along + 4 * across],
                _ => points[across + 4 * along],
            };
            let first: Vec<Place> = (0..4)
                .map(|across| between([0, 1, 2, 3].map(|along| at(along, across))))
                .collect();
            canvas.panel(name);
            canvas.caption(name);
            edges(canvas, "edge", mesh, &points);
            canvas.points("vertices", &points, PointStyle::Control);
            canvas.polyline("edge points", &first, Style::Level(1));
            canvas.point(
                "face point",
                between([first[0], first[1], first[2], first[3]]),
                PointStyle::Result,
            );
        }
        // The law is about closed grids: the points repeat with period 4 in both directions.
        canvas.panel(WAYS[0]);
        canvas.law(
            "subdivision-kobbelt",
            &laws::kobbelt_tensor_product(|mesh| Kobbelt.refine(mesh), 4, 4, &points),
        );
        Ok(())
    })
}
