//! The affine maps with names: scalings, rotations, shears, parallel projections.

use nalgebra::SMatrix;
use thiserror::Error;

use super::{Affine, AffineMap, Hyperplane, Point, Vector};
use crate::scalar::{OrderedScalar, Real, Scalar};

/// Why there is no such parallel projection.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ParallelProjectionError {
    /// The direction is parallel to the hyperplane, or zero.
    #[error(
        "a projection along {direction} does not meet the hyperplane of normal {normal}; choose a direction that leads out of it"
    )]
    ParallelToHyperplane {
        /// The direction.
        direction: String,
        /// The normal vector of the hyperplane.
        normal: String,
    },
}

impl<T: Scalar, const D: usize> AffineMap<T, D, D> {
    /// The map with this linear part that leaves the origin where it is.
    fn fixing_the_origin(entry: impl Fn(usize, usize) -> T) -> Self {
        let rows = std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)));
        Self::new(rows, std::array::from_fn(|_| T::zero()))
    }

    /// Scales each coordinate by a factor of its own; the origin stays.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let scaling = AffineMap::scaling([2.0, -1.0]);
    /// assert_eq!(scaling.point(&Point::new([3.0, 3.0])), Point::new([6.0, -3.0]));
    /// ```
    #[must_use]
    pub fn scaling(factors: [T; D]) -> Self {
        Self::fixing_the_origin(|row, column| {
            if row == column {
                factors[row].clone()
            } else {
                T::zero()
            }
        })
    }

    /// Scales by one factor from a centre: x ↦ c + k·(x − c).
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let half_way = AffineMap::homothety(&Point::new([4.0, 4.0]), 0.5);
    /// assert_eq!(half_way.point(&Point::new([4.0, 4.0])), Point::new([4.0, 4.0]));
    /// assert_eq!(half_way.point(&Point::new([0.0, 2.0])), Point::new([2.0, 3.0]));
    /// ```
    #[must_use]
    pub fn homothety(centre: &Point<T, D>, factor: T) -> Self {
        Self::scaling(std::array::from_fn(|_| factor.clone())).about(centre)
    }

    /// The same map with `centre` in the role of the origin: x ↦ c + α(x − c).
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let quarter_turn = AffineMap::new([[0.0, -1.0], [1.0, 0.0]], [0.0, 0.0]);
    /// let about = quarter_turn.about(&Point::new([1.0, 1.0]));
    /// assert_eq!(about.point(&Point::new([2.0, 1.0])), Point::new([1.0, 2.0]));
    /// ```
    #[must_use]
    pub fn about(&self, centre: &Point<T, D>) -> Self {
        let centre = centre.from_origin();
        Self::translating(centre.clone()).after(&self.after(&Self::translating(-centre)))
    }

    /// The projection onto a hyperplane along a direction: each point moves parallel to it into the hyperplane.
    ///
    /// ```text
    /// x ↦ x − v·(⟨x, m⟩ − c)/⟨v, m⟩   for the hyperplane ⟨X, m⟩ = c
    /// ```
    ///
    /// With the normal vector as direction it is the orthogonal projection.
    ///
    /// # Errors
    ///
    /// [`ParallelProjectionError`] if the direction is parallel to the hyperplane or zero.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Line, Point, Vector};
    ///
    /// let axis = Line::new([0.0, 1.0], 0.0)?;
    /// let shadow = AffineMap::parallel_projection(&axis, &Vector::from([1.0, -1.0]))?;
    /// assert_eq!(shadow.point(&Point::new([1.0, 3.0])), Point::new([4.0, 0.0]));
    /// assert!(AffineMap::parallel_projection(&axis, &Vector::from([1.0, 0.0])).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parallel_projection(
        onto: &Hyperplane<T, D>,
        along: &Vector<T, D>,
    ) -> Result<Self, ParallelProjectionError> {
        let normal = onto.normal();
        let slope = std::iter::zip(along.iter(), normal.iter())
            .fold(T::zero(), |sum, (v, m)| sum + v.clone() * m.clone());
        if slope.is_zero() {
            let written = |vector: &Vector<T, D>| Point::origin().translated(vector).to_string();
            return Err(ParallelProjectionError::ParallelToHyperplane {
                direction: written(along),
                normal: written(normal),
            });
        }
        let step = |k: usize| along[k].clone() / slope.clone();
        let rows = std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let kept = if row == column { T::one() } else { T::zero() };
                kept - step(row) * normal[column].clone()
            })
        });
        let translation = std::array::from_fn(|row| step(row) * onto.offset().clone());
        Ok(Self::new(rows, translation))
    }

    /// The determinant of the linear part: by how much the map multiplies areas (in space, volumes).
    ///
    /// It is computed without division, by expansion along the first row: exact for whole numbers in `f64`
    /// that stay below 2⁵³.
    ///
    /// ```
    /// use cagd::affine::AffineMap;
    ///
    /// assert_eq!(AffineMap::new([[2.0, 1.0], [1.0, 3.0]], [7.0, 7.0]).determinant(), 5.0);
    /// assert_eq!(AffineMap::scaling([2.0, 3.0, -1.0]).determinant(), -6.0);
    /// ```
    #[must_use]
    pub fn determinant(&self) -> T {
        let columns: Vec<usize> = (0..D).collect();
        minor(self.linear(), 0, &columns)
    }

    /// Whether the map is bijective: whether its determinant is not 0.
    #[must_use]
    pub fn is_affinity(&self) -> bool {
        !self.determinant().is_zero()
    }

    /// Whether the map keeps all distances: AᵀA = I. A question for exact numbers.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Vector};
    ///
    /// assert!(AffineMap::translating(Vector::from([1.0, 2.0])).is_motion());
    /// assert!(!AffineMap::shear(1.0).is_motion());
    /// ```
    #[must_use]
    pub fn is_motion(&self) -> bool {
        self.linear().transpose() * self.linear() == *Self::identity().linear()
    }

    /// Whether doing it twice is doing it once, α∘α = α, as for projections. A question for exact numbers.
    #[must_use]
    pub fn is_idempotent(&self) -> bool {
        self.after(self) == *self
    }
}

/// The determinant of the rows from `row` on, in the given columns.
fn minor<T: Scalar, const D: usize>(matrix: &SMatrix<T, D, D>, row: usize, columns: &[usize]) -> T {
    let mut sum = T::zero();
    for (i, &column) in columns.iter().enumerate() {
        let mut others = columns.to_vec();
        others.remove(i);
        let term = matrix[(row, column)].clone() * minor(matrix, row + 1, &others);
        if i % 2 == 0 {
            sum += term;
        } else {
            sum -= term;
        }
    }
    if columns.is_empty() { T::one() } else { sum }
}

impl<T: Scalar> AffineMap<T, 2, 2> {
    /// The shear along the first axis: (x, y) ↦ (x + a·y, y).
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let shear = AffineMap::shear(0.5);
    /// assert_eq!(shear.point(&Point::new([1.0, 2.0])), Point::new([2.0, 2.0]));
    /// assert_eq!(shear.determinant(), 1.0);
    /// ```
    #[must_use]
    pub fn shear(a: T) -> Self {
        let (zero, one) = (T::zero, T::one);
        Self::new([[one(), a], [zero(), one()]], [zero(), zero()])
    }
}

impl<T: OrderedScalar> AffineMap<T, 2, 2> {
    /// The rotation about the origin by the angle 2·arctan q, whose matrix has rational entries if q is rational.
    ///
    /// ```text
    /// cos = (1 − q²)/(1 + q²),   sin = 2q/(1 + q²)
    /// ```
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let turn = AffineMap::rational_rotation(0.5);
    /// assert_eq!(turn.point(&Point::new([5.0, 0.0])), Point::new([3.0, 4.0]));
    /// ```
    ///
    /// Over `f64` the square of q must be finite: |q| < 10¹⁵⁴.
    #[must_use]
    pub fn rational_rotation(q: T) -> Self {
        let (zero, one) = (T::zero, T::one);
        let square = q.clone() * q.clone();
        let length = one() + square.clone();
        let cosine = (one() - square) / length.clone();
        let sine = (q.clone() + q) / length;
        Self::new(
            [[cosine.clone(), -sine.clone()], [sine, cosine]],
            [zero(), zero()],
        )
    }
}

impl<T: Real> AffineMap<T, 2, 2> {
    /// The rotation about the origin by an angle in radians, counterclockwise.
    #[must_use]
    pub fn rotation(angle: T) -> Self {
        let (cosine, sine) = (angle.cos(), angle.sin());
        Self::new([[cosine, -sine], [sine, cosine]], [T::zero(), T::zero()])
    }
}

impl<T: Scalar> AffineMap<T, 3, 3> {
    /// The shear of space with the rows (1, a, b), (0, 1, c) and (0, 0, 1).
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let shear = AffineMap::spatial_shear(1.0, 2.0, 3.0);
    /// assert_eq!(shear.point(&Point::new([0.0, 1.0, 1.0])), Point::new([3.0, 4.0, 1.0]));
    /// assert_eq!(shear.determinant(), 1.0);
    /// ```
    #[must_use]
    pub fn spatial_shear(a: T, b: T, c: T) -> Self {
        let (zero, one) = (T::zero, T::one);
        let rows = [[one(), a, b], [zero(), one(), c], [zero(), zero(), one()]];
        Self::new(rows, [zero(), zero(), zero()])
    }
}

impl<T: Real> AffineMap<T, 3, 3> {
    /// The rotation about the third axis by an angle in radians, counterclockwise as seen from above.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    ///
    /// let turn = AffineMap::rotation_about_z(std::f64::consts::FRAC_PI_2);
    /// let image = turn.point(&Point::new([1.0, 0.0, 5.0]));
    /// assert!((image - Point::new([0.0, 1.0, 5.0])).norm() < 1e-15, "the sine and the cosine are rounded");
    /// ```
    #[must_use]
    pub fn rotation_about_z(angle: T) -> Self {
        let (cosine, sine) = (angle.cos(), angle.sin());
        let (zero, one) = (T::zero, T::one);
        let rows = [
            [cosine, -sine, zero()],
            [sine, cosine, zero()],
            [zero(), zero(), one()],
        ];
        Self::new(rows, [zero(), zero(), zero()])
    }
}
