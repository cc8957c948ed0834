//! Elementary symmetric polynomials, and the blossoms of the powers 1, t, t², … made of them.

use super::bernstein::binomial;
use super::blossom::BlossomError;
use crate::scalar::Scalar;

/// The elementary symmetric polynomials e₀, e₁, …, eₙ of n numbers.
///
/// eₖ is the sum of all products of k different ones of the numbers x₁, …, xₙ:
///
/// ```text
/// e₀ = 1,   e₁ = x₁ + … + xₙ,   e₂ = x₁x₂ + x₁x₃ + … + xₙ₋₁xₙ,   …,   eₙ = x₁x₂ ⋯ xₙ
/// ```
///
/// They are the coefficients of (1 + x₁z)(1 + x₂z) ⋯ (1 + xₙz), and are computed as such, factor by
/// factor, with n(n + 1)/2 products.
/// In floating point eₖ has an error of at most γ₂ₙ·eₖ(|x₁|, …, |xₙ|).
///
/// # Examples
///
/// ```
/// use cagd::bezier::elementary_symmetric;
///
/// assert_eq!(elementary_symmetric(&[2.0, 3.0, 5.0]), [1.0, 10.0, 31.0, 30.0]);
/// assert_eq!(elementary_symmetric::<f64>(&[]), [1.0]);
/// ```
#[must_use]
pub fn elementary_symmetric<T: Scalar>(numbers: &[T]) -> Vec<T> {
    let mut coefficients = vec![T::one()];
    for x in numbers {
        coefficients.push(T::zero());
        for k in (1..coefficients.len()).rev() {
            let product = x.clone() * coefficients[k - 1].clone();
            coefficients[k] += product;
        }
    }
    coefficients
}

/// The blossom of the power tᵏ as a polynomial of degree at most n, at n = `arguments.len()` arguments.
///
/// ```text
/// eₖ(x₁, …, xₙ) / C(n, k)
/// ```
///
/// It depends on n: the blossom of t is x₁ for n = 1, but (x₁ + x₂)/2 for n = 2.
///
/// # Errors
///
/// [`BlossomError::PowerTooHigh`] if k > n: tᵏ is then no polynomial of degree at most n.
///
/// # Examples
///
/// ```
/// use cagd::bezier::{BlossomError, power_blossom};
///
/// assert_eq!(power_blossom(1, &[3.0]), Ok(3.0));
/// assert_eq!(power_blossom(1, &[3.0, 5.0]), Ok(4.0));
/// assert_eq!(power_blossom(2, &[3.0, 5.0]), Ok(15.0));
///
/// let error = power_blossom(2, &[3.0]).unwrap_err();
/// assert!(matches!(error, BlossomError::PowerTooHigh { power: 2, arguments: 1 }));
/// assert_eq!(error.to_string(), "the degree of t^2 is too high for a blossom with so few arguments (1); give at least 2");
/// ```
///
/// Source: `ramshaw1989`.
pub fn power_blossom<T: Scalar>(power: usize, arguments: &[T]) -> Result<T, BlossomError> {
    elementary_symmetric(arguments)
        .into_iter()
        .nth(power)
        .map(|sum| sum / binomial::<T>(arguments.len(), power as i64))
        .ok_or(BlossomError::PowerTooHigh {
            power,
            arguments: arguments.len(),
        })
}
