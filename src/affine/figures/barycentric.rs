//! Figures of the section on barycentric coordinates.

use crate::affine::{Affine, AffineBasis, Linear, Point, Vector, laws, line_coordinates};
use crate::figure::{Canvas, Figure, Place, PointStyle, Side, Style, decimal, midpoint};
use crate::scalar::Real;

pub(super) fn all() -> Vec<Figure> {
    vec![
        barycentric_on_line(),
        barycentric_in_triangle(),
        exercise_points_on_line(),
    ]
}

/// What coordinates on a line need.
const NO_LINE: &str = "A and B are in one place: every combination of them with the sum 1 is this place, \
     so no coordinates can be read off. They need A ≠ B.";

/// How far beside the line arrows are drawn.
const BESIDE: f64 = 0.45;

/// A vector of length [`BESIDE`] across the way from `start` to `end`; 0 if there is no way.
fn across(start: &Place, end: &Place) -> Vector<f64, 2> {
    let way = *end - *start;
    let length = Real::sqrt(way.dot(&way));
    if length == 0.0 {
        Vector::zeros()
    } else {
        Vector::from([-way[1], way[0]]).scaled(BESIDE / length)
    }
}

/// The point of the line through `start` and `end` that is nearest to `point`.
fn foot(start: &Place, end: &Place, point: &Place) -> Place {
    let way = *end - *start;
    let square = way.dot(&way);
    if square == 0.0 {
        *start
    } else {
        start.lerp(end, way.dot(&(*point - *start)) / square)
    }
}

/// A point inside a segment and one outside, with the lengths that are its coordinates.
#[must_use]
pub fn barycentric_on_line() -> Figure {
    const PANELS: [&str; 2] = ["inside", "outside"];
    Figure::new(
        "affine-barycentric-on-line",
        "The weight of a point is the length on the other side",
        "Twice the line through two points A and B with a point G on it. \
         An arrow from G to B, in the colour of A, shows the weight of A; \
         an arrow from A to G, in the colour of B, shows the weight of B. \
         On the left G lies between A and B, and both arrows point the way from A to B. \
         On the right G lies beyond B; the arrow from G to B points backwards, and the weight of A is negative.",
    )
    .rows(&[&PANELS])
    .handles_in(PANELS[0], "p", [[0.0, 0.0], [5.0, 1.0]])
    .handle_in(PANELS[0], "g", [1.5, 0.3])
    .handles_in(PANELS[1], "q", [[0.0, 0.0], [3.5, 0.7]])
    .handle_in(PANELS[1], "h", [5.25, 1.05])
    .draw(|values, canvas| {
        for (panel, ends, place) in [(PANELS[0], "p", "g"), (PANELS[1], "q", "h")] {
            canvas.panel(panel);
            let ends = values.points(ends)?;
            let (a, b) = (ends[0], ends[1]);
            draw_on_line(canvas, a, b, foot(&a, &b, &values.point(place)?));
        }
        Ok(())
    })
}

fn draw_on_line(canvas: &mut Canvas, a: Place, b: Place, g: Place) {
    canvas.line("line", a, b, Style::Guide);
    canvas.segment("AB", a, b, Style::Curve);
    match line_coordinates(&a, &b, &g) {
        Err(_) => {
            canvas.caption("$A = B$: no coordinates");
            canvas.remark(NO_LINE);
        }
        Ok([alpha, beta]) => {
            let n = across(&a, &b);
            canvas.arrow("alpha", g + n, b + n, Style::Level(1));
            canvas.arrow("beta", a - n, g - n, Style::Level(2));
            canvas.label_on(Side::Above, "\\alpha", midpoint(g + n, b + n));
            canvas.label_on(Side::Below, "\\beta", midpoint(a - n, g - n));
            canvas.law(
                "affine-barycentric-on-line",
                &laws::barycentric_on_line(
                    |a, b, g| line_coordinates(a, b, g).ok(),
                    [&a, &b],
                    &beta,
                ),
            );
            let [alpha, beta] = [alpha, beta].map(|weight| decimal(weight, 2));
            canvas.caption(&format!("$\\alpha = {alpha}$, $\\beta = {beta}$"));
        }
    }
    canvas.point("A", a, PointStyle::Level(1));
    canvas.point("B", b, PointStyle::Level(2));
    canvas.point("G", g, PointStyle::Result);
    for (name, place) in [("A", a), ("B", b), ("G", g)] {
        canvas.label(name, place);
    }
}

/// A triangle, a point in it, and the three triangles that are its coordinates.
#[must_use]
pub fn barycentric_in_triangle() -> Figure {
    Figure::new(
        "affine-barycentric-in-triangle",
        "Barycentric coordinates are ratios of areas",
        "A triangle A, B, C and a point G inside, joined with the corners. \
         The three triangles that arise have the colours of the opposite corners: \
         the triangle G, B, C that of A, and so on. \
         In each stands the coordinate of G that its area gives, a fraction of the whole triangle.",
    )
    .handle("A", [0.0, 0.0])
    .handle("B", [6.0, 0.0])
    .handle("C", [1.5, 4.5])
    .handle("G", [2.1, 1.8])
    .draw(|values, canvas| {
        const NAMES: [&str; 3] = ["A", "B", "C"];
        let [a, b, c] = [
            values.point(NAMES[0])?,
            values.point(NAMES[1])?,
            values.point(NAMES[2])?,
        ];
        let g = values.point("G")?;
        let opposite = [[g, b, c], [a, g, c], [a, b, g]];
        for (i, corners) in opposite.iter().enumerate() {
            let name = format!("opposite {}", NAMES[i]);
            canvas.polygon(&name, corners, Style::Share(i + 1));
        }
        canvas.polyline("triangle", [a, b, c, a], Style::Connector);
        match AffineBasis::new([a, b, c]) {
            Err(_) => {
                canvas.caption("$A$, $B$, $C$ on a line: no coordinates");
                canvas.remark(
                    "A, B and C are on a line: the whole area is 0, and nothing can be divided by it. \
                     Coordinates in the plane need three points that are not on a line.",
                );
            }
            Ok(basis) => {
                let weights = basis.coordinates(&g);
                let found = [weights[0], weights[1], weights[2]];
                canvas.law(
                    "affine-barycentric-in-triangle",
                    &laws::barycentric_in_triangle(|_, _| found, &[a, b, c], &g),
                );
                if found.iter().any(|weight| *weight < 0.0) {
                    canvas.remark(
                        "G is outside the triangle: the area opposite some corner is run through the other way round, \
                         and its coordinate is negative.",
                    );
                }
                let signs = ["\\alpha", "\\beta", "\\gamma"];
                for ((sign, weight), corners) in signs.iter().zip(&weights).zip(&opposite) {
                    let text = format!("{sign} = {}", decimal(*weight, 2));
                    let third = [1.0 / 3.0; 3];
                    let middle = Point::affine_combination(std::iter::zip(third, *corners))?;
                    canvas.label_on(Side::Centre, &text, middle);
                }
            }
        }
        for (i, (name, place)) in std::iter::zip(NAMES, [a, b, c]).enumerate() {
            canvas.segment(&format!("G{name}"), g, place, Style::Connector);
            canvas.point(name, place, PointStyle::Level(i + 1));
            canvas.label(name, place);
        }
        canvas.point("G", g, PointStyle::Result);
        canvas.label("G", g);
        Ok(())
    })
}

/// The points with the coordinates (1/2, 1/2), (1/4, 3/4) and (−1, 2), and the vector B − A at two places.
#[must_use]
pub fn exercise_points_on_line() -> Figure {
    Figure::new(
        "affine-exercise-points-on-line",
        "Points with given barycentric coordinates",
        "The line through A and B. \
         The midpoint M 1 has equal coordinates; \
         M 2 lies three quarters of the way from A to B; \
         M 3 lies beyond B, as far from it as A. \
         Two equal arrows beside the line show the vector B minus A, which has the coordinates minus one and one \
         and no place of its own.",
    )
    .handle("A", [0.0, 0.0])
    .handle("B", [4.0, 1.0])
    .draw(|values, canvas| {
        let [a, b] = [values.point("A")?, values.point("B")?];
        canvas.line("line", a, b, Style::Guide);
        canvas.segment("AB", a, b, Style::Curve);
        let vector = Point::vector_combination([(-1.0, a), (1.0, b)])?;
        let n = across(&a, &b);
        for (name, start) in [("vector", a - n), ("the same vector", b + vector.scaled(0.25) - n)] {
            canvas.arrow(name, start, start + vector, Style::Tangent);
            canvas.label_on(Side::Below, "B-A", midpoint(start, start + vector));
        }
        for (i, weights) in [[0.5, 0.5], [0.25, 0.75], [-1.0, 2.0]].into_iter().enumerate() {
            let name = format!("M_{}", i + 1);
            let point = Point::affine_combination(std::iter::zip(weights, [a, b]))?;
            canvas.point(&name, point, PointStyle::Result);
            canvas.label_on(Side::Above, &name, point);
        }
        for (name, place) in [("A", a), ("B", b)] {
            canvas.point(name, place, PointStyle::OnCurve);
            canvas.label_on(Side::Above, name, place);
        }
        if a == b {
            canvas.remark(NO_LINE);
        } else {
            canvas.law(
                "affine-barycentric-on-line",
                &laws::barycentric_on_line(|a, b, g| line_coordinates(a, b, g).ok(), [&a, &b], &0.75),
            );
        }
        Ok(())
    })
}
