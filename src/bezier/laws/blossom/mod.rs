//! Laws of blossoms and of curves over arbitrary intervals.
//!
//! # Rounding
//!
//! The local parameter t = (x − a)/(b − a) passes three roundings, so it has a relative error of 3u.
//! The weights 1 − t and t of a step then miss their exact values by at most 3u|t| + u|1 − t| and
//! 3u|t|, together at most 7u·L with L = |t| + |1 − t|. With a product and a sum that makes 9
//! roundings a level of de Casteljau's scheme, of terms bounded by L times those of the level before.
//! A Bernstein polynomial at a local parameter passes 7 for the same reason in each of its n
//! factors, and 3n + 1 more of its own; a sum of n + 1 products with points adds 1 + n. That is
//! 11n + 2.

mod interval;

pub use interval::*;

use num_traits::{One, Zero};

use super::{largest_coordinate, magnitude};
use crate::affine::{Affine, Interval};
use crate::bezier::{BezierCurve, BlossomTriangle, elementary_symmetric};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// Roundings of a level of de Casteljau's scheme; see the head of this file.
const LEVEL: usize = 9;

/// Roundings of a curve point that is a sum of Bernstein polynomials.
fn bernstein_roundings(n: usize) -> usize {
    11 * n + 2
}

/// Σᵢ Bᵢⁿ(t)·bᵢ, coordinate by coordinate.
fn bernstein_sum<P: Affine>(points: &[P], t: &P::Scalar) -> Vec<P::Scalar> {
    let weights = bernstein_row(points.len() - 1, t);
    weighted_sum(std::iter::zip(weights, points))
}

/// B₀ⁿ(t), …, Bₙⁿ(t) from the powers of t and of 1 − t.
fn bernstein_row<T: Scalar>(degree: usize, t: &T) -> Vec<T> {
    let (rising, falling) = (powers(degree, t), powers(degree, &(T::one() - t.clone())));
    std::iter::zip(rising, falling.into_iter().rev())
        .zip(binomials::<T>(degree))
        .map(|((rising, falling), binomial)| binomial * (rising * falling))
        .collect()
}

/// 1, x, …, xⁿ.
fn powers<T: Scalar>(degree: usize, x: &T) -> Vec<T> {
    let all = std::iter::successors(Some(T::one()), |power| Some(power.clone() * x.clone()));
    all.take(degree + 1).collect()
}

/// C(n, 0), …, C(n, n), each from the one before; every partial product is C(n, k) times a small whole number.
fn binomials<T: Scalar>(n: usize) -> Vec<T> {
    let next = |(k, binomial): &(usize, T)| {
        let raised = binomial.clone() * T::from_integer((n - k) as i64);
        (k + 1, raised / T::from_integer(*k as i64 + 1))
    };
    let all = std::iter::successors(Some((0, T::one())), |last| Some(next(last)));
    all.take(n + 1).map(|(_, binomial)| binomial).collect()
}

fn weighted_sum<'p, P: Affine>(terms: impl Iterator<Item = (P::Scalar, &'p P)>) -> Vec<P::Scalar> {
    let mut sum = vec![P::Scalar::zero(); P::DIMENSION];
    for (weight, point) in terms {
        for (total, coordinate) in sum.iter_mut().zip(point.coordinates()) {
            *total += weight.clone() * coordinate.clone();
        }
    }
    sum
}

/// |t| + |1 − t|, by which a step of de Casteljau can enlarge coordinates.
fn spread<T: Scalar>(t: &T) -> f64 {
    t.magnitude() + (T::one() - t.clone()).magnitude()
}

fn show<T: Scalar>(arguments: &[T]) -> String {
    let arguments: Vec<String> = arguments.iter().map(ToString::to_string).collect();
    format!("({})", arguments.join(", "))
}

/// `bezier-blossom`: symmetric, affine in every argument, and the curve on the diagonal.
///
/// `implementation(curve, arguments)` must give the blossom of the curve at n arguments.
/// It is asked for the value at the arguments in the given `order`; at arguments of which the first in
/// that order is replaced by (1 − λ)·x + λ·`other`; and at `other` n times, where it must agree with
/// the curve as a sum of Bernstein polynomials.
///
/// # Rounding
///
/// A value passes 9n roundings. The replaced argument itself is rounded three times, which moves its
/// local parameter by 3u·G, G = (|1 − λ||x| + |λ||other|)/|b − a|; that adds 2G to the bound of its level.
pub fn blossom<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, &[P::Scalar]) -> P,
    curve: &BezierCurve<P>,
    arguments: &[P::Scalar],
    order: &[usize],
    other: P::Scalar,
    lambda: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let largest = largest_coordinate(curve.control_points());
    let value = |arguments: &[P::Scalar]| implementation(curve, arguments).coordinates().to_vec();
    let sides = Sides::new(format!(
        "arguments {}, order {order:?}, other {other}, λ = {lambda}, {curve}",
        show(arguments)
    ))
    .equal(
        "the curve on the diagonal",
        value(&vec![other.clone(); n]),
        bernstein_sum(curve.control_points(), &domain.local(other.clone())),
        Rounding::new(LEVEL * n + bernstein_roundings(n), magnitude(curve, &other)),
    );
    let Some(&first) = order.first() else {
        return sides;
    };
    let permuted: Vec<P::Scalar> = order.iter().map(|&k| arguments[k].clone()).collect();
    let bound = |arguments: &[P::Scalar]| {
        let spreads = arguments.iter().map(|x| spread(&domain.local(x.clone())));
        largest * spreads.product::<f64>()
    };
    let at = value(arguments);
    let sides = sides.equal(
        "symmetric",
        value(&permuted),
        at.clone(),
        Rounding::new(2 * LEVEL * n, bound(arguments)),
    );

    let with_first = |x: P::Scalar| {
        let mut changed = arguments.to_vec();
        changed[first] = x;
        changed
    };
    let x = arguments[first].clone();
    let rest = P::Scalar::one() - lambda.clone();
    let between = rest.clone() * x.clone() + lambda.clone() * other.clone();
    let moved = with_first(other.clone());
    let global = (rest.magnitude() * x.magnitude() + lambda.magnitude() * other.magnitude())
        / domain.length().magnitude();
    let others: f64 = (0..n)
        .filter(|&k| k != first)
        .map(|k| spread(&domain.local(arguments[k].clone())))
        .product();
    let terms = rest.magnitude() * bound(arguments)
        + lambda.magnitude() * bound(&moved)
        + largest * others * 2.0 * global;
    let combination = std::iter::zip(at, value(&moved))
        .map(|(start, end)| rest.clone() * start + lambda.clone() * end)
        .collect::<Vec<_>>();
    sides.equal(
        format!("affine in argument {first}"),
        value(&with_first(between)),
        combination,
        Rounding::new(2 * LEVEL * n + 3, terms),
    )
}

/// `bezier-blossom-existence`: the blossom of Σ aₖtᵏ is Σ aₖ·eₖ(t₁, …, tₙ)/C(n, k).
///
/// `implementation(curve, arguments)` must give the blossom at n arguments, for instance by de
/// Casteljau's scheme. The right side goes through the monomials: aₖ = C(n, k)·Δᵏb₀, so it is Σ Δᵏb₀·eₖ.
/// Since there is only one blossom, both agree.
///
/// # Rounding
///
/// Δᵏb₀ is a sum of k + 1 products (n + 1); eₖ takes 2n roundings and 3n for its local parameters; a
/// product and n sums follow: 7n + 2.
/// The terms are at most max|bᵢ|·Σ 2ᵏeₖ(|t₁|, …, |tₙ|) = max|bᵢ|·Π(1 + 2|tⱼ|).
pub fn blossom_existence<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, &[P::Scalar]) -> P,
    curve: &BezierCurve<P>,
    arguments: &[P::Scalar],
) -> Sides<P::Scalar> {
    let (right, rounding) = blossom_from_powers(curve, arguments);
    Sides::new(format!("arguments {}, {curve}", show(arguments))).equal(
        "de Casteljau with different arguments, and elementary symmetric polynomials",
        implementation(curve, arguments).coordinates().to_vec(),
        right,
        rounding,
    )
}

/// The blossom through the monomials, and what it and de Casteljau's scheme may be apart.
fn blossom_from_powers<P: Affine>(
    curve: &BezierCurve<P>,
    arguments: &[P::Scalar],
) -> (Vec<P::Scalar>, Rounding) {
    let n = curve.degree();
    let local: Vec<P::Scalar> = arguments
        .iter()
        .map(|x| curve.domain().local(x.clone()))
        .collect();
    let mut value = vec![P::Scalar::zero(); P::DIMENSION];
    for (k, symmetric) in elementary_symmetric(&local).into_iter().enumerate() {
        let weights = difference_weights::<P::Scalar>(k);
        let difference = weighted_sum(std::iter::zip(weights, curve.control_points()));
        for (total, coordinate) in value.iter_mut().zip(difference) {
            *total += symmetric.clone() * coordinate;
        }
    }
    let growth: f64 = local.iter().map(|t| 1.0 + 2.0 * t.magnitude()).product();
    let magnitude = largest_coordinate(curve.control_points()) * growth;
    (value, Rounding::new((7 + LEVEL) * n + 2, magnitude))
}

/// The coefficients (−1)ᵖ⁻ᵏ·C(p, k) of Δᵖb₀ = Σₖ (−1)ᵖ⁻ᵏ·C(p, k)·bₖ.
fn difference_weights<T: Scalar>(order: usize) -> Vec<T> {
    binomials::<T>(order)
        .into_iter()
        .enumerate()
        .map(|(k, binomial)| {
            if (order - k) % 2 == 1 {
                -binomial
            } else {
                binomial
            }
        })
        .collect()
}

/// `bezier-blossom-exercise`: the blossoms of X, X² and X⁴ with 1, 2 and 4 arguments.
///
/// `implementation(k, arguments)` must give the blossom of the power Xᵏ as a polynomial of degree at most
/// `arguments.len()`.
///
/// # Rounding
///
/// On the left at most 2·4 + 1 for eₖ and the quotient, on the right at most 8 sums and products and a
/// quotient; all terms together are at most Π(1 + |xⱼ|).
pub fn blossom_exercise<T: Scalar>(
    implementation: impl Fn(usize, &[T]) -> T,
    arguments: &[T; 4],
) -> Sides<T> {
    let [x1, x2, x3, x4] = arguments.clone();
    let magnitude = arguments.iter().map(|x| 1.0 + x.magnitude()).product();
    let rounding = Rounding::new(18, magnitude);
    let quotient = |sum: T, count| sum / T::from_integer(count);
    let pairs = x1.clone() * (x2.clone() + x3.clone() + x4.clone())
        + x2.clone() * (x3.clone() + x4.clone())
        + x3.clone() * x4.clone();
    let claims = [
        ("X, n = 1", 1, 1, x1.clone()),
        ("X, n = 2", 1, 2, quotient(x1.clone() + x2.clone(), 2)),
        ("X², n = 2", 2, 2, x1.clone() * x2.clone()),
        (
            "X, n = 4",
            1,
            4,
            quotient(x1.clone() + x2.clone() + x3.clone() + x4.clone(), 4),
        ),
        ("X², n = 4", 2, 4, quotient(pairs, 6)),
        ("X⁴, n = 4", 4, 4, x1 * x2 * x3 * x4),
    ];
    claims.into_iter().fold(
        Sides::new(format!("arguments {}", show(arguments))),
        |sides, (name, power, count, expected)| {
            let found = implementation(power, &arguments[..count]);
            sides.equal(name, [found], [expected], rounding)
        },
    )
}

/// `bezier-blossom-control-points`: the control points over [c, d] are the values p(c, …, c, d, …, d).
///
/// `implementation(curve, arguments)` must give the blossom at n arguments. Three things are claimed:
/// over the domain [a, b] of the curve the values p(a, …, a, b, …, b) are its control points; over
/// `interval` = [c, d] they are control points of the same polynomial, which is compared at `u`; and the
/// points bᵢʲ(u) of de Casteljau, computed as Bernstein sums of degree j, are p(a, …, a, b, …, b, u, …, u).
///
/// # Rounding
///
/// At a and b the local parameters are exactly 0 and 1, so the first claim is exact. On the second, 9n
/// for the values and 11n + 2 for either sum, of terms at most max|bᵢ|·(L_s·max(L_c, L_d))ⁿ, where s is the
/// parameter in [c, d]. On the third, 9n and 11n + 2.
pub fn blossom_control_points<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, &[P::Scalar]) -> P,
    curve: &BezierCurve<P>,
    interval: &Interval<P::Scalar>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let (a, b) = (domain.start(), domain.end());
    let values_on = |c: P::Scalar, d: P::Scalar| -> Vec<P> {
        (0..=n)
            .map(|i| implementation(curve, &repeated([(&c, n - i), (&d, i)])))
            .collect()
    };
    let t = domain.local(u.clone());
    let values = values_on(interval.start(), interval.end());
    let widest = f64::max(
        spread(&domain.local(interval.start())),
        spread(&domain.local(interval.end())),
    );
    let s = interval.local(u.clone());
    let largest = largest_coordinate(curve.control_points());
    let terms = largest * (spread(&s) * widest).powi(n as i32);
    let mut sides = Sides::new(format!(
        "[c, d] = [{}, {}], u = {u}, {curve}",
        interval.start(),
        interval.end()
    ))
    .equal(
        "the control points over the domain",
        super::flat(&values_on(a.clone(), b.clone())),
        super::flat(curve.control_points()),
        Rounding::none(),
    )
    .equal(
        "the control points over [c, d] give the same polynomial",
        bernstein_sum(&values, &s),
        bernstein_sum(curve.control_points(), &t),
        Rounding::new(LEVEL * n + 2 * bernstein_roundings(n), terms),
    );
    for j in 0..=n {
        let found = (0..=n - j).flat_map(|i| {
            let arguments = repeated([(&a, n - j - i), (&b, i), (&u, j)]);
            implementation(curve, &arguments).coordinates().to_vec()
        });
        let expected = curve
            .control_points()
            .windows(j + 1)
            .flat_map(|points| bernstein_sum(points, &t));
        sides = sides.equal(
            format!("the intermediate points of level {j}"),
            found.collect::<Vec<_>>(),
            expected.collect::<Vec<_>>(),
            Rounding::new(LEVEL * n + bernstein_roundings(n), magnitude(curve, &u)),
        );
    }
    sides
}

/// Arguments, each repeated as often as it says.
fn repeated<T: Scalar, const K: usize>(arguments: [(&T, usize); K]) -> Vec<T> {
    arguments
        .into_iter()
        .flat_map(|(argument, times)| std::iter::repeat_n(argument.clone(), times))
        .collect()
}

/// `bezier-blossom-de-casteljau`: every point of the scheme is the blossom value that its label says, and
/// the sides of the triangle are control points over [a, u] and [u, b].
///
/// `implementation(curve, u)` must give the labelled triangle. The labels are evaluated through the
/// monomials. The sides are compared with the curve at `v`, as sums of Bernstein polynomials; where u is a or b, one
/// of the two intervals is a point and its side is left out.
///
/// # Rounding
///
/// The labels as in [`blossom_existence`]. For the sides 9n for the triangle and 11n + 2 for either sum, of
/// terms at most max|bᵢ|·(L_s·L_t)ⁿ.
pub fn blossom_de_casteljau<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> BlossomTriangle<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
    v: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let triangle = implementation(curve, u.clone());
    let mut sides = Sides::new(format!("u = {u}, v = {v}, {curve}"));
    for level in 0..=n {
        for (index, entry) in triangle.column(level).enumerate() {
            let arguments = repeated([
                (&domain.start(), entry.starts),
                (&u, entry.parameters),
                (&domain.end(), entry.ends),
            ]);
            let (expected, rounding) = blossom_from_powers(curve, &arguments);
            sides = sides.equal(
                format!(
                    "{} in level {level}, row {index}",
                    entry.label(["a", "u", "b"])
                ),
                entry.point.coordinates().to_vec(),
                expected,
                rounding,
            );
        }
    }
    let points = triangle.points();
    let left: Vec<P> = points.left_side().cloned().collect();
    let right: Vec<P> = points.right_side().cloned().collect();
    let pieces = [
        (
            "the left side",
            Interval::new(domain.start(), u.clone()),
            left,
        ),
        (
            "the right side",
            Interval::new(u.clone(), domain.end()),
            right,
        ),
    ];
    let t = domain.local(v.clone());
    let largest = largest_coordinate(curve.control_points());
    for (name, interval, points) in pieces {
        let Ok(interval) = interval else { continue };
        let s = interval.local(v.clone());
        let growth = spread(&s) * spread(&domain.local(u.clone()));
        sides = sides.equal(
            format!("{name} has the same curve"),
            bernstein_sum(&points, &s),
            bernstein_sum(curve.control_points(), &t),
            Rounding::new(
                LEVEL * n + 2 * bernstein_roundings(n),
                largest * growth.powi(n as i32),
            ),
        );
    }
    sides
}
