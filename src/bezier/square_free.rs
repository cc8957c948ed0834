//! Polynomials over a field, taken apart by the multiplicity of their roots.

use super::bernstein::binomial;
use crate::scalar::Scalar;

/// A polynomial Σ aᵢ·xⁱ; the last coefficient is not 0, the zero polynomial has none.
#[derive(Debug, Clone, PartialEq)]
struct Polynomial<T>(Vec<T>);

/// For each k = 1, 2, … the Bernstein control values of the polynomial whose roots in (0, 1) are the
/// k-fold roots of the given one.
///
/// With x = t/(1 − t) the polynomial Σ bᵢ·Bᵢⁿ(t) becomes (1 − t)ⁿ·Σ C(n, i)·bᵢ·xⁱ. The algorithm of
/// Yun takes it apart. Exact numbers only: a rounded greatest common divisor has no meaning.
/// The first and the last control value must not be 0.
pub(crate) fn square_free_factors<T: Scalar>(control_values: &[T]) -> Vec<Vec<T>> {
    let n = control_values.len() - 1;
    let coefficients = control_values
        .iter()
        .enumerate()
        .map(|(i, value)| binomial::<T>(n, i as i64) * value.clone());
    let polynomial = Polynomial::new(coefficients.collect());
    let derivative = polynomial.derivative();
    let repeated = polynomial.gcd(&derivative);
    let mut rest = polynomial.divided(&repeated).0;
    let mut other = derivative.divided(&repeated).0.minus(&rest.derivative());
    let mut factors = Vec::new();
    while rest.degree() > 0 {
        let factor = rest.gcd(&other);
        rest = rest.divided(&factor).0;
        other = other.divided(&factor).0.minus(&rest.derivative());
        factors.push(factor.control_values());
    }
    factors
}

impl<T: Scalar> Polynomial<T> {
    fn new(mut coefficients: Vec<T>) -> Self {
        while coefficients.last().is_some_and(T::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// aᵢ = C(d, i)·bᵢ, solved for bᵢ.
    fn control_values(&self) -> Vec<T> {
        let d = self.degree();
        let value = |(i, a): (usize, &T)| a.clone() / binomial::<T>(d, i as i64);
        self.0.iter().enumerate().map(value).collect()
    }

    fn derivative(&self) -> Self {
        let term = |(i, a): (usize, &T)| T::from_integer(i as i64) * a.clone();
        Self::new(self.0.iter().enumerate().skip(1).map(term).collect())
    }

    fn minus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let coefficient = |p: &Self, i: usize| p.0.get(i).cloned().unwrap_or_else(T::zero);
        Self::new(
            (0..length)
                .map(|i| coefficient(self, i) - coefficient(other, i))
                .collect(),
        )
    }

    /// Quotient and remainder.
    fn divided(&self, divisor: &Self) -> (Self, Self) {
        let lead = divisor.0.last().expect("the divisor is not zero");
        let mut rest = self.0.clone();
        let mut quotient = vec![T::zero(); rest.len().saturating_sub(divisor.degree())];
        for shift in (0..quotient.len()).rev() {
            let factor = rest[shift + divisor.degree()].clone() / lead.clone();
            for (i, a) in divisor.0.iter().enumerate() {
                rest[shift + i] -= factor.clone() * a.clone();
            }
            quotient[shift] = factor;
        }
        (Self::new(quotient), Self::new(rest))
    }

    /// The greatest common divisor with leading coefficient 1.
    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while let Some(lead) = b.0.last().cloned() {
            // A leading coefficient of 1 keeps the fractions from growing faster than need be.
            let monic = Self(b.0.iter().map(|c| c.clone() / lead.clone()).collect());
            let remainder = a.divided(&monic).1;
            (a, b) = (monic, remainder);
        }
        let lead = a.0.last().expect("not both are zero").clone();
        Self(a.0.iter().map(|c| c.clone() / lead.clone()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::BigRational;

    /// (t − 1/2)·(t − 1/3)² has the simple root 1/2 and the double root 1/3.
    #[test]
    fn roots_are_sorted_by_multiplicity() {
        let q = |p: i64, q: i64| BigRational::from_ratio(p, q);
        // In powers of x: (x/2 − 1/2)(2x/3 − 1/3)², as t − r = (1 − t)·((1 − r)·x − r).
        let coefficients = [q(-1, 18), q(5, 18), q(-4, 9), q(2, 9)];
        let values: Vec<_> = std::iter::zip(coefficients, [1, 3, 3, 1])
            .map(|(a, c)| a / q(c, 1))
            .collect();
        let factors = square_free_factors(&values);
        assert_eq!(factors, [vec![q(-1, 1), q(1, 1)], vec![q(-1, 2), q(1, 1)]]);
    }
}
