//! Worked numbers of the algorithm of de Casteljau.

use super::Computed;
use crate::affine::Point;
use crate::bezier::{BezierCurve, CasteljauTriangle, Counted, recursive_at};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("de_casteljau_examples", de_casteljau_examples),
    ("de_casteljau_cost", de_casteljau_cost),
];

type RationalPoint = Point<BigRational, 2>;

pub(super) fn curve<const N: usize>(points: [[i64; 2]; N]) -> BezierCurve<RationalPoint> {
    let whole = |p: [i64; 2]| Point::new(p.map(<BigRational as Scalar>::from_integer));
    BezierCurve::new(points.map(whole)).expect("at least one point")
}

/// The quadratic and the cubic at 1/2 and 1/4, each as a triangle.
fn de_casteljau_examples() -> String {
    let quadratic = curve([[0, 0], [4, 8], [8, 0]]);
    let cubic = curve([[0, 0], [0, 4], [4, 4], [4, 0]]);
    let mut text = String::new();
    for (name, curve) in [("quadratic", quadratic), ("cubic", cubic)] {
        for parts in [2, 4] {
            let t = BigRational::from_ratio(1, parts);
            text += &format!("The {name} at $t = {}$:\n\n", tex::fraction(&t));
            text += &table(&curve.triangle(t));
            text.push('\n');
        }
    }
    text
}

/// The triangle with bᵢ₋ⱼʲ in row i and column j, so that neighbours stand above each other.
fn table(triangle: &CasteljauTriangle<RationalPoint>) -> String {
    let n = triangle.degree();
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut table = row((0..=n).map(|j| format!("level {j}")).collect());
    table += &row(vec!["---".into(); n + 1]);
    for i in 0..=n {
        let cell = |j: usize| match i.checked_sub(j) {
            Some(index) => {
                let point = tex::point(triangle.point(j, index), tex::fraction);
                format!("${point}$")
            }
            None => String::new(),
        };
        table += &row((0..=n).map(cell).collect());
    }
    table
}

/// What both programs spend, counted.
fn de_casteljau_cost() -> String {
    let mut table = String::from(
        "| degree | affine combinations, in place | points in memory | calls of the recursive program |\n|--:|--:|--:|--:|\n",
    );
    for degree in [1, 2, 3, 5, 10, 20] {
        let values = (0..=degree).map(f64::from);
        let curve = BezierCurve::new(values).expect("whole numbers");
        let cost = Counted::curve(&curve).at(0.5).cost();
        let (_, calls) = recursive_at(&curve, 0.5);
        table += &format!(
            "| {degree} | {} | {} | {calls} |\n",
            cost.combinations, cost.points
        );
    }
    table
}
