//! Laws of the algorithm of de Casteljau.

use num_traits::One;

use super::{flat, magnitude};
use crate::affine::{Affine, Point};
use crate::bezier::{BezierCurve, CasteljauTriangle, Counted};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-de-casteljau`: bᵢ⁰ = bᵢ and bᵢʲ = (1 − t)·bᵢʲ⁻¹ + t·bᵢ₊₁ʲ⁻¹, column by column.
///
/// `implementation(curve, u)` must give the whole scheme.
///
/// # Rounding
///
/// The right side is computed from the columns of the left, so the sides differ by one step only:
/// two products, a sum and 1 − t, on each side.
pub fn de_casteljau<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> CasteljauTriangle<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let triangle = implementation(curve, u.clone());
    let t = curve.domain().local(u.clone());
    let s = P::Scalar::one() - t.clone();
    let rounding = Rounding::new(6, 2.0 * magnitude(curve, &u));
    let mut sides = Sides::new(format!("u = {u}, {curve}")).equal(
        "the first column holds the control points",
        flat(triangle.column(0)),
        flat(curve.control_points()),
        Rounding::none(),
    );
    for level in 1..=curve.degree() {
        let expected = triangle.column(level - 1).windows(2).flat_map(|pair| {
            let (upper, lower) = (pair[0].coordinates(), pair[1].coordinates());
            std::iter::zip(upper.to_vec(), lower.to_vec())
                .map(|(upper, lower)| s.clone() * upper + t.clone() * lower)
                .collect::<Vec<_>>()
        });
        sides = sides.equal(
            format!("column {level} combines its neighbours with weights 1 − t and t"),
            flat(triangle.column(level)),
            expected,
            rounding,
        );
    }
    sides
}

/// `bezier-de-casteljau-examples`: a quadratic and a cubic at t = 1/2 and t = 1/4, worked by hand.
///
/// `implementation(curve, u)` must give the whole scheme. The tables on the right were computed with
/// pencil and paper; nothing else in the chapter is.
///
/// # Rounding
///
/// None: all numbers are small multiples of 1/16, and `f64` computes with them exactly.
pub fn de_casteljau_examples<T: Scalar>(
    implementation: impl Fn(&BezierCurve<Point<T, 2>>, T) -> CasteljauTriangle<Point<T, 2>>,
) -> Sides<T> {
    let quadratic: &[[i64; 2]] = &[[0, 0], [4, 8], [8, 0]];
    let cubic: &[[i64; 2]] = &[[0, 0], [0, 4], [4, 4], [4, 0]];
    // Points of the columns 1, 2, …, all numbers in units of 1/8, for t = 1/2 and t = 1/4.
    type Pairs<'a> = &'a [[i64; 2]];
    let tables: [(Pairs, i64, Pairs); 4] = [
        (quadratic, 2, &[[16, 32], [48, 32], [32, 32]]),
        (quadratic, 4, &[[8, 16], [40, 48], [16, 24]]),
        (
            cubic,
            2,
            &[[0, 16], [16, 32], [32, 16], [8, 24], [24, 24], [16, 24]],
        ),
        (
            cubic,
            4,
            &[[0, 8], [8, 32], [32, 24], [2, 14], [14, 30], [5, 18]],
        ),
    ];
    let mut sides = Sides::new("the worked examples");
    for (polygon, parts, table) in tables {
        let points = |list: Pairs, unit: i64| -> Vec<Point<T, 2>> {
            let point = |&pair: &[i64; 2]| Point::new(pair.map(|x| T::from_ratio(x, unit)));
            list.iter().map(point).collect()
        };
        let curve = BezierCurve::trusted(crate::affine::Interval::unit(), points(polygon, 1));
        let triangle = implementation(&curve, T::from_ratio(1, parts));
        sides = sides.equal(
            format!("degree {}, t = 1/{parts}", curve.degree()),
            flat(triangle.columns().skip(1).flatten()),
            flat(&points(table, 8)),
            Rounding::none(),
        );
    }
    sides
}

/// `bezier-de-casteljau-cost`: n(n + 1)/2 combinations in the memory of n + 1 points; 2ⁿ⁺¹ − 1 calls by recursion.
///
/// `implementation(curve, u)` must give the point b(u); what it spends is counted by the points
/// themselves. Beside the n + 1 points that it works on, there may be one that has just been computed.
/// `recursive(curve, u)` must give the same point by the recursion as it is written, and how many
/// calls that took.
///
/// # Rounding
///
/// None: both programs do the same operations on the same numbers.
pub fn de_casteljau_cost<P: Affine<Scalar: OrderedScalar>>(
    implementation: impl Fn(&BezierCurve<Counted<P>>, P::Scalar) -> Counted<P>,
    recursive: impl Fn(&BezierCurve<P>, P::Scalar) -> (P, u64),
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree() as i64;
    let point = implementation(&Counted::curve(curve), u.clone());
    let cost = point.cost();
    let (same_point, calls) = recursive(curve, u.clone());
    let number = |count: i64| [P::Scalar::from_integer(count)];
    Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "n(n + 1)/2 affine combinations",
            number(cost.combinations as i64),
            number(n * (n + 1) / 2),
            Rounding::none(),
        )
        .at_most(
            "memory for n + 1 points and a new one",
            number(cost.points as i64),
            number(n + 2),
            Rounding::none(),
        )
        .equal(
            "2ⁿ⁺¹ − 1 calls of the recursive program",
            number(calls as i64),
            number(2_i64.pow(n as u32 + 1) - 1),
            Rounding::none(),
        )
        .equal(
            "both programs find the same point",
            point.coordinates().to_vec(),
            same_point.coordinates().to_vec(),
            Rounding::none(),
        )
}
