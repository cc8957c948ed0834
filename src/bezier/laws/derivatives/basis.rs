//! Laws of the derivatives of Bernstein polynomials.

use super::{basis_magnitude, leibniz};
use crate::affine::Interval;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-bernstein-derivative`: d/dt Bᵢⁿ(t) = n·(Bᵢ₋₁ⁿ⁻¹(t) − Bᵢⁿ⁻¹(t)).
///
/// `implementation(n, i, t)` must give the right side, also for i < 0 and i > n; the left side is
/// computed by the product rule.
///
/// # Rounding
///
/// A term of the right side passes 3n − 2 roundings in its Bernstein polynomial, a difference and a
/// product; one of the left side 3n + 10 (see the module). A derivative by dual numbers passes 2 for each product of a
/// power and is allowed for: together at most 9n + 12.
pub fn bernstein_derivative<T: Scalar>(
    implementation: impl Fn(usize, i64, T) -> T,
    n: usize,
    i: i64,
    t: T,
) -> Sides<T> {
    let magnitude = basis_magnitude(&Interval::unit(), n, 1, &t);
    Sides::new(format!("n = {n}, i = {i}, t = {t}")).equal(
        "the derivative by the product rule is n times the difference of two neighbours",
        [leibniz(n, i, 1, &t)],
        [implementation(n, i, t)],
        Rounding::new(9 * n + 12, magnitude),
    )
}

/// `bezier-bernstein-higher-derivative`:
/// dᵖ/duᵖ Bᵢᵐ(u; [a, b]) = m!/(m − p)!/(b − a)ᵖ · Σⱼ (−1)ᵖ⁻ʲ·C(p, j)·Bᵢ₋ⱼᵐ⁻ᵖ(u; [a, b]).
///
/// `implementation(domain, m, i, p, u)` must give the right side; the left side is computed by Leibniz's rule.
///
/// # Rounding
///
/// A term of the right side passes 3(m − p) + 1 roundings in its Bernstein polynomial, one with the
/// binomial coefficient, p in the sum, 3p + 1 in the factor; one of the left side 3m + 4p + 6.
/// Together at most 6m + 5p + 10.
pub fn bernstein_higher_derivative<T: Scalar>(
    implementation: impl Fn(&Interval<T>, usize, i64, usize, T) -> T,
    domain: &Interval<T>,
    m: usize,
    i: i64,
    p: usize,
    u: T,
) -> Sides<T> {
    let magnitude = basis_magnitude(domain, m, p, &u);
    let t = domain.local(u.clone());
    let scale = num_traits::pow(domain.length(), p);
    Sides::new(format!(
        "m = {m}, i = {i}, p = {p}, u = {u} on [{}, {}]",
        domain.start(),
        domain.end()
    ))
    .equal(
        "the p-th derivative by Leibniz's rule is the alternating sum of lower polynomials",
        [leibniz(m, i, p, &t) / scale],
        [implementation(domain, m, i, p, u)],
        Rounding::new(6 * m + 5 * p + 10, magnitude),
    )
}
