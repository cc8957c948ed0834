//! What the tests of an exercise are written with.
//!
//! The tests of an exercise are plain `#[test]` functions and `proptest!` blocks that call the reader's functions as
//! `answer::…`. A plain `assert_eq!` works; a [`claim`] teaches more when it fails: what was tested, with which
//! input, what was expected and found (exact numbers as fractions), and a picture of the wrong curve beside the right
//! one.
//!
//! | item | is |
//! |---|---|
//! | [`claim`], [`Claim`] | one thing that an answer must do |
//! | [`Show`] | how a value is shown to the reader |
//! | [`Distance`] | how far two values are apart, for rounded numbers |
//! | [`Picture`] | curves and polygons: given, expected, found |
//! | [`tableau`] | triangular tables to fill by hand |
//! | [`probes!`](crate::probes) | what an answer does on chosen inputs, to recognise a misconception |
//! | [`harness`] | runs the tests and tells the verdict over a channel of its own |
//! | [`report`] | the words of that channel |
//!
//! # Examples
//!
//! ```
//! use cagd::affine::Point;
//! use cagd::check::{Picture, claim};
//!
//! fn midpoint(a: Point<f64, 2>, b: Point<f64, 2>) -> Point<f64, 2> {
//!     a + (b - a) * 0.5
//! }
//!
//! let (a, b) = (Point::new([0.0, 0.0]), Point::new([2.0, 4.0]));
//! claim("the midpoint of a and b")
//!     .input(format!("a = {a}, b = {b}"))
//!     .picture(|| Picture::new().given([a, b]).expected([Point::new([1.0, 2.0])]).found([midpoint(a, b)]))
//!     .equal(midpoint(a, b), Point::new([1.0, 2.0]));
//! ```

mod claim;
mod picture;
mod show;

#[cfg(unix)]
pub mod harness;
pub mod report;
pub mod tableau;

pub use claim::{Claim, claim, probe};
pub use picture::{Picture, Role, Stroke};
pub use show::{Distance, Show};
