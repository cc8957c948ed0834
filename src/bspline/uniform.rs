//! Spline curves with equidistant knots.

use thiserror::Error;

use crate::affine::{Affine, Interval, Linear};
use crate::bezier::BezierCurve;
use crate::scalar::{OrderedScalar, Scalar};

/// A spline curve of degree n with equidistant knots.
///
/// Over the knots ℤ, which [`new`](Self::new) takes, it is
///
/// ```text
/// s(u) = Σᵢ Pᵢ·Nⁿ(u − i),   n ≤ u ≤ m + 1,   i = 0 … m
/// ```
///
/// with the [uniform B-spline](super::uniform_b_spline) Nⁿ.
/// It consists of m + 1 − n polynomial segments. Segment j, over [n + j, n + j + 1], depends on
/// Pⱼ … Pⱼ₊ₙ alone, and with its blossom sⱼ each of these points is
///
/// ```text
/// Pᵢ = sⱼ(i + 1, i + 2, …, i + n),   j ≤ i ≤ j + n.
/// ```
///
/// A [`periodic`](Self::periodic) spline takes its control points cyclically and is a closed curve.
/// The control points may be points, vectors or numbers, and are always finite.
///
/// # Examples
///
/// ```
/// use cagd::bspline::UniformSpline;
///
/// let spline = UniformSpline::new(2, [0.0, 4.0, 20.0, 64.0])?;
/// assert_eq!((spline.domain().start(), spline.domain().end()), (2.0, 4.0));
/// assert_eq!(spline.at(2.0)?, 2.0, "the middle of the first leg");
/// assert_eq!(spline.at(2.5)?, (0.0 + 6.0 * 4.0 + 20.0) / 8.0);
/// # Ok::<(), cagd::bspline::UniformSplineError>(())
/// ```
///
/// Source: `prautzsch2002`, §5.1; `ramshaw1989`.
#[derive(Debug, Clone, PartialEq)]
pub struct UniformSpline<P: Affine> {
    degree: usize,
    control_points: Vec<P>,
    periodic: bool,
    start: P::Scalar,
    knot_distance: P::Scalar,
}

impl<P: Affine> UniformSpline<P> {
    /// The open spline of this degree with the knots ℤ over [n, m + 1].
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::TooFewControlPoints`] unless there are n + 1 control points or more,
    /// [`UniformSplineError::NotFinite`] if one is not finite.
    ///
    /// ```
    /// use cagd::bspline::UniformSpline;
    ///
    /// let refused = UniformSpline::new(3, [0.0, 1.0, 2.0]).unwrap_err();
    /// assert_eq!(refused.to_string(), "an open spline of degree 3 needs 4 control points or more, found 3; add some, or lower the degree");
    /// ```
    pub fn new(
        degree: usize,
        control_points: impl IntoIterator<Item = P>,
    ) -> Result<Self, UniformSplineError> {
        Self::checked(degree, control_points, false)
    }

    /// The closed spline of this degree with the knots ℤ over [n, n + K], where K is the number of control points.
    ///
    /// Pᵢ₊ₖ = Pᵢ, so that s(n + K) = s(n).
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::TooFewControlPoints`] if there is none,
    /// [`UniformSplineError::NotFinite`] if one is not finite.
    ///
    /// ```
    /// use cagd::bspline::UniformSpline;
    ///
    /// let spline = UniformSpline::periodic(2, [0.0, 4.0, 2.0])?;
    /// assert_eq!(spline.segment_count(), 3);
    /// assert_eq!((spline.at(2.0)?, spline.at(5.0)?), (2.0, 2.0));
    /// # Ok::<(), cagd::bspline::UniformSplineError>(())
    /// ```
    pub fn periodic(
        degree: usize,
        control_points: impl IntoIterator<Item = P>,
    ) -> Result<Self, UniformSplineError> {
        Self::checked(degree, control_points, true)
    }

    fn checked(
        degree: usize,
        control_points: impl IntoIterator<Item = P>,
        periodic: bool,
    ) -> Result<Self, UniformSplineError> {
        let control_points: Vec<P> = control_points.into_iter().collect();
        let needed = if periodic { 1 } else { degree + 1 };
        if control_points.len() < needed {
            return Err(UniformSplineError::TooFewControlPoints {
                kind: if periodic { "a closed" } else { "an open" },
                degree,
                needed,
                found: control_points.len(),
            });
        }
        if let Some(index) = control_points
            .iter()
            .position(|point| !point.coordinates().iter().all(Scalar::is_finite))
        {
            return Err(UniformSplineError::NotFinite {
                index,
                point: format!("{:?}", control_points[index]),
            });
        }
        Ok(Self {
            degree,
            control_points,
            periodic,
            start: P::Scalar::from_integer(degree as i64),
            knot_distance: P::Scalar::from_integer(1),
        })
    }

    /// The degree n.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The control points P₀ … Pₘ; of a periodic spline one period.
    #[must_use]
    pub fn control_points(&self) -> &[P] {
        &self.control_points
    }

    /// Whether the control points are taken cyclically.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    /// The distance of neighbouring knots: 1, halved by each [refinement](Self::refined).
    #[must_use]
    pub fn knot_distance(&self) -> P::Scalar {
        self.knot_distance.clone()
    }

    /// The number of polynomial segments: m + 1 − n, or the number of control points of a periodic spline.
    #[must_use]
    pub fn segment_count(&self) -> usize {
        if self.periodic {
            self.control_points.len()
        } else {
            self.control_points.len() - self.degree
        }
    }

    /// The parameter interval: [n, m + 1] for the knots ℤ, kept by refinement.
    #[must_use]
    pub fn domain(&self) -> Interval<P::Scalar> {
        self.interval(0, self.segment_count())
    }

    /// The knot between the segments j − 1 and j, for any whole number j.
    fn knot(&self, j: i64) -> P::Scalar {
        self.start.clone() + self.knot_distance.clone() * P::Scalar::from_integer(j)
    }

    fn interval(&self, first: usize, behind: usize) -> Interval<P::Scalar> {
        Interval::new(self.knot(first as i64), self.knot(behind as i64))
            .expect("knots of different numbers are different: their distance is a power of two")
    }

    /// Control point number i of the segment that begins at `first`, cyclically.
    fn cyclic(&self, i: i64) -> &P {
        let count = self.control_points.len() as i64;
        &self.control_points[i.rem_euclid(count) as usize]
    }

    /// The value of the blossom of segment j = `first` at arguments counted in knots from the start of the segment.
    ///
    /// De Boor's algorithm: each step replaces one knot among the arguments.
    fn local_blossom(&self, first: i64, argument: impl Fn(usize) -> P::Scalar) -> P {
        let n = self.degree;
        let mut points: Vec<P> = (0..=n as i64)
            .map(|l| self.cyclic(first + l).clone())
            .collect();
        for step in 1..=n {
            let span = P::Scalar::from_integer((n + 1 - step) as i64);
            let t = argument(step);
            for l in (step..=n).rev() {
                let above = t.clone() + P::Scalar::from_integer((n - l) as i64);
                points[l] = points[l - 1].lerp(&points[l], above / span.clone());
            }
        }
        points.swap_remove(n)
    }

    /// Segment number `index` as a Bézier curve over its parameter interval; its blossom is that of the segment.
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::NoSuchSegment`] if there are not so many.
    ///
    /// ```
    /// use cagd::bspline::UniformSpline;
    ///
    /// let spline = UniformSpline::new(2, [0.0, 4.0, 20.0, 64.0])?;
    /// let segment = spline.segment(0)?;
    /// assert_eq!(segment.control_points(), [2.0, 4.0, 12.0], "middle of a leg, vertex, middle of the next");
    /// // s(2, 3) is the control point that both segments share.
    /// assert_eq!(segment.blossom().at(&[2.0, 3.0])?, 4.0);
    /// assert_eq!(spline.segment(1)?.blossom().at(&[2.0, 3.0])?, 4.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn segment(&self, index: usize) -> Result<BezierCurve<P>, UniformSplineError> {
        if index >= self.segment_count() {
            return Err(UniformSplineError::NoSuchSegment {
                index,
                count: self.segment_count(),
            });
        }
        let n = self.degree;
        let points = (0..=n).map(|ends| {
            self.local_blossom(index as i64, |step| {
                P::Scalar::from_integer(i64::from(step > n - ends))
            })
        });
        Ok(BezierCurve::trusted(
            self.interval(index, index + 1),
            points.collect(),
        ))
    }

    /// The same curve with twice as many knots: a knot in the middle of every interval.
    ///
    /// The new control points are values of the blossom of the old segments at neighbouring new knots.
    /// For the knots ℤ they are s((i + 1)/2, …, (i + n)/2), i = n … 2m + 1.
    /// k control points become 2k − n, or 2k if the spline is periodic; the domain stays.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bspline::UniformSpline;
    ///
    /// let spline = UniformSpline::new(2, [0.0, 4.0, 20.0, 64.0])?;
    /// let refined = spline.refined();
    /// assert_eq!(refined.control_points(), [1.0, 3.0, 8.0, 16.0, 31.0, 53.0]);
    /// assert_eq!(refined.at(2.25)?, spline.at(2.25)?);
    /// # Ok::<(), cagd::bspline::UniformSplineError>(())
    /// ```
    ///
    /// Source: `class-notes`, §5; `ramshaw1989`.
    #[must_use]
    pub fn refined(&self) -> Self {
        let n = self.degree as i64;
        let segments = self.segment_count() as i64;
        let count = if self.periodic {
            2 * segments
        } else {
            2 * segments + n
        };
        let point = |j: i64| {
            // Point j belongs to the new segments j − n … j; an old one around the middle of them is asked.
            let middle = j - n / 2;
            let new_segment = if self.periodic {
                middle
            } else {
                middle.clamp(0, 2 * segments - 1)
            };
            let old_segment = new_segment.div_euclid(2);
            self.local_blossom(old_segment, |step| {
                // The new knots (j − n + 1)/2 … j/2, counted from the start of the old segment.
                P::Scalar::from_ratio(j - n + step as i64 - 2 * old_segment, 2)
            })
        };
        Self {
            degree: self.degree,
            control_points: (0..count).map(point).collect(),
            periodic: self.periodic,
            start: self.start.clone(),
            knot_distance: self.knot_distance.clone() * P::Scalar::from_ratio(1, 2),
        }
    }

    /// The derivative s′, a spline of degree n − 1 over the same domain, with the control points (Pᵢ₊₁ − Pᵢ)/h.
    ///
    /// h is the distance of the knots.
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::NoDerivative`] for degree 0,
    /// [`UniformSplineError::NotFinite`] if a difference is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::bspline::UniformSpline;
    ///
    /// let derivative = UniformSpline::new(2, [0.0, 4.0, 20.0, 64.0])?.derivative()?;
    /// assert_eq!(derivative.at(2.0)?, 4.0, "at the middle of the first leg: the vector of the leg");
    /// # Ok::<(), cagd::bspline::UniformSplineError>(())
    /// ```
    pub fn derivative(&self) -> Result<UniformSpline<P::Difference>, UniformSplineError> {
        let degree = self
            .degree
            .checked_sub(1)
            .ok_or(UniformSplineError::NoDerivative)?;
        let legs = if self.periodic {
            self.control_points.len()
        } else {
            self.control_points.len() - 1
        };
        let per_knot = P::Scalar::from_integer(1) / self.knot_distance.clone();
        let differences = (0..legs as i64).map(|i| {
            self.cyclic(i + 1)
                .difference(self.cyclic(i))
                .scaled(per_knot.clone())
        });
        let mut derivative = UniformSpline::checked(degree, differences, self.periodic)?;
        derivative.start = self.start.clone();
        derivative.knot_distance = self.knot_distance.clone();
        Ok(derivative)
    }
}

impl<P: Affine<Scalar: OrderedScalar>> UniformSpline<P> {
    /// The point s(u), by de Boor's algorithm: n(n + 1)/2 affine combinations.
    ///
    /// At a knot the segment to the right counts, at the end of the domain the last one.
    /// Inside the domain each step is a mean, so in `f64` a coordinate is wrong by at most 8n·u·max|Pᵢ|, u = 2⁻⁵³,
    /// besides what the rounding of the parameter itself moves the point.
    ///
    /// # Errors
    ///
    /// [`UniformSplineError::OutsideDomain`] if u is not in the domain.
    ///
    /// ```
    /// use cagd::bspline::{UniformSpline, UniformSplineError};
    ///
    /// let spline = UniformSpline::new(3, [0.0, 6.0, 0.0, 0.0])?;
    /// assert_eq!(spline.at(3.0)?, 4.0);
    /// assert!(matches!(spline.at(4.5), Err(UniformSplineError::OutsideDomain { .. })));
    /// # Ok::<(), UniformSplineError>(())
    /// ```
    ///
    /// Source: `prautzsch2002`, §5.3.
    pub fn at(&self, u: P::Scalar) -> Result<P, UniformSplineError> {
        let x = (u.clone() - self.start.clone()) / self.knot_distance.clone();
        let last = self.segment_count() as i64;
        // Not `x < 0 || x > last`, which NaN would pass.
        if !(P::Scalar::from_integer(0) <= x && x <= P::Scalar::from_integer(last)) {
            return Err(UniformSplineError::OutsideDomain {
                parameter: u.to_string(),
                start: self.domain().start().to_string(),
                end: self.domain().end().to_string(),
            });
        }
        let segment = segment_of(&x).min(last - 1);
        let t = x - P::Scalar::from_integer(segment);
        Ok(self.local_blossom(segment, |_| t.clone()))
    }
}

/// The largest whole number ≤ x, for x ≥ 0 of the size of an index.
fn segment_of<T: OrderedScalar>(x: &T) -> i64 {
    let mut whole = x.to_f64() as i64;
    // The conversion rounds, so it can be one too high or too low next to a whole number.
    if T::from_integer(whole) > *x {
        whole -= 1;
    } else if T::from_integer(whole + 1) <= *x {
        whole += 1;
    }
    whole
}

/// Why there is no uniform spline, or no point of it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum UniformSplineError {
    /// The degree is too high for so few control points.
    #[error(
        "{kind} spline of degree {degree} needs {needed} control points or more, found {found}; add some, or lower the degree"
    )]
    TooFewControlPoints {
        /// Open or closed.
        kind: &'static str,
        /// The degree.
        degree: usize,
        /// How many there must be.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// A control point has a coordinate that is NaN or infinite.
    #[error(
        "control point {index} of the spline is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which control point, counted from 0.
        index: usize,
        /// The point.
        point: String,
    },
    /// The parameter is outside of the domain, or not finite.
    #[error(
        "the parameter {parameter} is not in the domain [{start}, {end}] of the spline; choose one from there"
    )]
    OutsideDomain {
        /// The parameter.
        parameter: String,
        /// The start of the domain.
        start: String,
        /// The end of the domain.
        end: String,
    },
    /// There are not so many segments.
    #[error("the spline has {count} segments, counted from 0; there is no segment {index}")]
    NoSuchSegment {
        /// The segment asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A spline of degree 0 is piecewise constant and jumps.
    #[error("a spline of degree 0 jumps at its knots and has no derivative; raise the degree")]
    NoDerivative,
}
