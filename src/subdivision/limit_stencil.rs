//! Points and derivatives of the limit curve, straight from the polygon.

use num_traits::{One, Zero};
use thiserror::Error;

use super::laurent::LaurentPolynomial;
use super::local_matrix::LocalMatrix;
use super::mask::Mask;
use crate::affine::Affine;
use crate::scalar::{BigRational, OrderedScalar, Scalar};

/// Weights of polygon points whose sum is a point, or a derivative, of the limit curve.
///
/// The limit curve f of points pⱼ at the parameters j has the derivative
///
/// ```text
/// f⁽ʳ⁾(i + t) = Σⱼ lⱼ·pᵢ₊ⱼ
/// ```
///
/// at every whole number i, for the parameter t that the stencil was made for.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{LaurentPolynomial, Mask};
///
/// let ratio = |p, q| <BigRational as Scalar>::from_ratio(p, q);
/// let cubic = Mask::lane_riesenfeld(3).limit_stencil(0)?;
/// assert_eq!(*cubic.weights(), LaurentPolynomial::new(-3, [ratio(1, 6), ratio(4, 6), ratio(1, 6)]));
///
/// // The closed polygon 0, 6, 0, 0 at the parameter 3: its weights meet p₀, p₁ and p₂.
/// assert_eq!(cubic.to_f64().of_closed(&[0.0, 6.0, 0.0, 0.0], 3), 4.0);
/// # Ok::<(), cagd::subdivision::LimitStencilError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LimitStencil<T> {
    weights: LaurentPolynomial<T>,
    order: usize,
}

impl<T: Scalar> LimitStencil<T> {
    /// The weights lⱼ, as the coefficients of zʲ.
    #[must_use]
    pub fn weights(&self) -> &LaurentPolynomial<T> {
        &self.weights
    }

    /// The order r of the derivative; 0 for the point itself.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// The point of the limit of a closed polygon at the parameter number `i`.
    ///
    /// For a stencil of order 0; the weights of the others sum to 0 and give the point 0.
    /// `points` must not be empty.
    #[must_use]
    pub fn of_closed<P: Affine<Scalar = T>>(&self, points: &[P], i: i64) -> P {
        P::from_fn(|k| {
            self.weights.terms().fold(T::zero(), |sum, (j, weight)| {
                let index = (i + j).rem_euclid(points.len().max(1) as i64);
                sum + weight.clone() * points[index as usize].coordinates()[k].clone()
            })
        })
    }

    /// The derivative vector of the limit of a closed polygon at the parameter number `i`, for an order ≥ 1.
    ///
    /// `points` must not be empty.
    #[must_use]
    pub fn derivative_of_closed<P: Affine<Scalar = T>>(
        &self,
        points: &[P],
        i: i64,
    ) -> P::Difference {
        // The weights sum to 0, so differences to any point serve.
        let vectors: Vec<P::Difference> = points.iter().map(|p| p.difference(&points[0])).collect();
        P::Difference::from_fn(|k| {
            self.weights.terms().fold(T::zero(), |sum, (j, weight)| {
                let index = (i + j).rem_euclid(points.len().max(1) as i64);
                sum + weight.clone() * vectors[index as usize].coordinates()[k].clone()
            })
        })
    }
}

impl LimitStencil<BigRational> {
    /// The same stencil with rounded weights.
    #[must_use]
    pub fn to_f64(&self) -> LimitStencil<f64> {
        let weights = self.weights.coefficients().iter();
        LimitStencil {
            weights: LaurentPolynomial::new(
                self.weights.powers().start,
                weights.map(OrderedScalar::to_f64),
            ),
            order: self.order,
        }
    }
}

impl Mask<BigRational> {
    /// The stencil of the derivative of order r of the limit curve at the parameter 0: a left eigenvector of the
    /// [`LocalMatrix`] for the eigenvalue 2⁻ʳ, whose sum over jʳ is r!.
    ///
    /// That the limits are Cʳ is not tested here; [`smoothness`](Mask::smoothness) proves it.
    ///
    /// # Errors
    ///
    /// [`LimitStencilError::NoPoints`] if no point decides the limit at 0,
    /// [`LimitStencilError::Eigenvectors`] unless there is one eigenvector but for multiples,
    /// [`LimitStencilError::NotNormalisable`] if its sum over jʳ is 0.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::scalar::{BigRational, Scalar};
    /// use cagd::subdivision::{LimitStencilError, Mask};
    ///
    /// let four_point = Mask::four_point(BigRational::from_ratio(1, 16))?;
    /// let derivative = four_point.limit_stencil(1)?;
    /// let twelfths = [1, -8, 0, 8, -1].map(|n| BigRational::from_ratio(n, 12));
    /// assert_eq!(derivative.weights().coefficients(), twelfths);
    /// // The limit is not C², and the double eigenvalue 1/4 has a single eigenvector.
    /// assert_eq!(four_point.limit_stencil(2), Err(LimitStencilError::NotNormalisable { order: 2 }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `warren-weimer2001`, §3; `dyn-levin2002`, §2.
    pub fn limit_stencil(
        &self,
        order: usize,
    ) -> Result<LimitStencil<BigRational>, LimitStencilError> {
        let matrix = LocalMatrix::of(self);
        if matrix.size() == 0 {
            return Err(LimitStencilError::NoPoints);
        }
        let half = BigRational::from_ratio(1, 2);
        let eigenvalue = (0..order).fold(BigRational::one(), |power, _| power * &half);
        let mut eigenvectors = matrix.left_eigenvectors(&eigenvalue);
        let found = eigenvectors.len();
        let (Some(vector), 1) = (eigenvectors.pop(), found) else {
            return Err(LimitStencilError::Eigenvectors { order, found });
        };
        let weights = matrix.indexed(vector);
        let moment = moment(&weights, order);
        if moment.is_zero() {
            return Err(LimitStencilError::NotNormalisable { order });
        }
        let factorial = (1..=order as i64).fold(BigRational::one(), |product, k| {
            product * <BigRational as Scalar>::from_integer(k)
        });
        Ok(LimitStencil {
            weights: weights.scaled(&(factorial / moment)),
            order,
        })
    }

    /// The stencil of the derivative of order r at the parameter `numerator`/2^`halvings`.
    ///
    /// As many steps are made, and the stencil at 0 is applied there.
    ///
    /// # Errors
    ///
    /// As [`limit_stencil`](Self::limit_stencil).
    ///
    /// ```
    /// use cagd::scalar::{BigRational, Scalar};
    /// use cagd::subdivision::Mask;
    ///
    /// let chaikin = Mask::lane_riesenfeld(2);
    /// let at_vertex = chaikin.limit_stencil_at(0, 1, 1)?;
    /// let eighths = [1, 6, 1].map(|n| BigRational::from_ratio(n, 8));
    /// assert_eq!(at_vertex.weights().coefficients(), eighths);
    /// # Ok::<(), cagd::subdivision::LimitStencilError>(())
    /// ```
    pub fn limit_stencil_at(
        &self,
        order: usize,
        numerator: i64,
        halvings: u32,
    ) -> Result<LimitStencil<BigRational>, LimitStencilError> {
        let mut stencil = self.limit_stencil(order)?;
        stencil.weights = stencil.weights.shifted(numerator);
        // The derivative of f(t) = g(2t) of order r is 2ʳ times that of g.
        let chain = (0..order).fold(BigRational::one(), |power, _| {
            power * <BigRational as Scalar>::from_integer(2)
        });
        for _ in 0..halvings {
            let known = stencil.weights.powers();
            let support = self.support();
            let first = (known.start - support.end).div_euclid(2);
            let last = (known.end - support.start).div_euclid(2);
            let weight = |j: i64| {
                let terms = stencil.weights.terms();
                terms.fold(BigRational::zero(), |sum, (i, l)| {
                    sum + l * self.coefficient(i - 2 * j)
                })
            };
            let weights: Vec<BigRational> = (first..=last).map(weight).collect();
            stencil.weights = LaurentPolynomial::new(first, weights).scaled(&chain);
        }
        Ok(stencil)
    }
}

/// The sum Σ lⱼ·jʳ.
fn moment(weights: &LaurentPolynomial<BigRational>, order: usize) -> BigRational {
    weights.terms().fold(BigRational::zero(), |sum, (j, l)| {
        let power = (0..order).fold(BigRational::one(), |power, _| {
            power * <BigRational as Scalar>::from_integer(j)
        });
        sum + l * power
    })
}

/// Why a scheme has no limit stencil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LimitStencilError {
    /// The mask has so few indices that no point decides the limit at 0.
    #[error(
        "a mask with fewer than three indices has no stencil at 0: no limit is continuous there; take a longer mask"
    )]
    NoPoints,
    /// There is not exactly one eigenvector.
    #[error(
        "the stencil of order {order} needs exactly one left eigenvector for the eigenvalue 1/2^{order}, found {found}; take a lower order"
    )]
    Eigenvectors {
        /// The order of the derivative.
        order: usize,
        /// How many there are.
        found: usize,
    },
    /// The eigenvector does not see monomials of the order, so that the limit is not so smooth.
    #[error(
        "the left eigenvector for 1/2^{order} vanishes on the data j^{order}: the limit is not C^{order}; take a lower order"
    )]
    NotNormalisable {
        /// The order of the derivative.
        order: usize,
    },
}
