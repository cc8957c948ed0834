//! The blossom of a Bézier curve: its polar form, symmetric and affine in every argument.

use thiserror::Error;

use super::casteljau::CasteljauTriangle;
use super::curve::{BezierCurve, BezierError, tuple};
use crate::affine::{Affine, Interval};
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The blossom of the curve, with as many arguments as the degree says.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// // t² has the Bernstein coefficients 0, 0, 1 and the blossom x₁·x₂.
    /// let square = BezierCurve::new([0.0, 0.0, 1.0])?;
    /// assert_eq!(square.blossom().at(&[3.0, 5.0])?, 15.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn blossom(&self) -> Blossom<P> {
        Blossom {
            curve: self.clone(),
        }
    }

    /// The curve of degree n over `domain` = [a, b] whose blossom is the given function.
    ///
    /// Its control points are the values bᵢ = p(a, …, a, b, …, b), with a repeated n − i times and b
    /// repeated i times; the function is asked for these n + 1 values only.
    /// If it is symmetric and affine in every argument, it is the blossom of the curve.
    /// Otherwise it merely agrees with the blossom at these arguments.
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if a value is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let square = BezierCurve::<f64>::from_blossom(Interval::new(1.0, 3.0)?, 2, |x| x[0] * x[1])?;
    /// assert_eq!(square.control_points(), [1.0, 3.0, 9.0]);
    /// assert_eq!(square.at(2.0), 4.0);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `ramshaw1989`; `farin2002`, §4.4.
    pub fn from_blossom(
        domain: Interval<P::Scalar>,
        degree: usize,
        mut blossom: impl FnMut(&[P::Scalar]) -> P,
    ) -> Result<Self, BezierError> {
        let values: Vec<P> = (0..=degree)
            .map(|ends| blossom(&end_arguments(&domain, degree, ends)))
            .collect();
        Self::on(domain, values)
    }
}

/// The arguments a, …, a, b, …, b: the start n − i times, then the end i = `ends` times.
fn end_arguments<T: Scalar>(interval: &Interval<T>, degree: usize, ends: usize) -> Vec<T> {
    let mut arguments = vec![interval.start(); degree - ends];
    arguments.resize(degree, interval.end());
    arguments
}

/// The blossom p of a Bézier curve of degree n.
///
/// It is the only function of n arguments that
///
/// - is symmetric: the order of the arguments does not matter,
/// - is affine in every argument: p((1 − λ)u + λv, x₂, …) = (1 − λ)·p(u, x₂, …) + λ·p(v, x₂, …),
/// - has the curve on its diagonal: p(u, …, u) = b(u).
///
/// It is computed by de Casteljau's algorithm with the argument xⱼ in step j:
///
/// ```text
/// bᵢʲ = (1 − tⱼ)·bᵢʲ⁻¹ + tⱼ·bᵢ₊₁ʲ⁻¹,   tⱼ = (xⱼ − a)/(b − a),   p(x₁, …, xₙ) = b₀ⁿ
/// ```
///
/// The blossom depends on the degree: elevation gives the same curve another blossom.
/// A curve of degree 0 has a blossom without arguments, which is its only point.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
///
/// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
/// let p = curve.blossom();
/// assert_eq!(p.at(&[0.5, 0.5, 0.5])?, curve.at(0.5));
/// assert_eq!(p.at(&[0.0, 1.0, 1.0])?, curve.control_points()[2]);
/// assert_eq!(p.at(&[0.0, 0.5, 1.0])?, p.at(&[1.0, 0.0, 0.5])?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Source: `ramshaw1989`; `farin2002`, §4.4; `prautzsch2002`, §3.1.
#[derive(Debug, Clone, PartialEq)]
pub struct Blossom<P: Affine> {
    curve: BezierCurve<P>,
}

impl<P: Affine> Blossom<P> {
    /// The degree n: the number of arguments.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.curve.degree()
    }

    /// The value p(x₁, …, xₙ) at any n numbers.
    ///
    /// In floating point a value passes at most 9 roundings a level, 9n in all, three of them for
    /// the map of the argument to the unit interval.
    ///
    /// # Errors
    ///
    /// [`BlossomError::ArgumentCount`] unless there are n arguments,
    /// [`BlossomError::ArgumentNotFinite`] if one is NaN or infinite,
    /// [`BlossomError::OutOfRange`] if the value is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, BlossomError};
    ///
    /// let p = BezierCurve::new([0.0, 0.0, 1.0])?.blossom();
    /// let error = p.at(&[3.0]).unwrap_err();
    /// assert_eq!(error, BlossomError::ArgumentCount { degree: 2, found: 1 });
    /// assert_eq!(
    ///     error.to_string(),
    ///     "the blossom takes as many arguments as the degree, 2, not 1; repeat a parameter, or change the degree"
    /// );
    /// assert!(matches!(p.at(&[1.0, f64::NAN]), Err(BlossomError::ArgumentNotFinite { index: 1, .. })));
    /// assert!(matches!(p.at(&[1e200, 1e200]), Err(BlossomError::OutOfRange { .. })));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn at(&self, arguments: &[P::Scalar]) -> Result<P, BlossomError> {
        self.check(arguments)?;
        let value = self.value(arguments);
        if value.coordinates().iter().all(Scalar::is_finite) {
            Ok(value)
        } else {
            Err(BlossomError::OutOfRange {
                arguments: list(arguments),
                value: tuple(&value),
            })
        }
    }

    /// All points of de Casteljau's scheme with the argument xⱼ in step j; the value is its tip.
    ///
    /// # Errors
    ///
    /// [`BlossomError::ArgumentCount`] and [`BlossomError::ArgumentNotFinite`] as for [`at`](Self::at).
    pub fn scheme(&self, arguments: &[P::Scalar]) -> Result<CasteljauTriangle<P>, BlossomError> {
        self.check(arguments)?;
        Ok(CasteljauTriangle::new(
            self.curve.control_points(),
            |step| self.curve.domain().local(arguments[step - 1].clone()),
        ))
    }

    /// The scheme of de Casteljau at the parameter `u`, read as values of the blossom.
    #[must_use]
    pub fn triangle(&self, u: P::Scalar) -> BlossomTriangle<P> {
        BlossomTriangle {
            triangle: self.curve.triangle(u.clone()),
            domain: self.curve.domain().clone(),
            parameter: u,
        }
    }

    /// The control points p(c, …, c, d, …, d) of the same polynomial curve over `interval` = [c, d].
    ///
    /// The interval need not lie in the domain of the curve.
    /// Each point is evaluated by itself, which costs n(n + 1)²/2 combinations in all.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let square = BezierCurve::new([0.0, 0.0, 1.0])?;
    /// assert_eq!(square.blossom().control_points_on(&Interval::new(1.0, 3.0)?), [1.0, 3.0, 9.0]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn control_points_on(&self, interval: &Interval<P::Scalar>) -> Vec<P> {
        let n = self.degree();
        (0..=n)
            .map(|ends| self.value(&end_arguments(interval, n, ends)))
            .collect()
    }

    /// The same polynomial curve as a Bézier curve over another interval.
    ///
    /// Both curves agree at every parameter.
    /// If the interval is part of the domain, the new curve is the restriction to it.
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if a control point is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Interval, Point};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let middle = curve.blossom().curve_on(Interval::new(0.25, 0.75)?)?;
    /// assert_eq!(middle.control_points(), [[1.0, 1.5], [2.0, 2.5], [3.0, 1.5]].map(Point::new));
    /// assert_eq!(middle.at(0.5), curve.at(0.5));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn curve_on(&self, interval: Interval<P::Scalar>) -> Result<BezierCurve<P>, BezierError> {
        let points = self.control_points_on(&interval);
        BezierCurve::on(interval, points)
    }

    /// The value at n arguments that are known to be n.
    fn value(&self, arguments: &[P::Scalar]) -> P {
        let mut points = self.curve.control_points().to_vec();
        for (finished, argument) in arguments.iter().enumerate() {
            let t = self.curve.domain().local(argument.clone());
            for i in 0..arguments.len() - finished {
                points[i] = points[i].lerp(&points[i + 1], t.clone());
            }
        }
        points.swap_remove(0)
    }

    fn check(&self, arguments: &[P::Scalar]) -> Result<(), BlossomError> {
        if arguments.len() != self.degree() {
            return Err(BlossomError::ArgumentCount {
                degree: self.degree(),
                found: arguments.len(),
            });
        }
        match arguments.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(index) => Err(BlossomError::ArgumentNotFinite {
                index,
                argument: arguments[index].to_string(),
            }),
        }
    }
}

/// The scheme of de Casteljau at a parameter u with every point read as a value of the blossom.
///
/// ```text
/// bᵢʲ(u) = p(a, …, a, u, …, u, b, …, b)    a: n − j − i times,  u: j times,  b: i times
/// ```
///
/// For a cubic over [0, 1], with t for u:
///
/// ```text
/// p(0,0,0)
/// p(0,0,1)  p(0,0,t)
/// p(0,1,1)  p(0,t,1)  p(0,t,t)
/// p(1,1,1)  p(t,1,1)  p(t,t,1)  p(t,t,t)
/// ```
///
/// # Examples
///
/// ```
/// use cagd::bezier::BezierCurve;
///
/// let cube = BezierCurve::new([0.0, 0.0, 0.0, 1.0])?;
/// let triangle = cube.blossom().triangle(0.5);
/// let entry = triangle.entry(1, 2);
/// assert_eq!(entry.label(["0", "t", "1"]), "p(t,1,1)");
/// assert_eq!(triangle.arguments(1, 2), [0.5, 1.0, 1.0]);
/// assert_eq!(entry.point, &0.5, "x₁·x₂·x₃ at these arguments");
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
///
/// Source: `farin2002`, §4.4.
#[derive(Debug, Clone, PartialEq)]
pub struct BlossomTriangle<P: Affine> {
    triangle: CasteljauTriangle<P>,
    domain: Interval<P::Scalar>,
    parameter: P::Scalar,
}

impl<P: Affine> BlossomTriangle<P> {
    /// The degree n: the number of arguments of every entry.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.triangle.degree()
    }

    /// The points without their arguments.
    #[must_use]
    pub fn points(&self) -> &CasteljauTriangle<P> {
        &self.triangle
    }

    /// The entry bᵢʲ with j = `level`, 0 ≤ j ≤ n, and i = `index`, 0 ≤ i ≤ n − j.
    ///
    /// # Panics
    ///
    /// If there is no such entry.
    #[must_use]
    pub fn entry(&self, level: usize, index: usize) -> BlossomEntry<'_, P> {
        BlossomEntry {
            point: self.triangle.point(level, index),
            starts: self.degree() - level - index,
            parameters: level,
            ends: index,
        }
    }

    /// The entries of column `level`, the first index first.
    ///
    /// # Panics
    ///
    /// If `level` exceeds the degree.
    pub fn column(
        &self,
        level: usize,
    ) -> impl ExactSizeIterator<Item = BlossomEntry<'_, P>> + use<'_, P> {
        (0..self.triangle.column(level).len()).map(move |index| self.entry(level, index))
    }

    /// The arguments of an entry as numbers: first the starts, then the parameters, then the ends.
    ///
    /// # Panics
    ///
    /// If there is no such entry.
    #[must_use]
    pub fn arguments(&self, level: usize, index: usize) -> Vec<P::Scalar> {
        let entry = self.entry(level, index);
        entry.arranged(&[
            self.domain.start(),
            self.parameter.clone(),
            self.domain.end(),
        ])
    }
}

/// One point of a [`BlossomTriangle`] and how often each argument occurs in it.
#[derive(Debug, PartialEq)]
pub struct BlossomEntry<'t, P> {
    /// The value of the blossom.
    pub point: &'t P,
    /// How many arguments are the start a of the domain.
    pub starts: usize,
    /// How many arguments are the parameter u.
    pub parameters: usize,
    /// How many arguments are the end b of the domain.
    pub ends: usize,
}

impl<P> BlossomEntry<'_, P> {
    /// The value as it is written, such as `p(0,t,1)`, with names for start, parameter and end.
    #[must_use]
    pub fn label(&self, names: [&str; 3]) -> String {
        format!("p({})", self.arranged(&names).join(","))
    }

    fn arranged<A: Clone>(&self, [start, parameter, end]: &[A; 3]) -> Vec<A> {
        let mut arguments = vec![start.clone(); self.starts];
        arguments.resize(self.starts + self.parameters, parameter.clone());
        arguments.resize(self.starts + self.parameters + self.ends, end.clone());
        arguments
    }
}

/// Why a blossom has no value.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BlossomError {
    /// The number of arguments is not the degree.
    #[error(
        "the blossom takes as many arguments as the degree, {degree}, not {found}; repeat a parameter, or change the degree"
    )]
    ArgumentCount {
        /// The degree of the curve.
        degree: usize,
        /// The number of arguments given.
        found: usize,
    },
    /// An argument is NaN or infinite.
    #[error(
        "argument {index} of the blossom is {argument}; every argument must be a finite number"
    )]
    ArgumentNotFinite {
        /// Which argument, counted from 0.
        index: usize,
        /// The argument.
        argument: String,
    },
    /// The value is beyond the range of the number type.
    #[error(
        "the value of the blossom at {arguments} is beyond the range of the number type: {value}; scale the control points down"
    )]
    OutOfRange {
        /// The arguments.
        arguments: String,
        /// What the computation gave.
        value: String,
    },
    /// A power of t is no polynomial of so low a degree.
    #[error(
        "the degree of t^{power} is too high for a blossom with so few arguments ({arguments}); give at least {power}"
    )]
    PowerTooHigh {
        /// The exponent.
        power: usize,
        /// The number of arguments given.
        arguments: usize,
    },
}

fn list<T: Scalar>(arguments: &[T]) -> String {
    let arguments: Vec<String> = arguments.iter().map(ToString::to_string).collect();
    format!("({})", arguments.join(", "))
}
