//! Arc length of any parametric curve, and its inverse.

use thiserror::Error;

use super::ParametricCurve;
use super::quadrature::SIXTEEN;
use super::range;
use crate::affine::Affine;

/// An arc length with its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcLength {
    /// The length.
    pub value: f64,
    /// How far the true length may be away.
    pub error: f64,
    /// How far `error` can be trusted.
    pub certainty: Certainty,
}

/// How far an error can be trusted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Certainty {
    /// The error is a bound, rounding included.
    Guaranteed,
    /// The error is an estimate: for a curve of which only points and derivatives are known, something
    /// may happen between the parameters that were looked at. Where the speed has a zero, the estimate may be
    /// a few times too small.
    Estimated,
}

/// Curves that have a length: over `f64`, in any dimension.
pub trait Rectifiable: ParametricCurve<Point: Affine<Scalar = f64>> {
    /// The arc length ∫‖c′(t)‖ dt over the domain, with an estimated error of at most `tolerance`.
    ///
    /// Adaptive Gauss–Legendre quadrature: the piece on which one rule of 16 nodes and two halves
    /// of it differ most is halved until these differences sum to at most `tolerance`.
    /// The result is that of the halves, which is far better than the difference for smooth curves.
    ///
    /// # Errors
    ///
    /// [`ArcLengthError::Tolerance`] if `tolerance` is not a positive number,
    /// [`ArcLengthError::NotFinite`] if a derivative is not finite,
    /// [`ArcLengthError::NotReached`] if rounding or the limit of 4096 pieces stops the work before.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Interval, Point, Vector};
    /// use cagd::curves::{ParametricCurve, Rectifiable};
    ///
    /// /// The graph of y = t^(3/2), whose length over [0, 4] is (80√10 − 8)/27.
    /// struct Neil;
    ///
    /// impl ParametricCurve for Neil {
    ///     type Point = Point<f64, 2>;
    ///
    ///     fn domain(&self) -> Interval<f64> {
    ///         Interval::new(0.0, 4.0).expect("two different ends")
    ///     }
    ///
    ///     fn at(&self, t: f64) -> Point<f64, 2> {
    ///         Point::new([t, t * t.sqrt()])
    ///     }
    ///
    ///     fn derivatives<const K: usize>(&self, t: f64) -> [Vector<f64, 2>; K] {
    ///         // c⁽ᵖ⁾ has the ordinate (3/2)(1/2)(−1/2)… t^(3/2 − p).
    ///         let mut factor = 1.0;
    ///         std::array::from_fn(|k| {
    ///             factor *= 1.5 - k as f64;
    ///             Vector::from([if k == 0 { 1.0 } else { 0.0 }, factor * t.powf(0.5 - k as f64)])
    ///         })
    ///     }
    /// }
    ///
    /// let length = Neil.arc_length(1e-10)?;
    /// assert!((length.value - (80.0 * 10f64.sqrt() - 8.0) / 27.0).abs() < 1e-10);
    /// # Ok::<(), cagd::curves::ArcLengthError>(())
    /// ```
    ///
    /// Source: `farin2002`, §10.1.
    fn arc_length(&self, tolerance: f64) -> Result<ArcLength, ArcLengthError> {
        let domain = self.domain();
        adaptive(domain.start(), domain.end(), tolerance, |t| self.speed(t))
    }

    /// The speed ‖c′(t)‖.
    fn speed(&self, t: f64) -> f64 {
        let [first] = self.derivatives(t);
        range::length(first.coordinates())
    }

    /// The parameter at which the curve has the length `length` from its start.
    ///
    /// The length up to the parameter misses `length` by at most `tolerance`, as far as the estimated errors
    /// of [`arc_length`](Self::arc_length) can be trusted.
    ///
    /// # Errors
    ///
    /// As [`arc_length`](Self::arc_length), and [`ArcLengthError::Beyond`] if `length` is negative or longer than the curve.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::Rectifiable;
    ///
    /// // The segment from 0 to 3 that starts at rest: b(t) = 3t².
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 0.0], [3.0, 0.0]].map(Point::new))?;
    /// let middle = Rectifiable::parameter_at_length(&curve, 1.5, 1e-9)?;
    /// assert!((middle - 0.5f64.sqrt()).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn parameter_at_length(&self, length: f64, tolerance: f64) -> Result<f64, ArcLengthError> {
        let domain = self.domain();
        let start = domain.start();
        invert(
            (start, domain.end()),
            length,
            tolerance,
            |t| self.speed(t),
            |t, tolerance| adaptive(start, t, tolerance, |t| self.speed(t)),
        )
    }
}

impl<C: ParametricCurve<Point: Affine<Scalar = f64>>> Rectifiable for C {}

/// How many pieces the adaptive rule makes at most.
const MAX_PIECES: usize = 4096;

/// The integral of `speed` from `start` to `end`.
fn adaptive(
    start: f64,
    end: f64,
    tolerance: f64,
    speed: impl Fn(f64) -> f64,
) -> Result<ArcLength, ArcLengthError> {
    check_tolerance(tolerance)?;
    let piece = |start: f64, end: f64| {
        let middle = 0.5 * (start + end);
        let whole = SIXTEEN.integrate(start, end, &speed).abs();
        let halves = SIXTEEN.integrate(start, middle, &speed).abs()
            + SIXTEEN.integrate(middle, end, &speed).abs();
        Piece {
            start,
            end,
            value: halves,
            error: (whole - halves).abs(),
        }
    };
    let mut pieces = vec![piece(start, end)];
    loop {
        let value: f64 = pieces.iter().map(|piece| piece.value).sum();
        let error: f64 = pieces.iter().map(|piece| piece.error).sum();
        if !value.is_finite() {
            return Err(ArcLengthError::NotFinite);
        }
        if error <= tolerance {
            return Ok(ArcLength {
                value,
                error,
                certainty: Certainty::Estimated,
            });
        }
        // The rounding of 16 speeds and weights; a piece that is that good cannot become better.
        let improvable = |piece: &Piece| piece.error > 32.0 * f64::EPSILON * piece.value;
        let worst = (0..pieces.len())
            .filter(|&k| improvable(&pieces[k]))
            .max_by(|&k, &l| pieces[k].error.total_cmp(&pieces[l].error));
        match worst {
            Some(k) if pieces.len() < MAX_PIECES => {
                let Piece { start, end, .. } = pieces[k];
                let middle = 0.5 * (start + end);
                pieces[k] = piece(start, middle);
                pieces.push(piece(middle, end));
            }
            _ => {
                return Err(ArcLengthError::NotReached {
                    tolerance,
                    value,
                    error,
                });
            }
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct Piece {
    start: f64,
    end: f64,
    value: f64,
    error: f64,
}

/// A tolerance must be a positive finite number.
pub(crate) fn check_tolerance(tolerance: f64) -> Result<(), ArcLengthError> {
    if tolerance > 0.0 && tolerance.is_finite() {
        Ok(())
    } else {
        Err(ArcLengthError::Tolerance { found: tolerance })
    }
}

/// The parameter in the domain from `domain.0` to `domain.1` up to which the curve has the length `target`.
///
/// `length_to(t, tolerance)` measures; it may be off by `tolerance`, and half of the tolerance is left to it.
/// Newton's method, kept inside a bracket that shrinks in every step; where it would leave the
/// bracket, or the speed is 0, the bracket is halved.
pub(crate) fn invert(
    domain: (f64, f64),
    target: f64,
    tolerance: f64,
    speed: impl Fn(f64) -> f64,
    length_to: impl Fn(f64, f64) -> Result<ArcLength, ArcLengthError>,
) -> Result<f64, ArcLengthError> {
    check_tolerance(tolerance)?;
    let measure = 0.5 * tolerance;
    let total = length_to(domain.1, measure)?;
    if !(target >= 0.0 && target <= total.value + total.error) {
        return Err(ArcLengthError::Beyond {
            target,
            length: total.value,
        });
    }
    if target == 0.0 {
        return Ok(domain.0);
    }
    if target >= total.value - measure {
        return Ok(domain.1);
    }
    let (mut low, mut high) = domain;
    let direction = (high - low).signum();
    let mut t = low + (high - low) * (target / total.value);
    let mut best = (f64::INFINITY, t);
    // A step halves the bracket at least every second time: after 200 it cannot be halved any more.
    for step in 0..200 {
        let reached = length_to(t, measure)?;
        let residual = reached.value - target;
        if residual.abs() < best.0 {
            best = (residual.abs(), t);
        }
        if residual.abs() + reached.error <= tolerance {
            return Ok(t);
        }
        if residual < 0.0 {
            low = t;
        } else {
            high = t;
        }
        let newton = t - direction * residual / speed(t);
        let inside = (newton - low) * direction > 0.0 && (high - newton) * direction > 0.0;
        let next = if inside && step % 2 == 0 {
            newton
        } else {
            low + 0.5 * (high - low)
        };
        if next == t {
            break;
        }
        t = next;
    }
    Err(ArcLengthError::NotReached {
        tolerance,
        value: best.1,
        error: best.0 + measure,
    })
}

/// Why there is no arc length within the tolerance, or no parameter for a length.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ArcLengthError {
    /// The tolerance is not a positive number.
    #[error("the tolerance of an arc length must be a positive finite number, found {found}")]
    Tolerance {
        /// The tolerance.
        found: f64,
    },
    /// A derivative, or the length itself, is not finite.
    #[error(
        "the length or a derivative of the curve is beyond the range of f64; scale the curve down"
    )]
    NotFinite,
    /// Rounding or the limit of work forbids the tolerance.
    #[error(
        "the tolerance {tolerance} was not reached: {value} is certain up to {error} only; ask for a larger tolerance"
    )]
    NotReached {
        /// What was asked for.
        tolerance: f64,
        /// The best result.
        value: f64,
        /// Its error.
        error: f64,
    },
    /// The curve has no point at that length.
    #[error(
        "the curve has the length {length}; no point of it has the length {target} from its start"
    )]
    Beyond {
        /// The length asked for.
        target: f64,
        /// The length of the curve.
        length: f64,
    },
}
