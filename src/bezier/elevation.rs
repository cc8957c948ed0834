//! Degree elevation, and degree reduction where it is exact.

use thiserror::Error;

use super::curve::{BezierCurve, tuple};
use crate::affine::Affine;
use crate::law::Rounding;
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The same curve with one control point more.
    ///
    /// ```text
    /// b̃₀ = b₀,   b̃ᵢ = i/(n + 1)·bᵢ₋₁ + (1 − i/(n + 1))·bᵢ,   b̃ₙ₊₁ = bₙ
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let segment = BezierCurve::new([[0.0, 0.0], [4.0, 2.0]].map(Point::new))?;
    /// let elevated = segment.elevated();
    /// assert_eq!(elevated.control_points(), [[0.0, 0.0], [2.0, 1.0], [4.0, 2.0]].map(Point::new));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §6.1.
    #[must_use]
    pub fn elevated(&self) -> Self {
        let points = self.control_points();
        let n = self.degree();
        let inner = (1..=n).map(|i| {
            let weight = P::Scalar::from_ratio(i as i64, n as i64 + 1);
            points[i].lerp(&points[i - 1], weight)
        });
        let elevated = std::iter::once(points[0].clone())
            .chain(inner)
            .chain(points.last().cloned());
        Self::trusted(self.domain().clone(), elevated.collect())
    }

    /// The same curve after `times` elevations; its degree is n + `times`.
    #[must_use]
    pub fn elevated_times(&self, times: usize) -> Self {
        (0..times).fold(self.clone(), |curve, _| curve.elevated())
    }

    /// The same curve with one control point fewer, if there is one.
    ///
    /// It exists exactly if the polynomial has a degree below n, that is if Δⁿb₀ = 0.
    /// The recurrence of elevation is solved for the old points, from both ends to the middle, where
    /// no factor exceeds 1 and errors do not grow; there the two halves must meet.
    ///
    /// # Errors
    ///
    /// [`ReductionError::Constant`] for a curve of degree 0;
    /// [`ReductionError::FullDegree`] if the halves do not meet: exact numbers must agree exactly,
    /// rounded ones within the rounding of their own computation (stated in the source).
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, ReductionError};
    ///
    /// let parabola = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]].map(Point::new))?;
    /// assert_eq!(parabola.elevated().reduced()?, parabola);
    /// assert!(matches!(parabola.reduced(), Err(ReductionError::FullDegree { .. })));
    ///
    /// let point = BezierCurve::new([Point::new([1.0, 2.0])])?;
    /// assert_eq!(point.reduced(), Err(ReductionError::Constant));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `farin2002`, §6.4.
    pub fn reduced(&self) -> Result<Self, ReductionError> {
        let points = self.control_points();
        let n = self.degree();
        if n == 0 {
            return Err(ReductionError::Constant);
        }
        let last_of_left = (n - 1) / 2;
        let mut left: Vec<P> = vec![points[0].clone()];
        for i in 1..=last_of_left {
            let weight = P::Scalar::from_ratio(n as i64, (n - i) as i64);
            left.push(left[i - 1].lerp(&points[i], weight));
        }
        // The old points n − 1, n − 2, …, last_of_left + 1, and one more for comparison.
        let mut right: Vec<P> = vec![points[n].clone()];
        for i in (last_of_left + 1..n).rev() {
            let weight = P::Scalar::from_ratio(n as i64, i as i64);
            right.push(right[right.len() - 1].lerp(&points[i], weight));
        }
        let meeting = right.pop().unwrap_or_else(|| points[n].clone());
        // Solved, an old point is Σ ±C(n, j)/C(n − 1, i)·b̃ⱼ over j ≤ i. On its own half of the
        // polygon that is at most (i + 1)·n/(n − i) ≤ n + 1 times the largest coordinate, with
        // five roundings a step; the given points have been rounded twice themselves.
        let largest = super::laws::largest_coordinate(points);
        let allowed = Rounding::new(5 * n + 7, 2.0 * (n as f64 + 1.0) * largest).bound();
        let gap = meeting.difference(&left[last_of_left]);
        let meets = gap.coordinates().iter().all(|coordinate| {
            if P::Scalar::EXACT {
                *coordinate == P::Scalar::from_integer(0)
            } else {
                coordinate.magnitude() <= allowed
            }
        });
        if !meets {
            return Err(ReductionError::FullDegree {
                degree: n,
                gap: tuple(&gap),
            });
        }
        left.extend(right.into_iter().rev());
        Ok(Self::trusted(self.domain().clone(), left))
    }
}

/// Why a curve cannot be written with one control point fewer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReductionError {
    /// The curve has a single control point.
    #[error("a curve of degree 0 has one control point and cannot lose it")]
    Constant,
    /// The polynomial really has degree n.
    #[error(
        "the curve has full degree {degree}: reduced from both ends, the polygons miss each other by {gap}; keep the degree, or approximate"
    )]
    FullDegree {
        /// The degree n.
        degree: usize,
        /// The displacement between the two halves in the middle.
        gap: String,
    },
}
