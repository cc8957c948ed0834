//! Convex hulls in the plane.

use std::cmp::Ordering;

use thiserror::Error;

use super::orientation::{Orient, Turn};
use super::{Affine, Point};
use crate::scalar::Scalar;

/// The convex hull of points in the plane: the smallest convex set that contains them.
///
/// Its vertices go round counterclockwise and start with the leftmost one, of two leftmost the lower.
/// No vertex lies on the segment between two others.
/// If all points coincide there is one vertex, if they lie on a line there are two.
///
/// # Examples
///
/// ```
/// use cagd::affine::{ConvexHull, Point};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [4.0, 4.0], [2.0, 2.0]].map(Point::new);
/// let hull = ConvexHull::of(&points)?;
/// assert_eq!(hull.vertices(), [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]].map(Point::new));
/// assert!(hull.contains(&Point::new([2.0, 2.0])), "on the boundary");
/// assert!(!hull.contains(&Point::new([2.0, 2.1])));
/// # Ok::<(), cagd::affine::HullError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexHull<T: Orient> {
    vertices: Vec<Point<T, 2>>,
    cost: HullCost,
}

/// What it took to compute a convex hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct HullCost {
    /// How often two points were compared while sorting: O(n log n).
    pub comparisons: usize,
    /// How often the turn of three points was decided: at most 4n.
    pub turns: usize,
}

/// Why there is no convex hull.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum HullError {
    /// There is no point.
    #[error("the convex hull needs at least one point, found none")]
    Empty,
    /// A coordinate is NaN or infinite.
    #[error(
        "point {index} of the convex hull is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which point, counted from 0.
        index: usize,
        /// The point.
        point: String,
    },
}

impl<T: Orient> ConvexHull<T> {
    /// The convex hull of these points, in O(n log n) steps, by Andrew's monotone chain.
    ///
    /// The points are sorted from left to right. A walk along them keeps a chain that only turns left:
    /// the lower boundary. The walk back gives the upper boundary.
    /// Every turn is decided exactly, over `f64` too, so the vertices are those of the true hull.
    ///
    /// # Errors
    ///
    /// [`HullError::Empty`] without points, [`HullError::NotFinite`] for NaN and infinities.
    ///
    /// ```
    /// use cagd::affine::{ConvexHull, HullError, Point};
    ///
    /// assert_eq!(ConvexHull::<f64>::of(&[]), Err(HullError::Empty));
    /// let broken = [[0.0, f64::NAN]].map(Point::new);
    /// assert!(matches!(ConvexHull::of(&broken), Err(HullError::NotFinite { index: 0, .. })));
    /// ```
    ///
    /// Source: `andrew1979`.
    pub fn of(points: &[Point<T, 2>]) -> Result<Self, HullError> {
        if points.is_empty() {
            return Err(HullError::Empty);
        }
        for (index, point) in points.iter().enumerate() {
            if !Affine::coordinates(point).iter().all(Scalar::is_finite) {
                return Err(HullError::NotFinite {
                    index,
                    point: point.to_string(),
                });
            }
        }
        let mut cost = HullCost::default();
        let mut sorted = points.to_vec();
        sorted.sort_unstable_by(|p, q| {
            cost.comparisons += 1;
            left_to_right(p, q)
        });
        sorted.dedup();
        let mut vertices = chain(sorted.iter(), &mut cost);
        if sorted.len() > 1 {
            vertices.pop();
            let mut upper = chain(sorted.iter().rev(), &mut cost);
            upper.pop();
            vertices.append(&mut upper);
        }
        Ok(Self { vertices, cost })
    }

    /// The vertices, counterclockwise.
    #[must_use]
    pub fn vertices(&self) -> &[Point<T, 2>] {
        &self.vertices
    }

    /// The edges in the order of the vertices; none for a single place, two (there and back) for a segment.
    pub fn edges(&self) -> impl Iterator<Item = (&Point<T, 2>, &Point<T, 2>)> {
        let count = self.vertices.len();
        let edges = if count < 2 { 0 } else { count };
        (0..edges).map(move |i| (&self.vertices[i], &self.vertices[(i + 1) % count]))
    }

    /// Whether `point` lies in the hull; its boundary belongs to it. Exact, over `f64` too.
    ///
    /// ```
    /// use cagd::affine::{ConvexHull, Point};
    ///
    /// let segment = ConvexHull::of(&[[0.0, 0.0], [4.0, 2.0]].map(Point::new))?;
    /// assert!(segment.contains(&Point::new([2.0, 1.0])));
    /// assert!(!segment.contains(&Point::new([6.0, 3.0])), "on the line, beyond the end");
    /// # Ok::<(), cagd::affine::HullError>(())
    /// ```
    #[must_use]
    pub fn contains(&self, point: &Point<T, 2>) -> bool {
        match &self.vertices[..] {
            [only] => point == only,
            [start, end] => {
                T::turn(start, end, point) == Turn::Straight
                    && left_to_right(start, point) != Ordering::Greater
                    && left_to_right(point, end) != Ordering::Greater
            }
            _ => self
                .edges()
                .all(|(start, end)| T::turn(start, end, point) != Turn::Right),
        }
    }

    /// How many comparisons and turns it took.
    ///
    /// Each turn either drops a point from the chain or lets the walk go on. A chain of n points
    /// therefore needs at most 2n turns, both chains at most 4n.
    #[must_use]
    pub fn cost(&self) -> HullCost {
        self.cost
    }
}

/// The chain that turns only left, along sorted points.
fn chain<'a, T: Orient>(
    points: impl Iterator<Item = &'a Point<T, 2>>,
    cost: &mut HullCost,
) -> Vec<Point<T, 2>> {
    let mut chain: Vec<Point<T, 2>> = Vec::new();
    for point in points {
        while let [.., before, last] = &chain[..] {
            cost.turns += 1;
            if T::turn(before, last, point) == Turn::Left {
                break;
            }
            chain.pop();
        }
        chain.push(point.clone());
    }
    chain
}

/// By the first coordinate, then by the second.
fn left_to_right<T: Orient>(p: &Point<T, 2>, q: &Point<T, 2>) -> Ordering {
    let compare = |k: usize| p[k].partial_cmp(&q[k]).unwrap_or(Ordering::Equal);
    compare(0).then_with(|| compare(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::BigRational;

    /// Carathéodory: a point is in the convex hull of others exactly if three of them, not
    /// necessarily different, span a triangle that contains it.
    fn in_a_triangle(point: &Point<f64, 2>, others: &[Point<f64, 2>]) -> bool {
        let between = |x: f64, y: f64, z: f64| x.min(z) <= y && y <= x.max(z);
        let on_segment = |a: &Point<f64, 2>, b: &Point<f64, 2>| {
            f64::turn(a, point, b) == Turn::Straight
                && (0..2).all(|k| between(a[k], point[k], b[k]))
        };
        let turns = |a, b, c| [(a, b), (b, c), (c, a)].map(|(p, q)| f64::turn(p, q, point));
        others.iter().any(|a| {
            others.iter().any(|b| {
                on_segment(a, b)
                    || others.iter().any(|c| {
                        let turns = turns(a, b, c);
                        turns == [Turn::Left; 3] || turns == [Turn::Right; 3]
                    })
            })
        })
    }

    /// Many small sets of points of a grid, so that they repeat and are collinear often.
    #[test]
    fn vertices_are_the_points_that_the_others_do_not_span() {
        for set in 0..400_u32 {
            let count = 1 + set % 7;
            let points: Vec<_> = (0..count)
                .map(|i| {
                    let scattered = (set * 7 + i).wrapping_mul(2_654_435_761) >> 20;
                    Point::new([f64::from(scattered % 4), f64::from(scattered / 4 % 4)])
                })
                .collect();
            let hull = ConvexHull::of(&points).expect("finite points");
            for point in &points {
                let others: Vec<_> = points.iter().copied().filter(|p| p != point).collect();
                let is_vertex = hull.vertices().contains(point);
                assert_eq!(
                    is_vertex,
                    !in_a_triangle(point, &others),
                    "{point} of {points:?}"
                );
            }
            for probe in 0..25 {
                let probe = Point::new([f64::from(probe % 5) - 0.5, f64::from(probe / 5) - 0.5]);
                assert_eq!(
                    hull.contains(&probe),
                    in_a_triangle(&probe, &points),
                    "{probe} in {points:?}"
                );
            }
            assert!(hull.cost().turns <= 4 * points.len());
            let exact_points: Vec<Point<BigRational, 2>> = points
                .iter()
                .map(|point| point.map(|x| crate::scalar::exact(x).expect("finite")))
                .collect();
            let exact_hull = ConvexHull::of(&exact_points).expect("exact points");
            assert_eq!(exact_hull.vertices().len(), hull.vertices().len());
        }
    }
}
