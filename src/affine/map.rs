//! Affine maps.

use nalgebra::SMatrix;
use thiserror::Error;

use super::elimination::solve;
use super::{Affine, AffineBasis, Point, Vector};
use crate::scalar::Scalar;

/// An affine map from dimension `FROM` to dimension `TO`.
///
/// ```text
/// α(x) = A·x + a
/// ```
///
/// Points are mapped by α, vectors by the linear part A alone.
///
/// # Examples
///
/// ```
/// use cagd::affine::{AffineMap, Point, Vector};
///
/// let shear = AffineMap::new([[1.0, 0.5], [0.0, 1.0]], [3.0, 0.0]);
/// assert_eq!(shear.point(&Point::new([1.0, 2.0])), Point::new([5.0, 2.0]));
/// assert_eq!(shear.vector(&Vector::from([1.0, 2.0])), Vector::from([2.0, 2.0]));
/// ```
///
/// Source: `farin2002`, §2.2.
#[derive(Debug, Clone, PartialEq)]
pub struct AffineMap<T: Scalar, const FROM: usize, const TO: usize> {
    linear: SMatrix<T, TO, FROM>,
    translation: Vector<T, TO>,
}

/// Why there is no such affine map.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum AffineMapError {
    /// Not one image for each point of the basis.
    #[error(
        "an affine map is determined by one image for each of the {expected} points of a basis, found {found}"
    )]
    ImageCount {
        /// How many points the basis has.
        expected: usize,
        /// How many images were given.
        found: usize,
    },
    /// The linear part is singular, so points are mapped on top of each other.
    #[error("the affine map has no inverse: its linear part {linear} is singular")]
    Singular {
        /// The rows of the linear part.
        linear: String,
    },
    /// An entry of the map is NaN, infinite, or beyond the range of the number type.
    #[error(
        "an entry of the affine map is not finite: linear part {linear}, translation {translation}"
    )]
    NotFinite {
        /// The rows of the linear part.
        linear: String,
        /// The translation.
        translation: String,
    },
}

impl<T: Scalar, const FROM: usize, const TO: usize> AffineMap<T, FROM, TO> {
    /// The map with the rows of the linear part A and the translation a.
    pub fn new(rows: [[T; FROM]; TO], translation: impl Into<[T; TO]>) -> Self {
        Self {
            linear: SMatrix::from_fn(|row, column| rows[row][column].clone()),
            translation: Vector::from(translation.into()),
        }
    }

    /// The one affine map that takes each point of a basis to the image given for it.
    ///
    /// # Errors
    ///
    /// [`AffineMapError::ImageCount`] if there is not one image a point,
    /// [`AffineMapError::NotFinite`] if an entry of the map is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::{AffineBasis, AffineMap, Point};
    ///
    /// let basis = AffineBasis::new([[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]].map(Point::new))?;
    /// let images = [[0.0, 0.0], [0.0, 1.0], [-1.0, 0.0]].map(Point::new);
    /// let quarter_turn = AffineMap::from_images(&basis, &images)?;
    /// assert_eq!(quarter_turn.point(&Point::new([3.0, 1.0])), Point::new([0.0, 2.0]));
    /// assert!(AffineMap::from_images(&basis, &images[1..]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_images(
        basis: &AffineBasis<T, FROM>,
        images: &[Point<T, TO>],
    ) -> Result<Self, AffineMapError> {
        if images.len() != FROM + 1 {
            return Err(AffineMapError::ImageCount {
                expected: FROM + 1,
                found: images.len(),
            });
        }
        let points = basis.points();
        // A·(pᵢ − p₀) = qᵢ − q₀, transposed: row i of the system holds pᵢ − p₀.
        let rows = points[1..].iter().map(|p| p.difference(&points[0]));
        let right = images[1..].iter().map(|q| q.difference(&images[0]));
        let transposed = solve(
            rows.map(|row| row.as_slice().to_vec()).collect(),
            right.map(|row| row.as_slice().to_vec()).collect(),
        )
        .expect("the points of an affine basis are independent");
        let linear = SMatrix::from_fn(|row, column| transposed[column][row].clone());
        let translation = images[0].from_origin() - &linear * points[0].from_origin();
        Self {
            linear,
            translation,
        }
        .finite()
    }

    /// The linear part A.
    #[must_use]
    pub fn linear(&self) -> &SMatrix<T, TO, FROM> {
        &self.linear
    }

    /// The translation a, the image of the origin as seen from the origin.
    #[must_use]
    pub fn translation(&self) -> &Vector<T, TO> {
        &self.translation
    }

    /// The image A·x + a of a point.
    #[must_use]
    pub fn point(&self, point: &Point<T, FROM>) -> Point<T, TO> {
        Point::origin() + (&self.linear * point.from_origin() + &self.translation)
    }

    /// The image A·v of a vector: translations do not move vectors.
    #[must_use]
    pub fn vector(&self, vector: &Vector<T, FROM>) -> Vector<T, TO> {
        &self.linear * vector
    }

    /// The map that first applies `first` and then this one.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let double = AffineMap::new([[2.0]], [0.0]);
    /// let next = AffineMap::new([[1.0]], [1.0]);
    /// assert_eq!(double.after(&next).point(&Point::new([3.0])), Point::new([8.0]));
    /// assert_eq!(next.after(&double).point(&Point::new([3.0])), Point::new([7.0]));
    /// ```
    #[must_use]
    pub fn after<const START: usize>(
        &self,
        first: &AffineMap<T, START, FROM>,
    ) -> AffineMap<T, START, TO> {
        AffineMap {
            linear: &self.linear * &first.linear,
            translation: &self.linear * &first.translation + &self.translation,
        }
    }

    fn finite(self) -> Result<Self, AffineMapError> {
        let entries = self.linear.iter().chain(self.translation.iter());
        if entries.into_iter().all(Scalar::is_finite) {
            Ok(self)
        } else {
            Err(AffineMapError::NotFinite {
                linear: self.rows(),
                translation: format!("{:?}", self.translation.as_slice()),
            })
        }
    }

    /// The rows of the linear part as `[[a, b], [c, d]]`.
    fn rows(&self) -> String {
        let row = |row: usize| {
            let entries = (0..FROM).map(|column| self.linear[(row, column)].to_string());
            format!("[{}]", entries.collect::<Vec<_>>().join(", "))
        };
        format!("[{}]", (0..TO).map(row).collect::<Vec<_>>().join(", "))
    }
}

impl<T: Scalar, const D: usize> AffineMap<T, D, D> {
    /// The map that moves nothing.
    #[must_use]
    pub fn identity() -> Self {
        Self {
            linear: SMatrix::from_fn(
                |row, column| if row == column { T::one() } else { T::zero() },
            ),
            translation: Vector::zeros(),
        }
    }

    /// The map that moves every point by the same vector.
    #[must_use]
    pub fn translating(by: Vector<T, D>) -> Self {
        Self {
            translation: by,
            ..Self::identity()
        }
    }

    /// The map that undoes this one.
    ///
    /// # Errors
    ///
    /// [`AffineMapError::Singular`] if different points have the same image,
    /// [`AffineMapError::NotFinite`] if an entry of the inverse is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, AffineMapError, Point};
    ///
    /// let shear = AffineMap::new([[1.0, 2.0], [0.0, 1.0]], [3.0, 4.0]);
    /// assert_eq!(shear.inverse()?.after(&shear), AffineMap::identity());
    ///
    /// let projection = AffineMap::new([[1.0, 0.0], [0.0, 0.0]], [0.0, 0.0]);
    /// assert!(matches!(projection.inverse(), Err(AffineMapError::Singular { .. })));
    /// # Ok::<(), AffineMapError>(())
    /// ```
    pub fn inverse(&self) -> Result<Self, AffineMapError> {
        let entry = |row: usize, column: usize| self.linear[(row, column)].clone();
        let unit = |row: usize, column: usize| if row == column { T::one() } else { T::zero() };
        let matrix = (0..D).map(|row| (0..D).map(|column| entry(row, column)).collect());
        let right = (0..D).map(|row| (0..D).map(|column| unit(row, column)).collect());
        let inverse =
            solve(matrix.collect(), right.collect()).ok_or_else(|| AffineMapError::Singular {
                linear: self.rows(),
            })?;
        let linear = SMatrix::from_fn(|row, column| inverse[row][column].clone());
        let translation = -(&linear * &self.translation);
        Self {
            linear,
            translation,
        }
        .finite()
    }
}
