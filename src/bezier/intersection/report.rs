//! What a search for intersections finds.

use thiserror::Error;

use super::range::Range;
use crate::affine::Interval;
use crate::bezier::bounds::ToleranceError;

/// A box of parameters in which two curves meet, or may meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// The parameters of the first curve.
    pub first: Range,
    /// The parameters of the second curve.
    pub second: Range,
    /// What is known about the box.
    pub kind: Kind,
}

/// What is known about a box of parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// It is proved that the curves meet there exactly once, and cross.
    Certain,
    /// They may meet there, once, more often or not at all; within the tolerance they do.
    Possible,
    /// They agree within the tolerance along these arcs, with proportional parameters.
    Overlap {
        /// Whether they run in opposite directions.
        reversed: bool,
    },
}

/// All places where two curves meet: outside these boxes they do not.
#[derive(Debug, Clone, PartialEq)]
pub struct Intersections {
    /// The places, by the parameter of the first curve.
    pub meetings: Vec<Meeting>,
    /// How many pairs of pieces were looked at.
    pub pairs_seen: usize,
}

impl Intersections {
    /// The boxes of one kind.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Meeting> {
        self.meetings
            .iter()
            .filter(move |meeting| meeting.kind == kind)
    }
}

/// Joins boxes that touch, until none do.
pub(super) fn merged(mut boxes: Vec<[Range; 2]>) -> Vec<[Range; 2]> {
    loop {
        boxes.sort_by(|a, b| a[0].low().total_cmp(&b[0].low()));
        let before = boxes.len();
        let mut joined: Vec<[Range; 2]> = Vec::new();
        for next in boxes {
            let touching = joined
                .iter_mut()
                .rev()
                .find(|other| (0..2).all(|k| other[k].meets(&next[k])));
            match touching {
                Some(other) => *other = [0, 1].map(|k| other[k].hull(&next[k])),
                None => joined.push(next),
            }
        }
        if joined.len() == before {
            return joined;
        }
        boxes = joined;
    }
}

/// A range of local parameters as one of the domain, rounded outwards.
///
/// The map passes 4 roundings of terms of at most max(|a|, |b|), and the two ends of a domain are kept.
pub(super) fn over(domain: &Interval<f64>, local: &Range) -> Range {
    if domain.is_unit() {
        return *local;
    }
    let [low, high] = [local.low(), local.high()].map(|t| domain.global(t));
    let error = 4.0 * f64::EPSILON * domain.start().abs().max(domain.end().abs());
    let whole = Range::new(domain.start(), domain.end());
    let range = Range::new(low, high).widened(error);
    range.common(&whole).unwrap_or(range)
}

/// Why the intersections were not found.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum IntersectionError {
    /// The tolerance is not a positive finite number.
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    /// The coordinates are so large that rounding alone can exceed the tolerance.
    #[error(
        "the tolerance {tolerance:e} is below what rounding leaves, {least:e} for these coordinates; allow more or move the curves to the origin"
    )]
    BelowRounding {
        /// The tolerance.
        tolerance: f64,
        /// The least tolerance that can be kept.
        least: f64,
    },
    /// More pairs of pieces are left than may be looked at.
    #[error(
        "the intersections need more than {most} pairs of pieces; allow more pairs or a larger tolerance, or take the {} boxes found so far, which miss none",
        found.meetings.len()
    )]
    TooMuchWork {
        /// How many pairs were allowed.
        most: usize,
        /// What was found, and the boxes not looked at as possible ones.
        found: Box<Intersections>,
    },
}
