//! Frames: a point and as many vectors as the space has dimensions.

use super::elimination::{is_regular, solve};
use super::{Affine, AffineBasis, AffineBasisError, Point, Vector};
use crate::scalar::Scalar;

/// An origin and D independent vectors; a point is found by going from the origin along them.
///
/// ```text
/// P = O + Σ cᵢ·vᵢ
/// ```
///
/// The cᵢ are the Cartesian coordinates of P in the frame. With the barycentric coordinates λ₀ … λ_D with respect to
/// the points O, O + v₁, …, O + v_D they agree: cᵢ = λᵢ for i ≥ 1.
///
/// # Examples
///
/// ```
/// use cagd::affine::{AffineBasis, Point, Vector};
///
/// let triangle = AffineBasis::new([[1.0, 1.0], [5.0, 1.0], [1.0, 3.0]].map(Point::new))?;
/// let frame = triangle.frame();
/// assert_eq!(*frame.axes(), [[4.0, 0.0], [0.0, 2.0]].map(Vector::from));
/// assert_eq!(frame.coordinates(&Point::new([2.0, 2.0])), [0.25, 0.5]);
/// assert_eq!(frame.point(&[0.25, 0.5]), Point::new([2.0, 2.0]));
/// assert_eq!(frame.basis()?, triangle);
/// # Ok::<(), cagd::affine::AffineBasisError>(())
/// ```
///
/// Source: `farin2002`, §2.6.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame<T: Scalar, const D: usize> {
    origin: Point<T, D>,
    axes: [Vector<T, D>; D],
}

impl<T: Scalar, const D: usize> Frame<T, D> {
    /// The frame with this origin and these vectors.
    ///
    /// # Errors
    ///
    /// [`AffineBasisError`] if the vectors are dependent or a coordinate is not finite; it names the points
    /// O, O + v₁, …, O + v_D.
    ///
    /// ```
    /// use cagd::affine::{Frame, Point, Vector};
    ///
    /// let axes = [[1.0, 0.0], [1.0, 1.0]].map(Vector::from);
    /// let frame = Frame::new(Point::new([2.0, 0.0]), axes)?;
    /// assert_eq!(frame.point(&[3.0, 4.0]), Point::new([9.0, 4.0]));
    ///
    /// let parallel = [[1.0, 2.0], [2.0, 4.0]].map(Vector::from);
    /// assert!(Frame::new(Point::new([0.0, 0.0]), parallel).is_err());
    /// # Ok::<(), cagd::affine::AffineBasisError>(())
    /// ```
    pub fn new(origin: Point<T, D>, axes: [Vector<T, D>; D]) -> Result<Self, AffineBasisError> {
        let frame = Self { origin, axes };
        let points = || {
            let tips = frame.axes.iter().map(|axis| frame.origin.translated(axis));
            std::iter::once(frame.origin.clone()).chain(tips)
        };
        let is_finite = |point: &Point<T, D>| point.coordinates().iter().all(Scalar::is_finite);
        if let Some((index, point)) = points().enumerate().find(|(_, point)| !is_finite(point)) {
            return Err(AffineBasisError::NotFinite {
                index,
                point: point.to_string(),
            });
        }
        if frame.is_regular() {
            Ok(frame)
        } else {
            let points: Vec<String> = points().map(|point| point.to_string()).collect();
            Err(AffineBasisError::Dependent {
                points: points.join(", "),
            })
        }
    }

    /// The frame of a basis, whose points are known to be independent or asked whether they are.
    pub(super) fn trusted(origin: Point<T, D>, axes: [Vector<T, D>; D]) -> Self {
        Self { origin, axes }
    }

    /// The origin O.
    #[must_use]
    pub fn origin(&self) -> &Point<T, D> {
        &self.origin
    }

    /// The vectors v₁, …, v_D.
    #[must_use]
    pub fn axes(&self) -> &[Vector<T, D>; D] {
        &self.axes
    }

    /// The point O + Σ cᵢ·vᵢ.
    #[must_use]
    pub fn point(&self, coordinates: &[T; D]) -> Point<T, D> {
        std::iter::zip(coordinates, &self.axes).fold(self.origin.clone(), |point, (c, axis)| {
            point.translated(&(axis * c.clone()))
        })
    }

    /// The Cartesian coordinates of a point in this frame. Over rationals they are exact.
    #[must_use]
    pub fn coordinates(&self, point: &Point<T, D>) -> [T; D] {
        let target = point.difference(&self.origin);
        let right = (0..D).map(|k| vec![target[k].clone()]);
        let solution = solve(self.matrix(), right.collect()).expect(
            "the constructor has seen, by the same pivots, that the vectors are independent",
        );
        std::array::from_fn(|i| solution[i][0].clone())
    }

    /// Whether the vectors are independent, as far as rounding can tell.
    pub(super) fn is_regular(&self) -> bool {
        is_regular(self.matrix())
    }

    /// The matrix whose columns are the vectors, row by row.
    fn matrix(&self) -> Vec<Vec<T>> {
        (0..D)
            .map(|k| self.axes.iter().map(|axis| axis[k].clone()).collect())
            .collect()
    }

    /// The points O, O + v₁, …, O + v_D.
    ///
    /// # Errors
    ///
    /// [`AffineBasisError`] if rounding or overflow makes these sums dependent or infinite.
    pub fn basis(&self) -> Result<AffineBasis<T, D>, AffineBasisError> {
        let tips = self.axes.iter().map(|axis| self.origin.translated(axis));
        AffineBasis::new(std::iter::once(self.origin.clone()).chain(tips))
    }
}
