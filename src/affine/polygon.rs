//! Simple polygons of the plane.

use std::cmp::Ordering;

use thiserror::Error;

use super::orientation::{Orient, Turn};
use super::segment::{lies_on, meet};
use super::{Affine, AffineMap, Interval, Point, plane_determinant, signed_area};
use crate::scalar::Scalar;

/// A simple polygon: a closed way along segments that meets itself nowhere, together with its inside.
///
/// The last vertex is joined to the first one. Three neighbours may lie on a line, as long as the way
/// does not turn back. Every question about sides is decided exactly, over `f64` too.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, SimplePolygon};
///
/// let arrow = SimplePolygon::new([[0.0, 0.0], [4.0, -2.0], [1.0, 0.0], [4.0, 2.0]].map(Point::new))?;
/// assert_eq!(arrow.area(), 2.0);
/// assert!(arrow.contains(&Point::new([0.5, 0.0])));
/// assert!(!arrow.contains(&Point::new([2.0, 0.0])));
/// assert!(!arrow.is_convex());
/// # Ok::<(), cagd::affine::PolygonError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SimplePolygon<T: Orient> {
    vertices: Vec<Point<T, 2>>,
}

/// Where a point lies with respect to a polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Location {
    /// In the interior.
    Inside,
    /// On an edge or a vertex.
    Boundary,
    /// Neither.
    Outside,
}

/// Why points are no simple polygon.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// There are fewer than three vertices.
    #[error("a polygon needs at least 3 vertices, found {found}")]
    TooFewVertices {
        /// How many were given.
        found: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error(
        "vertex {index} of the polygon is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which vertex, counted from 0.
        index: usize,
        /// The vertex.
        point: String,
    },
    /// Two vertices are the same point.
    #[error(
        "vertices {first} and {second} of the polygon are the same point {point}; leave one out"
    )]
    RepeatedVertex {
        /// The first of them, counted from 0.
        first: usize,
        /// The second.
        second: usize,
        /// The point.
        point: String,
    },
    /// Two edges have a point in common that is no vertex of both.
    #[error(
        "the polygon is not simple: the edges {first} and {second} meet; move a vertex or change the order of the vertices"
    )]
    SelfIntersecting {
        /// One edge, `(x, y)–(x, y)`.
        first: String,
        /// The other edge.
        second: String,
    },
}

impl<T: Orient> SimplePolygon<T> {
    /// The polygon with these vertices, in order.
    ///
    /// Each edge is compared with each other one, exactly, in O(n²) steps.
    ///
    /// # Errors
    ///
    /// [`PolygonError`] if there are fewer than three vertices, one is not finite, two are equal, or
    /// two edges meet where they should not.
    ///
    /// ```
    /// use cagd::affine::{Point, PolygonError, SimplePolygon};
    ///
    /// let bow_tie = SimplePolygon::new([[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]].map(Point::new));
    /// assert_eq!(
    ///     bow_tie.unwrap_err().to_string(),
    ///     "the polygon is not simple: the edges (0, 0)–(2, 2) and (2, 0)–(0, 2) meet; \
    ///      move a vertex or change the order of the vertices"
    /// );
    /// let flat = SimplePolygon::new([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]].map(Point::new));
    /// assert!(matches!(flat, Err(PolygonError::SelfIntersecting { .. })), "the way back meets the way out");
    /// let twice = SimplePolygon::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]].map(Point::new));
    /// assert!(matches!(twice, Err(PolygonError::RepeatedVertex { first: 0, second: 3, .. })));
    /// let pair = SimplePolygon::new([[0.0, 0.0], [1.0, 0.0]].map(Point::new));
    /// assert_eq!(pair, Err(PolygonError::TooFewVertices { found: 2 }));
    /// let broken = SimplePolygon::new([[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]].map(Point::new));
    /// assert!(matches!(broken, Err(PolygonError::NotFinite { index: 1, .. })));
    /// ```
    pub fn new(vertices: impl IntoIterator<Item = Point<T, 2>>) -> Result<Self, PolygonError> {
        let vertices: Vec<_> = vertices.into_iter().collect();
        let count = vertices.len();
        if count < 3 {
            return Err(PolygonError::TooFewVertices { found: count });
        }
        let is_finite = |point: &Point<T, 2>| point.coordinates().iter().all(Scalar::is_finite);
        if let Some(index) = vertices.iter().position(|vertex| !is_finite(vertex)) {
            return Err(PolygonError::NotFinite {
                index,
                point: vertices[index].to_string(),
            });
        }
        for second in 1..count {
            let same = (0..second).find(|&first| vertices[first] == vertices[second]);
            if let Some(first) = same {
                return Err(PolygonError::RepeatedVertex {
                    first,
                    second,
                    point: vertices[first].to_string(),
                });
            }
        }
        let polygon = Self { vertices };
        for second in 0..count {
            if let Some(first) = (0..second).find(|&first| polygon.edges_clash(first, second)) {
                let name = |i: usize| format!("{}–{}", polygon.vertex(i), polygon.vertex(i + 1));
                return Err(PolygonError::SelfIntersecting {
                    first: name(first),
                    second: name(second),
                });
            }
        }
        Ok(polygon)
    }

    /// Whether two edges meet elsewhere than in a common vertex.
    fn edges_clash(&self, first: usize, second: usize) -> bool {
        let count = self.vertices.len();
        let [a, b] = [first, first + 1].map(|i| self.vertex(i));
        let [c, d] = [second, second + 1].map(|i| self.vertex(i));
        if (first + 1) % count == second {
            lies_on(d, a, b) || lies_on(a, c, d)
        } else if (second + 1) % count == first {
            lies_on(b, c, d) || lies_on(c, a, b)
        } else {
            meet([a, b], [c, d])
        }
    }

    /// Vertex `i`, counted round and round.
    fn vertex(&self, i: usize) -> &Point<T, 2> {
        &self.vertices[i % self.vertices.len()]
    }

    /// The vertices, in order.
    #[must_use]
    pub fn vertices(&self) -> &[Point<T, 2>] {
        &self.vertices
    }

    /// The edges, from each vertex to the next one.
    pub fn edges(&self) -> impl Iterator<Item = (&Point<T, 2>, &Point<T, 2>)> {
        (0..self.vertices.len()).map(|i| (self.vertex(i), self.vertex(i + 1)))
    }

    /// The area with a sign: positive if the vertices go round counterclockwise.
    ///
    /// ```text
    /// Σ [p₀ pᵢ pᵢ₊₁],   i = 1 … n − 2
    /// ```
    ///
    /// ```
    /// use cagd::affine::{Point, SimplePolygon};
    ///
    /// let clockwise = SimplePolygon::new([[0.0, 0.0], [0.0, 2.0], [3.0, 2.0], [3.0, 0.0]].map(Point::new))?;
    /// assert_eq!(clockwise.signed_area(), -6.0);
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    #[must_use]
    pub fn signed_area(&self) -> T {
        let first = &self.vertices[0];
        self.vertices[1..].windows(2).fold(T::zero(), |sum, pair| {
            sum + signed_area(first, &pair[0], &pair[1])
        })
    }

    /// The area.
    #[must_use]
    pub fn area(&self) -> T {
        self.signed_area().abs()
    }

    /// Which way the vertices go round: [`Turn::Left`] is counterclockwise. Exact, over `f64` too.
    ///
    /// The leftmost vertex, of two the lower one, is a corner, and the way turns there as the polygon does.
    #[must_use]
    pub fn orientation(&self) -> Turn {
        let count = self.vertices.len();
        let corner = (0..count)
            .min_by(|&i, &j| left_to_right(&self.vertices[i], &self.vertices[j]))
            .unwrap_or(0);
        self.turn_at(corner)
    }

    /// How the way turns at vertex `i`.
    fn turn_at(&self, i: usize) -> Turn {
        let before = self.vertex(i + self.vertices.len() - 1);
        T::turn(before, self.vertex(i), self.vertex(i + 1))
    }

    /// Whether the polygon, with its inside, is a convex set: the way never turns back against its orientation.
    ///
    /// ```
    /// use cagd::affine::{Point, SimplePolygon};
    ///
    /// let with_a_straight_vertex = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]].map(Point::new);
    /// assert!(SimplePolygon::new(with_a_straight_vertex)?.is_convex());
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    #[must_use]
    pub fn is_convex(&self) -> bool {
        let against = self.orientation().reversed();
        (0..self.vertices.len()).all(|i| self.turn_at(i) != against)
    }

    /// Where a point lies: inside, on the boundary or outside. Exact, over `f64` too.
    ///
    /// It counts how often the boundary winds round the point: edges that go up to the left of it add 1, edges that
    /// go down there subtract 1.
    ///
    /// ```
    /// use cagd::affine::{Location, Point, SimplePolygon};
    ///
    /// let triangle = SimplePolygon::new([[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]].map(Point::new))?;
    /// assert_eq!(triangle.locate(&Point::new([1.0, 1.0])), Location::Inside);
    /// assert_eq!(triangle.locate(&Point::new([1.0, 2.0])), Location::Boundary);
    /// assert_eq!(triangle.locate(&Point::new([2.0, 2.0])), Location::Outside);
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    ///
    /// The coordinates of the point must be finite; for NaN the answer has no meaning.
    #[must_use]
    pub fn locate(&self, point: &Point<T, 2>) -> Location {
        let mut winding = 0;
        for (start, end) in self.edges() {
            let [low, height, high] = [&start[1], &point[1], &end[1]];
            let (up, down) = (
                low <= height && height < high,
                high <= height && height < low,
            );
            let may_touch = up || down || low == height || high == height;
            if !may_touch {
                continue;
            }
            let turn = T::turn(start, end, point);
            if turn == Turn::Straight && lies_on(point, start, end) {
                return Location::Boundary;
            }
            winding += i64::from(up && turn == Turn::Left);
            winding -= i64::from(down && turn == Turn::Right);
        }
        if winding == 0 {
            Location::Outside
        } else {
            Location::Inside
        }
    }

    /// Whether `point` lies in the polygon; its boundary belongs to it.
    #[must_use]
    pub fn contains(&self, point: &Point<T, 2>) -> bool {
        self.locate(point) != Location::Outside
    }

    /// Cuts the polygon into n − 2 triangles along segments between its vertices.
    ///
    /// Each triangle names three vertices by their numbers, in the orientation of the polygon.
    /// The algorithm cuts off ears: corners whose triangle contains no other vertex. Each polygon with
    /// more than three vertices has at least two of them (`meisters1975`), so it never gets stuck;
    /// it takes O(n³) steps at worst.
    ///
    /// ```
    /// use cagd::affine::{Point, SimplePolygon};
    ///
    /// let arrow = SimplePolygon::new([[0.0, 0.0], [4.0, -2.0], [1.0, 0.0], [4.0, 2.0]].map(Point::new))?;
    /// assert_eq!(arrow.triangulation(), [[0, 1, 2], [0, 2, 3]]);
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    #[must_use]
    pub fn triangulation(&self) -> Vec<[usize; 3]> {
        let mut left: Vec<usize> = (0..self.vertices.len()).collect();
        let orientation = self.orientation();
        let mut triangles = Vec::with_capacity(left.len() - 2);
        while left.len() > 3 {
            let count = left.len();
            let around = |i: usize| {
                [
                    left[(i + count - 1) % count],
                    left[i],
                    left[(i + 1) % count],
                ]
            };
            let is_ear = |&i: &usize| self.is_ear(around(i), orientation, &left);
            let ear = (1..count)
                .chain([0])
                .find(is_ear)
                .expect("a simple polygon with more than three vertices has two ears");
            triangles.push(around(ear));
            left.remove(ear);
        }
        triangles.push([left[0], left[1], left[2]]);
        triangles
    }

    /// Whether the triangle turns as the polygon does and contains none of the other vertices.
    fn is_ear(&self, triangle: [usize; 3], orientation: Turn, others: &[usize]) -> bool {
        let [a, b, c] = triangle.map(|i| &self.vertices[i]);
        let outside = |point: &Point<T, 2>| {
            [(a, b), (b, c), (c, a)]
                .iter()
                .any(|(start, end)| T::turn(start, end, point) == orientation.reversed())
        };
        T::turn(a, b, c) == orientation
            && others
                .iter()
                .filter(|other| !triangle.contains(other))
                .all(|&other| outside(&self.vertices[other]))
    }

    /// The parts of the segment from `start` to `end` that lie outside, as intervals of the parameter t in
    /// (1 − t)·start + t·end, in order.
    ///
    /// Over rounded numbers the ends of the intervals are rounded.
    ///
    /// ```
    /// use cagd::affine::{Point, SimplePolygon};
    ///
    /// let notched = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]].map(Point::new);
    /// let notched = SimplePolygon::new(notched)?;
    /// let outside = notched.parts_outside(&Point::new([0.0, 2.5]), &Point::new([4.0, 2.5]));
    /// assert_eq!(outside.len(), 1);
    /// assert_eq!((outside[0].start(), outside[0].end()), (0.25, 0.75));
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    #[must_use]
    pub fn parts_outside(&self, start: &Point<T, 2>, end: &Point<T, 2>) -> Vec<Interval<T>> {
        let direction = end.difference(start);
        // Where the segment meets the line of an edge it may change sides; between two such places it does not.
        let mut cuts = vec![T::zero(), T::one()];
        for (a, b) in self.edges() {
            let edge = b.difference(a);
            let slope = plane_determinant(&edge, &direction);
            if !slope.is_zero() {
                let cut = plane_determinant(&edge, &a.difference(start)) / slope;
                if T::zero() < cut && cut < T::one() {
                    cuts.push(cut);
                }
            }
        }
        cuts.sort_by(|x, y| x.partial_cmp(y).unwrap_or(Ordering::Equal));
        let mut parts: Vec<Interval<T>> = Vec::new();
        for pair in cuts.windows(2) {
            let middle = pair[0].lerp(&pair[1], T::from_ratio(1, 2));
            if self.contains(&start.lerp(end, middle)) {
                continue;
            }
            let continued = parts.last().filter(|part| part.end() == pair[0]);
            let from = continued.map_or(pair[0].clone(), Interval::start);
            if continued.is_some() {
                parts.pop();
            }
            // Of two equal cuts there is nothing between.
            parts.extend(Interval::new(from, pair[1].clone()));
        }
        parts
    }

    /// The image under an affine map.
    ///
    /// # Errors
    ///
    /// [`PolygonError`] if the image is no simple polygon: an affine map that is not injective makes it flat.
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point, SimplePolygon};
    ///
    /// let square = SimplePolygon::new([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::new))?;
    /// let double = AffineMap::new([[2.0, 1.0], [0.0, 1.0]], [5.0, 5.0]);
    /// assert_eq!(square.mapped(&double)?.area(), 2.0);
    /// assert!(square.mapped(&AffineMap::new([[1.0, 0.0], [0.0, 0.0]], [0.0, 0.0])).is_err());
    /// # Ok::<(), cagd::affine::PolygonError>(())
    /// ```
    pub fn mapped(&self, map: &AffineMap<T, 2, 2>) -> Result<Self, PolygonError> {
        Self::new(self.vertices.iter().map(|vertex| map.point(vertex)))
    }
}

/// By the first coordinate, then by the second.
fn left_to_right<T: Orient>(p: &Point<T, 2>, q: &Point<T, 2>) -> Ordering {
    let compare = |k: usize| p[k].partial_cmp(&q[k]).unwrap_or(Ordering::Equal);
    compare(0).then_with(|| compare(1))
}
