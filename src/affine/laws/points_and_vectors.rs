//! Laws of points and vectors.

use num_traits::Zero;

use super::largest;
use crate::affine::Affine;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `affine-space`: P + 0 = P, (P + u) + v = P + (u + v), and v = Q − P is the only vector with Q = P + v.
///
/// `translate(point, vector)` must give the point moved by the vector, `difference(end, start)` the vector from
/// `start` to `end`. That a vector is the only one is claimed as (P + v) − P = v.
///
/// # Rounding
///
/// Adding 0 rounds nothing. The sides of the second claim pass 2 roundings each, with terms P, u, v.
/// P + (Q − P) and (P + v) − P pass 2, with P twice among the terms.
pub fn space<P: Affine>(
    translate: impl Fn(&P, &P::Difference) -> P,
    difference: impl Fn(&P, &P) -> P::Difference,
    [p, q]: [&P; 2],
    [u, v]: [&P::Difference; 2],
) -> Sides<P::Scalar> {
    let zero = P::Difference::from_fn(|_| P::Scalar::zero());
    let coordinates = |point: &P| point.coordinates().to_vec();
    let rounding = Rounding::new(4, 2.0 * largest([p, q]) + largest([u, v]) * 2.0);
    Sides::new(format!("P = {p:?}, Q = {q:?}, u = {u:?}, v = {v:?}"))
        .equal(
            "P + 0 = P",
            coordinates(&translate(p, &zero)),
            coordinates(p),
            Rounding::none(),
        )
        .equal(
            "(P + u) + v = P + (u + v)",
            coordinates(&translate(&translate(p, u), v)),
            coordinates(&translate(p, &u.translated(v))),
            rounding,
        )
        .equal(
            "P + (Q − P) = Q",
            coordinates(&translate(p, &difference(q, p))),
            coordinates(q),
            rounding,
        )
        .equal(
            "(P + v) − P = v",
            difference(&translate(p, v), p).coordinates().to_vec(),
            v.coordinates().to_vec(),
            rounding,
        )
}

/// `affine-points-versus-vectors`: a translation moves every point by v and leaves every vector as it is,
/// and “λP” depends on the origin.
///
/// `multiple(origin, factor, point)` must give the point that a reader with this origin finds for “λP”;
/// readers with the origins O and O′ differ by (1 − λ)(O′ − O).
///
/// # Rounding
///
/// Each multiple passes 3 roundings, with terms O, λP and λO; their difference is one more. On the right 1 − λ, the
/// difference and the product are 3. All terms together are at most (4 + 4|λ|) times the largest coordinate.
pub fn points_versus_vectors<P: Affine>(
    multiple: impl Fn(&P, &P::Scalar, &P) -> P,
    [origin, other]: [&P; 2],
    factor: &P::Scalar,
    point: &P,
) -> Sides<P::Scalar> {
    let size = largest([origin, other, point]);
    let rounding = Rounding::new(8, (4.0 + 4.0 * factor.magnitude()) * size);
    let [here, there] = [origin, other].map(|origin| multiple(origin, factor, point));
    let gap = |k: usize| {
        let one = P::Scalar::from_integer(1);
        (one - factor.clone()) * (other.coordinates()[k].clone() - origin.coordinates()[k].clone())
    };
    let from_coordinates = |k: usize| {
        let o = origin.coordinates()[k].clone();
        o.clone() * (P::Scalar::from_integer(1) - factor.clone())
            + point.coordinates()[k].clone() * factor.clone()
    };
    Sides::new(format!(
        "O = {origin:?}, O′ = {other:?}, λ = {factor}, P = {point:?}"
    ))
    .equal(
        "the multiple seen from O is (1 − λ)O + λP",
        here.coordinates().to_vec(),
        (0..P::DIMENSION).map(from_coordinates),
        rounding,
    )
    .equal(
        "the multiples seen from O and O′ differ by (1 − λ)(O′ − O)",
        there.difference(&here).coordinates().to_vec(),
        (0..P::DIMENSION).map(gap),
        rounding,
    )
}
