//! The algorithm of de Casteljau and its triangle.

use super::curve::{BezierCurve, BezierError, tuple};
use crate::affine::Affine;
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The point b(u), by the algorithm of de Casteljau.
    ///
    /// ```text
    /// bᵢ⁰ = bᵢ,   bᵢʲ = (1 − t)·bᵢʲ⁻¹ + t·bᵢ₊₁ʲ⁻¹,   b(u) = b₀ⁿ,   t = (u − a)/(b − a)
    /// ```
    ///
    /// Works in place: n(n + 1)/2 affine combinations, n + 1 points of memory.
    /// `u` may lie outside the domain; then the formula extrapolates.
    /// For a parameter that is not finite, or a result beyond the range of the number type, the
    /// coordinates are not finite; [`try_at`](Self::try_at) makes that an error.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Interval, Point};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::on(Interval::new(0.0, 2.0)?, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// assert_eq!(curve.at(1.0), Point::new([2.0, 2.0]));
    /// assert_eq!(curve.at(2.0), Point::new([4.0, 0.0]), "the last control point");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Over dual numbers u + ε the same program gives the point and, beside it, the derivative;
    /// over complex numbers it gives the points of the complex curve.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::scalar::{Complex64, Dual64};
    ///
    /// let points = [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new);
    /// let dual = BezierCurve::new(points.map(|point| point.map(Dual64::from_re)))?;
    /// let point = dual.at(Dual64::new(0.5, 1.0));
    /// assert_eq!(point.map(|x| x.re), Point::new([2.0, 3.0]), "b(1/2)");
    /// assert_eq!([point[0].eps, point[1].eps], [6.0, 0.0], "b′(1/2)");
    ///
    /// let square = BezierCurve::new([0.0, 0.0, 1.0].map(Complex64::from))?;
    /// assert_eq!(square.at(Complex64::I), Complex64::from(-1.0), "i² = −1");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §4.2.
    #[must_use]
    pub fn at(&self, u: P::Scalar) -> P {
        let t = self.domain().local(u);
        let mut points = self.control_points().to_vec();
        for level in 1..=self.degree() {
            for i in 0..=self.degree() - level {
                points[i] = points[i].lerp(&points[i + 1], t.clone());
            }
        }
        points.swap_remove(0)
    }

    /// The point b(u), or why there is none.
    ///
    /// # Errors
    ///
    /// [`BezierError::ParameterNotFinite`] for a parameter that is NaN or infinite,
    /// [`BezierError::OutOfRange`] if the point is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, BezierError};
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 1.0]].map(Point::new))?;
    /// assert!(matches!(curve.try_at(f64::NAN), Err(BezierError::ParameterNotFinite { .. })));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn try_at(&self, u: P::Scalar) -> Result<P, BezierError> {
        if !u.is_finite() {
            return Err(BezierError::ParameterNotFinite {
                parameter: u.to_string(),
            });
        }
        let point = self.at(u.clone());
        if point.coordinates().iter().all(Scalar::is_finite) {
            Ok(point)
        } else {
            Err(BezierError::OutOfRange {
                parameter: u.to_string(),
                value: tuple(&point),
            })
        }
    }

    /// All points bᵢʲ of the algorithm of de Casteljau at the parameter `u`.
    #[must_use]
    pub fn triangle(&self, u: P::Scalar) -> CasteljauTriangle<P> {
        let t = self.domain().local(u);
        CasteljauTriangle::new(self.control_points(), |_| t.clone())
    }
}

/// The triangular scheme of de Casteljau: column j holds the n + 1 − j points bᵢʲ.
///
/// ```text
/// b₀⁰
///     ╲
/// b₁⁰ ─ b₀¹
///     ╲     ╲
/// b₂⁰ ─ b₁¹ ─ b₀²
/// ```
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
///
/// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
/// let triangle = curve.triangle(0.5);
/// assert_eq!(triangle.column(1), [[0.0, 2.0], [2.0, 4.0], [4.0, 2.0]].map(Point::new));
/// assert_eq!(triangle.point(2, 1), &Point::new([3.0, 3.0]), "b₁²");
/// assert_eq!(triangle.tip(), &curve.at(0.5));
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CasteljauTriangle<P> {
    columns: Vec<Vec<P>>,
}

impl<P: Affine> CasteljauTriangle<P> {
    /// The scheme over these control points, with the parameter `parameter(j)` in step j = 1 … n.
    ///
    /// One parameter in all steps gives a curve point, different ones give the blossom.
    pub(crate) fn new(control_points: &[P], parameter: impl Fn(usize) -> P::Scalar) -> Self {
        let mut columns = vec![control_points.to_vec()];
        for level in 1..control_points.len() {
            let t = parameter(level);
            let previous = &columns[level - 1];
            let column = previous
                .windows(2)
                .map(|pair| pair[0].lerp(&pair[1], t.clone()));
            columns.push(column.collect());
        }
        Self { columns }
    }

    /// The degree n: the number of steps.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.columns.len() - 1
    }

    /// The points b₀ʲ … bₙ₋ⱼʲ of column `level` = j, 0 ≤ j ≤ n.
    ///
    /// # Panics
    ///
    /// If `level` exceeds the degree.
    #[must_use]
    pub fn column(&self, level: usize) -> &[P] {
        &self.columns[level]
    }

    /// The point bᵢʲ with j = `level` and i = `index`, 0 ≤ i ≤ n − j.
    ///
    /// # Panics
    ///
    /// If there is no such point.
    #[must_use]
    pub fn point(&self, level: usize, index: usize) -> &P {
        &self.columns[level][index]
    }

    /// The point at the tip, b₀ⁿ: the curve point.
    #[must_use]
    pub fn tip(&self) -> &P {
        &self.columns[self.degree()][0]
    }

    /// All columns, the control points first.
    pub fn columns(&self) -> impl ExactSizeIterator<Item = &[P]> {
        self.columns.iter().map(Vec::as_slice)
    }

    /// The first points b₀⁰, b₀¹, …, b₀ⁿ of the columns: the control points of the left piece.
    pub fn left_side(&self) -> impl Iterator<Item = &P> {
        self.columns.iter().map(|column| &column[0])
    }

    /// The last points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the columns: the control points of the right piece.
    pub fn right_side(&self) -> impl Iterator<Item = &P> {
        self.columns
            .iter()
            .rev()
            .map(|column| &column[column.len() - 1])
    }
}
