//! Meshes as text: the formats OBJ and OFF, read with every refusal at its line, and written without loss.
//!
//! | module | is |
//! |---|---|
//! | [`read_obj`], [`as_obj`] | Wavefront OBJ |
//! | [`read_off`], [`as_off`] | the Object File Format |
//! | [`MeshFile`] | a mesh, what was left out, and where each element stands |
//! | [`MeshFileError`] | why a file is refused, and where |
//! | `polygons` | from the lists of a file to a mesh, for every format |
//! | `words` | lines, words and numbers |
//!
//! Only positions and faces are read.
//! What else a file says is dropped, and [`MeshFile::dropped`] tells it.
//! Binary formats need other libraries; the workbook reads PLY.

mod dropped;
mod error;
mod obj;
mod off;
mod place;
mod polygons;
pub(crate) mod words;

pub use dropped::{Attribute, Dropped};
pub use error::{MeshFileError, MeshFileProblem};
pub use obj::{as_obj, read_obj};
pub use off::{as_off, read_off};
pub use place::Place;
pub use polygons::MeshFile;
pub(crate) use polygons::Polygons;

use super::Mesh;
use crate::affine::Point;

/// A mesh in space.
type Space = Mesh<Point<f64, 3>>;
