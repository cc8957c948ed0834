//! How far a Bézier curve is from its chord and from its control polygon.
//!
//! Everything is said with the second differences of the control points,
//!
//! ```text
//! Δ²bₖ = bₖ₊₂ − 2bₖ₊₁ + bₖ,   ‖Δ²b‖ = max |Δ²bₖ|,   k = 0 … n − 2,
//! ```
//!
//! in any norm: a norm is an argument, [`maximum_norm`] (exact for exact numbers) or [`euclidean_norm`].

use num_traits::Zero;
use thiserror::Error;

use super::curve::BezierCurve;
use crate::affine::{Affine, Linear};
use crate::scalar::{OrderedScalar, Real, Scalar};

/// The largest absolute value of a coordinate, |v|_∞.
///
/// ```
/// use cagd::affine::Vector;
/// assert_eq!(cagd::bezier::bounds::maximum_norm(&Vector::from([3.0, -4.0])), 4.0);
/// ```
pub fn maximum_norm<V: Linear>(vector: &V) -> V::Scalar
where
    V::Scalar: OrderedScalar,
{
    vector
        .coordinates()
        .iter()
        .fold(V::Scalar::zero(), |largest, x| largest.max(x.abs()))
}

/// The Euclidean length |v|₂.
///
/// The vector is scaled by its largest coordinate first, so that no square leaves the range of the numbers.
///
/// ```
/// use cagd::affine::Vector;
/// use cagd::bezier::bounds::euclidean_norm;
/// assert_eq!(euclidean_norm(&Vector::from([3.0, -4.0])), 5.0);
/// let huge = 2.0_f64.powi(1000);
/// assert_eq!(euclidean_norm(&Vector::from([3.0 * huge, -4.0 * huge])), 5.0 * huge);
/// ```
pub fn euclidean_norm<V: Linear>(vector: &V) -> V::Scalar
where
    V::Scalar: Real,
{
    let largest = maximum_norm(vector);
    if largest.is_zero() || !largest.is_finite() {
        return largest;
    }
    let sum = vector
        .coordinates()
        .iter()
        .fold(V::Scalar::zero(), |sum, &x| {
            sum + (x / largest) * (x / largest)
        });
    largest * sum.sqrt()
}

/// The factor n(n − 1)/8 of the chord bound; 0 for n ≤ 1.
///
/// ```
/// assert_eq!(cagd::bezier::bounds::chord_factor::<f64>(3), 0.75);
/// ```
#[must_use]
pub fn chord_factor<T: Scalar>(degree: usize) -> T {
    let n = degree as i64;
    T::from_ratio(n * (n - 1), 8)
}

/// The factor N_∞(n) = ⌊n/2⌋·⌈n/2⌉/(2n) of the control polygon bound; 0 for n ≤ 1.
///
/// ```
/// use cagd::bezier::bounds::control_polygon_factor;
/// assert_eq!(control_polygon_factor::<f64>(2), 0.25);
/// assert_eq!(control_polygon_factor::<f64>(4), 0.5);
/// ```
#[must_use]
pub fn control_polygon_factor<T: Scalar>(degree: usize) -> T {
    if degree == 0 {
        return T::zero();
    }
    let n = degree as i64;
    T::from_ratio((n / 2) * (n - n / 2), 2 * n)
}

impl<P: Affine> BezierCurve<P> {
    /// The second differences Δ²bₖ = (bₖ₊₂ − bₖ₊₁) − (bₖ₊₁ − bₖ), k = 0 … n − 2; none for n ≤ 1.
    ///
    /// Over [0, 1] the vectors n(n − 1)Δ²bₖ are the control vectors of b″.
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    /// assert_eq!(BezierCurve::new([0.0, 1.0, 4.0, 9.0])?.second_differences(), [2.0, 2.0]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn second_differences(&self) -> Vec<P::Difference> {
        second_differences(self.control_points())
    }

    /// ‖Δ²b‖ in a given norm; 0 for n ≤ 1.
    pub fn largest_second_difference(&self, norm: impl Fn(&P::Difference) -> P::Scalar) -> P::Scalar
    where
        P::Scalar: OrderedScalar,
    {
        self.second_differences()
            .iter()
            .fold(P::Scalar::zero(), |largest, difference| {
                largest.max(norm(difference))
            })
    }

    /// How far the curve can be from its chord, parameter by parameter.
    ///
    /// ```text
    /// |b(t) − L(t)| ≤ n(n − 1)/8·‖Δ²b‖,   L(t) = (1 − t)b₀ + t·bₙ,   0 ≤ t ≤ 1
    /// ```
    ///
    /// In `f64` the bound passes at most 5 roundings, those of differences near 10³⁰⁸ may be infinite.
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, bounds::maximum_norm};
    ///
    /// let curve = BezierCurve::new([0.0, 0.0, 1.0])?; // t², chord t
    /// assert_eq!(curve.chord_bound(maximum_norm), 0.25);
    /// assert_eq!((curve.at(0.5) - 0.5).abs(), 0.25, "the bound is reached");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `wang1984`, `filip1986`.
    pub fn chord_bound(&self, norm: impl Fn(&P::Difference) -> P::Scalar) -> P::Scalar
    where
        P::Scalar: OrderedScalar,
    {
        chord_factor::<P::Scalar>(self.degree()) * self.largest_second_difference(norm)
    }

    /// How far the curve can be from its control polygon, parameter by parameter.
    ///
    /// ```text
    /// |b(t) − l(t)| ≤ N_∞(n)·‖Δ²b‖,   l(k/n) = bₖ and linear between,   0 ≤ t ≤ 1
    /// ```
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, bounds::maximum_norm};
    ///
    /// let curve = BezierCurve::new([0.0, 1.0, 4.0])?; // bₖ = k²
    /// assert_eq!(curve.control_polygon_bound(maximum_norm), 0.5);
    /// assert_eq!(curve.at(0.5) - 1.0, 0.5, "the bound is reached at t = 1/2, where l = b₁");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `nairn1999`, `reif2000`.
    pub fn control_polygon_bound(&self, norm: impl Fn(&P::Difference) -> P::Scalar) -> P::Scalar
    where
        P::Scalar: OrderedScalar,
    {
        control_polygon_factor::<P::Scalar>(self.degree()) * self.largest_second_difference(norm)
    }

    /// After how many halvings every piece is within `tolerance` of its chord: known in advance.
    ///
    /// ```text
    /// the least k ≥ 0 with 4ᵏ·ε ≥ n(n − 1)/8·‖Δ²b‖
    /// ```
    ///
    /// # Errors
    ///
    /// As [`halvings`].
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, bounds::maximum_norm};
    ///
    /// let curve = BezierCurve::new([0.0, 0.0, 1.0])?; // bound 1/4
    /// assert_eq!(curve.subdivision_depth(&0.25, maximum_norm)?, 0);
    /// assert_eq!(curve.subdivision_depth(&0.2, maximum_norm)?, 1);
    /// assert_eq!(curve.subdivision_depth(&1e-6, maximum_norm)?, 9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn subdivision_depth(
        &self,
        tolerance: &P::Scalar,
        norm: impl Fn(&P::Difference) -> P::Scalar,
    ) -> Result<usize, ToleranceError>
    where
        P::Scalar: OrderedScalar,
    {
        halvings(&self.chord_bound(norm), tolerance)
    }
}

/// The second differences of a sequence.
pub(crate) fn second_differences<P: Affine>(points: &[P]) -> Vec<P::Difference> {
    points
        .windows(3)
        .map(|p| p[2].difference(&p[1]).difference(&p[1].difference(&p[0])))
        .collect()
}

/// The least k ≥ 0 with 4ᵏ·tolerance ≥ bound: how often to halve if each halving divides the bound by 4.
///
/// No logarithm is taken: the tolerance is multiplied by 4, which is exact, until it reaches the bound.
/// So huge and tiny numbers are safe; at most 1075 steps for `f64`.
///
/// # Errors
///
/// [`ToleranceError::NotPositive`] if the tolerance is not a positive finite number,
/// [`ToleranceError::BoundOutOfRange`] if the bound is infinite or NaN.
///
/// ```
/// use cagd::bezier::bounds::{ToleranceError, halvings};
///
/// assert_eq!(halvings(&1e300, &5e-324)?, 1036);
/// assert!(matches!(halvings(&1.0, &0.0), Err(ToleranceError::NotPositive { .. })));
/// assert!(matches!(halvings(&f64::INFINITY, &1.0), Err(ToleranceError::BoundOutOfRange { .. })));
/// # Ok::<(), ToleranceError>(())
/// ```
pub fn halvings<T: OrderedScalar>(bound: &T, tolerance: &T) -> Result<usize, ToleranceError> {
    if !(*tolerance > T::zero() && tolerance.is_finite()) {
        return Err(ToleranceError::NotPositive {
            tolerance: tolerance.to_string(),
        });
    }
    if !bound.is_finite() {
        return Err(ToleranceError::BoundOutOfRange {
            bound: bound.to_string(),
        });
    }
    let four = T::from_integer(4);
    let mut reach = tolerance.clone();
    let mut steps = 0;
    while reach < *bound {
        reach *= four.clone();
        steps += 1;
    }
    Ok(steps)
}

/// The square of the distance of a point from the segment between two others.
///
/// Its root is a convex function of the point, so on a Bézier curve it is at most as large as at the
/// worst control point. Exact for exact numbers; in `f64` the squares must be in range.
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::bounds::segment_distance_squared;
///
/// let [start, end] = [[0.0, 0.0], [2.0, 0.0]].map(Point::new);
/// assert_eq!(segment_distance_squared(&Point::new([1.0, 3.0]), &start, &end), 9.0);
/// assert_eq!(segment_distance_squared(&Point::new([5.0, 4.0]), &start, &end), 25.0);
/// ```
pub fn segment_distance_squared<P: Affine>(point: &P, start: &P, end: &P) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let direction = end.difference(start);
    let offset = point.difference(start);
    let along = dot(&offset, &direction);
    let length = dot(&direction, &direction);
    if along <= P::Scalar::zero() || length.is_zero() {
        return dot(&offset, &offset);
    }
    if along >= length {
        let offset = point.difference(end);
        return dot(&offset, &offset);
    }
    let foot = start.lerp(end, along / length);
    let offset = point.difference(&foot);
    dot(&offset, &offset)
}

/// The scalar product of two differences.
pub(crate) fn dot<V: Linear>(a: &V, b: &V) -> V::Scalar {
    std::iter::zip(a.coordinates(), b.coordinates())
        .fold(V::Scalar::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
}

/// Why a tolerance cannot be kept.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ToleranceError {
    /// The tolerance is zero, negative, infinite or NaN.
    #[error("a tolerance must be a positive finite number, found {tolerance}")]
    NotPositive {
        /// The tolerance.
        tolerance: String,
    },
    /// The error bound is beyond the range of the number type.
    #[error(
        "the error bound of the curve is beyond the range of the number type: {bound}; scale the control points down"
    )]
    BoundOutOfRange {
        /// The bound.
        bound: String,
    },
}
