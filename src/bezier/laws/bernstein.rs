//! Laws of the Bernstein polynomials.

use num_traits::pow;

use crate::affine::Interval;
use crate::bezier::{BernsteinMaximum, bernstein_on, binomial};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-binomial-coefficients`: C(n, k)·k!·(n − k)! = n! for 0 ≤ k ≤ n, C(n, k) = 0 otherwise, and
/// C(n, k) = C(n − 1, k − 1) + C(n − 1, k) for n ≥ 1 and every k.
///
/// `implementation(n, k)` must give C(n, k).
///
/// # Rounding
///
/// A computed coefficient passes at most n roundings (two for each of at most n/2 steps), and so do
/// the products of n factors. The first claim multiplies a coefficient by n numbers and compares with
/// a product of n: 3n. The second has a coefficient on one side, two and a sum on the other: 2n + 1.
pub fn binomial_coefficients<T: Scalar>(
    implementation: impl Fn(usize, i64) -> T,
    n: usize,
    k: i64,
) -> Sides<T> {
    let product = |last: i64| (1..=last).fold(T::one(), |product, j| product * T::from_integer(j));
    let value = implementation(n, k);
    let mut sides = Sides::new(format!("n = {n}, k = {k}"));
    if 0 <= k && k <= n as i64 {
        let whole = product(n as i64);
        sides = sides.equal(
            "C(n, k)·k!·(n − k)! = n!",
            [value.clone() * product(k) * product(n as i64 - k)],
            [whole.clone()],
            Rounding::new(3 * n + 1, whole.magnitude()),
        );
    } else {
        sides = sides.equal(
            "C(n, k) = 0 outside 0 ≤ k ≤ n",
            [value.clone()],
            [T::zero()],
            Rounding::none(),
        );
    }
    if n >= 1 {
        sides = sides.equal(
            "C(n, k) = C(n − 1, k − 1) + C(n − 1, k)",
            [value],
            [implementation(n - 1, k - 1) + implementation(n - 1, k)],
            Rounding::new(2 * n + 1, libm::exp2(n as f64)),
        );
    }
    sides
}

/// `bezier-bernstein-polynomials`: Bᵢⁿ(u; [a, b]) = C(n, i)·(u − a)ⁱ·(b − u)ⁿ⁻ⁱ/(b − a)ⁿ for 0 ≤ i ≤ n, and 0 otherwise.
///
/// `implementation(n, i, interval, u)` must give Bᵢⁿ(u; [a, b]).
///
/// # Rounding
///
/// Let t be the local parameter and σ = |t| + |1 − t|. The implementation works with a t that passes 3
/// roundings, and with 1 − t, whose error is thus at most 4σ·u; so each of its n factors has an error of
/// at most 4σ·u, and n factors, multiplied, one of 4n·σⁿ·u. With 3n + 1 for its own operations and 4n + 1
/// for the right side (n differences, n products, n for the coefficient, n for (b − a)ⁿ, a quotient), 11n + 2.
pub fn bernstein_polynomials<T: Scalar>(
    implementation: impl Fn(usize, i64, &Interval<T>, T) -> T,
    n: usize,
    i: i64,
    interval: &Interval<T>,
    u: T,
) -> Sides<T> {
    let value = implementation(n, i, interval, u.clone());
    let expected = match usize::try_from(i) {
        Ok(index) if index <= n => {
            let from_start = u.clone() - interval.start();
            let to_end = interval.end() - u.clone();
            binomial::<T>(n, i) * pow(from_start, index) * pow(to_end, n - index)
                / pow(interval.length(), n)
        }
        _ => T::zero(),
    };
    let t = interval.local(u.clone());
    Sides::new(format!("B_{i}^{n} at u = {u}")).equal(
        "B is C(n, i)·(u − a)ⁱ·(b − u)ⁿ⁻ⁱ/(b − a)ⁿ, or 0",
        [value],
        [expected],
        Rounding::new(11 * n + 2, spread(&t, n)),
    )
}

/// `bezier-bernstein-special-values`: Bᵢⁿ(0) = δᵢ₀, Bᵢⁿ(1) = δᵢₙ, B₀ⁿ(t) = (1 − t)ⁿ, Bₙⁿ(t) = tⁿ, and
/// Bᵢⁿ = 0 for i < 0 and i > n.
///
/// `implementation(n, i, t)` must give Bᵢⁿ(t).
///
/// # Rounding
///
/// At the ends the values are exact. A power passes 2n roundings with that of 1 − t, and the
/// implementation 3n + 1.
pub fn bernstein_special_values<T: Scalar>(
    implementation: impl Fn(usize, i64, T) -> T,
    n: usize,
    t: T,
) -> Sides<T> {
    let last = n as i64;
    let indices = || -2..=last + 2;
    let delta = |i: i64, j: i64| if i == j { T::one() } else { T::zero() };
    let at = |t: T| indices().map(move |i| (i, t.clone()));
    let rounding = Rounding::new(5 * n + 1, spread(&t, n));
    Sides::new(format!("n = {n}, t = {t}"))
        .equal(
            "at 0 only that of index 0 is 1",
            at(T::zero()).map(|(i, t)| implementation(n, i, t)),
            indices().map(|i| delta(i, 0)),
            Rounding::none(),
        )
        .equal(
            "at 1 only that of index n is 1",
            at(T::one()).map(|(i, t)| implementation(n, i, t)),
            indices().map(|i| delta(i, last)),
            Rounding::none(),
        )
        .equal(
            "B₀ⁿ = (1 − t)ⁿ",
            [implementation(n, 0, t.clone())],
            [pow(T::one() - t.clone(), n)],
            rounding,
        )
        .equal(
            "Bₙⁿ = tⁿ",
            [implementation(n, last, t.clone())],
            [pow(t.clone(), n)],
            rounding,
        )
        .equal(
            "0 beyond the ends of the index",
            [-2, -1, last + 1, last + 2].map(|i| implementation(n, i, t.clone())),
            [T::zero(), T::zero(), T::zero(), T::zero()],
            Rounding::none(),
        )
}

/// `bezier-bernstein-recursion`: Bₗʲ(t) = (1 − t)·Bₗʲ⁻¹(t) + t·Bₗ₋₁ʲ⁻¹(t) for j ≥ 1 and every l, with B₀⁰ = 1.
///
/// `implementation(j, l, t)` must give Bₗʲ(t). With the start, the recursion determines it.
///
/// # Rounding
///
/// 3j + 1 on the left; on the right 3(j − 1) + 1 and three more: together 6j + 2.
pub fn bernstein_recursion<T: Scalar>(
    implementation: impl Fn(usize, i64, T) -> T,
    j: usize,
    l: i64,
    t: T,
) -> Sides<T> {
    let value = implementation(j, l, t.clone());
    let sides = Sides::new(format!("j = {j}, l = {l}, t = {t}"));
    let Some(lower) = j.checked_sub(1) else {
        let start = if l == 0 { T::one() } else { T::zero() };
        return sides.equal(
            "the start: B₀⁰ = 1, the others 0",
            [value],
            [start],
            Rounding::none(),
        );
    };
    let s = T::one() - t.clone();
    let combined = s * implementation(lower, l, t.clone())
        + t.clone() * implementation(lower, l - 1, t.clone());
    sides.equal(
        "B combines its two predecessors with weights 1 − t and t",
        [value],
        [combined],
        Rounding::new(6 * j + 2, spread(&t, j)),
    )
}

/// `bezier-partition-of-unity`: ΣBᵢⁿ(t) = 1 for every t.
///
/// `implementation(n, t)` must give the n + 1 values.
///
/// # Rounding
///
/// 3n + 1 for each value and n for the sum.
pub fn partition_of_unity<T: Scalar>(
    implementation: impl Fn(usize, T) -> Vec<T>,
    n: usize,
    t: T,
) -> Sides<T> {
    let values = implementation(n, t.clone());
    let count = T::from_integer(values.len() as i64);
    Sides::new(format!("n = {n}, t = {t}"))
        .equal(
            "there are n + 1 values",
            [count],
            [T::from_integer(n as i64 + 1)],
            Rounding::none(),
        )
        .equal(
            "they sum to 1",
            [values.into_iter().fold(T::zero(), |sum, value| sum + value)],
            [T::one()],
            Rounding::new(4 * n + 1, spread(&t, n)),
        )
}

/// `bezier-nonnegativity`: for t in [0, 1], Bᵢⁿ(t) ≥ min(t, 1 − t)ⁿ, so it is at least 0, and positive inside.
/// For t < 0 and n ≥ 1, B₁ⁿ(t) ≤ n·t < 0; for t > 1, Bₙ₋₁ⁿ(t) ≤ n·(1 − t) < 0.
///
/// `implementation(n, i, t)` must give Bᵢⁿ(t).
///
/// # Rounding
///
/// 3n + 1 for the value, 2n for the power.
pub fn nonnegativity<T: OrderedScalar>(
    implementation: impl Fn(usize, i64, T) -> T,
    n: usize,
    t: T,
) -> Sides<T> {
    let s = T::one() - t.clone();
    let rounding = Rounding::new(5 * n + 1, spread(&t, n));
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let factor = T::from_integer(n as i64);
    if t < T::zero() && n >= 1 {
        sides.at_most(
            "to the left of 0, B₁ⁿ is at most n·t",
            [implementation(n, 1, t.clone())],
            [factor * t],
            rounding,
        )
    } else if t > T::one() && n >= 1 {
        sides.at_most(
            "to the right of 1, Bₙ₋₁ⁿ is at most n·(1 − t)",
            [implementation(n, n as i64 - 1, t)],
            [factor * s],
            rounding,
        )
    } else if n == 0 {
        sides.equal(
            "B₀⁰ = 1",
            [implementation(0, 0, t)],
            [T::one()],
            Rounding::none(),
        )
    } else {
        let values: Vec<T> = (0..=n)
            .map(|i| implementation(n, i as i64, t.clone()))
            .collect();
        let smallest = pow(t.clone().min(s), n);
        // Products of numbers that are not negative: no rounding makes them negative.
        sides
            .at_most(
                "no value is negative",
                vec![T::zero(); n + 1],
                values.clone(),
                Rounding::none(),
            )
            .at_most(
                "each value is at least min(t, 1 − t)ⁿ",
                vec![smallest.clone(); n + 1],
                values,
                Rounding::new(5 * n + 1, smallest.magnitude()),
            )
    }
}

/// `bezier-bernstein-symmetry`: Bᵢᵐ(a + h; [a, b]) = Bₘ₋ᵢᵐ(b − h; [a, b]).
///
/// `implementation(m, i, interval, u)` must give Bᵢᵐ(u; [a, b]).
///
/// # Rounding
///
/// Let τ = h/(b − a), σ = |τ| + |1 − τ| and c = (|a| + |b|)/|b − a|. The parameters a + h and b − h and
/// their maps to [0, 1] have errors of at most (c + 5σ)·u, and so have the n factors of each side: 2n times
/// (c + 5)·σⁿ in total, as σ ≥ 1. With 3n + 1 for the operations of each side: 16n + 2 roundings of (1 + c)·σⁿ.
pub fn bernstein_symmetry<T: Scalar>(
    implementation: impl Fn(usize, i64, &Interval<T>, T) -> T,
    m: usize,
    i: i64,
    interval: &Interval<T>,
    h: T,
) -> Sides<T> {
    let (a, b) = (interval.start(), interval.end());
    let size = 1.0 + (a.magnitude() + b.magnitude()) / interval.length().magnitude();
    let local = h.clone() / interval.length();
    Sides::new(format!("m = {m}, i = {i}, h = {h}, on [{a}, {b}]")).equal(
        "Bᵢ at the distance h from a is Bₘ₋ᵢ at the distance h from b",
        [implementation(m, i, interval, a + h.clone())],
        [implementation(m, m as i64 - i, interval, b - h)],
        Rounding::new(16 * m + 2, size * spread(&local, m)),
    )
}

/// `bezier-unimodal`: for m ≥ 1 the one maximum of Bᵢᵐ on [a, b] is at a + (b − a)·i/m, its value is
/// C(m, i)·iⁱ·(m − i)ᵐ⁻ⁱ/mᵐ, and Bᵢᵐ increases before and decreases after.
///
/// `implementation(m, i, interval)` must give place and value. The law compares the polynomial at the
/// ends, at the place and at `parameters`, which lie in the interval (in any order), a < b.
///
/// # Rounding
///
/// Two products, a sum, a quotient and 1 − i/m for the place, of numbers up to max(|a|, |b|).
/// For the values as in [`bernstein_symmetry`]: the parameters are exact, the local parameter and the
/// place i/m have errors of at most (c + 5)·u, twice.
pub fn unimodal<T: OrderedScalar>(
    implementation: impl Fn(usize, usize, &Interval<T>) -> BernsteinMaximum<T>,
    m: usize,
    i: usize,
    interval: &Interval<T>,
    parameters: &[T],
) -> Sides<T> {
    let (a, b) = (interval.start(), interval.end());
    let ends = a.magnitude() + b.magnitude();
    let maximum = implementation(m, i, interval);
    let index = T::from_integer(i as i64);
    let rest = T::from_integer((m - i) as i64);
    let degree = T::from_integer(m as i64);
    let value = binomial::<T>(m, i as i64)
        * pow(index.clone() / degree.clone(), i)
        * pow(rest / degree.clone(), m - i);
    let size = 1.0 + ends / interval.length().magnitude();
    let rounding = Rounding::new(16 * m + 2, size);

    let mut ascending: Vec<T> = parameters.to_vec();
    ascending.extend([a.clone(), b.clone(), maximum.place.clone()]);
    ascending.sort_by(|x, y| x.partial_cmp(y).expect("parameters are comparable"));
    let at = |u: &T| bernstein_on(m, i as i64, interval, u.clone());
    let (before, after): (Vec<&[T]>, Vec<&[T]>) = ascending
        .windows(2)
        .partition(|pair| pair[1] <= maximum.place);
    Sides::new(format!("B_{i}^{m} on [{a}, {b}]"))
        .equal(
            "the place is a + (b − a)·i/m",
            [maximum.place.clone()],
            [a.clone() + (b - a) * index / degree],
            Rounding::new(10, 2.0 * ends),
        )
        .equal(
            "the value is C(m, i)·(i/m)ⁱ·((m − i)/m)ᵐ⁻ⁱ",
            [maximum.value.clone()],
            [value],
            Rounding::new(7 * m + 2, 1.0),
        )
        .at_most(
            "B increases up to the place",
            before.iter().map(|pair| at(&pair[0])),
            before.iter().map(|pair| at(&pair[1])),
            rounding,
        )
        .at_most(
            "B decreases after the place",
            after.iter().map(|pair| at(&pair[1])),
            after.iter().map(|pair| at(&pair[0])),
            rounding,
        )
        .at_most(
            "no value exceeds the maximum",
            ascending.iter().map(at),
            vec![maximum.value; ascending.len()],
            rounding,
        )
}

/// `bezier-bernstein-properties`: all properties of the Bernstein polynomials at once.
///
/// The values represent every power, tᵏ = Σᵢ C(i, k)/C(n, k)·Bᵢⁿ(t) (for k = 0 the partition of unity);
/// they follow from those of degree n − 1 by the recursion; those at 1 − t are the same in reverse order; at 0 and 1
/// all but one vanish; on [0, 1] none is negative; and for n ≥ 1 none exceeds its value at i/n.
///
/// `implementation(n, t)` must give the n + 1 values.
///
/// # Rounding
///
/// 3n + 1 for a value; 2n + 1 for a weight, a product and n for the sum; 2n for a power: 8n + 3. Symmetry: as in
/// [`bernstein_symmetry`] on [0, 1], where the parameter 1 − t has one rounding and 1 − (1 − t) two: 2·(3n + 1) + 2n.
pub fn bernstein_properties<T: OrderedScalar>(
    implementation: impl Fn(usize, T) -> Vec<T>,
    n: usize,
    t: T,
) -> Sides<T> {
    let s = T::one() - t.clone();
    let values = implementation(n, t.clone());
    let rounding = Rounding::new(8 * n + 3, spread(&t, n));
    let mut sides = Sides::new(format!("n = {n}, t = {t}"));
    for k in 0..=n {
        let terms = values
            .iter()
            .enumerate()
            .map(|(i, value)| binomial::<T>(i, k as i64) / binomial(n, k as i64) * value.clone());
        sides = sides.equal(
            format!("basis: the power of exponent {k} is represented"),
            [terms.fold(T::zero(), |sum, term| sum + term)],
            [pow(t.clone(), k)],
            rounding,
        );
    }
    if n >= 1 {
        let lower = implementation(n - 1, t.clone());
        let lower_at = |i: usize| lower.get(i).cloned().unwrap_or_else(T::zero);
        let combined = (0..=n).map(|i| {
            let previous = i.checked_sub(1).map_or_else(T::zero, lower_at);
            s.clone() * lower_at(i) + t.clone() * previous
        });
        sides = sides.equal("recursion", values.clone(), combined, rounding);
        let largest = (0..=n).map(|i| {
            let at_place = implementation(n, T::from_ratio(i as i64, n as i64));
            at_place.into_iter().nth(i).unwrap_or_else(T::zero)
        });
        if T::zero() <= t && t <= T::one() {
            sides = sides
                .at_most(
                    "maximum at i/n",
                    values.clone(),
                    largest,
                    Rounding::new(8 * n + 3, 1.0),
                )
                .at_most(
                    "not negative",
                    vec![T::zero(); n + 1],
                    values.clone(),
                    Rounding::none(),
                );
        }
    }
    let unit = |one: usize| (0..=n).map(move |i| T::from_integer(i64::from(i == one)));
    sides
        .equal(
            "symmetry",
            values.iter().rev().cloned(),
            implementation(n, s),
            Rounding::new(8 * n + 2, spread(&t, n)),
        )
        .equal(
            "start",
            implementation(n, T::zero()),
            unit(0),
            Rounding::none(),
        )
        .equal(
            "end",
            implementation(n, T::one()),
            unit(n),
            Rounding::none(),
        )
}

/// (|t| + |1 − t|)ⁿ, what the absolute values of the Bernstein polynomials sum to.
fn spread<T: Scalar>(t: &T, n: usize) -> f64 {
    let s = T::one() - t.clone();
    (t.magnitude() + s.magnitude()).powi(n as i32)
}
