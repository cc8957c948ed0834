//! Intersections of curves with lines and hyperplanes.

use num_traits::Zero;

use super::curve::{BezierCurve, BezierError};
use super::roots::{Root, RootSearch, Roots};
use crate::affine::{Hyperplane, Point};
use crate::scalar::{BigRational, OrderedScalar, Scalar, exact};

/// Where a curve meets a line or hyperplane.
#[derive(Debug, Clone, PartialEq)]
pub enum LineIntersections<T> {
    /// The curve lies in it.
    Within,
    /// Parameter intervals in increasing order; every intersection lies in one of them.
    Parameters(Vec<Root<T>>),
}

impl<T> LineIntersections<T> {
    /// The parameter intervals; none if the curve lies in the line.
    #[must_use]
    pub fn parameters(&self) -> &[Root<T>] {
        match self {
            Self::Within => &[],
            Self::Parameters(roots) => roots,
        }
    }
}

impl<T: Scalar, const D: usize> BezierCurve<Point<T, D>> {
    /// The function of a hyperplane along the curve: the polynomial ⟨b(u), m⟩ − c in Bernstein form.
    ///
    /// ```text
    /// ⟨b(u), m⟩ − c = Σ (⟨bᵢ, m⟩ − c)·Bᵢⁿ(t)
    /// ```
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if a value is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Line, Point};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;
    /// let height_over_one = curve.hyperplane_function(&Line::new([0.0, 1.0], 1.0)?)?;
    /// assert_eq!(height_over_one.control_points(), [-1.0, 1.0, -1.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn hyperplane_function(
        &self,
        hyperplane: &Hyperplane<T, D>,
    ) -> Result<BezierCurve<T>, BezierError> {
        let values = self.control_points().iter().map(|p| hyperplane.value(p));
        BezierCurve::on(self.domain().clone(), values)
    }
}

impl<T: OrderedScalar, const D: usize> BezierCurve<Point<T, D>> {
    /// The parameters of the domain at which the curve meets a line (in space: a hyperplane).
    ///
    /// They are the roots of ⟨b(u), m⟩ − c, so there are at most n unless the curve lies in the line.
    /// None is missed. Over exact numbers each has its multiplicity; over `f64` the rounding errors of
    /// the line function are allowed for, and what they leave open is marked as possible.
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if a value of the line function is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Line, Point};
    /// use cagd::bezier::{BezierCurve, LineIntersections};
    ///
    /// let arch = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;
    /// let meetings = arch.line_intersections(&Line::new([0.0, 1.0], 0.75)?)?;
    /// assert_eq!(meetings.parameters().len(), 2);
    /// assert!(meetings.parameters()[0].contains(&0.25));
    /// assert!(meetings.parameters()[1].contains(&0.75));
    ///
    /// let flat = BezierCurve::new([[0.0, 1.0], [1.0, 1.0], [5.0, 1.0]].map(Point::new))?;
    /// assert_eq!(flat.line_intersections(&Line::new([0.0, 1.0], 1.0)?)?, LineIntersections::Within);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `compendium`, Remark 7, corrected.
    pub fn line_intersections(
        &self,
        line: &Hyperplane<T, D>,
    ) -> Result<LineIntersections<T>, BezierError> {
        let function = self.hyperplane_function(line)?;
        if T::EXACT {
            return Ok(RootSearch::default().run(&function).into());
        }
        let exact_values: Vec<BigRational> = self
            .control_points()
            .iter()
            .map(|point| exact_value(line, point))
            .collect();
        if exact_values.iter().all(Zero::is_zero) {
            return Ok(LineIntersections::Within);
        }
        let search = RootSearch {
            coefficient_error: largest_error(function.control_points(), &exact_values),
            ..RootSearch::default()
        };
        Ok(search.run(&function).into())
    }
}

impl<T> From<Roots<T>> for LineIntersections<T> {
    fn from(roots: Roots<T>) -> Self {
        match roots {
            Roots::Everywhere => Self::Within,
            Roots::Isolated(roots) => Self::Parameters(roots),
        }
    }
}

/// The value of the line function without rounding; every finite `f64` is a fraction.
fn exact_value<T: OrderedScalar, const D: usize>(
    line: &Hyperplane<T, D>,
    point: &Point<T, D>,
) -> BigRational {
    let fraction = |x: &T| exact(x.to_f64()).unwrap_or_default();
    std::iter::zip(point.coordinates(), line.normal().iter())
        .map(|(x, m)| fraction(x) * fraction(m))
        .fold(-fraction(line.offset()), |sum, term| sum + term)
}

/// The largest distance of rounded values to the exact ones, itself rounded up.
fn largest_error<T: OrderedScalar>(rounded: &[T], exact_values: &[BigRational]) -> f64 {
    std::iter::zip(rounded, exact_values)
        .map(|(rounded, value)| {
            let error = exact(rounded.to_f64()).unwrap_or_default() - value;
            if error.is_zero() {
                0.0
            } else {
                (error.magnitude() * (1.0 + f64::EPSILON)).max(f64::MIN_POSITIVE)
            }
        })
        .fold(0.0, f64::max)
}
