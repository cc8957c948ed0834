//! Polygons whose vertices have whole coordinates, and the lattice points that they contain.

use thiserror::Error;

use super::orientation::Turn;
use super::{Location, Point, PolygonError, SimplePolygon};
use crate::scalar::Scalar;

/// A point of the plane with whole coordinates.
pub type LatticePoint = [i64; 2];

/// A simple polygon whose vertices are lattice points.
///
/// # Examples
///
/// ```
/// use cagd::affine::{LatticeCount, LatticePolygon};
///
/// let triangle = LatticePolygon::new([[0, 0], [2, 1], [1, 3]])?;
/// assert_eq!(triangle.interior_points(), [[1, 1], [1, 2]]);
/// assert_eq!(triangle.count(), LatticeCount { interior: 2, boundary: 3 });
/// assert_eq!(triangle.area::<f64>(), 2.5);
/// assert_eq!(triangle.count().pick_area::<f64>(), 2.5);
/// # Ok::<(), cagd::affine::LatticePolygonError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LatticePolygon {
    vertices: Vec<LatticePoint>,
    /// The same vertices as floating-point numbers, which hold them exactly.
    polygon: SimplePolygon<f64>,
}

/// How many lattice points a polygon contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LatticeCount {
    /// Those in the interior, I.
    pub interior: usize,
    /// Those on the boundary, R.
    pub boundary: usize,
}

impl LatticeCount {
    /// The area I + R/2 − 1 that Pick's theorem gives for a simple polygon.
    #[must_use]
    pub fn pick_area<T: Scalar>(&self) -> T {
        let whole = |count: usize| T::from_integer(count as i64);
        whole(self.interior) + whole(self.boundary) * T::from_ratio(1, 2) - T::one()
    }
}

/// Why lattice points are no simple polygon.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LatticePolygonError {
    /// A vertex is too far away.
    #[error(
        "vertex {index} of the lattice polygon is ({}, {}); its coordinates must lie between −{limit} and {limit}, so that every lattice point around the polygon can be tried", vertex[0], vertex[1]
    )]
    TooFarAway {
        /// Which vertex, counted from 0.
        index: usize,
        /// The vertex.
        vertex: LatticePoint,
        /// The largest coordinate.
        limit: i64,
    },
    /// They are no simple polygon.
    #[error(transparent)]
    NotSimple(#[from] PolygonError),
}

impl LatticePolygon {
    /// The largest absolute value of a coordinate.
    ///
    /// Interior points are found by trying all lattice points of a box, at most 2001² = 4·10⁶ of them.
    /// Numbers of this size, and products of two, are exact in `f64` too.
    pub const LARGEST_COORDINATE: i64 = 1000;

    /// The polygon with these vertices, in order.
    ///
    /// # Errors
    ///
    /// [`LatticePolygonError`] if a coordinate is larger than [`LARGEST_COORDINATE`](Self::LARGEST_COORDINATE), or the
    /// vertices are no simple polygon.
    ///
    /// ```
    /// use cagd::affine::{LatticePolygon, LatticePolygonError};
    ///
    /// let bow_tie = LatticePolygon::new([[0, 0], [2, 2], [2, 0], [0, 2]]);
    /// assert!(matches!(bow_tie, Err(LatticePolygonError::NotSimple(_))));
    /// let long = LatticePolygon::new([[0, 0], [5000, 0], [0, 1]]);
    /// assert!(matches!(long, Err(LatticePolygonError::TooFarAway { index: 1, .. })));
    /// ```
    pub fn new(
        vertices: impl IntoIterator<Item = LatticePoint>,
    ) -> Result<Self, LatticePolygonError> {
        let vertices: Vec<_> = vertices.into_iter().collect();
        let limit = Self::LARGEST_COORDINATE;
        let is_far = |vertex: &LatticePoint| vertex.iter().any(|x| !(-limit..=limit).contains(x));
        if let Some(index) = vertices.iter().position(is_far) {
            return Err(LatticePolygonError::TooFarAway {
                index,
                vertex: vertices[index],
                limit,
            });
        }
        let polygon = SimplePolygon::new(vertices.iter().map(|&vertex| place(vertex)))?;
        Ok(Self { vertices, polygon })
    }

    /// The vertices, in order.
    #[must_use]
    pub fn vertices(&self) -> &[LatticePoint] {
        &self.vertices
    }

    /// The polygon over `f64`, to draw it or to ask where points lie.
    #[must_use]
    pub fn polygon(&self) -> &SimplePolygon<f64> {
        &self.polygon
    }

    /// Twice the area, a whole number.
    #[must_use]
    pub fn twice_area(&self) -> i64 {
        let [x, y] = self.vertices[0];
        let doubled: i64 = self.vertices[1..]
            .windows(2)
            .map(|pair| {
                let [[ax, ay], [bx, by]] = [pair[0], pair[1]];
                (ax - x) * (by - y) - (ay - y) * (bx - x)
            })
            .sum();
        doubled.abs()
    }

    /// The area, from determinants.
    #[must_use]
    pub fn area<T: Scalar>(&self) -> T {
        T::from_ratio(self.twice_area(), 2)
    }

    /// How many lattice points lie inside and on the boundary, counted without use of the area.
    ///
    /// On the edge from p to q lie gcd(|q₁ − p₁|, |q₂ − p₂|) of them besides p.
    #[must_use]
    pub fn count(&self) -> LatticeCount {
        LatticeCount {
            interior: self.interior_points().len(),
            boundary: self.edges().map(|(p, q)| steps(p, q) as usize).sum(),
        }
    }

    /// The lattice points inside, row by row from below.
    #[must_use]
    pub fn interior_points(&self) -> Vec<LatticePoint> {
        let extent = |k: usize| {
            let coordinates = || self.vertices.iter().map(move |vertex| vertex[k]);
            coordinates().min().unwrap_or(0)..=coordinates().max().unwrap_or(0)
        };
        extent(1)
            .flat_map(|y| extent(0).map(move |x| [x, y]))
            .filter(|&point| self.polygon.locate(&place(point)) == Location::Inside)
            .collect()
    }

    /// The lattice points on the boundary, in the order of the edges.
    ///
    /// ```
    /// use cagd::affine::LatticePolygon;
    ///
    /// let triangle = LatticePolygon::new([[0, 0], [4, 2], [0, 2]])?;
    /// assert_eq!(triangle.boundary_points(), [[0, 0], [2, 1], [4, 2], [3, 2], [2, 2], [1, 2], [0, 2], [0, 1]]);
    /// # Ok::<(), cagd::affine::LatticePolygonError>(())
    /// ```
    #[must_use]
    pub fn boundary_points(&self) -> Vec<LatticePoint> {
        let on_edge = |(p, q): (LatticePoint, LatticePoint)| {
            let steps = steps(p, q);
            (0..steps).map(move |k| [0, 1].map(|i| p[i] + (q[i] - p[i]) / steps * k))
        };
        self.edges().flat_map(on_edge).collect()
    }

    /// Triangles whose corners are lattice points and that contain no other ones, which fill the polygon.
    ///
    /// The polygon is cut into triangles, and a triangle with a further lattice point into smaller ones with this point
    /// as a corner. So the proof of Pick's theorem cuts it.
    ///
    /// ```
    /// use cagd::affine::LatticePolygon;
    ///
    /// let square = LatticePolygon::new([[0, 0], [2, 0], [2, 2], [0, 2]])?;
    /// let triangles = square.primitive_triangles();
    /// assert_eq!(triangles.len(), 8, "each has the area 1/2");
    /// # Ok::<(), cagd::affine::LatticePolygonError>(())
    /// ```
    #[must_use]
    pub fn primitive_triangles(&self) -> Vec<[LatticePoint; 3]> {
        let mut open: Vec<[LatticePoint; 3]> = self
            .polygon
            .triangulation()
            .into_iter()
            .map(|triangle| triangle.map(|i| self.vertices[i]))
            .collect();
        let mut primitive = Vec::new();
        while let Some(triangle) = open.pop() {
            let further = Self::new(triangle).ok().and_then(|polygon| {
                let on_boundary = polygon.boundary_points().into_iter();
                let inside = polygon.interior_points().into_iter();
                on_boundary.chain(inside).find(|x| !triangle.contains(x))
            });
            match further {
                None => primitive.push(triangle),
                Some(x) => open.extend(split(triangle, x)),
            }
        }
        primitive
    }

    fn edges(&self) -> impl Iterator<Item = (LatticePoint, LatticePoint)> {
        let next = self.vertices.iter().cycle().skip(1);
        self.vertices.iter().copied().zip(next.copied())
    }
}

/// The triangles from `x` to the sides that `x` does not lie on: three, or two if `x` lies on a side.
fn split([a, b, c]: [LatticePoint; 3], x: LatticePoint) -> impl Iterator<Item = [LatticePoint; 3]> {
    [[a, b, x], [b, c, x], [c, a, x]]
        .into_iter()
        .filter(|&[p, q, x]| {
            use super::Orient;
            f64::turn(&place(p), &place(q), &place(x)) != Turn::Straight
        })
}

/// The lattice point as a point over `f64`.
fn place([x, y]: LatticePoint) -> Point<f64, 2> {
    Point::new([x as f64, y as f64])
}

/// Into how many equal steps between lattice points the segment from `p` to `q` falls.
fn steps(p: LatticePoint, q: LatticePoint) -> i64 {
    let (mut a, mut b) = ((q[0] - p[0]).abs(), (q[1] - p[1]).abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
