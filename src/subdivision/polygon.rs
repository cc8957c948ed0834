//! The polygon that curve schemes refine: open or closed.

use thiserror::Error;

use crate::affine::Affine;
use crate::bspline::{UniformSpline, UniformSplineError};
use crate::scalar::Scalar;

/// Whether the last vertex of a polygon is joined to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Closing {
    /// From the first vertex to the last; k vertices have k − 1 legs.
    Open,
    /// Back to the first vertex: k vertices have k legs, and indices are cyclic.
    Closed,
}

/// An open or closed polygon of points, vectors or numbers: what a curve scheme refines.
///
/// It has one vertex or more, and all are finite.
/// Vertices may coincide.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::subdivision::ControlPolygon;
///
/// let square = ControlPolygon::closed([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::new))?;
/// assert_eq!(square.legs().count(), 4);
/// assert_eq!(square.averaged()?.vertices(), [[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]].map(Point::new));
/// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ControlPolygon<P> {
    vertices: Vec<P>,
    closing: Closing,
}

impl<P: Affine> ControlPolygon<P> {
    /// The polygon with these vertices.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::NoVertices`] or [`ControlPolygonError::NotFinite`].
    ///
    /// ```
    /// use cagd::subdivision::{Closing, ControlPolygon, ControlPolygonError};
    ///
    /// let none: [f64; 0] = [];
    /// assert_eq!(ControlPolygon::new(none, Closing::Open), Err(ControlPolygonError::NoVertices));
    /// ```
    pub fn new(
        vertices: impl IntoIterator<Item = P>,
        closing: Closing,
    ) -> Result<Self, ControlPolygonError> {
        let vertices: Vec<P> = vertices.into_iter().collect();
        if vertices.is_empty() {
            return Err(ControlPolygonError::NoVertices);
        }
        match vertices
            .iter()
            .position(|vertex| !vertex.coordinates().iter().all(Scalar::is_finite))
        {
            None => Ok(Self { vertices, closing }),
            Some(index) => Err(ControlPolygonError::NotFinite {
                index,
                vertex: format!("{:?}", vertices[index]),
            }),
        }
    }

    /// The open polygon with these vertices.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn open(vertices: impl IntoIterator<Item = P>) -> Result<Self, ControlPolygonError> {
        Self::new(vertices, Closing::Open)
    }

    /// The closed polygon with these vertices; the first is not repeated at the end.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn closed(vertices: impl IntoIterator<Item = P>) -> Result<Self, ControlPolygonError> {
        Self::new(vertices, Closing::Closed)
    }

    /// A polygon whose vertices are known to be finite and not empty.
    pub(crate) fn trusted(vertices: Vec<P>, closing: Closing) -> Self {
        debug_assert!(!vertices.is_empty());
        Self { vertices, closing }
    }

    /// The vertices, in order.
    #[must_use]
    pub fn vertices(&self) -> &[P] {
        &self.vertices
    }

    /// Open or closed.
    #[must_use]
    pub fn closing(&self) -> Closing {
        self.closing
    }

    /// Whether the last vertex is joined to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closing == Closing::Closed
    }

    /// The vertex number `index`: cyclically if the polygon is closed, none outside of an open one.
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let values = [1.0, 2.0, 3.0];
    /// assert_eq!(ControlPolygon::closed(values)?.vertex(-1), Some(&3.0));
    /// assert_eq!(ControlPolygon::open(values)?.vertex(-1), None);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    #[must_use]
    pub fn vertex(&self, index: i64) -> Option<&P> {
        let index = match self.closing {
            Closing::Open => usize::try_from(index).ok()?,
            Closing::Closed => index.rem_euclid(self.vertices.len() as i64) as usize,
        };
        self.vertices.get(index)
    }

    /// The legs: each vertex with the next one.
    pub fn legs(&self) -> impl Iterator<Item = (&P, &P)> {
        let ends = self.vertices.iter().cycle().skip(1);
        let count = match self.closing {
            Closing::Open => self.vertices.len() - 1,
            Closing::Closed => self.vertices.len(),
        };
        self.vertices.iter().zip(ends).take(count)
    }

    /// Every vertex twice: the step that schemes by averaging begin with.
    ///
    /// k vertices become 2k.
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// assert_eq!(ControlPolygon::open([1.0, 5.0])?.doubled().vertices(), [1.0, 1.0, 5.0, 5.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    #[must_use]
    pub fn doubled(&self) -> Self {
        let twice = |vertex: &P| [vertex.clone(), vertex.clone()];
        Self::trusted(self.vertices.iter().flat_map(twice).collect(), self.closing)
    }

    /// The midpoints of the legs, in order; the first is that of the first leg.
    ///
    /// An open polygon loses a vertex, a closed one keeps their number.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has a single vertex.
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// assert_eq!(ControlPolygon::open([1.0, 5.0, 7.0])?.averaged()?.vertices(), [3.0, 6.0]);
    /// assert_eq!(ControlPolygon::closed([1.0, 5.0, 7.0])?.averaged()?.vertices(), [3.0, 6.0, 4.0]);
    /// assert!(ControlPolygon::open([1.0])?.averaged().is_err());
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    pub fn averaged(&self) -> Result<Self, ControlPolygonError> {
        self.needs(2, "averaging")?;
        let half = P::Scalar::from_ratio(1, 2);
        let middles = self
            .legs()
            .map(|(start, end)| start.lerp(end, half.clone()));
        Ok(Self::trusted(middles.collect(), self.closing))
    }

    /// Refuses an open polygon with fewer than `needed` vertices.
    pub(crate) fn needs(
        &self,
        needed: usize,
        what: &'static str,
    ) -> Result<(), ControlPolygonError> {
        if self.is_closed() || self.vertices.len() >= needed {
            Ok(())
        } else {
            Err(ControlPolygonError::TooFewVertices {
                what,
                needed,
                found: self.vertices.len(),
            })
        }
    }

    /// The uniform spline of this degree with the vertices as control points, periodic if the polygon is closed.
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::TooFewControlPoints`] if an open polygon has not n + 1 vertices.
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let spline = ControlPolygon::closed([0.0, 4.0, 2.0])?.spline(2)?;
    /// assert_eq!(spline.at(2.5)?, (0.0 + 6.0 * 4.0 + 2.0) / 8.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn spline(&self, degree: usize) -> Result<UniformSpline<P>, UniformSplineError> {
        match self.closing {
            Closing::Open => UniformSpline::new(degree, self.vertices.iter().cloned()),
            Closing::Closed => UniformSpline::periodic(degree, self.vertices.iter().cloned()),
        }
    }
}

/// Why there is no polygon, or no refinement of it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ControlPolygonError {
    /// There is no vertex.
    #[error("a polygon needs at least one vertex, found none")]
    NoVertices,
    /// A vertex has a coordinate that is NaN or infinite.
    #[error("vertex {index} is not finite: {vertex}; every coordinate must be a finite number")]
    NotFinite {
        /// Which vertex, counted from 0.
        index: usize,
        /// The vertex.
        vertex: String,
    },
    /// An open polygon is too short for the step.
    #[error(
        "{what} needs an open polygon of {needed} vertices or more, found {found}; add vertices, or close the polygon"
    )]
    TooFewVertices {
        /// Which step.
        what: &'static str,
        /// How many there must be.
        needed: usize,
        /// How many there are.
        found: usize,
    },
}
