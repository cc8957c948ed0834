//! Worked numbers of the Bernstein representation.

use super::Computed;
use crate::affine::{Interval, Point, Vector};
use crate::bezier::{
    BezierCurve, MonomialCurve, TrianglePaths, bernstein, bernstein_basis, bernstein_matrix,
};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("paths_of_a_cubic", paths_of_a_cubic),
    ("scheme_of_a_basis_function", scheme_of_a_basis_function),
    ("collected_terms", collected_terms),
    ("parabola_points", parabola_points),
    ("quartic_matrix", quartic_matrix),
    ("masses", masses),
];

fn rational(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn quarter() -> BigRational {
    BigRational::from_ratio(1, 4)
}

fn curve(values: &[i64]) -> BezierCurve<BigRational> {
    BezierCurve::new(values.iter().copied().map(rational)).expect("there are control values")
}

/// The paths from b₁ to the tip for n = 3, with their weights at t = 1/4 and the sum.
fn paths_of_a_cubic() -> String {
    let mut table = String::from("| path | weight at $t = \\tfrac14$ |\n|---|---|\n");
    for path in TrianglePaths::new(3, 1) {
        let points: Vec<String> = path
            .points()
            .into_iter()
            .map(|(level, index)| format!("b_{index}^{level}"))
            .collect();
        let weight = tex::fraction(&path.weight(quarter()));
        table += &format!("| ${}$ | ${weight}$ |\n", points.join(r" \to "));
    }
    let sum = tex::fraction(&bernstein(3, 1, quarter()));
    table + &format!("| sum: $B_1^3(\\tfrac14)$ | ${sum}$ |\n")
}

/// The scheme of de Casteljau for the values 0, 1, 0, 0 at t = 1/4, by columns.
fn scheme_of_a_basis_function() -> String {
    let triangle = curve(&[0, 1, 0, 0]).triangle(quarter());
    let mut table = String::from("| column | values | they are |\n|---|---|---|\n");
    for (level, column) in triangle.columns().enumerate() {
        let values: Vec<String> = column.iter().map(tex::fraction).collect();
        let meaning = match level {
            2 => r"$B_1^2,\; B_0^2$",
            3 => "$B_1^3$",
            _ => "",
        };
        table += &format!("| {level} | ${}$ | {meaning} |\n", values.join(r",\; "));
    }
    table
}

/// The columns of the scheme of 0, 8, 4, 12 at t = 1/4, and their Bernstein sums.
fn collected_terms() -> String {
    let triangle = curve(&[0, 8, 4, 12]).triangle(quarter());
    let mut table = String::from(
        "| $r$ | points of column $r$ | Bernstein polynomials of degree $3-r$ at $\\tfrac14$ | sum of the products |\n|---|---|---|---|\n",
    );
    for (r, column) in triangle.columns().enumerate() {
        let weights = bernstein_basis(3 - r, quarter());
        let sum: BigRational = std::iter::zip(column, &weights)
            .map(|(value, weight)| value * weight)
            .sum();
        let list = |numbers: &[BigRational]| {
            let texts: Vec<String> = numbers.iter().map(tex::fraction).collect();
            texts.join(r",\; ")
        };
        table += &format!(
            "| {r} | ${}$ | ${}$ | ${}$ |\n",
            list(column),
            list(&weights),
            tex::fraction(&sum)
        );
    }
    table
}

/// The Bézier points of (u, u²) over three intervals.
fn parabola_points() -> String {
    let vector = |x, y| Vector::from([rational(x), rational(y)]);
    let parabola = MonomialCurve::new(
        Point::new([rational(0), rational(0)]),
        [vector(1, 0), vector(0, 1)],
    )
    .expect("exact coefficients");
    let mut table = String::from("| interval | $b_0$ | $b_1$ | $b_2$ |\n|---|---|---|---|\n");
    for (a, b) in [(0, 1), (1, 3), (-1, 1)] {
        let interval = Interval::new(rational(a), rational(b)).expect("two different ends");
        let form = parabola.over(interval).expect("exact coefficients");
        let curve = BezierCurve::from_monomial(&form).expect("exact coefficients");
        let points: Vec<String> = curve
            .control_points()
            .iter()
            .map(|point| format!("${}$", tex::point(point, tex::fraction)))
            .collect();
        table += &format!("| $[{a}, {b}]$ | {} |\n", points.join(" | "));
    }
    table
}

/// The matrix of the Bernstein polynomials of degree 4.
fn quartic_matrix() -> String {
    let matrix = bernstein_matrix::<BigRational>(4);
    let rows: Vec<String> = matrix
        .row_iter()
        .map(|row| {
            let entries: Vec<String> = row.iter().map(tex::fraction).collect();
            entries.join(" & ")
        })
        .collect();
    format!(
        "```math\n\\begin{{pmatrix}} {} \\end{{pmatrix}}\n```\n",
        rows.join(r" \\ ")
    )
}

/// The Bernstein polynomials of degree 3 at 0.4, and their sum.
fn masses() -> String {
    let values = bernstein_basis(3, BigRational::from_ratio(2, 5));
    let sum: BigRational = values.iter().sum();
    let cells: Vec<String> = values.iter().map(|value| tex::decimal(value, 3)).collect();
    format!(
        "| $b_0$ | $b_1$ | $b_2$ | $b_3$ | total |\n|---|---|---|---|---|\n| {} | {} |\n",
        cells.join(" | "),
        tex::decimal(&sum, 3)
    )
}
