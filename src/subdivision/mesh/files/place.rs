//! Where something stands in a file.

use std::fmt;

/// Where something stands in a file.
///
/// ```
/// use cagd::subdivision::files::Place;
/// assert_eq!(Place::Line(7).to_string(), "line 7");
/// assert_eq!(Place::Face(0).to_string(), "face 0 of the binary data");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// A line of a text, counted from 1.
    Line(usize),
    /// A vertex of binary data, counted from 0.
    Vertex(usize),
    /// A face of binary data, counted from 0.
    Face(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(number) => write!(f, "line {number}"),
            Self::Vertex(number) => write!(f, "vertex {number} of the binary data"),
            Self::Face(number) => write!(f, "face {number} of the binary data"),
        }
    }
}
