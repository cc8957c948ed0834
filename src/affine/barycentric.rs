//! Affine bases and barycentric coordinates.

use thiserror::Error;

use super::elimination::solve;
use super::{Affine, Point};
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
        "the points {points} are no affine basis: they lie in a common hyperplane; move one of them out of it"
    )]
    Dependent {
        /// The points.
        points: String,
    },
}

impl<T: Scalar, const D: usize> AffineBasis<T, D> {
    /// The basis of these D + 1 points.
    ///
    /// Over rounded numbers, points that miss a hyperplane by a rounding error only may be accepted;
    /// coordinates with respect to them are large and inaccurate, as they are for every method.
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
        if basis.solve(&basis.points[0]).is_some() {
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
        let others = self
            .solve(point)
            .expect("the constructor has seen that the points are independent");
        let first = others
            .iter()
            .fold(T::one(), |rest, coordinate| rest - coordinate.clone());
        std::iter::once(first).chain(others).collect()
    }

    /// The point Σ λᵢ·pᵢ with these barycentric coordinates.
    ///
    /// # Errors
    ///
    /// [`CombinationError`](super::CombinationError) if their sum is not 1.
    ///
    /// # Panics
    ///
    /// If there are not D + 1 coordinates.
    pub fn point(&self, coordinates: &[T]) -> Result<Point<T, D>, super::CombinationError> {
        assert_eq!(
            coordinates.len(),
            D + 1,
            "a point of dimension {D} has {} barycentric coordinates",
            D + 1
        );
        Point::affine_combination(std::iter::zip(
            coordinates.iter().cloned(),
            self.points.iter().cloned(),
        ))
    }

    /// Solves Σᵢ₌₁ λᵢ·(pᵢ − p₀) = x − p₀; `None` if the differences are dependent.
    fn solve(&self, point: &Point<T, D>) -> Option<Vec<T>> {
        let origin = &self.points[0];
        let edges: Vec<_> = self.points[1..]
            .iter()
            .map(|p| p.difference(origin))
            .collect();
        let target = point.difference(origin);
        let matrix = (0..D).map(|k| edges.iter().map(|edge| edge[k].clone()).collect());
        let right = (0..D).map(|k| vec![target[k].clone()]);
        let solution = solve(matrix.collect(), right.collect())?;
        Some(solution.into_iter().flatten().collect())
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
