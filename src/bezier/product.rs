//! Products of polynomials in Bernstein form.

use num_traits::Zero;

use super::bernstein::binomial;
use crate::affine::Affine;
use crate::scalar::Scalar;

/// The Bernstein coefficients of the product of two polynomials in Bernstein form.
///
/// For f of degree m and g of degree n it has degree m + n:
///
/// ```text
/// (f·g)ₖ = Σᵢ C(m, i)·C(n, k − i)/C(m + n, k) · fᵢ·gₖ₋ᵢ,   k = 0 … m + n
/// ```
///
/// because Bᵢᵐ·Bⱼⁿ = C(m, i)·C(n, j)/C(m + n, i + j)·Bᵢ₊ⱼᵐ⁺ⁿ. The weights of one k are positive and
/// sum to 1, so that no coefficient is larger than the largest |fᵢ| times the largest |gⱼ|.
/// An empty list stands for no polynomial; the product with it is empty.
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein_product;
///
/// // t·(1 − t) = ½·B₁²(t)
/// assert_eq!(bernstein_product(&[0.0, 1.0], &[1.0, 0.0]), [0.0, 0.5, 0.0]);
/// ```
///
/// Source: `farouki2012`, §4.
#[must_use]
pub fn bernstein_product<T: Scalar>(f: &[T], g: &[T]) -> Vec<T> {
    bernstein_inner_product(f, g)
}

/// The Bernstein coefficients of t ↦ ⟨f(t), g(t)⟩ for two curves of vectors (or numbers) in Bernstein form.
///
/// The same sum as in [`bernstein_product`], with the inner product of the coefficients.
///
/// # Examples
///
/// ```
/// use cagd::affine::Vector;
/// use cagd::bezier::bernstein_inner_product;
///
/// // (1 − t, t) has the squared length (1 − t)² + t².
/// let f = [[1.0, 0.0], [0.0, 1.0]].map(Vector::from);
/// assert_eq!(bernstein_inner_product(&f, &f), [1.0, 0.0, 1.0]);
/// ```
#[must_use]
pub fn bernstein_inner_product<V: Affine>(f: &[V], g: &[V]) -> Vec<V::Scalar> {
    let (Some(m), Some(n)) = (f.len().checked_sub(1), g.len().checked_sub(1)) else {
        return Vec::new();
    };
    let choose = |degree: usize| -> Vec<V::Scalar> {
        (0..=degree).map(|k| binomial(degree, k as i64)).collect()
    };
    let (of_f, of_g, of_product) = (choose(m), choose(n), choose(m + n));
    let mut product = vec![V::Scalar::zero(); m + n + 1];
    for (i, left) in f.iter().enumerate() {
        for (j, right) in g.iter().enumerate() {
            let weight = of_f[i].clone() * of_g[j].clone() / of_product[i + j].clone();
            let inner = std::iter::zip(left.coordinates(), right.coordinates())
                .fold(V::Scalar::zero(), |sum, (x, y)| sum + x.clone() * y.clone());
            product[i + j] += weight * inner;
        }
    }
    product
}
