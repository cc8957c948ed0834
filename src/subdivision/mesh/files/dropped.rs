//! What a file says and a mesh does not keep.

use std::fmt;

use super::Place;

/// What a mesh file may hold besides positions and faces.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Attribute {
    /// Normals.
    Normals,
    /// Texture coordinates.
    TextureCoordinates,
    /// Colours of vertices or faces.
    Colours,
    /// Homogeneous weights of vertices.
    Weights,
    /// Groups and objects.
    Groups,
    /// Smoothing groups.
    SmoothingGroups,
    /// Materials and their libraries.
    Materials,
    /// Polylines and edges.
    Edges,
    /// Points that are drawn as such.
    Points,
    /// Curves and surfaces, and the points of their parameters.
    FreeForms,
    /// How the mesh is to be displayed.
    Display,
    /// Vertices that belong to no face.
    UnusedVertices,
    /// Something else, by its name in the file.
    Other(String),
}

impl fmt::Display for Attribute {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Normals => "normals",
            Self::TextureCoordinates => "texture coordinates",
            Self::Colours => "colours",
            Self::Weights => "weights",
            Self::Groups => "groups and objects",
            Self::SmoothingGroups => "smoothing groups",
            Self::Materials => "materials",
            Self::Edges => "edges",
            Self::Points => "points",
            Self::FreeForms => "free-form curves and surfaces",
            Self::Display => "display settings",
            Self::UnusedVertices => "vertices without a face",
            Self::Other(name) => name,
        })
    }
}

/// Something that was in a file and is not in the mesh.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::files::{Attribute, Place, read_obj};
///
/// let file = read_obj(b"v 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nf 1//1 2//1 3//1\n")?;
/// let dropped = &file.dropped()[0];
/// assert_eq!((&dropped.attribute, dropped.count, dropped.first), (&Attribute::Normals, 1, Place::Line(3)));
/// assert_eq!(dropped.to_string(), "normals are left out: 1, from line 3 on");
/// # Ok::<(), cagd::subdivision::files::MeshFileError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dropped {
    /// What it is.
    pub attribute: Attribute,
    /// How often it occurs.
    pub count: usize,
    /// Where it occurs first.
    pub first: Place,
}

impl fmt::Display for Dropped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            attribute,
            count,
            first,
        } = self;
        write!(f, "{attribute} are left out: {count}, from {first} on")
    }
}
