//! A straight piece of something drawn, which a label should not cover.

use super::clip::Rect;

/// A segment in units of the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    from: [f64; 2],
    to: [f64; 2],
    /// How much it disturbs a label that it crosses.
    pub(super) weight: f64,
    /// The smallest rectangle around it: most strokes are told from a label by it, without a division.
    bounds: Rect,
}

impl Stroke {
    pub(super) fn new(from: [f64; 2], to: [f64; 2], weight: f64) -> Self {
        Self {
            from,
            to,
            weight,
            bounds: Rect::around(from, to),
        }
    }

    /// Whether the rectangle around it meets another one: if not, the stroke does not.
    pub(super) fn may_meet(&self, rect: &Rect) -> bool {
        self.bounds.meets(rect)
    }

    /// Its length as the sum of both coordinates.
    pub(super) fn length(&self) -> f64 {
        (self.to[0] - self.from[0]).abs() + (self.to[1] - self.from[1]).abs()
    }

    /// Which part of it lies in a rectangle, of 1.
    pub(super) fn part_inside(&self, rect: &Rect) -> Option<f64> {
        if !self.may_meet(rect) {
            return None;
        }
        let (enter, leave) = rect.inside(self.from, self.to)?;
        Some(leave - enter)
    }
}
