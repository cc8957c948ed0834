//! PLY, as text and binary.
//!
//! | module | is |
//! |---|---|
//! | `header` | what a file announces |
//! | `source` | its elements, one after the other |
//! | `record` | one element |
//! | `output` | writing |
//!
//! The crate `ply-rs-bw` reads headers and binary elements, and writes.
//! The lines of a text are read here: the crate refuses `nan` in properties that nobody asks for and numbers like `.5`,
//! ignores surplus numbers, and its reasons are not made for readers.

mod header;
mod output;
mod record;
mod source;
#[cfg(test)]
mod tests;

pub use output::write_ply;

use ply_rs_bw::ply::ElementDef;

use crate::subdivision::files::{MeshFile, MeshFileError, MeshFileProblem, Place, Polygons};
use header::Announced;
use record::Record;
use source::Source;

const VERTEX: &str = "vertex";
const FACE: &str = "face";
const AXES: [&str; 3] = ["x", "y", "z"];
/// The names that programs give to the list of a face; the first is written.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Reads a mesh in the format PLY, as text or binary.
///
/// Elements other than `vertex` and `face` are dropped, and so are properties other than the coordinates and the
/// vertices of faces; their place is the line of the header that announces them.
///
/// # Errors
///
/// [`MeshFileError`] names the line, in binary data the vertex or the face.
///
/// # Examples
///
/// ```
/// use cagd::workbook::mesh_files::read_ply;
///
/// let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
///               element face 1\nproperty list uchar int vertex_indices\nend_header\n";
/// let triangle = format!("{header}0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
/// assert_eq!(read_ply(triangle.as_bytes())?.mesh().connectivity().face_count(), 1);
///
/// let broken = format!("{header}0 0 0\n1 0\n0 1 0\n3 0 1 2\n");
/// let error = read_ply(broken.as_bytes()).unwrap_err();
/// assert!(error.to_string().starts_with("line 11: the vertex has 3 numbers by the header, found 2"), "{error}");
/// # Ok::<(), cagd::subdivision::files::MeshFileError>(())
/// ```
pub fn read_ply(bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let announced = Announced::read(bytes)?;
    let mut source = Source::of(&announced);
    let mut polygons = Polygons::default();
    for element in announced.header.elements.values() {
        announced.drop_attributes(element, &mut polygons);
        announced.check(element)?;
        // Without properties there is nothing to read, however many elements there are said to be.
        if element.properties.is_empty() {
            continue;
        }
        for number in 0..element.count {
            let (record, place) = source.next(element, number)?;
            add(&mut polygons, element, record, place).map_err(|problem| problem.at(place))?;
        }
    }
    source.end()?;
    polygons.finish(0)
}

/// Puts an element that was read to the others.
fn add(
    polygons: &mut Polygons,
    element: &ElementDef,
    record: Record,
    place: Place,
) -> Result<(), MeshFileProblem> {
    match element.name.as_str() {
        VERTEX => {
            if let Some(x) = record.position.iter().find(|x| !x.is_finite()) {
                return Err(MeshFileProblem::NotFinite {
                    found: x.to_string(),
                });
            }
            polygons.add_point(record.position, place);
        }
        FACE => {
            for &corner in &record.corners {
                let vertex =
                    u32::try_from(corner).map_err(|_| MeshFileProblem::NoVertexBefore {
                        index: corner,
                        vertices: polygons.point_count(),
                    })?;
                polygons.add_corner(vertex);
            }
            polygons.end_face(place);
        }
        _ => {}
    }
    Ok(())
}

/// What the crate says, on one line.
fn refused(text: &str) -> MeshFileProblem {
    MeshFileProblem::Format(text.lines().collect::<Vec<_>>().join(" "))
}
