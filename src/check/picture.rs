//! A picture of what an answer does: data, to be drawn by whoever can.

use crate::affine::Point;
use crate::scalar::OrderedScalar;

/// What a stroke of a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The input: a control polygon, a set of points.
    Given,
    /// What is right.
    Expected,
    /// What the answer gave.
    Found,
}

/// Points joined by lines; a single point is a dot.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// What it shows.
    pub role: Role,
    /// The points in the plane, in order.
    pub points: Vec<[f64; 2]>,
}

/// The wrong curve beside the right one.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::check::{Picture, Role};
///
/// let picture = Picture::new()
///     .given([Point::new([0.0, 0.0]), Point::new([1.0, 2.0])])
///     .found([Point::new([0.5, 1.0])]);
/// assert_eq!(picture.strokes[1].role, Role::Found);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// What is drawn, in order.
    pub strokes: Vec<Stroke>,
}

impl Picture {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the input, such as a control polygon.
    #[must_use]
    pub fn given<T: OrderedScalar>(self, points: impl IntoIterator<Item = Point<T, 2>>) -> Self {
        self.stroke(Role::Given, points)
    }

    /// Adds what is right.
    #[must_use]
    pub fn expected<T: OrderedScalar>(self, points: impl IntoIterator<Item = Point<T, 2>>) -> Self {
        self.stroke(Role::Expected, points)
    }

    /// Adds what the answer gave.
    #[must_use]
    pub fn found<T: OrderedScalar>(self, points: impl IntoIterator<Item = Point<T, 2>>) -> Self {
        self.stroke(Role::Found, points)
    }

    fn stroke<T: OrderedScalar>(
        mut self,
        role: Role,
        points: impl IntoIterator<Item = Point<T, 2>>,
    ) -> Self {
        let points = points
            .into_iter()
            .map(|point| [point[0].to_f64(), point[1].to_f64()])
            .collect();
        self.strokes.push(Stroke { role, points });
        self
    }
}
