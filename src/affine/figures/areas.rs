//! Figures of the section on areas.

use crate::affine::{
    Affine, BoundingBox, LatticePoint, LatticePolygon, Location, MonteCarloEstimate, Point,
    SimplePolygon, UniformPoints, laws, monte_carlo, signed_area,
};
use crate::figure::{BoxError, Canvas, Figure, PointStyle, Side, Style, Values, decimal};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_triangle_area(), figure_pick(), figure_monte_carlo()]
}

type Place = Point<f64, 2>;

/// A triangle in the parallelogram of two of its sides.
#[must_use]
pub fn figure_triangle_area() -> Figure {
    Figure::new(
        "affine-figure-triangle-area",
        "A triangle is half of a parallelogram",
        "Two arrows v and w lead from the corner R of a triangle to its corners P and Q. \
         The triangle is one half of the shaded parallelogram that they span. A text gives the signed area.",
    )
    .handle("R", [0.0, 0.0])
    .handle("P", [3.0, 0.6])
    .handle("Q", [1.2, 2.4])
    .draw(|values, canvas| {
        let [r, p, q] = [values.point("R")?, values.point("P")?, values.point("Q")?];
        let w = q - r;
        canvas.polygon("parallelogram", [r, p, p + w, q], Style::Region);
        canvas.polygon("rest", [p, p + w, q], Style::Guide);
        canvas.polygon("triangle", [r, p, q], Style::Disc);
        canvas.arrow("v", r, p, Style::Tangent);
        canvas.arrow("w", r, q, Style::Tangent);
        for (name, at) in [("R", r), ("P", p), ("Q", q)] {
            canvas.label(name, at);
        }
        canvas.label("v", r.lerp(&p, 0.5));
        canvas.label("w", r.lerp(&q, 0.5));
        let text = format!("[R P Q] = {}", decimal(signed_area(&r, &p, &q), 3));
        canvas.text("area", &text, [2.1, -0.5], Side::Centre);
        canvas.law(
            "affine-triangle-area-determinant",
            &laws::triangle_area_determinant(signed_area, &r, &p, &q),
        );
        if signed_area(&r, &p, &q) == 0.0 {
            canvas.remark("The corners are on a line: both vectors have one direction, and their determinant is 0.");
        }
        Ok(())
    })
}

/// A lattice triangle with its lattice points inside and on the boundary, and its area twice.
#[must_use]
pub fn figure_pick() -> Figure {
    Figure::new(
        "affine-figure-pick",
        "Pick's theorem for a triangle",
        "A square lattice and a triangle whose corners are lattice points. \
         The lattice points inside are large dots, those on the boundary smaller ones of another colour, all others small and grey. \
         A text counts both and gives the area by the count and by the determinant, which agree.",
    )
    .handles("P", [[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]])
    .draw(|values, canvas| {
        const LOW: [i64; 2] = [-1, -1];
        const HIGH: [i64; 2] = [4, 4];
        let place = |[x, y]: LatticePoint| Point::new([x as f64, y as f64]);
        let vertices: Vec<LatticePoint> = values
            .points("P")?
            .iter()
            .map(|p| [0, 1].map(|k| libm::round(p[k]) as i64))
            .collect();
        canvas.window(place(LOW), [6.8, 4.0]);
        let lattice = (LOW[1]..=HIGH[1]).flat_map(|y| (LOW[0]..=HIGH[0]).map(move |x| [x, y]));
        let (text, inside, boundary) = match LatticePolygon::new(vertices.iter().copied()) {
            Ok(triangle) => {
                canvas.polygon("triangle", vertices.iter().copied().map(place), Style::Region);
                canvas.polygon("sides", vertices.iter().copied().map(place), Style::Connector);
                let count = triangle.count();
                canvas.law(
                    "affine-pick-theorem",
                    &laws::pick_theorem::<f64>(LatticePolygon::count, &triangle),
                );
                let text = format!(
                    "I = {}\nR = {}\nI + R/2 - 1 = {}\n\\text{{determinant}}/2 = {}",
                    count.interior,
                    count.boundary,
                    decimal(count.pick_area(), 1),
                    decimal(triangle.area(), 1)
                );
                (text, triangle.interior_points(), triangle.boundary_points())
            }
            Err(_) => {
                canvas.remark(
                    "The corners are on a line. Pick's theorem is about polygons with an inside: \
                     a segment has the area 0, but its points would give another number.",
                );
                ("\\text{no triangle}".into(), vec![], vertices.clone())
            }
        };
        let others = lattice.filter(|point| !inside.contains(point) && !boundary.contains(point));
        canvas.points("lattice", others.map(place), PointStyle::Guide);
        canvas.points("inside", inside.into_iter().map(place), PointStyle::Result);
        canvas.points("boundary", boundary.into_iter().map(place), PointStyle::OnCurve);
        canvas.text("count", &text, [5.7, 1.5], Side::Centre);
        for (i, vertex) in vertices.iter().enumerate() {
            canvas.label(&format!("P_{i}"), place(*vertex));
        }
        Ok(())
    })
}

/// Random points in a box, for a quarter disc and for a free shape.
#[must_use]
pub fn figure_monte_carlo() -> Figure {
    Figure::new(
        "affine-figure-monte-carlo",
        "Areas by random points",
        "Two squares with random points. In the first, those inside a quarter disc are solid and the others small and grey; \
         four times their share estimates the number pi. In the second, those inside a closed shape like a leaf are solid. \
         Texts give the estimates, their standard errors and the true values.",
    )
    .stepper("N", 10..=400, 200)
    .stepper("s", 0..=50, 1)
    .rows(&[&["quarter disc"], &["leaf"]])
    .draw(|values, canvas| {
        let corner = 0.25 * std::f64::consts::TAU;
        canvas.panel("quarter disc");
        canvas.caption("quarter disc");
        let arc = |angle: f64| [libm::cos(angle), libm::sin(angle)];
        canvas.curve("arc", 0.0..=corner, arc, Style::Curve);
        let (square, in_disc) = (unit_square()?, |x: &Place| {
            x[0] * x[0] + x[1] * x[1] <= 1.0
        });
        let disc = sampled(canvas, values, &square, in_disc)?;
        report(canvas, &disc, 4.0, std::f64::consts::PI, "4h/N");
        let draws = (values.count("N")?, values.count("s")? as u64);
        let law = laws::monte_carlo_area(|_, _, _, _| disc, &square, draws, &in_disc, 0.5 * corner);
        canvas.law("affine-monte-carlo-area", &law);

        canvas.panel("leaf");
        canvas.caption("free shape");
        let leaf = SimplePolygon::new((0..LEAF_VERTICES).map(leaf))?;
        canvas.polygon("leaf", leaf.vertices(), Style::Curve);
        let in_leaf = |x: &Place| leaf.locate(x) != Location::Outside;
        let estimate = sampled(canvas, values, &square, in_leaf)?;
        report(canvas, &estimate, 1.0, leaf.area(), "h/N");
        let law = laws::monte_carlo_area(|_, _, _, _| estimate, &square, draws, &in_leaf, leaf.area());
        canvas.law("affine-monte-carlo-area", &law);
        Ok(())
    })
}

/// How many vertices the polygon of the free shape has.
const LEAF_VERTICES: usize = 120;

/// Vertex `k` of a closed shape with three bays, in the unit square.
fn leaf(k: usize) -> Place {
    let angle = k as f64 / LEAF_VERTICES as f64 * std::f64::consts::TAU;
    let radius = 0.33 + 0.09 * libm::cos(3.0 * angle) + 0.05 * libm::sin(2.0 * angle);
    Point::new([
        0.5 + radius * libm::cos(angle),
        0.5 + radius * libm::sin(angle),
    ])
}

fn unit_square() -> Result<BoundingBox<Place>, BoxError> {
    Ok(BoundingBox::of(&[[0.0, 0.0], [1.0, 1.0]].map(Point::new))?)
}

/// Draws the points of the seed s, those inside and those outside, and estimates the area from them.
fn sampled(
    canvas: &mut Canvas,
    values: &Values,
    square: &BoundingBox<Place>,
    contains: impl Fn(&Place) -> bool,
) -> Result<MonteCarloEstimate, BoxError> {
    let (count, seed) = (values.count("N")?, values.count("s")? as u64);
    canvas.window([0.0, 0.0], [1.85, 1.0]);
    canvas.rectangle("box", square.low(), square.high(), Style::Connector);
    let points = UniformPoints::new(*square, seed).take(count);
    let (hits, misses): (Vec<Place>, Vec<Place>) = points.partition(|point| contains(point));
    canvas.points("misses", misses, PointStyle::Guide);
    canvas.points("hits", hits, PointStyle::OnCurve);
    Ok(monte_carlo(square, count, seed, contains)?)
}

/// Writes the estimate, times a factor, with its standard error, and the true value below.
fn report(canvas: &mut Canvas, estimate: &MonteCarloEstimate, factor: f64, truth: f64, name: &str) {
    let text = format!(
        "{name} = {} \\pm {}\n\\text{{in truth }}{}",
        decimal(factor * estimate.area(), 3),
        decimal(factor * estimate.standard_error(), 3),
        decimal(truth, 3)
    );
    canvas.text("estimate", &text, [1.45, 0.5], Side::Centre);
}
