//! On which side of a line a point lies, decided without rounding.

use num_rational::BigRational;
use robust::{Coord, orient2d};

use super::Point;
use crate::scalar::{OrderedScalar, exact};

/// How the way from a over b to c turns at b.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Turn {
    /// Counterclockwise: c lies to the left of the line from a to b.
    Left,
    /// The three points lie on one line.
    Straight,
    /// Clockwise: c lies to the right of the line from a to b.
    Right,
}

impl Turn {
    fn of_sign<T: OrderedScalar>(determinant: &T) -> Self {
        if *determinant > T::zero() {
            Self::Left
        } else if *determinant < T::zero() {
            Self::Right
        } else {
            Self::Straight
        }
    }

    /// The turn of the way back, from c over b to a.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Straight => Self::Straight,
            Self::Right => Self::Left,
        }
    }
}

/// Numbers over which the turn of three points of the plane is decided exactly.
///
/// ```text
/// turn(a, b, c) = sign det(b − a, c − a)
/// ```
///
/// Rationals compute the determinant. For `f64` its rounded value may have the wrong sign, so the
/// adaptive predicate of Shewchuk decides (crate `robust`).
///
/// # Examples
///
/// ```
/// use cagd::affine::{Orient, Point, Turn};
///
/// let [a, b] = [[0.0, 0.0], [1.0, 1.0]].map(Point::new);
/// assert_eq!(f64::turn(&a, &b, &Point::new([0.0, 1.0])), Turn::Left);
/// assert_eq!(f64::turn(&a, &b, &Point::new([7.0, 7.0])), Turn::Straight);
///
/// // So close to the line through b and c that the determinant, rounded, is 0.
/// let [a, b, c] = [[0.5, 0.5 + f64::EPSILON], [12.0, 12.0], [24.0, 24.0]].map(Point::new);
/// let [v, w] = [b - a, c - a];
/// assert_eq!(v[0] * w[1] - v[1] * w[0], 0.0);
/// assert_eq!(f64::turn(&a, &b, &c), Turn::Left);
/// ```
///
/// Source: `shewchuk1997`, §4.2.
pub trait Orient: OrderedScalar {
    /// How the way from `a` over `b` to `c` turns.
    ///
    /// The coordinates must be finite; for NaN the answer has no meaning.
    fn turn(a: &Point<Self, 2>, b: &Point<Self, 2>, c: &Point<Self, 2>) -> Turn;
}

impl Orient for BigRational {
    fn turn(a: &Point<Self, 2>, b: &Point<Self, 2>, c: &Point<Self, 2>) -> Turn {
        let determinant = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
        Turn::of_sign(&determinant)
    }
}

/// 2⁻⁴⁸⁰. Below it a product of two roundoffs, (2⁻⁵²·2⁻⁴⁸⁰)², may fall under 2⁻¹⁰⁷⁴ and be lost.
const SMALLEST: f64 = f64::from_bits((1023 - 480) << 52);

/// 2⁵⁰⁸. Up to it a sum of 16 products of differences stays below 16·(2·2⁵⁰⁸)² = 2¹⁰²².
const LARGEST: f64 = f64::from_bits((1023 + 508) << 52);

impl Orient for f64 {
    fn turn(a: &Point<Self, 2>, b: &Point<Self, 2>, c: &Point<Self, 2>) -> Turn {
        let safe = [a, b, c]
            .iter()
            .flat_map(|point| point.coordinates())
            .all(|&x| x == 0.0 || (SMALLEST..=LARGEST).contains(&x.abs()));
        if safe {
            let [a, b, c] = [a, b, c].map(|point| Coord {
                x: point[0],
                y: point[1],
            });
            Turn::of_sign(&orient2d(a, b, c))
        } else {
            let rational = |point: &Point<Self, 2>| point.map(|x| exact(x).unwrap_or_default());
            BigRational::turn(&rational(a), &rational(b), &rational(c))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_beyond_the_predicate_are_decided_exactly() {
        for scale in [1.0, 1e-150, 1e-300, 1e150, 1e300] {
            let [a, b, c] = [
                [0.0, 0.0],
                [scale, scale],
                [scale, scale * (1.0 + f64::EPSILON)],
            ]
            .map(Point::new);
            assert_eq!(f64::turn(&a, &b, &c), Turn::Left, "size {scale}");
            assert_eq!(f64::turn(&c, &b, &a), Turn::Right, "size {scale}");
            assert_eq!(f64::turn(&a, &b, &b), Turn::Straight, "size {scale}");
        }
    }
}
