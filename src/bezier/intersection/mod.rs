//! Intersections of two plane Bézier curves, by subdivision.
//!
//! Read in this order: this file (the algorithm), [`report`] (what it finds), `contraction` (the proof that a box
//! holds exactly one intersection), `overlap` (common arcs), [`range`] (arithmetic rounded outwards).

mod contraction;
mod overlap;
pub mod range;
pub mod report;

pub use range::Range;
pub use report::{IntersectionError, Intersections, Kind, Meeting};

use contraction::{Pair, Verdict};
use overlap::{Overlap, overlaps};

use super::bounds::{euclidean_norm, halvings, segment_distance_squared};
use super::curve::{BezierCurve, PlaneCurve};
use super::subdivision::halved;
use crate::affine::{Interval, Point};
use crate::scalar::{Scalar, UNIT_ROUNDOFF};

/// How many pairs of pieces are looked at unless the caller says otherwise.
///
/// Two cubics that cross nine times take a few hundred; a common arc of curves that are not seen to overlap takes
/// about as many as its length divided by the root of the tolerance.
pub const MOST_PAIRS: usize = 100_000;

impl PlaneCurve {
    /// All intersections with another curve, as boxes of parameters; none is missed.
    ///
    /// A pair of pieces whose boxes are disjoint is dropped.
    /// A pair in which exactly one intersection is proved gives a [`Kind::Certain`] box.
    /// If both pieces are within ε of their chords, the pair is dropped when the chords are more than 2ε apart,
    /// otherwise it is a [`Kind::Possible`] one, merged with its neighbours: a touch, or a near miss.
    /// Else both are halved.
    /// Arcs that agree within ε all along are found first, as [`Kind::Overlap`].
    ///
    /// `tolerance` is ε, a length.
    ///
    /// # Rounding
    ///
    /// The coordinates are scaled by a power of two to less than 2, which is exact but for numbers below 10⁻³⁰⁰ times
    /// the largest. After k halvings a control point is wrong by at most kn·u; all boxes are larger by that.
    ///
    /// # Errors
    ///
    /// [`IntersectionError`]; if too much work is needed it carries what was found, and nothing is missed in that.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, intersection::Kind};
    ///
    /// let parabola = BezierCurve::new([[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let line = BezierCurve::new([[0.0, 1.5], [4.0, 1.5]].map(Point::new))?;
    /// let found = parabola.intersections(&line, 1e-9)?;
    /// let at: Vec<f64> = found.meetings.iter().map(|meeting| meeting.first.middle()).collect();
    /// assert!((at[0] - 0.25).abs() < 1e-12 && (at[1] - 0.75).abs() < 1e-12);
    /// assert!(found.meetings.iter().all(|meeting| meeting.kind == Kind::Certain));
    ///
    /// let tangent = BezierCurve::new([[0.0, 2.0], [4.0, 2.0]].map(Point::new))?;
    /// let touch = parabola.intersections(&tangent, 1e-9)?;
    /// assert_eq!(touch.meetings.len(), 1);
    /// assert_eq!(touch.meetings[0].kind, Kind::Possible, "a touch cannot be told from a near miss");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `sederberg1986`, `class-notes`, section 4.
    pub fn intersections(
        &self,
        other: &Self,
        tolerance: f64,
    ) -> Result<Intersections, IntersectionError> {
        self.intersections_within(other, tolerance, MOST_PAIRS)
    }

    /// [`intersections`](Self::intersections), looking at no more than `most_pairs` pairs of pieces.
    ///
    /// # Errors
    ///
    /// [`IntersectionError`].
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, intersection::IntersectionError};
    ///
    /// let arch = BezierCurve::new([[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let bowl = BezierCurve::new([[0.0, 4.0], [2.0, 0.0], [4.0, 4.0]].map(Point::new))?;
    /// let Err(IntersectionError::TooMuchWork { found, .. }) = arch.intersections_within(&bowl, 1e-9, 3) else {
    ///     panic!("three pairs cannot be enough for a touch");
    /// };
    /// assert!(found.meetings[0].first.contains(0.5), "the touch is in a box that was not looked at");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn intersections_within(
        &self,
        other: &Self,
        tolerance: f64,
        most_pairs: usize,
    ) -> Result<Intersections, IntersectionError> {
        let mut search = Search::new([self, other], tolerance)?;
        let unfinished = search.run(most_pairs);
        let found = search.report([self.domain(), other.domain()]);
        if unfinished {
            return Err(IntersectionError::TooMuchWork {
                most: most_pairs,
                found: Box::new(found),
            });
        }
        Ok(found)
    }

    /// The pairs of dyadic pieces of step `level` whose bounding boxes meet, as ranges of local parameters.
    ///
    /// They are what the box test alone leaves after halving both curves `level` times.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let [rising, falling] = [[[0.0, 0.0], [4.0, 4.0]], [[0.0, 3.0], [4.0, 0.0]]]
    ///     .map(|points| BezierCurve::new(points.map(Point::new)).expect("finite points"));
    /// assert_eq!(rising.surviving_pairs(&falling, 0).len(), 1);
    /// assert_eq!(rising.surviving_pairs(&falling, 2).len(), 3, "of 16 pairs of quarters");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn surviving_pairs(&self, other: &Self, level: usize) -> Vec<[Range; 2]> {
        let whole = [self, other].map(|curve| Piece {
            points: curve.control_points().to_vec(),
            range: Range::new(0.0, 1.0),
        });
        let mut pairs = vec![whole];
        pairs.retain(|pair| boxes_meet(pair, 0.0));
        for _ in 0..level {
            pairs = pairs
                .iter()
                .flat_map(|pair| {
                    let [first, second] = [pair[0].halves(), pair[1].halves()];
                    first
                        .into_iter()
                        .flat_map(move |a| second.clone().map(|b| [a.clone(), b]))
                })
                .filter(|pair| boxes_meet(pair, 0.0))
                .collect();
        }
        pairs
            .into_iter()
            .map(|pair| pair.map(|piece| piece.range))
            .collect()
    }
}

/// A piece of a curve over a dyadic range of [0, 1].
#[derive(Debug, Clone)]
struct Piece {
    points: Vec<Point<f64, 2>>,
    range: Range,
}

impl Piece {
    fn halves(&self) -> [Self; 2] {
        let [left, right] = halved(&self.points);
        let [lower, upper] = self.range.halves();
        [(left, lower), (right, upper)].map(|(points, range)| Self { points, range })
    }

    /// The piece, or its halves.
    fn parts(&self, halve: bool) -> Vec<Self> {
        if halve {
            self.halves().to_vec()
        } else {
            vec![self.clone()]
        }
    }

    /// The box of the control points, side by side with the axes.
    fn sides(&self) -> [Range; 2] {
        [0, 1].map(|k| {
            let numbers = self
                .points
                .iter()
                .map(|point| Range::new(point[k], point[k]));
            let hull = numbers.reduce(|hull, number| hull.hull(&number));
            hull.unwrap_or_else(|| Range::new(0.0, 0.0))
        })
    }

    /// Whether the piece is within the tolerance of its chord.
    fn is_flat(&self, tolerance: f64) -> bool {
        let curve = BezierCurve::trusted(Interval::unit(), self.points.clone());
        curve.chord_bound(euclidean_norm) <= tolerance
    }

    /// Whether the piece is a point, as far as the tolerance can tell.
    fn is_small(&self, tolerance: f64) -> bool {
        64.0 * self.extent() <= tolerance
    }

    /// How far the piece reaches, at most.
    fn extent(&self) -> f64 {
        let [x, y] = self.sides();
        x.width().max(y.width())
    }

    fn chord(&self) -> [Point<f64, 2>; 2] {
        [self.points[0], self.points[self.points.len() - 1]]
    }
}

fn boxes_meet(pair: &[Piece; 2], slack: f64) -> bool {
    let [a, b] = [pair[0].sides(), pair[1].sides()];
    (0..2).all(|k| a[k].widened(slack).meets(&b[k]))
}

/// The square of the distance between two segments.
///
/// If they do not cross, an end of one is nearest. Where rounding hides a crossing, an end is as near as rounding.
fn segments_apart_squared(a: [Point<f64, 2>; 2], b: [Point<f64, 2>; 2]) -> f64 {
    let side = |line: &[Point<f64, 2>; 2], point: &Point<f64, 2>| {
        let (along, offset) = (line[1] - line[0], *point - line[0]);
        along[0] * offset[1] - along[1] * offset[0]
    };
    let parted = |line: &[Point<f64, 2>; 2], ends: &[Point<f64, 2>; 2]| {
        side(line, &ends[0]) * side(line, &ends[1]) < 0.0
    };
    if parted(&a, &b) && parted(&b, &a) {
        return 0.0;
    }
    let from_b = a
        .iter()
        .map(|end| segment_distance_squared(end, &b[0], &b[1]));
    let from_a = b
        .iter()
        .map(|end| segment_distance_squared(end, &a[0], &a[1]));
    from_a.chain(from_b).fold(f64::INFINITY, f64::min)
}

/// What the halving of a pair is meant to reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Aim {
    /// Both pieces within the tolerance of their chords.
    Flat,
    /// A proof of the crossing that is known to be there; it ends at the latest when both pieces are nearly points.
    Proof,
}

/// Halving more often than this would leave the grid of `f64` parameters.
const DEEPEST: usize = 50;

/// The search for intersections, in scaled coordinates and local parameters.
struct Search {
    pair: Pair,
    tolerance: f64,
    /// By how much rounding may have moved a control point of a piece.
    slack: f64,
    overlaps: Vec<Overlap>,
    /// Boxes with exactly one zero, and where in it that is.
    unique: Vec<([Range; 2], [Range; 2])>,
    possible: Vec<[Range; 2]>,
    pairs_seen: usize,
}

impl Search {
    fn new(curves: [&PlaneCurve; 2], tolerance: f64) -> Result<Self, IntersectionError> {
        halvings(&0.0, &tolerance)?;
        let size = curves
            .iter()
            .flat_map(|curve| curve.control_points())
            .flat_map(|point| point.coordinates())
            .map(Scalar::magnitude)
            .fold(0.0, f64::max);
        let degree = curves[0].degree().max(curves[1].degree());
        // Scaled coordinates are below 2.
        let slack = 2.0 * ((DEEPEST + 8) * (degree + 1)) as f64 * UNIT_ROUNDOFF;
        // Twice the slack for each of two pieces, and as much to spare.
        let least = 8.0 * slack * size;
        if tolerance < least {
            return Err(IntersectionError::BelowRounding { tolerance, least });
        }
        let scale = power_of_two_near(size);
        let scaled = curves.map(|curve| {
            let points = curve.control_points().iter();
            let points = points.map(|point| point.map(|x| x / scale)).collect();
            BezierCurve::trusted(Interval::unit(), points)
        });
        let tolerance = tolerance / scale;
        Ok(Self {
            overlaps: overlaps(&scaled, tolerance),
            pair: Pair::new(scaled),
            tolerance,
            slack,
            unique: Vec::new(),
            possible: Vec::new(),
            pairs_seen: 0,
        })
    }

    /// Looks at all pairs, level by level; whether some had to be left as they are.
    fn run(&mut self, most_pairs: usize) -> bool {
        let whole = [0, 1].map(|k| Piece {
            points: self.pair.curves[k].control_points().to_vec(),
            range: Range::new(0.0, 1.0),
        });
        let mut level = vec![(whole, Aim::Flat)];
        for depth in 0.. {
            let mut next = Vec::new();
            for (index, (pair, aim)) in level.iter().enumerate() {
                if self.pairs_seen == most_pairs {
                    let left = level[index..].iter().chain(&next);
                    self.possible.extend(left.map(|(pair, _)| ranges(pair)));
                    return true;
                }
                self.pairs_seen += 1;
                let Some(aim) = self.settle(pair, *aim, depth) else {
                    continue;
                };
                let reached = |piece: &Piece| match aim {
                    Aim::Flat => piece.is_flat(self.tolerance),
                    Aim::Proof => piece.is_small(self.tolerance),
                };
                let [first, second] = pair;
                let halve_first = !reached(first) || first.extent() > second.extent();
                let halve_second = !reached(second) || second.extent() > first.extent();
                let seconds = second.parts(halve_second);
                for a in first.parts(halve_first) {
                    next.extend(seconds.iter().map(|b| ([a.clone(), b.clone()], aim)));
                }
            }
            if next.is_empty() {
                break;
            }
            level = next;
        }
        false
    }

    /// What to aim at when the pair is halved; `None` if nothing more is to be done for it.
    fn settle(&mut self, pair: &[Piece; 2], aim: Aim, depth: usize) -> Option<Aim> {
        let within = ranges(pair);
        let second = &self.pair.curves[1];
        let covers = |outer: &[Range; 2]| (0..2).all(|k| outer[k].covers(&within[k]));
        if !boxes_meet(pair, 2.0 * self.slack)
            || self.unique.iter().any(|(outer, _)| covers(outer))
            || self
                .overlaps
                .iter()
                .any(|overlap| overlap.explains(&within, second))
        {
            return None;
        }
        let widened = within.map(|range| range.widened(0.25 * range.width()));
        match self.pair.judge(widened) {
            Verdict::Empty => return None,
            Verdict::Unique(place) => {
                // A zero outside this box belongs to a neighbour, or lies beyond an end.
                if (0..2).all(|k| place[k].meets(&within[k])) {
                    let known = |(outer, other): &([Range; 2], [Range; 2])| {
                        (0..2).all(|k| outer[k].covers(&place[k]))
                            || (0..2).all(|k| widened[k].covers(&other[k]))
                    };
                    if !self.unique.iter().any(known) {
                        self.unique.push((widened, place));
                    }
                }
                return None;
            }
            Verdict::Unknown => {}
        }
        let finished = depth >= DEEPEST
            || match aim {
                Aim::Flat => pair.iter().all(|piece| piece.is_flat(self.tolerance)),
                Aim::Proof => pair.iter().all(|piece| piece.is_small(self.tolerance)),
            };
        if !finished {
            return Some(aim);
        }
        let reach = 2.0 * (self.tolerance + self.slack);
        if segments_apart_squared(pair[0].chord(), pair[1].chord()) > reach * reach * (1.0 + 1e-12)
        {
            return None;
        }
        // A crossing in flat pieces deserves a proof: then the search goes on below the tolerance.
        if aim == Aim::Flat && self.pair.crosses_somewhere(&within) {
            return Some(Aim::Proof);
        }
        self.possible.push(within);
        None
    }

    /// The boxes over the domains of the curves, in the order of the first parameter.
    fn report(self, domains: [&Interval<f64>; 2]) -> Intersections {
        let unit = Range::new(0.0, 1.0);
        let mut meetings: Vec<([Range; 2], Kind)> = Vec::new();
        for (_, place) in &self.unique {
            let inside = (0..2).all(|k| unit.covers(&place[k]));
            if inside {
                meetings.push((*place, Kind::Certain));
            } else if let Some(corner) = self.common_end(place) {
                meetings.push((corner, Kind::Certain));
            } else if let [Some(s), Some(t)] = place.map(|range| range.common(&unit)) {
                meetings.push(([s, t], Kind::Possible));
            }
        }
        let mut shared: Vec<([Range; 2], Kind)> = self
            .overlaps
            .iter()
            .map(|overlap| {
                let reversed = overlap.second[0] > overlap.second[1];
                (
                    [overlap.first, overlap.second_range()],
                    Kind::Overlap { reversed },
                )
            })
            .collect();
        for place in report::merged(self.possible) {
            // What remains undecided around the end of an overlap is taken into it.
            let touching = std::iter::zip(&self.overlaps, &mut shared).find(|(overlap, _)| {
                let ends = [overlap.first.low(), overlap.first.high()];
                std::iter::zip(ends, overlap.second).any(|(s, t)| {
                    let near = |range: &Range, x: f64| range.widened(range.width()).contains(x);
                    near(&place[0], s) && near(&place[1], t)
                })
            });
            match touching {
                Some((_, (ranges, _))) => *ranges = [0, 1].map(|k| ranges[k].hull(&place[k])),
                None => meetings.push((place, Kind::Possible)),
            }
        }
        meetings.extend(shared);
        meetings.sort_by(|(a, _), (b, _)| {
            let key = |ranges: &[Range; 2]| [ranges[0].low(), ranges[1].low()];
            key(a).partial_cmp(&key(b)).expect("numbers")
        });
        let meetings = meetings.into_iter().map(|([first, second], kind)| Meeting {
            first: report::over(domains[0], &first),
            second: report::over(domains[1], &second),
            kind,
        });
        Intersections {
            meetings: meetings.collect(),
            pairs_seen: self.pairs_seen,
        }
    }

    /// The corner of the parameter square in a box, if the curves have exactly that end in common.
    fn common_end(&self, place: &[Range; 2]) -> Option<[Range; 2]> {
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
        corners.into_iter().find_map(|(s, t)| {
            let [p, q] = [(0, s), (1, t)].map(|(k, end)| self.pair.curves[k].at(end));
            (p == q && place[0].contains(s) && place[1].contains(t))
                .then(|| [Range::new(s, s), Range::new(t, t)])
        })
    }
}

fn ranges(pair: &[Piece; 2]) -> [Range; 2] {
    [pair[0].range, pair[1].range]
}

/// A power of two near a size, so that division by it is exact and gives numbers below 2; 1 if all are 0.
fn power_of_two_near(size: f64) -> f64 {
    let mut power: f64 = 1.0;
    while power <= 0.5 * size {
        power *= 2.0;
    }
    while size > 0.0 && 0.5 * power >= size && power > 4.0 * f64::MIN_POSITIVE {
        power *= 0.5;
    }
    power
}
