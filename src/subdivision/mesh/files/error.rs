//! Why a file is not a mesh, and where it says so.

use std::fmt;

use thiserror::Error;

use super::Place;
use crate::subdivision::MeshError;

/// A file that is not a mesh: where, and why.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::files::{MeshFileProblem, Place, read_obj};
///
/// let error = read_obj(b"v 0 0 0\nv 1 0 0\nv 0 one 0\nf 1 2 3\n").unwrap_err();
/// assert_eq!(error.place, Some(Place::Line(3)));
/// assert!(matches!(error.problem, MeshFileProblem::Word { .. }));
/// assert_eq!(error.to_string(), "line 3: expected a number, found `one`; mend it or export the mesh again");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub struct MeshFileError {
    /// Where; `None` if it is about the whole file.
    pub place: Option<Place>,
    /// Why.
    pub problem: MeshFileProblem,
}

impl fmt::Display for MeshFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        self.problem.fmt(f)
    }
}

/// What is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshFileProblem {
    /// The text has another encoding.
    #[error("the text is UTF-16, expected UTF-8 or ASCII; save it so")]
    Utf16,
    /// The file does not begin as its format does.
    #[error(
        "expected {expected}, found `{found}`; check that the ending of the file name tells its format"
    )]
    Header {
        /// How it should begin.
        expected: &'static str,
        /// How it begins.
        found: String,
    },
    /// A variant of the format that is not read.
    #[error("{variant} is not read; export the mesh as {instead}")]
    Variant {
        /// Which variant.
        variant: String,
        /// What is read.
        instead: &'static str,
    },
    /// A statement that the format does not have.
    #[error("the format has no statement `{found}`; remove the line or export the mesh again")]
    Statement {
        /// How the line begins.
        found: String,
    },
    /// A word that is not what must stand there.
    #[error("expected {expected}, found `{found}`; mend it or export the mesh again")]
    Word {
        /// What must stand there.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// A line with too few or too many numbers.
    #[error("{what} has {expected}, found {found}; mend the line or export the mesh again")]
    Count {
        /// What the line is.
        what: &'static str,
        /// How many numbers it has.
        expected: String,
        /// How many there are.
        found: usize,
    },
    /// A coordinate that is NaN, infinite or beyond the numbers of 64 bits.
    #[error("the coordinate `{found}` is not finite; give the vertex a place in space")]
    NotFinite {
        /// The coordinate.
        found: String,
    },
    /// A face names a vertex that the file does not have.
    #[error(
        "the face names vertex {index}, but there are only {vertices} vertices, counted from {first}; mend the number or add the vertex"
    )]
    NoVertex {
        /// The vertex that it names.
        index: u64,
        /// How many vertices there are.
        vertices: usize,
        /// The number of the first vertex in this format.
        first: usize,
    },
    /// A face names a vertex relative to its line, or with a number beyond all meshes.
    #[error(
        "the face names vertex {index}, but {vertices} vertices stand before it; mend the number or add the vertex"
    )]
    NoVertexBefore {
        /// The vertex that it names.
        index: i64,
        /// How many vertices there are before.
        vertices: usize,
    },
    /// The file ends before it has what it promises.
    #[error(
        "the file ends after {found} of {expected} {what}; it was cut off, or the number is wrong"
    )]
    Ends {
        /// Which elements are missing.
        what: String,
        /// How many were promised.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The file goes on after it has what it promises.
    #[error(
        "expected the end of the file after {what}, found `{found}`; correct the numbers of elements"
    )]
    GoesOn {
        /// What has been read.
        what: String,
        /// What stands there.
        found: String,
    },
    /// There is no face.
    #[error(
        "a mesh needs at least one face, found none among {vertices} vertices; give the vertices of a face"
    )]
    NoFace {
        /// How many vertices there are.
        vertices: usize,
    },
    /// The lists are not a mesh.
    #[error("{error}{}", legend(named))]
    Mesh {
        /// Why not; elements are counted from 0, in the order of the file.
        error: MeshError,
        /// Where the elements stand that it names.
        named: Vec<(String, Place)>,
    },
    /// What the reader of a binary format says.
    #[error("{0}; mend it or export the mesh again")]
    Format(String),
}

impl MeshFileProblem {
    /// The problem, with its place.
    pub(crate) fn at(self, place: Place) -> MeshFileError {
        MeshFileError {
            place: Some(place),
            problem: self,
        }
    }

    /// The problem of the whole file.
    pub(crate) fn anywhere(self) -> MeshFileError {
        MeshFileError {
            place: None,
            problem: self,
        }
    }
}

/// Where the elements of a message stand.
fn legend(named: &[(String, Place)]) -> String {
    if named.is_empty() {
        return String::new();
    }
    let entries = named
        .iter()
        .map(|(element, place)| format!("{element}: {place}"));
    format!(
        " (counted from 0; {})",
        entries.collect::<Vec<_>>().join(", ")
    )
}
