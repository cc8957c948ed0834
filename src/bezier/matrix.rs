//! The change between the Bernstein basis and the monomials as matrices.

use nalgebra::DMatrix;

use super::bernstein::binomial;
use crate::scalar::Scalar;

/// The matrix M of the matrix form b(t) = (tⁿ, …, t, 1)·M·(b₀, …, bₙ)ᵀ.
///
/// ```text
/// Bᵢⁿ(t) = Σₖ (−1)ᵏ⁻ⁱ·C(n, k)·C(k, i)·tᵏ
/// ```
///
/// Column i holds the monomial coefficients of Bᵢⁿ, that of the highest power first.
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein_matrix;
/// use nalgebra::{DMatrix, dmatrix};
///
/// let cubic: DMatrix<f64> = dmatrix![
///     -1.0,  3.0, -3.0, 1.0;
///      3.0, -6.0,  3.0, 0.0;
///     -3.0,  3.0,  0.0, 0.0;
///      1.0,  0.0,  0.0, 0.0
/// ];
/// assert_eq!(bernstein_matrix::<f64>(3), cubic);
/// ```
///
/// Source: `alggeom`; `farin2002`, §5.8.
#[must_use]
pub fn bernstein_matrix<T: Scalar>(degree: usize) -> DMatrix<T> {
    DMatrix::from_fn(degree + 1, degree + 1, |row, i| {
        let k = degree - row;
        let value = binomial::<T>(degree, k as i64) * binomial(k, i as i64);
        if k >= i && (k - i) % 2 == 1 {
            -value
        } else {
            value
        }
    })
}

/// The inverse of [`bernstein_matrix`]: column r holds the control values of tᵏ with k = n − r.
///
/// ```text
/// tᵏ = Σᵢ C(i, k)/C(n, k)·Bᵢⁿ(t)
/// ```
///
/// # Examples
///
/// ```
/// use cagd::bezier::{bernstein_matrix, monomial_matrix};
/// use cagd::scalar::BigRational;
/// use nalgebra::DMatrix;
///
/// let product = bernstein_matrix::<BigRational>(5) * monomial_matrix::<BigRational>(5);
/// assert_eq!(product, DMatrix::identity(6, 6));
/// ```
///
/// Source: `farin2002`, §5.8.
#[must_use]
pub fn monomial_matrix<T: Scalar>(degree: usize) -> DMatrix<T> {
    DMatrix::from_fn(degree + 1, degree + 1, |i, column| {
        let k = degree - column;
        binomial::<T>(i, k as i64) / binomial(degree, k as i64)
    })
}
