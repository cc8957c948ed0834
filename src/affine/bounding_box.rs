//! Axis-aligned boxes.

use thiserror::Error;

use super::Affine;
use crate::scalar::{OrderedScalar, Scalar};

/// A box with sides along the axes: all points between two corners, coordinate by coordinate.
///
/// ```text
/// { x : lowₖ ≤ xₖ ≤ highₖ for every coordinate k }
/// ```
///
/// For numbers it is an interval.
///
/// # Examples
///
/// ```
/// use cagd::affine::{BoundingBox, Point};
///
/// let bounds = BoundingBox::of(&[[0.0, 3.0], [2.0, 1.0], [1.0, 5.0]].map(Point::new))?;
/// assert_eq!(bounds.low(), &Point::new([0.0, 1.0]));
/// assert_eq!(bounds.high(), &Point::new([2.0, 5.0]));
/// assert!(bounds.contains(&Point::new([2.0, 2.0])));
/// assert!(!bounds.contains(&Point::new([2.0, 6.0])));
///
/// assert_eq!(BoundingBox::of(&[3.0, -1.0, 2.0])?.low(), &-1.0);
/// # Ok::<(), cagd::affine::BoundingBoxError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox<P> {
    low: P,
    high: P,
}

/// Why points have no bounding box.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BoundingBoxError {
    /// There is no point.
    #[error("a bounding box needs at least one point, found none")]
    Empty,
    /// A coordinate is NaN or infinite.
    #[error(
        "point {index} of the bounding box is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which point, counted from 0.
        index: usize,
        /// The point.
        point: String,
    },
}

impl<P: Affine> BoundingBox<P>
where
    P::Scalar: OrderedScalar,
{
    /// The smallest box around these points, in O(n) comparisons.
    ///
    /// # Errors
    ///
    /// [`BoundingBoxError::Empty`] without points, [`BoundingBoxError::NotFinite`] for NaN and infinities.
    ///
    /// ```
    /// use cagd::affine::{BoundingBox, BoundingBoxError};
    ///
    /// assert_eq!(BoundingBox::<f64>::of(&[]), Err(BoundingBoxError::Empty));
    /// assert!(matches!(BoundingBox::of(&[0.0, f64::NAN]), Err(BoundingBoxError::NotFinite { index: 1, .. })));
    /// ```
    pub fn of(points: &[P]) -> Result<Self, BoundingBoxError> {
        for (index, point) in points.iter().enumerate() {
            if !point.coordinates().iter().all(Scalar::is_finite) {
                return Err(BoundingBoxError::NotFinite {
                    index,
                    point: format!("{point:?}"),
                });
            }
        }
        match points {
            [] => Err(BoundingBoxError::Empty),
            [first, others @ ..] => Ok(Self::around(first, others)),
        }
    }

    /// The smallest box around finite points.
    pub(crate) fn around(first: &P, others: &[P]) -> Self {
        let extreme = |choose: fn(P::Scalar, P::Scalar) -> P::Scalar| {
            P::from_fn(|k| {
                others
                    .iter()
                    .fold(first.coordinates()[k].clone(), |found, point| {
                        choose(found, point.coordinates()[k].clone())
                    })
            })
        };
        Self {
            low: extreme(OrderedScalar::min),
            high: extreme(OrderedScalar::max),
        }
    }

    /// The corner with the smallest coordinates.
    #[must_use]
    pub fn low(&self) -> &P {
        &self.low
    }

    /// The corner with the largest coordinates.
    #[must_use]
    pub fn high(&self) -> &P {
        &self.high
    }

    /// The lengths of the sides: the difference of the two corners.
    #[must_use]
    pub fn size(&self) -> P::Difference {
        self.high.difference(&self.low)
    }

    /// Whether `point` lies in the box; its boundary belongs to it.
    #[must_use]
    pub fn contains(&self, point: &P) -> bool {
        (0..P::DIMENSION).all(|k| {
            let x = &point.coordinates()[k];
            self.low.coordinates()[k] <= *x && *x <= self.high.coordinates()[k]
        })
    }

    /// Whether both boxes have a point in common; touching is enough.
    ///
    /// ```
    /// use cagd::affine::BoundingBox;
    ///
    /// let [a, b, c] = [[0.0, 1.0], [1.0, 2.0], [3.0, 4.0]].map(|ends| BoundingBox::of(&ends).unwrap());
    /// assert!(a.meets(&b));
    /// assert!(!b.meets(&c));
    /// ```
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        (0..P::DIMENSION).all(|k| {
            self.low.coordinates()[k] <= other.high.coordinates()[k]
                && other.low.coordinates()[k] <= self.high.coordinates()[k]
        })
    }

    /// The smallest box that contains both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self::around(
            &self.low,
            &[self.high.clone(), other.low.clone(), other.high.clone()],
        )
    }
}
