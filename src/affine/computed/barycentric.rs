//! Worked numbers of barycentric coordinates.

use super::Computed;
use crate::affine::{Affine, AffineBasis, Point, signed_area};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("areas_of_a_triangle", areas_of_a_triangle),
    ("points_on_a_line", points_on_a_line),
];

type Rational = BigRational;

fn quarters<const N: usize>(numbers: [i64; N]) -> [Rational; N] {
    numbers.map(|n| Rational::from_ratio(n, 4))
}

fn row(cells: impl IntoIterator<Item = String>) -> String {
    let cells: Vec<String> = cells.into_iter().map(|cell| format!("${cell}$")).collect();
    format!("| {} |\n", cells.join(" | "))
}

/// Some points of the plane with their three areas and their coordinates, for the triangle (0,0), (1,0), (0,1).
fn areas_of_a_triangle() -> String {
    let [a, b, c] = [[0, 0], [4, 0], [0, 4]].map(|point| Point::new(quarters(point)));
    let basis = AffineBasis::new([a.clone(), b.clone(), c.clone()]).expect("a triangle");
    let mut table = String::from(
        "| $G$ | $[GBC]$ | $[AGC]$ | $[ABG]$ | $(\\alpha, \\beta, \\gamma)$ |\n|---|--:|--:|--:|---|\n",
    );
    for g in [[2, 1], [0, 0], [2, 2], [4, 4], [-2, 1]].map(|point| Point::new(quarters(point))) {
        let areas = [
            signed_area(&g, &b, &c),
            signed_area(&a, &g, &c),
            signed_area(&a, &b, &g),
        ];
        let coordinates: Vec<String> = basis.coordinates(&g).iter().map(tex::fraction).collect();
        let cells = std::iter::once(tex::point(&g, tex::fraction))
            .chain(areas.iter().map(tex::fraction))
            .chain([format!("({})", coordinates.join(", "))]);
        table += &row(cells);
    }
    format!(
        "For $A = (0,0)$, $B = (1,0)$, $C = (0,1)$ the whole triangle has the area ${}$:\n\n{table}",
        tex::fraction(&signed_area(&a, &b, &c))
    )
}

/// The points of the exercise, for A = (0, 0) and B = (4, 1), and the vector.
fn points_on_a_line() -> String {
    let ends = [[0, 0], [16, 4]].map(|point| Point::new(quarters(point)));
    let with = |weights: [i64; 2]| std::iter::zip(quarters(weights), ends.clone());
    let mut table = String::from("| coordinates | is | at |\n|---|---|---|\n");
    let listed = |weights: [i64; 2]| {
        let [alpha, beta] = quarters(weights).map(|weight| tex::fraction(&weight));
        format!("$({alpha}, {beta})$")
    };
    for (i, weights) in [[2, 2], [1, 3], [-4, 8]].into_iter().enumerate() {
        let point = Point::affine_combination(with(weights)).expect("the weights sum to 1");
        let place = tex::point(&point, tex::fraction);
        table += &format!(
            "| {} | the point $M_{}$ | ${place}$ |\n",
            listed(weights),
            i + 1
        );
    }
    let vector = Point::vector_combination(with([-4, 4])).expect("the weights sum to 0");
    let components = tex::point(&vector, tex::fraction);
    table += &format!(
        "| {} | the vector ${components}$ | no place |\n",
        listed([-4, 4])
    );
    table
}
