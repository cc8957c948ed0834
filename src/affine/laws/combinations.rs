//! Laws of affine combinations and barycentres.

use num_traits::{One, Zero};

use super::{indicator, largest, listed, sums};
use crate::affine::{Affine, CombinationKind, Linear, Orient, Point, Turn, Vector};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// A weighted point.
type Term<P> = (<P as Affine>::Scalar, P);

fn points<P: Affine>(terms: &[Term<P>]) -> impl Iterator<Item = &P> {
    terms.iter().map(|(_, point)| point)
}

fn weights<P: Affine>(terms: &[Term<P>]) -> impl Iterator<Item = &P::Scalar> {
    terms.iter().map(|(weight, _)| weight)
}

/// The sum of the terms, coordinate by coordinate.
fn weighted_sum<P: Affine>(terms: &[Term<P>]) -> Vec<P::Scalar> {
    let coordinate = |k: usize| {
        terms
            .iter()
            .fold(P::Scalar::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point.coordinates()[k].clone()
            })
    };
    (0..P::DIMENSION).map(coordinate).collect()
}

/// `affine-combinations`: Σ λᵢAᵢ is a point if Σ λᵢ = 1, and then it moves with the points; otherwise it is none.
/// Without negative weights it lies between the smallest and the largest coordinates.
///
/// `implementation(terms)` must give the point, or nothing if the weights do not sum to 1. The sum of the weights
/// must be free of rounding, so that there is no doubt whether it is 1.
///
/// # Rounding
///
/// n products and n sums: n + 1 roundings a term. From the first point, A₀ + Σ λᵢ(Aᵢ − A₀), a difference, a product, n
/// sums: n + 3, with terms up to (2Σ|λᵢ| + 1) times the largest coordinate. Moved points have one rounding more.
pub fn combinations<P: Affine>(
    implementation: impl Fn(&[Term<P>]) -> Option<P>,
    terms: &[Term<P>],
    shift: &P::Difference,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let (sum, magnitude) = sums(weights(terms));
    let is_affine = !terms.is_empty() && sum.is_one();
    let found = implementation(terms);
    let sides = Sides::new(format!("{}, moved by {shift:?}", listed(terms))).equal(
        "there is a point exactly if the weights sum to 1",
        [indicator(found.is_some())],
        [indicator(is_affine)],
        Rounding::none(),
    );
    let Some(point) = found.filter(|_| is_affine) else {
        return sides;
    };
    let size = largest(points(terms)) + largest([shift]);
    let rounding = Rounding::new(2 * terms.len() + 5, (2.0 * magnitude + 1.0) * size);
    let start = &terms[0].1;
    let from_start = terms.iter().fold(start.clone(), |sum, (weight, point)| {
        sum.translated(&point.difference(start).scaled(weight.clone()))
    });
    let moved: Vec<Term<P>> = terms
        .iter()
        .map(|(weight, point)| (weight.clone(), point.translated(shift)))
        .collect();
    let moved = implementation(&moved).map_or_else(Vec::new, |point| point.coordinates().to_vec());
    let sides = sides
        .equal(
            "Σ λᵢAᵢ = A₀ + Σ λᵢ(Aᵢ − A₀)",
            point.coordinates().to_vec(),
            from_start.coordinates().to_vec(),
            rounding,
        )
        .equal(
            "if all points move by v, so does the combination",
            moved,
            point.translated(shift).coordinates().to_vec(),
            rounding,
        );
    if weights(terms).any(|weight| *weight < P::Scalar::zero()) {
        return sides;
    }
    let extreme = |choose: fn(P::Scalar, P::Scalar) -> P::Scalar| {
        let coordinate = move |k: usize| {
            points(terms)
                .map(|point| point.coordinates()[k].clone())
                .reduce(choose)
                .expect("the weights sum to 1, so there is a term")
        };
        (0..P::DIMENSION).map(coordinate)
    };
    sides
        .at_most(
            "a convex combination has no coordinate below the least",
            extreme(OrderedScalar::min),
            point.coordinates().to_vec(),
            rounding,
        )
        .at_most(
            "a convex combination has no coordinate above the greatest",
            point.coordinates().to_vec(),
            extreme(OrderedScalar::max),
            rounding,
        )
}

/// `affine-line-through-two-points`: for linearly independent a and b, λa + μb lies on the line through their tips
/// exactly if λ + μ = 1, and on the segment exactly if also λ, μ ≥ 0. For dependent ones “if” remains.
///
/// `implementation(λ, μ)` must tell the kind of combination. Where a point lies is decided by the exact predicate
/// for turns, so the sums and products of the numbers given must be free of rounding.
///
/// # Rounding
///
/// None: see above.
pub fn line_through_two_points<T: Orient>(
    implementation: impl Fn(&T, &T) -> CombinationKind,
    [a, b]: [&Vector<T, 2>; 2],
    [lambda, mu]: [&T; 2],
) -> Sides<T> {
    let kind = implementation(lambda, mu);
    let origin = Point::origin();
    let tip = |v: &Vector<T, 2>| origin.clone() + v.clone();
    let combination = tip(&(a * lambda.clone() + b * mu.clone()));
    let [a, b] = [tip(a), tip(b)];
    let on_line = if a == b {
        combination == a
    } else {
        T::turn(&a, &b, &combination) == Turn::Straight
    };
    let between = |k: usize| {
        let [low, high] = [
            OrderedScalar::min(a[k].clone(), b[k].clone()),
            OrderedScalar::max(a[k].clone(), b[k].clone()),
        ];
        low <= combination[k] && combination[k] <= high
    };
    let on_segment = on_line && between(0) && between(1);
    let claimed = [
        indicator(kind >= CombinationKind::Affine),
        indicator(kind == CombinationKind::Convex),
    ];
    let true_places = [indicator(on_line), indicator(on_segment)];
    let independent = T::turn(&origin, &a, &b) != Turn::Straight;
    let sides = Sides::new(format!("a = {a}, b = {b}, λ = {lambda}, μ = {mu}"));
    let sides = if independent {
        sides.equal(
            "on the line exactly if λ + μ = 1, on the segment exactly if also λ, μ ≥ 0",
            claimed,
            true_places,
            Rounding::none(),
        )
    } else {
        sides.at_most(
            "on the line if λ + μ = 1, on the segment if also λ, μ ≥ 0",
            claimed,
            true_places,
            Rounding::none(),
        )
    };
    if kind == CombinationKind::Linear {
        return sides;
    }
    sides.equal(
        "the parameter of the point is μ",
        combination.coordinates().to_vec(),
        a.translated(&b.difference(&a).scaled(mu.clone()))
            .coordinates()
            .to_vec(),
        Rounding::none(),
    )
}

/// `affine-point-arithmetic`: seen from O and from O′ the points O + Σ αᵢ(Aᵢ − O) differ by (1 − Σαᵢ)(O′ − O),
/// and the vectors Σ αᵢ(Aᵢ − O) by −Σαᵢ·(O′ − O).
///
/// So the point is the same for all origins exactly if Σ αᵢ = 1, the vector exactly if Σ αᵢ = 0.
/// `point(origin, terms)` and `vector(origin, terms)` must give what a reader with that origin finds.
///
/// # Rounding
///
/// A term αᵢ(Aᵢ − O) passes 2 roundings, n in the sum, one more for the point; the terms are up to
/// (2Σ|αᵢ| + 1) times the largest coordinate. The difference of two of them is one more. On the right Σ αᵢ passes n,
/// then 3.
pub fn point_arithmetic<P: Affine>(
    point: impl Fn(&P, &[Term<P>]) -> P,
    vector: impl Fn(&P, &[Term<P>]) -> P::Difference,
    terms: &[Term<P>],
    [origin, other]: [&P; 2],
) -> Sides<P::Scalar> {
    let (sum, magnitude) = sums(weights(terms));
    let size = largest(points(terms).chain([origin, other]));
    let rounding = Rounding::new(2 * terms.len() + 9, (8.0 * magnitude + 6.0) * size);
    let gap = other.difference(origin);
    let missing = P::Scalar::one() - sum.clone();
    let seen: Vec<P::Scalar> = std::iter::zip(weighted_sum(terms), origin.coordinates())
        .map(|(sum, o)| sum + missing.clone() * o.clone())
        .collect();
    let difference_of_vectors = vector(other, terms).difference(&vector(origin, terms));
    Sides::new(format!("{}, O = {origin:?}, O′ = {other:?}", listed(terms)))
        .equal(
            "seen from O the point is Σ αᵢAᵢ + (1 − Σαᵢ)O",
            point(origin, terms).coordinates().to_vec(),
            seen,
            rounding,
        )
        .equal(
            "the points seen from O and O′ differ by (1 − Σαᵢ)(O′ − O)",
            point(other, terms)
                .difference(&point(origin, terms))
                .coordinates()
                .to_vec(),
            gap.scaled(missing.clone()).coordinates().to_vec(),
            rounding,
        )
        .equal(
            "the vectors seen from O and O′ differ by −Σαᵢ·(O′ − O)",
            difference_of_vectors.coordinates().to_vec(),
            gap.scaled(-sum).coordinates().to_vec(),
            rounding,
        )
        .equal(
            "the point is the origin moved by the vector",
            point(origin, terms)
                .difference(origin)
                .coordinates()
                .to_vec(),
            vector(origin, terms).coordinates().to_vec(),
            rounding,
        )
}

/// `affine-combination-from-base-point`: if Σ αᵢ = 1, then Σ αᵢAᵢ = Q + Σ αᵢ(Aᵢ − Q) for every point Q,
/// for instance Q = A₀.
///
/// `implementation(base, terms)` must give the right side. The sum of the weights must be 1 without rounding.
///
/// # Rounding
///
/// n + 1 roundings a term on the left, n + 3 on the right, with terms up to (2Σ|αᵢ| + 1) times the largest coordinate.
pub fn combination_from_base_point<P: Affine>(
    implementation: impl Fn(&P, &[Term<P>]) -> P,
    terms: &[Term<P>],
    base: &P,
) -> Sides<P::Scalar> {
    let (_, magnitude) = sums(weights(terms));
    let size = largest(points(terms).chain([base]));
    let rounding = Rounding::new(2 * terms.len() + 4, (3.0 * magnitude + 1.0) * size);
    let from = |base: &P| implementation(base, terms).coordinates().to_vec();
    Sides::new(format!("{}, Q = {base:?}", listed(terms)))
        .equal(
            "Σ αᵢAᵢ = Q + Σ αᵢ(Aᵢ − Q)",
            from(base),
            weighted_sum(terms),
            rounding,
        )
        .equal(
            "Σ αᵢAᵢ = A₀ + Σ αᵢ(Aᵢ − A₀)",
            from(&terms[0].1),
            weighted_sum(terms),
            rounding,
        )
}

/// `affine-barycentre`: the masses balance at G, Σ wᵢ(Aᵢ − G) = 0; a common factor changes nothing; more weight on one
/// point draws G towards it, G′ − G = δ/(W + δ)·(A − G). There is no barycentre if the weights sum to 0.
///
/// `implementation(masses)` must give G, or nothing. The weights, the factor and δ = `extra` must have sums and products
/// free of rounding, so that there is no doubt whether W is 0; `index` tells which weight grows by δ.
///
/// # Rounding
///
/// G = A₀ + Σ wᵢ(Aᵢ − A₀)/W passes n + 4 roundings a term. With r = Σ|wᵢ|/|W| its terms are at most 2r + 1 times the
/// largest coordinate M, so that |G| ≤ (2r + 1)·M and its error is at most γₙ₊₄·(2r + 1)·M; after the change likewise
/// with r′. In the claims these are multiplied by at most S = Σ|wᵢ| + |δ|, and the claims themselves pass n + 4.
pub fn barycentre<P: Affine>(
    implementation: impl Fn(&[Term<P>]) -> Option<P>,
    masses: &[Term<P>],
    factor: &P::Scalar,
    (index, extra): (usize, &P::Scalar),
) -> Sides<P::Scalar> {
    let (total, magnitude) = sums(weights(masses));
    let found = implementation(masses);
    let sides = Sides::new(format!(
        "{}, factor {factor}, δ = {extra} for point {index}",
        listed(masses)
    ))
    .equal(
        "there is a barycentre exactly if the weights do not sum to 0",
        [indicator(found.is_some())],
        [indicator(!total.is_zero())],
        Rounding::none(),
    );
    let Some(centre) = found.filter(|_| !total.is_zero()) else {
        return sides;
    };
    let changed = |change: &dyn Fn(usize, &P::Scalar) -> P::Scalar| -> Vec<Term<P>> {
        let term = |(i, (weight, point)): (usize, &Term<P>)| (change(i, weight), point.clone());
        masses.iter().enumerate().map(term).collect()
    };
    let size = largest(points(masses));
    let new_total = total.clone() + extra.clone();
    let all = magnitude + extra.magnitude();
    let far = 2.0 * magnitude / total.magnitude() + 1.0;
    let new_far = 2.0 * all / new_total.magnitude() + 1.0;
    let roundings = 2 * masses.len() + 8;
    let balance = masses.iter().fold(
        P::Difference::from_fn(|_| P::Scalar::zero()),
        |sum, (weight, point)| sum.translated(&point.difference(&centre).scaled(weight.clone())),
    );
    let sides = sides.equal(
        "Σ wᵢ(Aᵢ − G) = 0",
        balance.coordinates().to_vec(),
        vec![P::Scalar::zero(); P::DIMENSION],
        Rounding::new(roundings, magnitude * 2.0 * (1.0 + far) * size),
    );
    let sides = if factor.is_zero() {
        sides
    } else {
        let scaled = implementation(&changed(&|_, weight| weight.clone() * factor.clone()));
        sides.equal(
            "multiplying all weights by one factor changes nothing",
            scaled.map_or_else(Vec::new, |point| point.coordinates().to_vec()),
            centre.coordinates().to_vec(),
            Rounding::new(roundings, 2.0 * far * size),
        )
    };
    if new_total.is_zero() {
        return sides;
    }
    let heavier = changed(&|i, weight| {
        if i == index {
            weight.clone() + extra.clone()
        } else {
            weight.clone()
        }
    });
    let moved = implementation(&heavier).map_or_else(Vec::new, |point| {
        let way = point.difference(&centre).scaled(new_total.clone());
        way.coordinates().to_vec()
    });
    sides.equal(
        "(W + δ)(G′ − G) = δ(A − G)",
        moved,
        masses[index]
            .1
            .difference(&centre)
            .scaled(extra.clone())
            .coordinates()
            .to_vec(),
        Rounding::new(roundings, all * 2.0 * (1.0 + far + new_far) * size),
    )
}
