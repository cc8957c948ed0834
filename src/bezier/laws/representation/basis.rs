//! The change between Bernstein polynomials and powers.

use nalgebra::DMatrix;
use num_traits::{One, Zero, pow};

use super::weighted_sum;
use crate::affine::{Affine, Interval};
use crate::bezier::laws::{flat, largest_coordinate};
use crate::bezier::{
    BezierCurve, MonomialCurve, bernstein_basis as all_values, binomial, elementary_symmetric,
};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-polynomial-space`: a polynomial of degree at most n is given by n + 1 coefficients, and its values at
/// 0, 1, …, n determine them; so 1, t, …, tⁿ are linearly independent, and the dimension is n + 1.
///
/// `implementation(coefficients, t)` must give Σ coefficientₖ·tᵏ. The law finds the coefficients
/// from its values: a_k* = Δᵏf(0)/k! are the coefficients in the basis of the products
/// t(t − 1)⋯(t − k + 1), and these are multiplied out.
///
/// # Rounding
///
/// With A = Σ|aₖ|, a value is a sum of terms up to A·nⁿ with 2n roundings, and a difference of order k one of 2ᵏ
/// values with k more. The coefficients of t(t − 1)⋯(t − k + 1)/k! have absolute sum 1 and pass 3k
/// roundings. With a product and n sums, 7n + 1 roundings of 2A·(2n)ⁿ.
pub fn polynomial_space<T: Scalar>(
    implementation: impl Fn(&[T], T) -> T,
    coefficients: &[T],
) -> Sides<T> {
    let count = coefficients.len();
    let n = count.saturating_sub(1);
    let mut differences: Vec<T> = (0..count)
        .map(|t| implementation(coefficients, T::from_integer(t as i64)))
        .collect();
    let mut found = vec![T::zero(); count];
    // The coefficients of t(t − 1)⋯(t − k + 1)/k!.
    let mut product = vec![T::one()];
    for k in 0..count {
        for (total, coefficient) in found.iter_mut().zip(&product) {
            *total += coefficient.clone() * differences[0].clone();
        }
        let shift = T::from_integer(k as i64);
        let divisor = T::from_integer(k as i64 + 1);
        product = (0..=k + 1)
            .map(|power| {
                let raised = power
                    .checked_sub(1)
                    .map_or_else(T::zero, |p| product[p].clone());
                let kept = product.get(power).cloned().unwrap_or_else(T::zero);
                (raised - shift.clone() * kept) / divisor.clone()
            })
            .collect();
        differences = differences
            .windows(2)
            .map(|pair| pair[1].clone() - pair[0].clone())
            .collect();
    }
    let size: f64 = coefficients.iter().map(Scalar::magnitude).sum();
    Sides::new(format!("{n} = degree")).equal(
        "the values at 0, 1, …, n give the coefficients back",
        found,
        coefficients.iter().cloned(),
        Rounding::new(
            7 * n + 1,
            2.0 * size * (2.0 * n.max(1) as f64).powi(n as i32),
        ),
    )
}

/// `bezier-bernstein-basis`: C(n, k)·tᵏ = Σᵢ C(i, k)·Bᵢⁿ(t), and the two changes of basis are inverse to each other.
///
/// `implementation(n)` must give the pair of matrices: to monomials (column i holds the
/// coefficients of Bᵢⁿ, the highest power first) and back.
///
/// # Rounding
///
/// A control value of tᵏ is a quotient of two binomial coefficients of n roundings each, 2n + 1, and at
/// most 1. Σᵢ Bᵢⁿ·cᵢ: 3n + 1 more for Bᵢⁿ, a product and n for the sum; 2n for the power.
/// A monomial coefficient is a product of two binomial coefficients, 2n + 1 roundings. The terms of Bᵢⁿ sum to
/// C(n, i)·|t|ⁱ·(1 + |t|)ⁿ⁻ⁱ ≤ (1 + 2|t|)ⁿ, those of an entry of the product to at most C(n, k)·2ᵏ ≤ 3ⁿ.
pub fn bernstein_basis<T: Scalar>(
    implementation: impl Fn(usize) -> (DMatrix<T>, DMatrix<T>),
    n: usize,
    t: T,
) -> Sides<T> {
    let (to_monomials, from_monomials) = implementation(n);
    let values = all_values(n, t.clone());
    let s = T::one() - t.clone();
    let size = (t.magnitude() + s.magnitude()).powi(n as i32);
    let powers: Vec<T> = (0..=n).map(|row| pow(t.clone(), n - row)).collect();
    let identity = DMatrix::<T>::identity(n + 1, n + 1);
    let product = to_monomials.clone() * from_monomials.clone();
    let sum = |column: usize, matrix: &DMatrix<T>, terms: &[T]| {
        matrix
            .column(column)
            .iter()
            .zip(terms)
            .fold(T::zero(), |sum, (entry, term)| {
                sum + entry.clone() * term.clone()
            })
    };
    Sides::new(format!("n = {n}, t = {t}"))
        .equal(
            "the powers are sums of Bernstein polynomials",
            (0..=n).map(|column| sum(column, &from_monomials, &values)),
            powers.iter().cloned(),
            Rounding::new(8 * n + 3, size),
        )
        .equal(
            "the Bernstein polynomials are sums of powers",
            (0..=n).map(|column| sum(column, &to_monomials, &powers)),
            values.iter().cloned(),
            Rounding::new(8 * n + 3, (1.0 + 2.0 * t.magnitude()).powi(n as i32)),
        )
        .equal(
            "one change undoes the other",
            product.iter().cloned(),
            identity.iter().cloned(),
            Rounding::new(5 * n + 3, 3_f64.powi(n as i32)),
        )
}
/// `bezier-every-polynomial-curve`: a polynomial curve f of degree at most n is, over every interval, a
/// Bézier curve of formal degree n, with the only possible control points.
///
/// `implementation(f, interval)` must give the Bézier curve.
/// The control points are compared with the polar form of f, another route:
/// with c and d the ends of the interval in the local parameter of f,
/// bᵢ = Σₖ eₖ(c, …, c, d, …, d)/C(n, k)·aₖ, where the elementary symmetric polynomial eₖ takes n − i times c and i times d.
///
/// # Rounding
///
/// Let t be the local parameter of u, σ = |t| + |1 − t| and F = σⁿ·Σ|aₖ|·(|c| + |d − c|)ᵏ: all terms of f(u), of the
/// control points, and of these times their Bernstein polynomials sum to at most F.
/// Each of c, d, t and the local parameter of f passes 3 roundings and d − c one more; they move both sides by
/// at most 16n roundings of F. Horner's scheme passes 2n, shift and stretch of the coefficients 3n + 1,
/// the control points 6n + 2, de Casteljau 3n: 30n + 3. The polar form passes 2n for eₖ and 2n + 2 for
/// quotient, product and sum, less than what the control points leave.
pub fn every_polynomial_curve<P: Affine>(
    implementation: impl Fn(&MonomialCurve<P>, Interval<P::Scalar>) -> BezierCurve<P>,
    form: &MonomialCurve<P>,
    interval: Interval<P::Scalar>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let curve = implementation(form, interval.clone());
    let n = form.degree();
    let c = form.domain().local(interval.start());
    let d = form.domain().local(interval.end());
    let coefficients = || {
        let vectors = form.coefficients().iter().map(Affine::coordinates);
        std::iter::once(form.start().coordinates()).chain(vectors)
    };
    let reach = c.magnitude() + (d.clone() - c.clone()).magnitude();
    let terms: f64 = coefficients()
        .enumerate()
        .map(|(k, coordinates)| {
            let largest = coordinates
                .iter()
                .map(Scalar::magnitude)
                .fold(0.0, f64::max);
            largest * reach.powi(k as i32)
        })
        .sum();
    let t = interval.local(u.clone());
    let spread = (t.magnitude() + (P::Scalar::one() - t).magnitude()).powi(n as i32);
    let rounding = Rounding::new(30 * n + 3, spread * terms);
    let polar = (0..=n).flat_map(|i| {
        let mut arguments = vec![c.clone(); n - i];
        arguments.resize(n, d.clone());
        let symmetric = elementary_symmetric(&arguments);
        (0..P::DIMENSION)
            .map(|axis| {
                coefficients().zip(&symmetric).enumerate().fold(
                    P::Scalar::zero(),
                    |sum, (k, (coordinates, e))| {
                        sum + e.clone() / binomial(n, k as i64) * coordinates[axis].clone()
                    },
                )
            })
            .collect::<Vec<_>>()
    });
    Sides::new(format!(
        "u = {u}, on [{}, {}], {form:?}",
        interval.start(),
        interval.end()
    ))
    .equal(
        "the Bézier curve is the polynomial curve",
        flat([&curve.at(u.clone())]),
        flat([&form.at(u)]),
        rounding,
    )
    .equal(
        "its control points are the values of the polar form",
        flat(curve.control_points()),
        polar,
        rounding,
    )
}

/// The monomial form of a Bézier curve has the same points and leads back to the same control points.
///
/// `implementation(curve)` must give the monomial form over the same domain.
///
/// # Rounding
///
/// A coefficient C(n, k)·Δᵏb₀ passes n roundings for the differences, n for C(n, k) and a product; Horner's
/// scheme 2n, de Casteljau 3n: 7n + 1. The terms sum to at most (1 + 2|t|)ⁿ·max|bᵢ|. The way back passes 6n + 2 with
/// terms up to 3ⁿ·max|bᵢ|: 8n + 3.
pub fn monomial_form<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> MonomialCurve<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let form = implementation(curve);
    let n = curve.degree();
    let t = curve.domain().local(u.clone());
    let largest = largest_coordinate(curve.control_points());
    let size = largest * (1.0 + 2.0 * t.magnitude()).powi(n as i32);
    let sides = Sides::new(format!("u = {u}, {curve}")).equal(
        "the points are the same",
        flat([&form.at(u.clone())]),
        flat([&curve.at(u)]),
        Rounding::new(7 * n + 1, size),
    );
    // A form that is out of range has no control points to compare.
    let back = BezierCurve::from_monomial(&form);
    sides.equal(
        "the way back gives the control points",
        back.map(|back| flat(back.control_points()))
            .unwrap_or_default(),
        flat(curve.control_points()),
        Rounding::new(8 * n + 3, largest * 3_f64.powi(n as i32)),
    )
}

/// `bezier-cubic-matrix-form`: b(t) = (tⁿ, …, t, 1)·M·(b₀, …, bₙ)ᵀ; for n = 3 the rows of M are
/// (−1, 3, −3, 1), (3, −6, 3, 0), (−3, 3, 0, 0), (1, 0, 0, 0), those of its inverse (0, 0, 0, 1),
/// (0, 0, 1/3, 1), (0, 1/3, 2/3, 1), (1, 1, 1, 1).
///
/// `implementation(n)` must give M.
///
/// # Rounding
///
/// An entry of M passes 2n + 1, a power n, the two products 2 and their sums 2n; de Casteljau 3n: 8n + 3.
/// The terms sum to at most (1 + 2|t|)ⁿ·max|bᵢ|.
pub fn cubic_matrix_form<P: Affine>(
    implementation: impl Fn(usize) -> DMatrix<P::Scalar>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let matrix = implementation(n);
    let t = curve.domain().local(u.clone());
    let powers: Vec<P::Scalar> = (0..=n).map(|row| pow(t.clone(), n - row)).collect();
    let weights: Vec<P::Scalar> = (0..=n)
        .map(|i| {
            let column = matrix.column(i);
            std::iter::zip(column.iter(), &powers).fold(P::Scalar::zero(), |sum, (entry, power)| {
                sum + entry.clone() * power.clone()
            })
        })
        .collect();
    let size =
        largest_coordinate(curve.control_points()) * (1.0 + 2.0 * t.magnitude()).powi(n as i32);
    let sides = Sides::new(format!("u = {u}, {curve}")).equal(
        "powers times M times control points is the curve point",
        (0..P::DIMENSION).map(|k| weighted_sum(&weights, curve.control_points(), k)),
        flat([&curve.at(u)]),
        Rounding::new(8 * n + 3, size),
    );
    if n != 3 {
        return sides;
    }
    let third = |row: &[i64; 4]| row.map(|entry| P::Scalar::from_ratio(entry, 3));
    let printed = [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]];
    let inverse = [[0, 0, 0, 3], [0, 0, 1, 3], [0, 1, 2, 3], [3, 3, 3, 3]];
    let inverse = DMatrix::from_row_iterator(4, 4, inverse.iter().flat_map(third));
    let product = matrix.clone() * inverse;
    sides
        .equal(
            "M is the matrix of the slides",
            matrix.transpose().iter().cloned(),
            printed
                .iter()
                .flatten()
                .map(|&entry| P::Scalar::from_integer(entry)),
            Rounding::none(),
        )
        .equal(
            "M times the printed inverse is the identity",
            product.iter().cloned(),
            DMatrix::<P::Scalar>::identity(4, 4).iter().cloned(),
            Rounding::new(6, 27.0),
        )
}
