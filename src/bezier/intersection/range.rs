//! Arithmetic with ranges of numbers, rounded outwards.

use std::ops::{Add, Mul, Sub};

/// All numbers between `low` and `high`.
///
/// A result contains every result of numbers from the operands: each end is moved to the next `f64` outside.
///
/// # Examples
///
/// ```
/// use cagd::bezier::intersection::Range;
///
/// let product = Range::new(-1.0, 2.0) * Range::new(3.0, 4.0);
/// assert!(product.contains(-4.0) && product.contains(8.0));
/// assert!(!product.contains(-4.001));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    low: f64,
    high: f64,
}

impl Range {
    /// The range between two numbers, in either order.
    #[must_use]
    pub fn new(one: f64, other: f64) -> Self {
        Self {
            low: one.min(other),
            high: one.max(other),
        }
    }

    /// The range of the numbers that are at most `radius` from `centre`.
    #[must_use]
    pub fn around(centre: f64, radius: f64) -> Self {
        Self::new((centre - radius).next_down(), (centre + radius).next_up())
    }

    /// The smallest number.
    #[must_use]
    pub fn low(&self) -> f64 {
        self.low
    }

    /// The largest number.
    #[must_use]
    pub fn high(&self) -> f64 {
        self.high
    }

    /// A number in the middle.
    #[must_use]
    pub fn middle(&self) -> f64 {
        f64::midpoint(self.low, self.high)
    }

    /// The difference of the ends.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.high - self.low
    }

    /// Whether a number lies in the range.
    #[must_use]
    pub fn contains(&self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// Whether all of another range lies in this one.
    #[must_use]
    pub fn covers(&self, other: &Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    /// Whether all of another range lies strictly inside.
    #[must_use]
    pub fn covers_strictly(&self, other: &Self) -> bool {
        self.low < other.low && other.high < self.high
    }

    /// Whether the ranges have a number in common.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.low <= other.high && other.low <= self.high
    }

    /// The numbers in both; `None` if there is none.
    #[must_use]
    pub fn common(&self, other: &Self) -> Option<Self> {
        self.meets(other).then(|| Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
        })
    }

    /// The smallest range with all numbers of both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The range with `by` more at each end.
    #[must_use]
    pub fn widened(&self, by: f64) -> Self {
        Self {
            low: self.low - by,
            high: self.high + by,
        }
    }

    /// The lower and the upper half.
    #[must_use]
    pub fn halves(&self) -> [Self; 2] {
        let middle = self.middle();
        [Self::new(self.low, middle), Self::new(middle, self.high)]
    }
}

impl Add for Range {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            low: (self.low + other.low).next_down(),
            high: (self.high + other.high).next_up(),
        }
    }
}

impl Sub for Range {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            low: (self.low - other.high).next_down(),
            high: (self.high - other.low).next_up(),
        }
    }
}

impl Mul for Range {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        let low = products.into_iter().fold(f64::INFINITY, f64::min);
        let high = products.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self {
            low: low.next_down(),
            high: high.next_up(),
        }
    }
}
