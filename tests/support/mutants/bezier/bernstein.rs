//! Wrong binomial coefficients and Bernstein polynomials.

use cagd::affine::Interval;
use cagd::bezier::{BernsteinMaximum, bernstein, bernstein_basis, binomial};
use cagd::scalar::Scalar;
use num_traits::pow;

/// C(n, k) with the missing cases filled by C(n, −k): a lower index below 0 is not 0.
pub fn binomial_even<T: Scalar>(n: usize, k: i64) -> T {
    binomial(n, k.abs())
}

/// C(n, k) without the division by k!.
pub fn arrangements<T: Scalar>(n: usize, k: i64) -> T {
    let n = n as i64;
    if k < 0 || k > n {
        return T::zero();
    }
    (n - k + 1..=n).fold(T::one(), |product, j| product * T::from_integer(j))
}

/// C(n + 1, k): off by one in the upper index.
pub fn binomial_of_next<T: Scalar>(n: usize, k: i64) -> T {
    if k > n as i64 {
        T::zero()
    } else {
        binomial(n + 1, k)
    }
}

/// tⁱ(1 − t)ⁿ⁻ⁱ without the binomial coefficient.
pub fn no_binomial<T: Scalar>(n: usize, i: i64, t: T) -> T {
    with_coefficient(n, i, t, |_, _| T::one())
}

/// The binomial coefficient of the next degree.
pub fn wrong_binomial<T: Scalar>(n: usize, i: i64, t: T) -> T {
    with_coefficient(n, i, t, |n, i| binomial(n + 1, i))
}

/// t and 1 − t swapped: the polynomial of the reversed index.
pub fn reversed<T: Scalar>(n: usize, i: i64, t: T) -> T {
    bernstein(n, n as i64 - i, t)
}

/// B₀ⁿ = 1 for every n, as the notes have it.
pub fn first_is_one<T: Scalar>(n: usize, i: i64, t: T) -> T {
    if i == 0 { T::one() } else { bernstein(n, i, t) }
}

/// An index beyond the ends is taken as the nearest end.
pub fn index_clamped<T: Scalar>(n: usize, i: i64, t: T) -> T {
    bernstein(n, i.clamp(0, n as i64), t)
}

/// The polynomial changes its sign with i.
pub fn alternating<T: Scalar>(n: usize, i: i64, t: T) -> T {
    let value = bernstein(n, i, t);
    if i % 2 == 0 { value } else { -value }
}

/// The absolute value: right on [0, 1], and not negative outside.
pub fn absolute<T: cagd::scalar::OrderedScalar>(n: usize, i: i64, t: T) -> T {
    bernstein(n, i, t).abs()
}

/// The product in its textbook order, C(n, i) first: beyond the range of `f64` for high degrees.
pub fn coefficient_first<T: Scalar>(n: usize, i: i64, t: T) -> T {
    with_coefficient(n, i, t, binomial)
}

/// Over an interval, without division by its length.
pub fn not_normalised<T: Scalar>(n: usize, i: i64, interval: &Interval<T>, u: T) -> T {
    bernstein(n, i, u - interval.start())
}

/// Over an interval, with the parameter of the unit interval.
pub fn interval_forgotten<T: Scalar>(n: usize, i: i64, _: &Interval<T>, u: T) -> T {
    bernstein(n, i, u)
}

/// Over an interval, measured from its end.
pub fn from_the_end<T: Scalar>(n: usize, i: i64, interval: &Interval<T>, u: T) -> T {
    bernstein(n, i, T::one() - interval.local(u))
}

/// The last polynomial is left out.
pub fn last_missing<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let mut values = bernstein_basis(n, t);
    values.pop();
    values
}

/// tⁱ(1 − t)ⁿ⁻ⁱ for all i.
pub fn all_without_binomial<T: Scalar>(n: usize, t: T) -> Vec<T> {
    (0..=n)
        .map(|i| no_binomial(n, i as i64, t.clone()))
        .collect()
}

/// All values in reverse order.
pub fn all_reversed<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let mut values = bernstein_basis(n, t);
    values.reverse();
    values
}

/// Forces a sum of 1 by dividing tⁱ(1 − t)ⁿ⁻ⁱ by its sum: another partition of unity.
pub fn normalised<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let values = all_without_binomial(n, t);
    let sum = values
        .iter()
        .fold(T::zero(), |sum, value| sum + value.clone());
    values
        .into_iter()
        .map(|value| value / sum.clone())
        .collect()
}

/// Place and value exchanged, as on the slides: the place a + (b − a)·i/m is given as the maximum.
pub fn place_as_value<T: Scalar>(
    m: usize,
    i: usize,
    interval: &Interval<T>,
) -> BernsteinMaximum<T> {
    let place = interval.global(T::from_ratio(i as i64, m as i64));
    BernsteinMaximum {
        place: place.clone(),
        value: place,
    }
}

/// The place i/(m + 1), as if there were m + 2 polynomials.
pub fn place_off_by_one<T: Scalar>(
    m: usize,
    i: usize,
    interval: &Interval<T>,
) -> BernsteinMaximum<T> {
    let t = T::from_ratio(i as i64, m as i64 + 1);
    BernsteinMaximum {
        place: interval.global(t.clone()),
        value: bernstein(m, i as i64, t),
    }
}

/// The place on the unit interval, whatever the interval is.
pub fn place_on_unit_interval<T: Scalar>(
    m: usize,
    i: usize,
    _: &Interval<T>,
) -> BernsteinMaximum<T> {
    let t = T::from_ratio(i as i64, m as i64);
    BernsteinMaximum {
        place: t.clone(),
        value: bernstein(m, i as i64, t),
    }
}

fn with_coefficient<T: Scalar>(n: usize, i: i64, t: T, coefficient: impl Fn(usize, i64) -> T) -> T {
    match usize::try_from(i) {
        Ok(index) if index <= n => {
            let s = T::one() - t.clone();
            coefficient(n, i) * pow(t, index) * pow(s, n - index)
        }
        _ => T::zero(),
    }
}
