//! Lines of the plane and hyperplanes, in implicit form.

use thiserror::Error;

use super::{Point, Vector};
use crate::scalar::Scalar;

/// The hyperplane { X : ⟨X, m⟩ = c }: a line in the plane, a plane in space.
///
/// Its function X ↦ ⟨X, m⟩ − c is affine: 0 on the hyperplane, and of one sign on each side.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Line, Point};
///
/// let line = Line::new([1.0, 2.0], 4.0)?; // x + 2y = 4
/// assert_eq!(line.value(&Point::new([2.0, 1.0])), 0.0);
/// assert_eq!(line.value(&Point::new([0.0, 0.0])), -4.0);
///
/// let diagonal = Line::through(&Point::new([1.0, 1.0]), &Point::new([3.0, 3.0]))?;
/// assert_eq!(diagonal.value(&Point::new([7.0, 7.0])), 0.0);
/// assert!(diagonal.value(&Point::new([1.0, 2.0])) > 0.0, "to the left it is positive");
/// # Ok::<(), cagd::affine::HyperplaneError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Hyperplane<T: Scalar, const D: usize> {
    normal: Vector<T, D>,
    offset: T,
}

/// A line in the plane.
pub type Line<T> = Hyperplane<T, 2>;

/// Why an equation is no hyperplane.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum HyperplaneError {
    /// The normal vector is zero; for a line through two points, the points are equal.
    #[error("a hyperplane needs a normal vector other than 0; a line needs two different points")]
    NoNormal,
    /// A coordinate is NaN, infinite, or beyond the range of the number type.
    #[error("the hyperplane of normal {normal} and offset {offset} is not finite")]
    NotFinite {
        /// The normal vector.
        normal: String,
        /// The offset.
        offset: String,
    },
}

impl<T: Scalar, const D: usize> Hyperplane<T, D> {
    /// The hyperplane ⟨X, m⟩ = c with the normal vector m and the offset c.
    ///
    /// # Errors
    ///
    /// [`HyperplaneError`] if m is zero or a number is not finite.
    ///
    /// ```
    /// use cagd::affine::{HyperplaneError, Line};
    ///
    /// assert_eq!(Line::new([0.0, 0.0], 1.0), Err(HyperplaneError::NoNormal));
    /// assert!(matches!(Line::new([1.0, f64::NAN], 1.0), Err(HyperplaneError::NotFinite { .. })));
    /// ```
    pub fn new(normal: impl Into<[T; D]>, offset: T) -> Result<Self, HyperplaneError> {
        let normal = Vector::from(normal.into());
        if !normal.iter().chain([&offset]).all(Scalar::is_finite) {
            return Err(HyperplaneError::NotFinite {
                normal: (Point::origin() + normal).to_string(),
                offset: offset.to_string(),
            });
        }
        if normal.iter().all(|x| x.is_zero()) {
            return Err(HyperplaneError::NoNormal);
        }
        Ok(Self { normal, offset })
    }

    /// The normal vector m.
    #[must_use]
    pub fn normal(&self) -> &Vector<T, D> {
        &self.normal
    }

    /// The offset c.
    #[must_use]
    pub fn offset(&self) -> &T {
        &self.offset
    }

    /// The value ⟨X, m⟩ − c at a point X.
    ///
    /// In floating point it passes D + 1 roundings.
    #[must_use]
    pub fn value(&self, point: &Point<T, D>) -> T {
        std::iter::zip(point.coordinates(), self.normal.iter())
            .fold(-self.offset.clone(), |sum, (x, m)| {
                sum + x.clone() * m.clone()
            })
    }
}

impl<T: Scalar> Line<T> {
    /// The line from `start` to `end`, its function positive to the left.
    ///
    /// # Errors
    ///
    /// [`HyperplaneError::NoNormal`] if both points are equal, [`HyperplaneError::NotFinite`] if the
    /// equation is beyond the range of the number type.
    pub fn through(start: &Point<T, 2>, end: &Point<T, 2>) -> Result<Self, HyperplaneError> {
        let direction = end.clone() - start.clone();
        let normal = [-direction[1].clone(), direction[0].clone()];
        let offset = start[0].clone() * normal[0].clone() + start[1].clone() * normal[1].clone();
        Self::new(normal, offset)
    }
}
