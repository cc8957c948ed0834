//! Positions in a figure: what can be drawn at.

use crate::affine::{Point, Vector};

/// A position in the plane of a figure.
pub type Place = Point<f64, 2>;

/// What has a position in a figure.
///
/// A [`Vector`] is shown as the point that it leads to from the origin; that is how a hodograph is drawn.
pub trait Position {
    /// The abscissa and the ordinate.
    fn position(&self) -> [f64; 2];
}

impl Position for Place {
    fn position(&self) -> [f64; 2] {
        [self[0], self[1]]
    }
}

impl Position for Vector<f64, 2> {
    fn position(&self) -> [f64; 2] {
        [self[0], self[1]]
    }
}

impl Position for [f64; 2] {
    fn position(&self) -> [f64; 2] {
        *self
    }
}

impl Position for (f64, f64) {
    fn position(&self) -> [f64; 2] {
        [self.0, self.1]
    }
}

impl<P: Position + ?Sized> Position for &P {
    fn position(&self) -> [f64; 2] {
        (**self).position()
    }
}

/// The midpoint of two positions: where the label of a segment goes.
///
/// ```
/// use cagd::affine::Point;
/// assert_eq!(cagd::figure::midpoint([0.0, 2.0], [4.0, 4.0]), Point::new([2.0, 3.0]));
/// ```
#[must_use]
pub fn midpoint(a: impl Position, b: impl Position) -> Place {
    let ([ax, ay], [bx, by]) = (a.position(), b.position());
    Place::new([0.5 * (ax + bx), 0.5 * (ay + by)])
}
