//! What de Casteljau's algorithm costs, counted while it runs.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::curve::BezierCurve;
use crate::affine::Affine;

/// What an evaluation has cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cost {
    /// How many affine combinations of two points were computed.
    pub combinations: usize,
    /// How many points existed at the same time at most, those of the curve itself not counted.
    pub points: usize,
}

/// A control point that keeps count of the affine combinations, and of the points there are.
///
/// All points of a curve share one count.
/// So the cost of an algorithm is measured by running it, whatever it claims.
///
/// # Examples
///
/// ```
/// use cagd::bezier::{BezierCurve, Cost, Counted};
///
/// let curve = BezierCurve::new([0.0, 1.0, 4.0, 2.0])?;
/// let point = Counted::curve(&curve).at(0.5);
/// assert_eq!(point.value(), &curve.at(0.5));
/// assert_eq!(point.cost(), Cost { combinations: 6, points: 5 }, "3·4/2, and 3 + 1 and a new one");
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
pub struct Counted<P> {
    point: P,
    tally: Arc<Tally>,
}

#[derive(Default)]
struct Tally {
    combinations: AtomicUsize,
    alive: AtomicUsize,
    most_alive: AtomicUsize,
    /// How many points the curve itself has.
    given: AtomicUsize,
}

impl<P: Affine> Counted<P> {
    /// The same curve with points that count; the count starts now.
    #[must_use]
    pub fn curve(curve: &BezierCurve<P>) -> BezierCurve<Self> {
        let tally = Arc::new(Tally::default());
        let points: Vec<Self> = curve
            .control_points()
            .iter()
            .map(|point| Self::born(point.clone(), &tally))
            .collect();
        tally.given.store(points.len(), Ordering::Relaxed);
        BezierCurve::trusted(curve.domain().clone(), points)
    }

    /// The point itself.
    #[must_use]
    pub fn value(&self) -> &P {
        &self.point
    }

    /// What has been spent so far on all points of the same curve.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let most_alive = self.tally.most_alive.load(Ordering::Relaxed);
        Cost {
            combinations: self.tally.combinations.load(Ordering::Relaxed),
            points: most_alive - self.tally.given.load(Ordering::Relaxed),
        }
    }
}

impl<P> Counted<P> {
    fn born(point: P, tally: &Arc<Tally>) -> Self {
        let alive = 1 + tally.alive.fetch_add(1, Ordering::Relaxed);
        tally.most_alive.fetch_max(alive, Ordering::Relaxed);
        Self {
            point,
            tally: Arc::clone(tally),
        }
    }
}

impl<P: Clone> Clone for Counted<P> {
    fn clone(&self) -> Self {
        Self::born(self.point.clone(), &self.tally)
    }
}

impl<P> Drop for Counted<P> {
    fn drop(&mut self) {
        self.tally.alive.fetch_sub(1, Ordering::Relaxed);
    }
}

impl<P: PartialEq> PartialEq for Counted<P> {
    fn eq(&self, other: &Self) -> bool {
        self.point == other.point
    }
}

impl<P: fmt::Debug> fmt::Debug for Counted<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.point.fmt(f)
    }
}

/// Computes as `P` does; [`lerp`](Affine::lerp) counts, [`from_fn`](Affine::from_fn) starts a count of its own.
impl<P: Affine> Affine for Counted<P> {
    type Scalar = P::Scalar;
    type Difference = P::Difference;
    const DIMENSION: usize = P::DIMENSION;

    fn lerp(&self, other: &Self, t: P::Scalar) -> Self {
        self.tally.combinations.fetch_add(1, Ordering::Relaxed);
        Self::born(self.point.lerp(&other.point, t), &self.tally)
    }

    fn difference(&self, start: &Self) -> P::Difference {
        self.point.difference(&start.point)
    }

    fn translated(&self, by: &P::Difference) -> Self {
        Self::born(self.point.translated(by), &self.tally)
    }

    fn coordinates(&self) -> &[P::Scalar] {
        self.point.coordinates()
    }

    fn from_fn(coordinate: impl FnMut(usize) -> P::Scalar) -> Self {
        Self::born(P::from_fn(coordinate), &Arc::default())
    }
}

/// The point b(u) by the recursion as it is written, and how many calls the program has made.
///
/// Every call for more than one control point makes two further calls, for all points but the last and for all
/// but the first. That is 2ⁿ⁺¹ − 1 calls in all, the first one included: never do this for a high degree.
/// [`BezierCurve::at`] computes the same point with n(n + 1)/2 combinations.
///
/// # Examples
///
/// ```
/// use cagd::bezier::{BezierCurve, recursive_at};
///
/// let curve = BezierCurve::new([0.0, 1.0, 4.0, 2.0])?;
/// assert_eq!(recursive_at(&curve, 0.25), (curve.at(0.25), 15));
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
///
/// Source: `class-notes`, §4.
#[must_use]
pub fn recursive_at<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> (P, u64) {
    fn recursion<P: Affine>(points: &[P], t: &P::Scalar, calls: &mut u64) -> P {
        *calls += 1;
        match points {
            [point] => point.clone(),
            _ => {
                let upper = recursion(&points[..points.len() - 1], t, calls);
                let lower = recursion(&points[1..], t, calls);
                upper.lerp(&lower, t.clone())
            }
        }
    }
    let mut calls = 0;
    let point = recursion(curve.control_points(), &curve.domain().local(u), &mut calls);
    (point, calls)
}
