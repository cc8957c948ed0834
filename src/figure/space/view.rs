//! Looking at space: from where, and where a point of it stands in the picture.

use crate::affine::{Point, Vector};
use crate::figure::place::Place;

/// A view of space: the vertical axis is z, and a rotation about it and an inclination say from where one looks.
///
/// At yaw 0 and pitch 0 one looks along y: x points to the right, z upwards.
/// Yaw turns the objects about the z-axis, their front to the right; pitch raises the eye, at a right angle up to the top.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::figure::View;
///
/// let front = View::degrees(0.0, 0.0);
/// assert_eq!(front.place(&Point::new([1.0, 5.0, 2.0])), Point::new([1.0, 2.0]));
/// let plan = View::from_above();
/// assert_eq!(plan.place(&Point::new([1.0, 5.0, 2.0])), Point::new([1.0, 5.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    yaw: f64,
    pitch: f64,
    /// To the right, upwards, and towards the eye.
    axes: [[f64; 3]; 3],
    /// How far the eye is from the origin; infinitely far if `None`.
    distance: Option<f64>,
}

impl View {
    /// A view by angles in radians, the eye infinitely far away.
    #[must_use]
    pub fn new(yaw: f64, pitch: f64) -> Self {
        let ((sy, cy), (sp, cp)) = (
            (libm::sin(yaw), libm::cos(yaw)),
            (libm::sin(pitch), libm::cos(pitch)),
        );
        View {
            yaw,
            pitch,
            axes: [
                [cy, -sy, 0.0],
                [sy * sp, cy * sp, cp],
                [-sy * cp, -cy * cp, sp],
            ],
            distance: None,
        }
    }

    /// A view by angles in degrees.
    #[must_use]
    pub fn degrees(yaw: f64, pitch: f64) -> Self {
        Self::new(yaw.to_radians(), pitch.to_radians())
    }

    /// The view from above: the picture shows x to the right and y upwards.
    #[must_use]
    pub fn from_above() -> Self {
        View {
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            ..Self::degrees(0.0, 90.0)
        }
    }

    /// The same view in perspective, from an eye at this distance from the origin; it must lie in front of everything.
    #[must_use]
    pub fn from_distance(self, distance: f64) -> Self {
        View {
            distance: Some(distance),
            ..self
        }
    }

    /// Where the handle is that turns the view: drag it, and the front of a ball with this radius follows.
    ///
    /// ```
    /// use cagd::figure::View;
    /// let view = View::new(0.5, 0.25);
    /// assert_eq!(View::of_knob(view.knob(2.0), 2.0), view);
    /// ```
    #[must_use]
    pub fn knob(&self, radius: f64) -> Place {
        Place::new([radius * self.yaw, -radius * self.pitch])
    }

    /// The view that a handle at this place asks for; see [`knob`](Self::knob).
    #[must_use]
    pub fn of_knob(place: Place, radius: f64) -> Self {
        Self::new(place[0] / radius, -place[1] / radius)
    }

    /// Coordinates to the right, upwards and towards the eye.
    #[must_use]
    pub fn seen(&self, point: &Point<f64, 3>) -> Vector<f64, 3> {
        let coordinate = |axis: &[f64; 3]| (0..3).map(|k| axis[k] * point[k]).sum();
        Vector::from([0, 1, 2].map(|k: usize| coordinate(&self.axes[k])))
    }

    /// Where a point stands in the picture.
    #[must_use]
    pub fn place(&self, point: &Point<f64, 3>) -> Place {
        let seen = self.seen(point);
        let scale = match self.distance {
            None => 1.0,
            Some(distance) => distance / (distance - seen[2]),
        };
        Place::new([seen[0] * scale, seen[1] * scale])
    }
}
