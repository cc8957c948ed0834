//! Affine combinations: the sums of points that are points.

use num_traits::{One, Zero};
use thiserror::Error;

use super::origin::vector_seen_from;
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
    /// [`CombinationError::NotFinite`] if a weight or a coordinate is not finite,
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
    ///
    /// let refused = Point::affine_combination([0.5, 0.25, 0.5].into_iter().zip(corners)).unwrap_err();
    /// assert!(refused.to_string().contains("must sum to 1, not to 1.25"));
    /// # Ok::<(), cagd::affine::CombinationError>(())
    /// ```
    fn affine_combination(
        terms: impl IntoIterator<Item = (Self::Scalar, Self)>,
    ) -> Result<Self, CombinationError> {
        let terms: Vec<_> = terms.into_iter().collect();
        check_terms("an affine combination", &terms)?;
        if !sums_to(terms.iter().map(|(weight, _)| weight), Self::Scalar::one()) {
            return Err(CombinationError::WeightSum {
                count: terms.len(),
                found: weight_sum(&terms).to_string(),
            });
        }
        Ok(Self::from_fn(|k| {
            terms
                .iter()
                .fold(Self::Scalar::zero(), |sum, (weight, point)| {
                    sum + weight.clone() * point.coordinates()[k].clone()
                })
        }))
    }

    /// The vector `Σ weightᵢ · pointᵢ` with coefficient sum 0, such as `B − A`.
    ///
    /// It is computed from the first point, as Σ weightᵢ·(pointᵢ − point₀), which no choice of the origin changes.
    ///
    /// # Errors
    ///
    /// [`CombinationError::Empty`] if there is no term,
    /// [`CombinationError::NotFinite`] if a weight or a coordinate is not finite,
    /// [`CombinationError::VectorWeightSum`] if exact weights do not sum to 0, or if rounded weights
    /// miss 0 by more than the rounding of n weights and of their sum allows, γₙ₊₁·Σ|wᵢ|.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Affine, Point, Vector};
    ///
    /// let [a, b] = [[1.0, 1.0], [4.0, 3.0]].map(Point::new);
    /// assert_eq!(Point::vector_combination([(-1.0, a), (1.0, b)])?, b - a);
    /// assert!(Point::vector_combination([(1.0, a), (1.0, b)]).is_err());
    /// # Ok::<(), cagd::affine::CombinationError>(())
    /// ```
    fn vector_combination(
        terms: impl IntoIterator<Item = (Self::Scalar, Self)>,
    ) -> Result<Self::Difference, CombinationError> {
        let terms: Vec<_> = terms.into_iter().collect();
        check_terms("a vector combination", &terms)?;
        if !sums_to(terms.iter().map(|(weight, _)| weight), Self::Scalar::zero()) {
            return Err(CombinationError::VectorWeightSum {
                count: terms.len(),
                found: weight_sum(&terms).to_string(),
            });
        }
        Ok(vector_seen_from(&terms[0].1, &terms))
    }
}

/// Refuses what is empty or not finite.
pub(super) fn check_terms<P: Affine>(
    what: &'static str,
    terms: &[(P::Scalar, P)],
) -> Result<(), CombinationError> {
    if terms.is_empty() {
        return Err(CombinationError::Empty { what });
    }
    let finite = |(weight, point): &(P::Scalar, P)| {
        weight.is_finite() && point.coordinates().iter().all(Scalar::is_finite)
    };
    match terms.iter().position(|term| !finite(term)) {
        None => Ok(()),
        Some(index) => Err(CombinationError::NotFinite {
            what,
            index,
            weight: terms[index].0.to_string(),
            point: written(&terms[index].1),
        }),
    }
}

/// The coordinates of a point as `(x, y)`.
pub(super) fn written<P: Affine>(point: &P) -> String {
    let coordinates = point.coordinates().iter().map(ToString::to_string);
    format!("({})", coordinates.collect::<Vec<_>>().join(", "))
}

pub(super) fn weight_sum<P: Affine>(terms: &[(P::Scalar, P)]) -> P::Scalar {
    terms
        .iter()
        .fold(P::Scalar::zero(), |sum, (weight, _)| sum + weight.clone())
}

/// Whether weights sum to `target`: exactly, or as far as the rounding of n weights and of their sum can tell.
pub(crate) fn sums_to<'a, T: Scalar>(weights: impl Iterator<Item = &'a T>, target: T) -> bool {
    let (mut sum, mut magnitude, mut count) = (T::zero(), 0.0, 0);
    for weight in weights {
        sum += weight.clone();
        magnitude += weight.magnitude();
        count += 1;
    }
    if T::EXACT {
        sum == target
    } else {
        // A sum beyond the range is no sum at all.
        let defect = (sum - target).magnitude();
        defect.is_finite() && defect <= gamma(count + 1) * magnitude
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
    #[error("{what} needs at least one term, found none; give a weight and a point")]
    Empty {
        /// What was to be computed.
        what: &'static str,
    },
    /// A weight or a coordinate is NaN or infinite.
    #[error(
        "term {index} of {what} is not finite: {weight} · {point}; every weight and coordinate must be a finite number"
    )]
    NotFinite {
        /// What was to be computed.
        what: &'static str,
        /// Which term, counted from 0.
        index: usize,
        /// Its weight.
        weight: String,
        /// Its point.
        point: String,
    },
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
    /// The weights do not sum to 0.
    #[error(
        "the {count} weights of a vector combination must sum to 0, not to {found}; with the sum 1 take `affine_combination`"
    )]
    VectorWeightSum {
        /// How many weights there are.
        count: usize,
        /// Their sum.
        found: String,
    },
    /// The masses of a barycentre sum to 0.
    #[error(
        "the {count} weights of a barycentre sum to 0, so no point balances them; with the sum 0 take `vector_combination`"
    )]
    NoWeight {
        /// How many weights there are.
        count: usize,
    },
    /// There is not one weight a point.
    #[error("{expected} points need as many barycentric coordinates, found {found}")]
    Count {
        /// How many points there are.
        expected: usize,
        /// How many coordinates were given.
        found: usize,
    },
    /// The combination of finite points is beyond the range of the number type.
    #[error("{what} is beyond the range of the number type; scale the points or the weights down")]
    Overflow {
        /// What was to be computed.
        what: &'static str,
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
