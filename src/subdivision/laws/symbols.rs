//! Laws of masks, symbols and difference schemes.
//!
//! They are about exact numbers: whether (1 + z) divides a symbol cannot be told from rounded coefficients.

use num_traits::{One, Zero};

use crate::law::{Rounding, Sides};
use crate::scalar::{BigRational, OrderedScalar, Scalar};
use crate::subdivision::{LaurentPolynomial, Mask, Smoothness};

type Sequence = LaurentPolynomial<BigRational>;

fn number(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

/// `subdivision-symbol`: k steps turn p(z) into a(z)·a(z²)⋯a(z^2ᵏ⁻¹)·p(z^2ᵏ).
///
/// `implementation(mask, data)` must make one step. The other side multiplies polynomials.
pub fn symbol(
    implementation: impl Fn(&Mask<BigRational>, &Sequence) -> Sequence,
    mask: &Mask<BigRational>,
    data: &Sequence,
    steps: usize,
) -> Sides<BigRational> {
    let refined = (0..steps).fold(data.clone(), |data, _| implementation(mask, &data));
    let product = (0..steps).fold(data.stretched(1 << steps), |product, k| {
        &product * &mask.symbol().stretched(1 << k)
    });
    let lowest = |p: &Sequence| [number(p.powers().start)];
    Sides::new(format!("{mask}, data {data}, {steps} steps"))
        .equal(
            "the first index",
            lowest(&refined),
            lowest(&product),
            Rounding::none(),
        )
        .equal(
            "the coefficients of the product",
            refined.coefficients().to_vec(),
            product.coefficients().to_vec(),
            Rounding::none(),
        )
}

/// `subdivision-sum-rules`: m sum rules hold exactly if the data jʳ are refined to polynomial data of degree ≤ r for r < m.
///
/// `implementation(mask)` must tell the largest such m.
/// The new points of even index are a polynomial E of degree r, those of odd index another one O.
/// With E = O all differences of order r + 1 vanish. They are polynomials of degree ≤ r at the even places and at the
/// odd ones, so that 2(r + 1) successive ones decide.
/// That even and odd weights have the same sum is the case r = 0.
pub fn sum_rules(
    implementation: impl Fn(&Mask<BigRational>) -> usize,
    mask: &Mask<BigRational>,
) -> Sides<BigRational> {
    let rules = implementation(mask);
    let width = mask.support().end - mask.support().start;
    let differences = |degree: usize| -> Vec<BigRational> {
        let count = width + 2 * (degree as i64 + 2);
        let power = |j: i64| (0..degree).fold(number(1), |power, _| power * number(j));
        let data: Vec<BigRational> = (0..count).map(power).collect();
        let refined = mask.apply_window(0, &data);
        let mut refined = refined.map_or_else(|_| Vec::new(), |(_, refined)| refined);
        for _ in 0..=degree {
            refined = refined.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
        }
        refined
    };
    let sums = [0, 1].map(|parity| {
        let rule = mask.rule(parity).into_iter();
        rule.fold(BigRational::zero(), |sum, (_, weight)| sum + weight)
    });
    let flag = |holds: bool| [number(i64::from(holds))];
    let mut sides = Sides::new(mask).equal(
        "the first rule: even and odd weights have the same sum",
        flag(rules > 0),
        flag(sums[0] == sums[1]),
        Rounding::none(),
    );
    for degree in 0..rules {
        let differences = differences(degree);
        let zeros = vec![BigRational::zero(); differences.len()];
        sides = sides.equal(
            format!("j^{degree} goes to data of degree {degree}"),
            differences,
            zeros,
            Rounding::none(),
        );
    }
    let broken = differences(rules).iter().any(|d| !d.is_zero());
    sides.equal(
        format!("j^{rules} does not go to data of degree {rules}"),
        flag(broken),
        flag(true),
        Rounding::none(),
    )
}

/// Data whose absolute values are at most 1, with the signs that make the new number of index `r` after `steps` steps largest.
fn worst_data(scheme: &Mask<BigRational>, steps: usize, r: i64) -> Sequence {
    let symbol = scheme.steps(steps);
    let stride = 1_i64 << steps;
    let powers = symbol.powers();
    let (first, last) = (
        (r - powers.end).div_euclid(stride),
        (r - powers.start).div_euclid(stride) + 1,
    );
    let sign = |j: i64| {
        if symbol.coefficient(r - stride * j) < BigRational::zero() {
            number(-1)
        } else {
            number(1)
        }
    };
    LaurentPolynomial::new(first, (first..=last).map(sign))
}

/// The largest new number after `steps` steps over all bounded data, found by refining the worst data.
fn attained_norm(scheme: &Mask<BigRational>, steps: usize) -> BigRational {
    let attained = |r: i64| {
        let data = worst_data(scheme, steps, r);
        let refined = (0..steps).fold(data, |data, _| scheme.apply(&data));
        refined.coefficient(r)
    };
    (0..1_i64 << steps)
        .map(attained)
        .fold(BigRational::zero(), OrderedScalar::max)
}

fn largest(data: &Sequence) -> BigRational {
    data.coefficients()
        .iter()
        .map(OrderedScalar::abs)
        .fold(BigRational::zero(), OrderedScalar::max)
}

/// Δp: the sequence of the differences pᵢ − pᵢ₋₁.
fn difference(data: &Sequence) -> Sequence {
    data - &data.shifted(1)
}

/// `subdivision-difference-scheme`: ΔSₐp = S_bΔp, ‖S_bᴸ‖ is attained, and it bounds how far a polygon moves.
///
/// `scheme(mask)` must give the mask b, and `norm(b, L)` the norm of L steps.
/// `mask` must satisfy a(1) = 2 and a(−1) = 0; `data` has finitely many nonzero members.
pub fn difference_scheme(
    scheme: impl Fn(&Mask<BigRational>) -> Option<Mask<BigRational>>,
    norm: impl Fn(&Mask<BigRational>, usize) -> BigRational,
    mask: &Mask<BigRational>,
    data: &Sequence,
    steps: usize,
) -> Sides<BigRational> {
    let sides = Sides::new(format!("{mask}, data {data}, {steps} steps"));
    let Some(differences) = scheme(mask) else {
        return sides.equal(
            "there is a difference scheme",
            [],
            [number(1)],
            Rounding::none(),
        );
    };
    let refined = (0..steps).fold(data.clone(), |data, _| mask.apply(&data));
    let left = difference(&refined);
    let right = (0..steps).fold(difference(data), |data, _| differences.apply(&data));
    let bound = norm(&differences, steps);
    // The polygon fᵏ at the new parameters: the old points and the midpoints.
    let half = BigRational::from_ratio(1, 2);
    let midpoints = Mask::lane_riesenfeld(1).apply(&refined).shifted(-1);
    let moved = &mask.apply(&refined) - &midpoints;
    let displacement = mask.displacement().map_or(half, |e| e.norm(2));
    sides
        .equal(
            "the first index of the differences",
            [number(left.powers().start)],
            [number(right.powers().start)],
            Rounding::none(),
        )
        .equal(
            "the differences of the refined data are the refined differences",
            left.coefficients().to_vec(),
            right.coefficients().to_vec(),
            Rounding::none(),
        )
        .equal(
            "the norm is attained",
            [bound.clone()],
            [attained_norm(&differences, steps)],
            Rounding::none(),
        )
        .at_most(
            "the differences shrink by the norm",
            [largest(&left)],
            [bound.clone() * largest(&difference(data))],
            Rounding::none(),
        )
        .at_most(
            "the next step moves the polygon by no more than the norms say",
            [largest(&moved)],
            [displacement * bound * largest(&difference(data))],
            Rounding::none(),
        )
}

/// `subdivision-smoothness-criterion`: a(z) = 2⁻ᵏ(1 + z)ᵏ⁺¹·b(z) and ‖S_bᴸ‖ < 1, for the order k that is known.
///
/// `implementation(mask)` must prove the highest order that it can; `order` is the right one, `None` for divergence.
/// Then 2^(jk)Δᵏpʲ, j = L, arises from Δᵏp by the scheme 2ᵏa/(1 + z)ᵏ, and neighbours get closer by the norm.
pub fn smoothness_criterion(
    implementation: impl Fn(&Mask<BigRational>) -> Option<Smoothness<BigRational>>,
    mask: &Mask<BigRational>,
    order: Option<usize>,
    data: &Sequence,
) -> Sides<BigRational> {
    let code = |order: Option<usize>| [number(order.map_or(-1, |order| order as i64))];
    let proved = implementation(mask);
    let sides = Sides::new(format!("{mask}, data {data}")).equal(
        "the order that is proved, -1 for none",
        code(proved.as_ref().map(|proved| proved.order)),
        code(order),
        Rounding::none(),
    );
    let Some(proved) = proved else {
        return sides;
    };
    let (k, steps) = (proved.order, proved.contraction.steps);
    let power_of_two = |n: usize| (0..n).fold(number(1), |power, _| power * number(2));
    let product = proved.difference_scheme.symbol() * &LaurentPolynomial::one_plus_z_to(k + 1);
    let scaled = mask.symbol().scaled(&power_of_two(k));
    // 2^(jk)·Δᵏ⁺¹ of the data after j = L steps, and before.
    let refined = (0..steps).fold(data.clone(), |data, _| mask.apply(&data));
    let neighbours = |data: &Sequence| (0..=k).fold(data.clone(), |data, _| difference(&data));
    let after = neighbours(&refined).scaled(&power_of_two(steps * k));
    let norm = proved.contraction.norm.clone();
    sides
        .equal(
            "2^k·a(z) = (1 + z)^(k+1)·b(z)",
            product.coefficients().to_vec(),
            scaled.coefficients().to_vec(),
            Rounding::none(),
        )
        .equal(
            "the norm is attained",
            [norm.clone()],
            [attained_norm(&proved.difference_scheme, steps)],
            Rounding::none(),
        )
        .equal(
            "it is below 1",
            [number(i64::from(norm < BigRational::one()))],
            [number(1)],
            Rounding::none(),
        )
        .at_most(
            "neighbouring divided differences of order k get closer",
            [largest(&after)],
            [norm * largest(&neighbours(data))],
            Rounding::none(),
        )
}
