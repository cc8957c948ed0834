//! Affine combinations: the sums of points that are points.

use num_traits::{One, Zero};
use thiserror::Error;

use super::{Point, Vector};
use crate::law::gamma;
use crate::scalar::Scalar;

/// What can be combined with coefficient sum 1: points, vectors and numbers.
///
/// Everything that a curve needs of its control points is here.
/// So one curve type serves points (curves), vectors (their derivatives) and numbers (functions).
///
/// # Examples
///
/// ```
/// use cagd::affine::{Affine, Point};
///
/// let p = Point::new([0.0, 0.0]);
/// let q = Point::new([4.0, 8.0]);
/// assert_eq!(p.lerp(&q, 0.25), Point::new([1.0, 2.0]));
/// assert_eq!(3.0.lerp(&5.0, 0.5), 4.0);
/// ```
pub trait Affine: Clone + PartialEq + std::fmt::Debug + Send + Sync + 'static {
    /// The numbers that coefficients are made of.
    type Scalar: Scalar;

    /// What the difference of two is: a vector for points, the same kind otherwise.
    type Difference: Linear<Scalar = Self::Scalar>;

    /// The dimension of the space.
    const DIMENSION: usize;

    /// The affine combination `(1 − t)·self + t·other`.
    ///
    /// At `t = 0` and `t = 1` it gives exactly `self` and `other`, in floating point too.
    #[must_use]
    fn lerp(&self, other: &Self, t: Self::Scalar) -> Self;

    /// The difference `self − start`.
    #[must_use]
    fn difference(&self, start: &Self) -> Self::Difference;

    /// `self` moved by a difference.
    #[must_use]
    fn translated(&self, by: &Self::Difference) -> Self;

    /// The coordinates, in order.
    fn coordinates(&self) -> &[Self::Scalar];

    /// The element whose coordinate number `k` is `coordinate(k)`.
    #[must_use]
    fn from_fn(coordinate: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// The affine combination `Σ weightᵢ · pointᵢ`, its terms added in the given order.
    ///
    /// # Errors
    ///
    /// [`CombinationError::Empty`] if there is no term,
    /// [`CombinationError::WeightSum`] if exact weights do not sum to 1, or if rounded weights
    /// miss 1 by more than the rounding of n weights and of their sum allows, γₙ₊₁·Σ|wᵢ|.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Affine, Point};
    ///
    /// let corners = [Point::new([0.0, 0.0]), Point::new([4.0, 0.0]), Point::new([0.0, 8.0])];
    /// let centre = Point::affine_combination([0.5, 0.25, 0.25].into_iter().zip(corners))?;
    /// assert_eq!(centre, Point::new([1.0, 2.0]));
    /// # Ok::<(), cagd::affine::CombinationError>(())
    /// ```
    fn affine_combination(
        terms: impl IntoIterator<Item = (Self::Scalar, Self)>,
    ) -> Result<Self, CombinationError> {
        let mut coordinates = vec![Self::Scalar::zero(); Self::DIMENSION];
        let mut sum = Self::Scalar::zero();
        let mut magnitude = 0.0;
        let mut count = 0;
        for (weight, point) in terms {
            for (total, coordinate) in coordinates.iter_mut().zip(point.coordinates()) {
                *total += weight.clone() * coordinate.clone();
            }
            magnitude += weight.magnitude();
            sum += weight;
            count += 1;
        }
        if count == 0 {
            return Err(CombinationError::Empty);
        }
        let defect = (sum.clone() - Self::Scalar::one()).magnitude();
        let allowed = if Self::Scalar::EXACT {
            0.0
        } else {
            gamma(count + 1) * magnitude
        };
        if defect <= allowed {
            Ok(Self::from_fn(|k| coordinates[k].clone()))
        } else {
            Err(CombinationError::WeightSum {
                count,
                found: sum.to_string(),
            })
        }
    }
}

/// What can be added and scaled: vectors and numbers, the differences of an [`Affine`] kind.
pub trait Linear: Affine<Difference = Self> {
    /// `factor` times this.
    #[must_use]
    fn scaled(&self, factor: Self::Scalar) -> Self {
        Self::from_fn(|k| self.coordinates()[k].clone() * factor.clone())
    }
}

/// Why a sum is not an affine combination.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CombinationError {
    /// There is nothing to combine.
    #[error("an affine combination needs at least one term, found none; give a weight and a point")]
    Empty,
    /// The weights do not sum to 1.
    #[error(
        "the {count} weights of an affine combination must sum to 1, not to {found}; divide them by their sum"
    )]
    WeightSum {
        /// How many weights there are.
        count: usize,
        /// Their sum.
        found: String,
    },
}

impl<T: Scalar> Affine for T {
    type Scalar = T;
    type Difference = T;
    const DIMENSION: usize = 1;

    #[inline]
    fn lerp(&self, other: &Self, t: T) -> Self {
        self.clone() * (T::one() - t.clone()) + other.clone() * t
    }

    #[inline]
    fn difference(&self, start: &Self) -> Self {
        self.clone() - start.clone()
    }

    #[inline]
    fn translated(&self, by: &Self) -> Self {
        self.clone() + by.clone()
    }

    #[inline]
    fn coordinates(&self) -> &[T] {
        std::slice::from_ref(self)
    }

    #[inline]
    fn from_fn(mut coordinate: impl FnMut(usize) -> T) -> Self {
        coordinate(0)
    }
}

impl<T: Scalar> Linear for T {}

impl<T: Scalar, const D: usize> Affine for Point<T, D> {
    type Scalar = T;
    type Difference = Vector<T, D>;
    const DIMENSION: usize = D;

    #[inline]
    fn lerp(&self, other: &Self, t: T) -> Self {
        let s = T::one() - t.clone();
        Self::from_fn(|k| self[k].clone() * s.clone() + other[k].clone() * t.clone())
    }

    #[inline]
    fn difference(&self, start: &Self) -> Vector<T, D> {
        self.clone() - start.clone()
    }

    #[inline]
    fn translated(&self, by: &Vector<T, D>) -> Self {
        self.clone() + by.clone()
    }

    #[inline]
    fn coordinates(&self) -> &[T] {
        Point::coordinates(self)
    }

    #[inline]
    fn from_fn(coordinate: impl FnMut(usize) -> T) -> Self {
        Point::new(std::array::from_fn(coordinate))
    }
}

impl<T: Scalar, const D: usize> Affine for Vector<T, D> {
    type Scalar = T;
    type Difference = Self;
    const DIMENSION: usize = D;

    #[inline]
    fn lerp(&self, other: &Self, t: T) -> Self {
        let s = T::one() - t.clone();
        <Self as Affine>::from_fn(|k| self[k].clone() * s.clone() + other[k].clone() * t.clone())
    }

    #[inline]
    fn difference(&self, start: &Self) -> Self {
        self - start
    }

    #[inline]
    fn translated(&self, by: &Self) -> Self {
        self + by
    }

    #[inline]
    fn coordinates(&self) -> &[T] {
        self.as_slice()
    }

    #[inline]
    fn from_fn(coordinate: impl FnMut(usize) -> T) -> Self {
        let coordinates: [T; D] = std::array::from_fn(coordinate);
        Self::from(coordinates)
    }
}

impl<T: Scalar, const D: usize> Linear for Vector<T, D> {}
