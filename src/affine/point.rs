//! Points and vectors as two types.

use std::fmt;
use std::ops::{Add, AddAssign, Index, Sub, SubAssign};

use crate::scalar::Scalar;

/// A displacement in dimension `D`: what may be added, scaled and negated.
///
/// This is nalgebra's column vector.
pub type Vector<T, const D: usize> = nalgebra::SVector<T, D>;

/// A position in dimension `D`.
///
/// Points are not vectors: the sum of two points, or twice a point, would change with the origin.
/// So only three operations exist,
///
/// ```text
/// Point − Point  = Vector
/// Point + Vector = Point
/// Point − Vector = Point
/// ```
///
/// and sums with coefficient sum 1 come from [`Affine`](crate::affine::Affine).
/// (nalgebra's own `Point` allows `2.0 * point` and `-point`; that is why this is a type of its own.)
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, Vector};
///
/// let p = Point::new([1.0, 2.0]);
/// let q = Point::new([4.0, 6.0]);
/// assert_eq!(q - p, Vector::from([3.0, 4.0]));
/// assert_eq!(p + (q - p), q);
/// ```
///
/// ```compile_fail,E0308
/// # use cagd::affine::Point;
/// let sum = Point::new([1.0, 2.0]) + Point::new([4.0, 6.0]);
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Point<T: Scalar, const D: usize> {
    coordinates: Vector<T, D>,
}

impl<T: Scalar, const D: usize> Point<T, D> {
    /// The point with these coordinates.
    pub fn new(coordinates: impl Into<[T; D]>) -> Self {
        Self {
            coordinates: Vector::from(coordinates.into()),
        }
    }

    /// The origin of the coordinate system.
    #[must_use]
    pub fn origin() -> Self {
        Self {
            coordinates: Vector::zeros(),
        }
    }

    /// The coordinates, in order.
    #[must_use]
    pub fn coordinates(&self) -> &[T] {
        self.coordinates.as_slice()
    }

    /// The displacement from the origin to this point.
    #[must_use]
    pub fn from_origin(&self) -> Vector<T, D> {
        self.coordinates.clone()
    }

    /// The same point with every coordinate converted by `convert`.
    #[must_use]
    pub fn map<U: Scalar>(&self, convert: impl FnMut(T) -> U) -> Point<U, D> {
        Point {
            coordinates: self.coordinates.map(convert),
        }
    }
}

impl<T: Scalar, const D: usize> fmt::Debug for Point<T, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Writes `(x, y, …)`, exact numbers as fractions.
impl<T: Scalar, const D: usize> fmt::Display for Point<T, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("(")?;
        for (k, coordinate) in self.coordinates().iter().enumerate() {
            if k > 0 {
                f.write_str(", ")?;
            }
            fmt::Display::fmt(coordinate, f)?;
        }
        f.write_str(")")
    }
}

impl<T: Scalar, const D: usize> From<[T; D]> for Point<T, D> {
    fn from(coordinates: [T; D]) -> Self {
        Self::new(coordinates)
    }
}

impl<T: Scalar, const D: usize> Index<usize> for Point<T, D> {
    type Output = T;

    fn index(&self, k: usize) -> &T {
        &self.coordinates[k]
    }
}

impl<T: Scalar, const D: usize> Sub for Point<T, D> {
    type Output = Vector<T, D>;

    fn sub(self, other: Self) -> Vector<T, D> {
        self.coordinates - other.coordinates
    }
}

impl<T: Scalar, const D: usize> Add<Vector<T, D>> for Point<T, D> {
    type Output = Self;

    fn add(self, displacement: Vector<T, D>) -> Self {
        Self {
            coordinates: self.coordinates + displacement,
        }
    }
}

impl<T: Scalar, const D: usize> Sub<Vector<T, D>> for Point<T, D> {
    type Output = Self;

    fn sub(self, displacement: Vector<T, D>) -> Self {
        Self {
            coordinates: self.coordinates - displacement,
        }
    }
}

impl<T: Scalar, const D: usize> AddAssign<Vector<T, D>> for Point<T, D> {
    fn add_assign(&mut self, displacement: Vector<T, D>) {
        self.coordinates += displacement;
    }
}

impl<T: Scalar, const D: usize> SubAssign<Vector<T, D>> for Point<T, D> {
    fn sub_assign(&mut self, displacement: Vector<T, D>) {
        self.coordinates -= displacement;
    }
}
