//! Mistakes with affine combinations and barycentres.

use cagd::affine::{Affine, CombinationKind, Linear, barycentre};
use cagd::scalar::{OrderedScalar, Scalar};
use num_traits::{One, Zero};

type Term<P> = (<P as Affine>::Scalar, P);

fn weighted_sum<P: Affine>(terms: &[Term<P>]) -> P {
    P::from_fn(|k| {
        terms
            .iter()
            .fold(P::Scalar::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point.coordinates()[k].clone()
            })
    })
}

fn total<P: Affine>(terms: &[Term<P>]) -> P::Scalar {
    terms
        .iter()
        .fold(P::Scalar::zero(), |sum, (weight, _)| sum + weight.clone())
}

// ── combinations ──

/// Adds coordinates, whatever the weights sum to.
pub fn weights_unchecked<P: Affine>(terms: &[Term<P>]) -> Option<P> {
    Some(weighted_sum(terms))
}

/// Divides weights by their sum instead of refusing them.
pub fn weights_normalised<P: Affine>(terms: &[Term<P>]) -> Option<P> {
    barycentre(terms).ok()
}

/// Leaves out the last term.
pub fn last_term_dropped<P: Affine>(terms: &[Term<P>]) -> Option<P> {
    let point = weighted_sum(&terms[..terms.len() - 1]);
    total(terms).is_one().then_some(point)
}

/// Believes that an affine combination must not have negative weights.
pub fn negative_weights_refused<P: Affine<Scalar: OrderedScalar>>(terms: &[Term<P>]) -> Option<P> {
    let negative = terms.iter().any(|(weight, _)| *weight < P::Scalar::zero());
    (total(terms).is_one() && !negative).then(|| weighted_sum(terms))
}

/// Gives the first point all the weight that is missing.
pub fn first_takes_the_rest<P: Affine>(terms: &[Term<P>]) -> Option<P> {
    let mut terms = terms.to_vec();
    let missing = P::Scalar::one() - total(&terms);
    terms[0].0 += missing;
    Some(weighted_sum(&terms))
}

// ── the line through two points ──

/// Asks for weights that are not negative and forgets their sum.
pub fn signs_alone<T: OrderedScalar>(lambda: &T, mu: &T) -> CombinationKind {
    if *lambda >= T::zero() && *mu >= T::zero() {
        CombinationKind::Convex
    } else {
        CombinationKind::of(&[lambda.clone(), mu.clone()])
    }
}

/// Takes the segment for the line, as the Compendium writes it.
pub fn segment_for_line<T: OrderedScalar>(lambda: &T, mu: &T) -> CombinationKind {
    match CombinationKind::of(&[lambda.clone(), mu.clone()]) {
        CombinationKind::Affine => CombinationKind::Linear,
        kind => kind,
    }
}

/// Accepts every sum up to 1.
pub fn sum_at_most_one<T: OrderedScalar>(lambda: &T, mu: &T) -> CombinationKind {
    if lambda.clone() + mu.clone() <= T::one() {
        CombinationKind::of(&[lambda.clone(), T::one() - lambda.clone()])
    } else {
        CombinationKind::Linear
    }
}

// ── point arithmetic ──

/// Adds coordinates, as if every reader had the same origin.
pub fn origin_ignored<P: Affine>(_: &P, terms: &[Term<P>]) -> P {
    weighted_sum(terms)
}

/// Takes the vectors from the reader's origin, but puts them to the origin of the coordinates.
pub fn origin_not_added<P: Affine>(origin: &P, terms: &[Term<P>]) -> P {
    terms
        .iter()
        .fold(P::from_fn(|_| P::Scalar::zero()), |sum, (weight, point)| {
            sum.translated(&point.difference(origin).scaled(weight.clone()))
        })
}

/// Adds coordinates of points as if they were vectors.
pub fn points_taken_for_vectors<P: Affine>(_: &P, terms: &[Term<P>]) -> P::Difference {
    let sum = weighted_sum(terms);
    P::Difference::from_fn(|k| sum.coordinates()[k].clone())
}

// ── from a base point ──

/// Sums to one bound too few, as with the two bounds m and n of the class notes.
pub fn last_vector_left_out<P: Affine>(base: &P, terms: &[Term<P>]) -> P {
    terms[..terms.len() - 1]
        .iter()
        .fold(base.clone(), |sum, (weight, point)| {
            sum.translated(&point.difference(base).scaled(weight.clone()))
        })
}

/// Begins at Q, but takes the vectors from A₀.
pub fn vectors_from_the_first<P: Affine>(base: &P, terms: &[Term<P>]) -> P {
    terms.iter().fold(base.clone(), |sum, (weight, point)| {
        sum.translated(&point.difference(&terms[0].1).scaled(weight.clone()))
    })
}

// ── barycentres ──

/// Forgets to divide by the sum of the weights.
pub fn not_divided<P: Affine>(masses: &[Term<P>]) -> Option<P> {
    (!total(masses).is_zero()).then(|| weighted_sum(masses))
}

/// Divides by the number of points.
pub fn divided_by_the_count<P: Affine>(masses: &[Term<P>]) -> Option<P> {
    let count = P::Scalar::from_integer(masses.len() as i64);
    let sum = weighted_sum(masses);
    (!total(masses).is_zero()).then(|| P::from_fn(|k| sum.coordinates()[k].clone() / count.clone()))
}

/// Gives all points the same weight.
pub fn weights_forgotten<P: Affine>(masses: &[Term<P>]) -> Option<P> {
    let one = |(_, point): &Term<P>| (P::Scalar::one(), point.clone());
    let equal: Vec<Term<P>> = masses.iter().map(one).collect();
    (!total(masses).is_zero()).then(|| barycentre(&equal).expect("finite points"))
}

/// Takes weights without their signs.
pub fn signs_forgotten<P: Affine<Scalar: OrderedScalar>>(masses: &[Term<P>]) -> Option<P> {
    let positive = |(weight, point): &Term<P>| (OrderedScalar::abs(weight), point.clone());
    let masses: Vec<Term<P>> = masses.iter().map(positive).collect();
    barycentre(&masses).ok()
}

/// Gives the first point where there is no barycentre.
pub fn first_point_without_weight<P: Affine>(masses: &[Term<P>]) -> Option<P> {
    barycentre(masses)
        .ok()
        .or_else(|| Some(masses[0].1.clone()))
}
