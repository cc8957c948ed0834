//! Schemes that cut corners: Chaikin's, that of Lane and Riesenfeld, and the cubic one.

use super::polygon::{ControlPolygon, ControlPolygonError};
use crate::affine::Affine;
use crate::scalar::Scalar;

impl<P: Affine> ControlPolygon<P> {
    /// One step of Chaikin's algorithm: every leg is cut at 1/4 and at 3/4.
    ///
    /// ```text
    /// q₂ᵢ = (3pᵢ + pᵢ₊₁)/4,   q₂ᵢ₊₁ = (pᵢ + 3pᵢ₊₁)/4
    /// ```
    ///
    /// k vertices become 2k, or 2k − 2 if the polygon is open: its ends are cut off.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has a single vertex.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let open = ControlPolygon::open([0.0, 4.0, 20.0])?;
    /// assert_eq!(open.chaikin()?.vertices(), [1.0, 3.0, 8.0, 16.0]);
    /// let closed = ControlPolygon::closed([0.0, 4.0, 20.0])?;
    /// assert_eq!(closed.chaikin()?.vertices(), [1.0, 3.0, 8.0, 16.0, 15.0, 5.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    ///
    /// Source: `chaikin1974`.
    pub fn chaikin(&self) -> Result<Self, ControlPolygonError> {
        self.needs(2, "Chaikin's algorithm")?;
        let [near, far] = [1, 3].map(|quarters| P::Scalar::from_ratio(quarters, 4));
        let cuts = self
            .legs()
            .flat_map(|(start, end)| [start.lerp(end, near.clone()), start.lerp(end, far.clone())]);
        Ok(Self::trusted(cuts.collect(), self.closing()))
    }

    /// One step of the algorithm of Lane and Riesenfeld: double every vertex, then average `degree` = n times.
    ///
    /// k vertices become 2k, or 2k − n if the polygon is open.
    /// Vertex j of the result is the sum of all pᵢ with the weights C(n + 1, j + n − 2i)/2ⁿ.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has no more than n/2 vertices, so that none would be left.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let polygon = ControlPolygon::open([0.0, 8.0, 16.0, 0.0])?;
    /// assert_eq!(polygon.lane_riesenfeld(1)?.vertices(), [0.0, 4.0, 8.0, 12.0, 16.0, 8.0, 0.0]);
    /// assert_eq!(polygon.lane_riesenfeld(2)?, polygon.chaikin()?);
    /// assert_eq!(polygon.lane_riesenfeld(3)?.vertices(), [4.0, 8.0, 12.0, 13.0, 8.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    ///
    /// Source: `lane-riesenfeld1980`.
    pub fn lane_riesenfeld(&self, degree: usize) -> Result<Self, ControlPolygonError> {
        self.needs(degree / 2 + 1, "the algorithm of Lane and Riesenfeld")?;
        (0..degree).try_fold(self.doubled(), |polygon, _| polygon.averaged())
    }

    /// The polygons on the way of [`lane_riesenfeld`](Self::lane_riesenfeld): doubled, averaged once, twice, … n times.
    ///
    /// # Errors
    ///
    /// As [`lane_riesenfeld`](Self::lane_riesenfeld).
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let rounds = ControlPolygon::open([0.0, 8.0])?.averaging_rounds(2)?;
    /// let rounds: Vec<&[f64]> = rounds.iter().map(ControlPolygon::vertices).collect();
    /// assert_eq!(rounds, [&[0.0, 0.0, 8.0, 8.0][..], &[0.0, 4.0, 8.0], &[2.0, 6.0]]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    pub fn averaging_rounds(&self, degree: usize) -> Result<Vec<Self>, ControlPolygonError> {
        self.needs(degree / 2 + 1, "the algorithm of Lane and Riesenfeld")?;
        let mut rounds = vec![self.doubled()];
        for round in 0..degree {
            rounds.push(rounds[round].averaged()?);
        }
        Ok(rounds)
    }

    /// One step of the cubic scheme, the curve version of the scheme of Catmull and Clark.
    ///
    /// Every leg gives an edge point, every vertex with two neighbours a vertex point,
    ///
    /// ```text
    /// eᵢ = (pᵢ + pᵢ₊₁)/2,   vᵢ = (pᵢ₋₁ + 6pᵢ + pᵢ₊₁)/8,
    /// ```
    ///
    /// and the new polygon is e₀, v₁, e₁, v₂, …; a closed one ends with v₀.
    /// k vertices become 2k, or 2k − 3 if the polygon is open: its ends have no vertex point.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has a single vertex.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let open = ControlPolygon::open([0.0, 8.0, 16.0, 0.0])?;
    /// assert_eq!(open.cubic_step()?.vertices(), [4.0, 8.0, 12.0, 13.0, 8.0]);
    /// let closed = ControlPolygon::closed([0.0, 8.0, 16.0])?;
    /// assert_eq!(closed.cubic_step()?.vertices(), [4.0, 8.0, 12.0, 13.0, 8.0, 3.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    ///
    /// Source: `catmull-clark1978`.
    pub fn cubic_step(&self) -> Result<Self, ControlPolygonError> {
        self.needs(2, "the cubic scheme")?;
        let half = P::Scalar::from_ratio(1, 2);
        let [side, middle] = [1, 6].map(|eighths| P::Scalar::from_ratio(eighths, 8));
        let mut vertices = Vec::with_capacity(2 * self.vertices().len());
        for ((i, (start, end)), after) in (0..).zip(self.legs()).zip(2..) {
            vertices.push(start.lerp(end, half.clone()));
            if let (Some(before), Some(after)) = (self.vertex(i), self.vertex(after)) {
                vertices.push(P::from_fn(|k| {
                    let coordinate = |point: &P| point.coordinates()[k].clone();
                    coordinate(before) * side.clone()
                        + coordinate(end) * middle.clone()
                        + coordinate(after) * side.clone()
                }));
            }
        }
        Ok(Self::trusted(vertices, self.closing()))
    }
}
