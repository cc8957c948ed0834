//! Arcs that two curves have in common.

use super::range::Range;
use crate::affine::{Affine, Point};
use crate::bezier::BezierCurve;
use crate::bezier::bounds::{dot, euclidean_norm};
use crate::bezier::subdivision::{blossom_values, halved};

/// Two arcs that agree within the tolerance, with proportional parameters.
#[derive(Debug, Clone, Copy)]
pub(super) struct Overlap {
    /// The parameters of the first curve.
    pub(super) first: Range,
    /// Those of the second at both ends of `first`.
    pub(super) second: [f64; 2],
}

impl Overlap {
    /// The range of the second parameters.
    pub(super) fn second_range(&self) -> Range {
        Range::new(self.second[0], self.second[1])
    }

    /// The parameter of the second curve that belongs to one of the first.
    fn partner(&self, s: f64) -> f64 {
        let share = (s - self.first.low()) / self.first.width();
        self.second[0].lerp(&self.second[1], share)
    }

    /// Whether every intersection in this box belongs to the overlap.
    ///
    /// The first range lies in the overlap. If the second curve moves forward all along the range from its own
    /// parameters to the partners of the first ones, it comes to each place once: at the partner.
    pub(super) fn explains(
        &self,
        ranges: &[Range; 2],
        second: &BezierCurve<Point<f64, 2>>,
    ) -> bool {
        if !self.first.covers(&ranges[0]) {
            return false;
        }
        let partners = Range::new(
            self.partner(ranges[0].low()),
            self.partner(ranges[0].high()),
        );
        let over = ranges[1].hull(&partners);
        let arc = blossom_values(second.control_points(), &over.low(), &over.high());
        let along = arc[arc.len() - 1] - arc[0];
        arc.windows(2)
            .all(|leg| dot(&(leg[1] - leg[0]), &along) > 0.0)
    }
}

/// The arcs that both curves share within `tolerance`, with proportional parameters.
///
/// A common arc ends where one of the curves ends. So the ends of each are looked for on the other;
/// between two such places the control points are compared.
/// If all of them agree within the tolerance, so do the arcs: their difference is in the hull of the differences.
pub(super) fn overlaps(curves: &[BezierCurve<Point<f64, 2>>; 2], tolerance: f64) -> Vec<Overlap> {
    let [first, second] = curves;
    let mut places = Vec::new();
    for end in [0.0, 1.0] {
        for t in parameters_near(second, &first.at(end), tolerance) {
            places.push((end, t));
        }
        for s in parameters_near(first, &second.at(end), tolerance) {
            places.push((s, end));
        }
    }
    let mut found: Vec<Overlap> = Vec::new();
    for &(s0, t0) in &places {
        for &(s1, t1) in &places {
            if s0 < s1 && t0 != t1 && agree(curves, [s0, s1], [t0, t1], tolerance) {
                found.push(Overlap {
                    first: Range::new(s0, s1),
                    second: [t0, t1],
                });
            }
        }
    }
    // Keep those that no longer one contains, one of each kind.
    let mut longest: Vec<Overlap> = Vec::new();
    found.sort_by(|a, b| b.first.width().total_cmp(&a.first.width()));
    for overlap in found {
        let inside = |other: &Overlap| {
            other.first.widened(1e-9).covers(&overlap.first)
                && other
                    .second_range()
                    .widened(1e-9)
                    .covers(&overlap.second_range())
        };
        if !longest.iter().any(inside) {
            longest.push(overlap);
        }
    }
    longest
}

/// Whether the arcs between these parameters agree, and are more than a point.
fn agree(
    curves: &[BezierCurve<Point<f64, 2>>; 2],
    s: [f64; 2],
    t: [f64; 2],
    tolerance: f64,
) -> bool {
    let degree = curves[0].degree().max(curves[1].degree());
    let [a, b] = [(&curves[0], s), (&curves[1], t)].map(|(curve, ends)| {
        let points = blossom_values(curve.control_points(), &ends[0], &ends[1]);
        BezierCurve::new(points)
            .expect("finite control points")
            .elevated_times(degree - curve.degree())
    });
    let apart = std::iter::zip(a.control_points(), b.control_points())
        .all(|(a, b)| euclidean_norm(&(*b - *a)) <= tolerance);
    let start = a.control_points()[0];
    let extended = a
        .control_points()
        .iter()
        .any(|point| euclidean_norm(&(*point - start)) > 4.0 * tolerance);
    apart && extended
}

/// Parameters at which the curve passes a point within the tolerance, one for each passage.
fn parameters_near(
    curve: &BezierCurve<Point<f64, 2>>,
    place: &Point<f64, 2>,
    tolerance: f64,
) -> Vec<f64> {
    /// Short enough for the iteration that follows, and few enough pieces.
    const SHORT: f64 = 1.0 / (1 << 20) as f64;
    let mut stack = vec![(curve.control_points().to_vec(), Range::new(0.0, 1.0))];
    let mut found: Vec<Range> = Vec::new();
    while let Some((points, range)) = stack.pop() {
        let near = (0..2).all(|k| {
            let low = points.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
            let high = points
                .iter()
                .map(|p| p[k])
                .fold(f64::NEG_INFINITY, f64::max);
            Range::new(low, high).widened(tolerance).contains(place[k])
        });
        if !near {
            continue;
        }
        let extent = |k: usize| {
            let low = points.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
            points.iter().map(|p| p[k] - low).fold(0.0, f64::max)
        };
        if range.width() <= SHORT || extent(0).max(extent(1)) <= tolerance {
            match found.last_mut() {
                // The stack gives the pieces in order, so neighbours come one after the other.
                Some(last) if last.meets(&range) => *last = last.hull(&range),
                _ => found.push(range),
            }
        } else {
            let [left, right] = halved(&points);
            let [lower, upper] = range.halves();
            stack.push((right, upper));
            stack.push((left, lower));
        }
    }
    let derivative = curve.derivative();
    let distance = |t: f64| euclidean_norm(&(curve.at(t) - *place));
    let refined = found.into_iter().map(|range| {
        let mut t = range.middle();
        for _ in 0..4 {
            let slope = derivative.at(t);
            let square = dot(&slope, &slope);
            if square > 0.0 {
                t = (t - dot(&(curve.at(t) - *place), &slope) / square).clamp(0.0, 1.0);
            }
        }
        t
    });
    refined.filter(|&t| distance(t) <= tolerance).collect()
}
