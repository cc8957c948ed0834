//! Parameter intervals.

use thiserror::Error;

use crate::scalar::Scalar;

/// The parameter interval from `start` to `end`, on which a curve has its shape.
///
/// It carries the affine map `u ↦ t = (u − a)/(b − a)` to the unit interval, where every formula is
/// written. `start` need not be smaller than `end`, so that complex parameters are possible; they
/// must differ.
///
/// # Examples
///
/// ```
/// use cagd::affine::Interval;
///
/// let interval = Interval::new(2.0, 6.0)?;
/// assert_eq!(interval.local(3.0), 0.25);
/// assert_eq!(interval.global(0.25), 3.0);
/// # Ok::<(), cagd::affine::IntervalError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval<T: Scalar> {
    start: T,
    end: T,
}

impl<T: Scalar> Interval<T> {
    /// The interval from `start` to `end`.
    ///
    /// # Errors
    ///
    /// [`IntervalError`] if an end is NaN or infinite, or if both ends are equal.
    pub fn new(start: T, end: T) -> Result<Self, IntervalError> {
        if !start.is_finite() || !end.is_finite() {
            Err(IntervalError::NotFinite {
                start: start.to_string(),
                end: end.to_string(),
            })
        } else if start == end {
            Err(IntervalError::Empty {
                end: end.to_string(),
            })
        } else {
            Ok(Self { start, end })
        }
    }

    /// The interval from 0 to 1.
    #[must_use]
    pub fn unit() -> Self {
        Self {
            start: T::zero(),
            end: T::one(),
        }
    }

    /// Where the interval starts.
    pub fn start(&self) -> T {
        self.start.clone()
    }

    /// Where the interval ends.
    pub fn end(&self) -> T {
        self.end.clone()
    }

    /// The length `b − a`; never 0.
    pub fn length(&self) -> T {
        self.end.clone() - self.start.clone()
    }

    /// Whether this is the interval from 0 to 1, on which [`local`](Self::local) changes nothing.
    #[inline]
    pub fn is_unit(&self) -> bool {
        self.start.is_zero() && self.end.is_one()
    }

    /// The local parameter `t = (u − a)/(b − a)`: 0 at the start and 1 at the end.
    #[inline]
    pub fn local(&self, u: T) -> T {
        if self.is_unit() {
            u
        } else {
            (u - self.start.clone()) / self.length()
        }
    }

    /// The global parameter `u = (1 − t)·a + t·b`.
    #[inline]
    pub fn global(&self, t: T) -> T {
        if self.is_unit() {
            t
        } else {
            self.start.clone() * (T::one() - t.clone()) + self.end.clone() * t
        }
    }
}

/// Why two numbers do not bound a parameter interval.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum IntervalError {
    /// An end is NaN or infinite.
    #[error("a parameter interval needs finite ends, found [{start}, {end}]")]
    NotFinite {
        /// The start as given.
        start: String,
        /// The end as given.
        end: String,
    },
    /// Both ends are the same.
    #[error("a parameter interval needs two different ends, both are {end}")]
    Empty {
        /// The common value.
        end: String,
    },
}
