//! Mesh files: OBJ and OFF as the mathematics reads them, and PLY.

mod ply;

pub use ply::{read_ply, write_ply};
pub use ply_rs_bw::ply::Encoding;

use std::io::{self, Write};
use std::path::Path;

use clap::ValueEnum;

use crate::affine::Point;
use crate::subdivision::Mesh;
use crate::subdivision::files::{MeshFile, MeshFileError, as_obj, as_off, read_obj, read_off};

/// A mesh in space.
pub type Space = Mesh<Point<f64, 3>>;

/// The formats of meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MeshFormat {
    /// Wavefront OBJ
    Obj,
    /// The Object File Format
    Off,
    /// PLY, written as text
    Ply,
    /// PLY, written as little-endian binary data
    PlyBinary,
}

impl MeshFormat {
    /// The format that the ending of a file name tells.
    #[must_use]
    pub fn of(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "obj" => Some(Self::Obj),
            "off" => Some(Self::Off),
            "ply" => Some(Self::Ply),
            _ => None,
        }
    }

    /// Reads a mesh.
    ///
    /// # Errors
    ///
    /// [`MeshFileError`] says where the file is broken, and why.
    pub fn read(self, bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
        match self {
            Self::Obj => read_obj(bytes),
            Self::Off => read_off(bytes),
            Self::Ply | Self::PlyBinary => read_ply(bytes),
        }
    }

    /// Writes a mesh; reading it again gives the same one.
    ///
    /// # Errors
    ///
    /// What the operating system says.
    pub fn write(self, mesh: &Space, out: &mut impl Write) -> io::Result<()> {
        match self {
            Self::Obj => write!(out, "{}", as_obj(mesh)),
            Self::Off => write!(out, "{}", as_off(mesh)),
            Self::Ply => write_ply(mesh, Encoding::Ascii, out),
            Self::PlyBinary => write_ply(mesh, Encoding::BinaryLittleEndian, out),
        }
    }
}
