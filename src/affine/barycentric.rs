//! Affine bases and barycentric coordinates.

use thiserror::Error;

use super::{Affine, CombinationError, Frame, Point};
use crate::scalar::Scalar;

/// D + 1 points of dimension D that do not lie in a hyperplane: the corners of a simplex.
///
/// Every point is exactly one affine combination of them; the coefficients are its barycentric
/// coordinates.
///
/// ```text
/// x = Σ λᵢ·pᵢ,   Σ λᵢ = 1
/// ```
///
/// # Examples
///
/// ```
/// use cagd::affine::{AffineBasis, Point};
///
/// let triangle = AffineBasis::new([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(Point::new))?;
/// assert_eq!(triangle.coordinates(&Point::new([1.0, 2.0])), [0.25, 0.25, 0.5]);
/// assert_eq!(triangle.coordinates(&Point::new([4.0, 4.0])), [-1.0, 1.0, 1.0], "outside: a negative one");
/// # Ok::<(), cagd::affine::AffineBasisError>(())
/// ```
///
/// Source: `farin2002`, §2.6.
#[derive(Debug, Clone, PartialEq)]
pub struct AffineBasis<T: Scalar, const D: usize> {
    points: Vec<Point<T, D>>,
}

/// Why points are no affine basis.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum AffineBasisError {
    /// There are too few or too many points.
    #[error("an affine basis of dimension {dimension} needs {} points, found {found}", dimension + 1)]
    Count {
        /// The dimension of the space.
        dimension: usize,
        /// How many points were given.
        found: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error(
        "point {index} of the affine basis is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which point, counted from 0.
        index: usize,
        /// The point.
        point: String,
    },
    /// The points lie in a hyperplane (on a line, if there are three in the plane).
    #[error(
        "the points {points} are no affine basis: they lie in a common hyperplane, as far as rounding can tell; move one of them out of it"
    )]
    Dependent {
        /// The points.
        points: String,
    },
}

impl<T: Scalar, const D: usize> AffineBasis<T, D> {
    /// The basis of these D + 1 points.
    ///
    /// Over rounded numbers, points so close to a hyperplane that rounding could have put them there are refused:
    /// coordinates with respect to them would consist of rounding errors.
    ///
    /// # Errors
    ///
    /// [`AffineBasisError`] if their number is wrong, a coordinate is not finite, or they lie in a hyperplane.
    ///
    /// ```
    /// use cagd::affine::{AffineBasis, AffineBasisError, Point};
    ///
    /// let collinear = AffineBasis::new([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]].map(Point::new));
    /// assert!(matches!(collinear, Err(AffineBasisError::Dependent { .. })));
    ///
    /// let two = AffineBasis::new([[0.0, 0.0], [1.0, 1.0]].map(Point::new)).unwrap_err();
    /// assert_eq!(two.to_string(), "an affine basis of dimension 2 needs 3 points, found 2");
    /// ```
    pub fn new(points: impl IntoIterator<Item = Point<T, D>>) -> Result<Self, AffineBasisError> {
        let points: Vec<_> = points.into_iter().collect();
        if points.len() != D + 1 {
            return Err(AffineBasisError::Count {
                dimension: D,
                found: points.len(),
            });
        }
        for (index, point) in points.iter().enumerate() {
            if !point.coordinates().iter().all(Scalar::is_finite) {
                return Err(AffineBasisError::NotFinite {
                    index,
                    point: point.to_string(),
                });
            }
        }
        let basis = Self { points };
        if basis.frame().is_regular() {
            Ok(basis)
        } else {
            let points: Vec<String> = basis.points.iter().map(ToString::to_string).collect();
            Err(AffineBasisError::Dependent {
                points: points.join(", "),
            })
        }
    }

    /// The points of the basis.
    #[must_use]
    pub fn points(&self) -> &[Point<T, D>] {
        &self.points
    }

    /// The barycentric coordinates λ₀ … λ_D of a point. Over rationals they are exact.
    ///
    /// For `f64` they come from elimination with pivoting, and λ₀ = 1 − λ₁ − … − λ_D.
    #[must_use]
    pub fn coordinates(&self, point: &Point<T, D>) -> Vec<T> {
        let others = self.frame().coordinates(point);
        let first = others
            .iter()
            .fold(T::one(), |rest, coordinate| rest - coordinate.clone());
        std::iter::once(first).chain(others).collect()
    }

    /// The point Σ λᵢ·pᵢ with these barycentric coordinates.
    ///
    /// # Errors
    ///
    /// [`CombinationError::Count`] if there are not D + 1 coordinates, [`CombinationError`] if their sum is not 1.
    ///
    /// ```
    /// use cagd::affine::{AffineBasis, CombinationError, Point};
    ///
    /// let triangle = AffineBasis::<f64, 2>::standard();
    /// assert_eq!(triangle.point(&[0.25, 0.5, 0.25])?, Point::new([0.5, 0.25]));
    /// assert!(matches!(triangle.point(&[0.5, 0.5]), Err(CombinationError::Count { expected: 3, found: 2 })));
    /// assert!(matches!(triangle.point(&[1.0, 1.0, 1.0]), Err(CombinationError::WeightSum { .. })));
    /// # Ok::<(), CombinationError>(())
    /// ```
    pub fn point(&self, coordinates: &[T]) -> Result<Point<T, D>, CombinationError> {
        if coordinates.len() != D + 1 {
            return Err(CombinationError::Count {
                expected: D + 1,
                found: coordinates.len(),
            });
        }
        Point::affine_combination(std::iter::zip(
            coordinates.iter().cloned(),
            self.points.iter().cloned(),
        ))
    }

    /// The frame of the first point and of the vectors from there to the others.
    #[must_use]
    pub fn frame(&self) -> Frame<T, D> {
        let axis = |i: usize| self.points[i + 1].difference(&self.points[0]);
        Frame::trusted(self.points[0].clone(), std::array::from_fn(axis))
    }

    /// The basis of the origin and the unit points of the axes.
    #[must_use]
    pub fn standard() -> Self {
        let unit = |i: usize| {
            Point::new(std::array::from_fn(|k| {
                if k + 1 == i { T::one() } else { T::zero() }
            }))
        };
        Self {
            points: (0..=D).map(unit).collect(),
        }
    }
}
