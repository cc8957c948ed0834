//! Writing PLY.

use std::io::{self, Write};

use ply_rs_bw::ply::{
    Addable, ElementDef, Encoding, Header, PropertyAccess, PropertyDef, PropertyType, ScalarType,
    Version,
};
use ply_rs_bw::writer::Writer;

use super::{AXES, CORNERS, FACE, VERTEX};
use crate::workbook::mesh_files::Space;

/// A vertex or a face, to be written.
struct Written {
    position: [f64; 3],
    corners: Vec<i32>,
}

impl PropertyAccess for Written {
    fn new() -> Self {
        Self {
            position: [0.0; 3],
            corners: vec![],
        }
    }

    fn get_double(&self, name: &str) -> Option<f64> {
        let axis = AXES.iter().position(|axis| *axis == name)?;
        Some(self.position[axis])
    }

    fn get_list_int(&self, _: &str) -> Option<&[i32]> {
        Some(&self.corners)
    }
}

/// Writes a mesh in the format PLY, with coordinates of type `double`; reading it gives the same mesh.
///
/// # Errors
///
/// What the operating system says.
pub fn write_ply(mesh: &Space, encoding: Encoding, out: &mut impl Write) -> io::Result<()> {
    let connectivity = mesh.connectivity();
    let largest = connectivity
        .faces()
        .map(|f| connectivity.face_degree(f))
        .max();
    // Most programs expect the number of corners in one byte; a larger face needs more.
    let degree = if largest <= Some(usize::from(u8::MAX)) {
        ScalarType::UChar
    } else {
        ScalarType::UInt
    };
    let mut vertex = ElementDef::new(VERTEX.into());
    vertex.count = connectivity.vertex_count();
    for axis in AXES {
        let double = PropertyType::Scalar(ScalarType::Double);
        vertex.properties.add(PropertyDef::new(axis.into(), double));
    }
    let mut face = ElementDef::new(FACE.into());
    face.count = connectivity.face_count();
    let list = PropertyType::List(degree, ScalarType::Int);
    face.properties
        .add(PropertyDef::new(CORNERS[0].into(), list));

    let mut header = Header::new();
    header.encoding = encoding;
    header.version = Version { major: 1, minor: 0 };
    header.elements.add(vertex.clone());
    header.elements.add(face.clone());

    let writer = Writer::<Written>::new();
    writer.write_header(out, &header)?;
    let mut write = |element: &Written, kind: &ElementDef| match encoding {
        Encoding::Ascii => writer.write_ascii_element(out, element, kind),
        Encoding::BinaryBigEndian => writer.write_big_endian_element(out, element, kind),
        Encoding::BinaryLittleEndian => writer.write_little_endian_element(out, element, kind),
    };
    let mut element = Written::new();
    for point in mesh.points() {
        element.position = [point[0], point[1], point[2]];
        write(&element, &vertex)?;
    }
    for f in connectivity.faces() {
        element.corners.clear();
        // A mesh has at most 2³² half-edges, so its vertices have numbers below 2³¹.
        let vertices = connectivity.face_vertices(f).map(|v| v.0 as i32);
        element.corners.extend(vertices);
        write(&element, &face)?;
    }
    Ok(())
}
