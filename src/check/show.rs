//! How values are shown to the reader, and how far apart they are.

use crate::affine::{Point, Vector};
use crate::scalar::{BigRational, Complex64, Scalar};

/// How a value is shown to the reader: exact numbers as fractions, points as `(x, y)`, lists in brackets.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::check::Show;
/// use cagd::scalar::{BigRational, Scalar};
///
/// let half = BigRational::from_ratio(1, 2);
/// assert_eq!(Point::new([half.clone(), half]).show(), "(1/2, 1/2)");
/// assert_eq!(vec![Some(1), None].show(), "[1, nothing]");
/// ```
pub trait Show {
    /// The value in words and digits.
    fn show(&self) -> String;
}

macro_rules! shown_by_display {
    ($($t:ty),+) => {$(
        impl Show for $t {
            fn show(&self) -> String {
                self.to_string()
            }
        }
    )+};
}

shown_by_display!(
    f64,
    f32,
    i8,
    i16,
    i32,
    i64,
    i128,
    isize,
    u8,
    u16,
    u32,
    u64,
    u128,
    usize,
    bool,
    char,
    str,
    String,
    BigRational,
    Complex64,
    crate::scalar::Dual64
);

impl<T: Scalar, const D: usize> Show for Point<T, D> {
    fn show(&self) -> String {
        self.to_string()
    }
}

impl<T: Scalar, const D: usize> Show for Vector<T, D> {
    fn show(&self) -> String {
        let coordinates: Vec<String> = self.iter().map(ToString::to_string).collect();
        format!("({})ᵀ", coordinates.join(", "))
    }
}

impl<T: Show + ?Sized> Show for &T {
    fn show(&self) -> String {
        (**self).show()
    }
}

impl<T: Show> Show for [T] {
    fn show(&self) -> String {
        let entries: Vec<String> = self.iter().map(Show::show).collect();
        format!("[{}]", entries.join(", "))
    }
}

impl<T: Show, const N: usize> Show for [T; N] {
    fn show(&self) -> String {
        self.as_slice().show()
    }
}

impl<T: Show> Show for Vec<T> {
    fn show(&self) -> String {
        self.as_slice().show()
    }
}

impl<T: Show> Show for Option<T> {
    fn show(&self) -> String {
        self.as_ref()
            .map_or_else(|| "nothing".to_owned(), Show::show)
    }
}

impl<T: Show, E: std::fmt::Display> Show for Result<T, E> {
    fn show(&self) -> String {
        match self {
            Ok(value) => value.show(),
            Err(error) => format!("the error “{error}”"),
        }
    }
}

impl Show for () {
    fn show(&self) -> String {
        "nothing".to_owned()
    }
}

impl<A: Show, B: Show> Show for (A, B) {
    fn show(&self) -> String {
        format!("({}, {})", self.0.show(), self.1.show())
    }
}

impl<A: Show, B: Show, C: Show> Show for (A, B, C) {
    fn show(&self) -> String {
        format!("({}, {}, {})", self.0.show(), self.1.show(), self.2.show())
    }
}

/// How far two values over rounded numbers are apart.
///
/// # Examples
///
/// ```
/// use cagd::check::Distance;
///
/// assert_eq!(vec![1.0, 2.0].distance(&vec![1.5, 2.0]), 0.5);
/// assert_eq!(vec![1.0].distance(&vec![]), f64::INFINITY);
/// ```
pub trait Distance {
    /// The largest difference of two coordinates; infinite if the shapes differ, NaN if a coordinate is NaN.
    fn distance(&self, other: &Self) -> f64;
}

impl Distance for f64 {
    fn distance(&self, other: &Self) -> f64 {
        // Equal infinities are no distance apart, though their difference is NaN.
        if self == other {
            0.0
        } else {
            (self - other).abs()
        }
    }
}

/// The larger number, NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b < a { a } else { b }
}

impl<T: Distance> Distance for [T] {
    fn distance(&self, other: &Self) -> f64 {
        if self.len() != other.len() {
            return f64::INFINITY;
        }
        let pairs = self.iter().zip(other);
        pairs.map(|(a, b)| a.distance(b)).fold(0.0, larger)
    }
}

impl<T: Distance> Distance for Vec<T> {
    fn distance(&self, other: &Self) -> f64 {
        self.as_slice().distance(other)
    }
}

impl<T: Distance, const N: usize> Distance for [T; N] {
    fn distance(&self, other: &Self) -> f64 {
        self.as_slice().distance(other)
    }
}

impl<T: Distance> Distance for Option<T> {
    fn distance(&self, other: &Self) -> f64 {
        match (self, other) {
            (Some(a), Some(b)) => a.distance(b),
            (None, None) => 0.0,
            _ => f64::INFINITY,
        }
    }
}

impl<const D: usize> Distance for Point<f64, D> {
    fn distance(&self, other: &Self) -> f64 {
        self.coordinates().distance(other.coordinates())
    }
}

impl<const D: usize> Distance for Vector<f64, D> {
    fn distance(&self, other: &Self) -> f64 {
        self.as_slice().distance(other.as_slice())
    }
}

impl<A: Distance, B: Distance> Distance for (A, B) {
    fn distance(&self, other: &Self) -> f64 {
        larger(self.0.distance(&other.0), self.1.distance(&other.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_anywhere_is_seen() {
        assert!([0.0, f64::NAN, 1.0].distance(&[0.0, 0.0, 0.0]).is_nan());
        assert!([f64::NAN, 5.0].distance(&[0.0, 0.0]).is_nan());
        assert!((1.0, f64::NAN).distance(&(0.0, 0.0)).is_nan());
    }
}
