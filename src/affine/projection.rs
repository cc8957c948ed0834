//! Projections from a point.

use thiserror::Error;

use super::{Affine, Hyperplane, Point};
use crate::scalar::Scalar;

/// The projection from a centre O onto a hyperplane: a point x goes to where the line through O and x meets it.
///
/// ```text
/// x ↦ O + (x − O)·(c − ⟨O, m⟩) / ⟨x − O, m⟩   for the hyperplane ⟨X, m⟩ = c
/// ```
///
/// It is no affine map: the midpoint of two points does not go to the midpoint of their images.
///
/// # Examples
///
/// ```
/// use cagd::affine::{CentralProjection, Line, Point};
///
/// // From the origin onto the line y = 1.
/// let projection = CentralProjection::new(Point::origin(), Line::new([0.0, 1.0], 1.0)?)?;
/// assert_eq!(projection.point(&Point::new([0.0, 1.0]))?, Point::new([0.0, 1.0]));
/// assert_eq!(projection.point(&Point::new([2.0, 2.0]))?, Point::new([1.0, 1.0]));
/// assert_eq!(projection.point(&Point::new([1.0, 1.5]))?[0], 2.0 / 3.0, "and not 1/2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CentralProjection<T: Scalar, const D: usize> {
    centre: Point<T, D>,
    onto: Hyperplane<T, D>,
}

/// Why there is no such projection, or no image.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CentralProjectionError {
    /// The centre lies on the hyperplane.
    #[error("the centre {centre} of a projection must not lie on the hyperplane of the images")]
    CentreOnHyperplane {
        /// The centre.
        centre: String,
    },
    /// The line through the centre and the point does not meet the hyperplane.
    #[error(
        "the point {point} has no image: its line through the centre {centre} is parallel to the hyperplane, or it is the centre"
    )]
    NoImage {
        /// The point.
        point: String,
        /// The centre.
        centre: String,
    },
}

impl<T: Scalar, const D: usize> CentralProjection<T, D> {
    /// The projection from `centre` onto a hyperplane.
    ///
    /// # Errors
    ///
    /// [`CentralProjectionError::CentreOnHyperplane`] if the centre lies on it.
    pub fn new(
        centre: Point<T, D>,
        onto: Hyperplane<T, D>,
    ) -> Result<Self, CentralProjectionError> {
        if onto.value(&centre).is_zero() {
            Err(CentralProjectionError::CentreOnHyperplane {
                centre: centre.to_string(),
            })
        } else {
            Ok(Self { centre, onto })
        }
    }

    /// The image of a point.
    ///
    /// # Errors
    ///
    /// [`CentralProjectionError::NoImage`] if the line through the centre and the point is parallel to the hyperplane,
    /// if the point is the centre, or if the image is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::{CentralProjection, CentralProjectionError, Line, Point};
    ///
    /// let projection = CentralProjection::new(Point::origin(), Line::new([0.0, 1.0], 1.0)?)?;
    /// let level = projection.point(&Point::new([5.0, 0.0]));
    /// assert!(matches!(level, Err(CentralProjectionError::NoImage { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn point(&self, point: &Point<T, D>) -> Result<Point<T, D>, CentralProjectionError> {
        let no_image = || CentralProjectionError::NoImage {
            point: point.to_string(),
            centre: self.centre.to_string(),
        };
        let direction = point.difference(&self.centre);
        let slope = std::iter::zip(direction.iter(), self.onto.normal().iter())
            .fold(T::zero(), |sum, (x, m)| sum + x.clone() * m.clone());
        if slope.is_zero() {
            return Err(no_image());
        }
        let factor = -self.onto.value(&self.centre) / slope;
        let image = self.centre.translated(&(direction * factor));
        if image.coordinates().iter().all(Scalar::is_finite) {
            Ok(image)
        } else {
            Err(no_image())
        }
    }
}
