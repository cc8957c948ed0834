//! Meshes are written and read without loss, and no file makes a reader panic.

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::subdivision::files::{MeshFile, MeshFileError, as_obj, as_off, read_obj, read_off};
use cagd::subdivision::{HalfEdgeMesh, Mesh, Refinement};
#[cfg(feature = "workbook")]
use cagd::workbook::mesh_files::{Encoding, read_ply, write_ply};
use proptest::prelude::*;

use super::meshes::{Faces, Planted, Space, polygon_meshes};
use crate::generators::for_all_of;
use crate::support::{Outcome, holds, rejects};

/// How a mesh becomes a file.
type Write = fn(&Space) -> Vec<u8>;
/// How a file becomes a mesh.
type Read = fn(&[u8]) -> Result<MeshFile, MeshFileError>;

fn obj(mesh: &Space) -> Vec<u8> {
    as_obj(mesh).to_string().into_bytes()
}

fn off(mesh: &Space) -> Vec<u8> {
    as_off(mesh).to_string().into_bytes()
}

#[cfg(feature = "workbook")]
fn ply(mesh: &Space, encoding: Encoding) -> Vec<u8> {
    let mut bytes = vec![];
    write_ply(mesh, encoding, &mut bytes).expect("a list takes all bytes");
    bytes
}

/// Every format by its name, the PLY of the workbook among them.
fn formats() -> Vec<(&'static str, Write, Read)> {
    let formats: Vec<(&'static str, Write, Read)> =
        vec![("OBJ", obj, read_obj), ("OFF", off, read_off)];
    #[cfg(feature = "workbook")]
    let formats = [
        formats,
        vec![
            (
                "PLY",
                (|mesh| ply(mesh, Encoding::Ascii)) as Write,
                read_ply as Read,
            ),
            (
                "PLY, little-endian",
                |mesh| ply(mesh, Encoding::BinaryLittleEndian),
                read_ply,
            ),
            (
                "PLY, big-endian",
                |mesh| ply(mesh, Encoding::BinaryBigEndian),
                read_ply,
            ),
        ],
    ]
    .concat();
    formats
}

/// Random meshes whose coordinates are any finite numbers: tiny, huge, with all digits, negative zeros.
fn meshes_anywhere() -> impl Strategy<Value = Space> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    let number = NEGATIVE | NORMAL | POSITIVE | SUBNORMAL | ZERO;
    (polygon_meshes(), prop::collection::vec(number, 61)).prop_map(|(planted, numbers)| {
        let mut next = numbers.iter().copied().cycle();
        let mut coordinate = || next.next().unwrap_or(0.0);
        let connectivity = planted.connectivity().clone();
        let points = (0..connectivity.vertex_count())
            .map(|_| Point::new([coordinate(), coordinate(), coordinate()]));
        Mesh::new(connectivity, points.collect()).expect("finite numbers")
    })
}

/// All bits of all coordinates, in halves that a number holds.
fn bits(mesh: &Space) -> Vec<f64> {
    let coordinates = mesh.points().iter().flat_map(|p| p.coordinates().to_vec());
    let halves = coordinates
        .map(f64::to_bits)
        .flat_map(|bits| [bits >> 32, bits & 0xFFFF_FFFF]);
    halves.map(|half| half as f64).collect()
}

/// All faces, each behind its number of vertices.
fn faces(mesh: &Space) -> Vec<f64> {
    let lists = mesh.connectivity().face_lists();
    let counted = lists
        .iter()
        .flat_map(|face| std::iter::once(face.len() as u32).chain(face.iter().copied()));
    counted.map(f64::from).collect()
}

/// Two meshes are the same, bit by bit.
fn same(context: &str, found: &Space, expected: &Space) -> Sides<f64> {
    Sides::new(context.to_owned())
        .equal(
            "the bits of the coordinates",
            bits(found),
            bits(expected),
            Rounding::none(),
        )
        .equal("the faces", faces(found), faces(expected), Rounding::none())
}

/// What is written is read as the same mesh, and nothing is dropped.
fn round_trip(write: Write, read: Read) -> Outcome {
    for_all_of(64, meshes_anywhere(), |mesh| match read(&write(mesh)) {
        Ok(file) => {
            let dropped = file.dropped().len() as f64;
            same("read", file.mesh(), mesh).equal("dropped", [dropped], [0.0], Rounding::none())
        }
        Err(error) => {
            Sides::new(error.to_string()).equal("refused", [1.0], [0.0], Rounding::none())
        }
    })
}

#[test]
fn what_is_written_is_read_again_bit_by_bit() {
    for (format, write, read) in formats() {
        let outcome = round_trip(write, read);
        assert_eq!(outcome, Ok(()), "{format}");
    }
    rejects(
        "numbers of 32 bits",
        round_trip(
            |mesh| obj(&with_points(mesh, |x| f64::from(x as f32))),
            read_obj,
        ),
    );
    rejects(
        "16 digits",
        round_trip(|mesh| obj(&with_points(mesh, with_16_digits)), read_obj),
    );
    rejects(
        "the sign of zero is lost",
        round_trip(|mesh| off(&with_points(mesh, |x| x + 0.0)), read_off),
    );
    rejects(
        "faces are turned",
        round_trip(|mesh| obj(&turned(mesh)), read_obj),
    );
}

fn with_points(mesh: &Space, change: fn(f64) -> f64) -> Space {
    let finite = |x: f64| if change(x).is_finite() { change(x) } else { x };
    mesh.map(|p| Point::new([finite(p[0]), finite(p[1]), finite(p[2])]))
        .expect("finite numbers")
}

fn with_16_digits(x: f64) -> f64 {
    format!("{x:.15e}").parse().expect("a number")
}

/// Each face begins at its second vertex.
fn turned(mesh: &Space) -> Space {
    let mut faces = mesh.connectivity().face_lists();
    for face in &mut faces {
        face.rotate_left(1);
    }
    Mesh::from_faces(mesh.points().to_vec(), &faces).expect("the same faces")
}

/// What is done to the bytes of a file.
#[derive(Debug, Clone)]
enum Damage {
    Replace(u16, u8),
    Insert(u16, Vec<u8>),
    Remove(u16, u8),
    Repeat(u16, u8),
    CutOff(u16),
}

fn damage() -> impl Strategy<Value = Damage> {
    // What stands in such files, so that the damage is not always seen at once.
    let words = prop::sample::select(vec![
        " ",
        "\n",
        "\r\n",
        "-",
        "0",
        "9",
        "1e999",
        "nan",
        "-1",
        "4294967296",
        "18446744073709551616",
        "v ",
        "f ",
        "vn 1 2 3\n",
        "\\\n",
        "/",
        "//",
        "#",
        "OFF",
        "\u{feff}",
        "ply\n",
        "element vertex 9\n",
        "property float x\n",
        "list ",
        "end_header\n",
    ]);
    prop_oneof![
        (any::<u16>(), any::<u8>()).prop_map(|(at, byte)| Damage::Replace(at, byte)),
        (any::<u16>(), words).prop_map(|(at, word)| Damage::Insert(at, word.as_bytes().to_vec())),
        (any::<u16>(), any::<u8>()).prop_map(|(at, count)| Damage::Remove(at, count)),
        (any::<u16>(), any::<u8>()).prop_map(|(at, count)| Damage::Repeat(at, count)),
        any::<u16>().prop_map(Damage::CutOff),
    ]
}

impl Damage {
    fn done_to(&self, bytes: &mut Vec<u8>) {
        let place = |at: &u16| usize::from(*at) % (bytes.len() + 1);
        let range =
            |at: &u16, count: &u8| place(at)..(place(at) + usize::from(*count)).min(bytes.len());
        match self {
            Self::Replace(at, byte) => {
                let at = place(at);
                if let Some(old) = bytes.get_mut(at) {
                    *old = *byte;
                }
            }
            Self::Insert(at, word) => {
                let at = place(at);
                bytes.splice(at..at, word.iter().copied());
            }
            Self::Remove(at, count) => {
                let range = range(at, count);
                bytes.drain(range);
            }
            Self::Repeat(at, count) => {
                let range = range(at, count);
                let again = bytes[range.clone()].to_vec();
                bytes.splice(range.start..range.start, again);
            }
            Self::CutOff(at) => {
                let at = place(at);
                bytes.truncate(at);
            }
        }
    }
}

/// Whatever is read is the same mesh after it is written in any format and read again.
///
/// The rest is refused with a reason.
fn read_or_refused(bytes: &[u8]) -> Sides<f64> {
    let mut claims = vec![];
    for (format, _, read) in formats() {
        match read(bytes) {
            Ok(file) => {
                for (other, write, read) in formats() {
                    let again = read(&write(file.mesh()));
                    let same = again.is_ok_and(|again| again.mesh() == file.mesh());
                    claims.push((format!("{format}, written as {other}"), same));
                }
            }
            Err(error) => claims.push((format.to_owned(), !error.to_string().is_empty())),
        }
    }
    let sides = Sides::new("whatever can be read");
    claims.into_iter().fold(sides, |sides, (claim, holds)| {
        sides.equal(claim, [f64::from(holds)], [1.0], Rounding::none())
    })
}

#[test]
fn random_bytes_are_read_or_refused() {
    let bytes = prop::collection::vec(any::<u8>(), 0..300);
    let words = "[-vfnt0-9./# \\\\\nOFFplyelementvertexface]{0,200}".prop_map(String::into_bytes);
    let inputs = prop_oneof![bytes, words];
    holds(for_all_of(512, inputs, |bytes| read_or_refused(bytes)));
}

#[test]
fn damaged_files_are_read_or_refused() {
    let formats = formats();
    let inputs = (
        polygon_meshes(),
        0..formats.len(),
        prop::collection::vec(damage(), 1..6),
    );
    let read = std::cell::Cell::new(0);
    let refused = std::cell::Cell::new(0);
    holds(for_all_of(512, inputs, |(planted, format, damages)| {
        let (_, write, reader) = formats[*format];
        let mut bytes = write(&planted.mesh);
        for damage in damages {
            damage.done_to(&mut bytes);
        }
        match reader(&bytes) {
            Ok(_) => read.set(read.get() + 1),
            Err(_) => refused.set(refused.get() + 1),
        }
        read_or_refused(&bytes)
    }));
    // Both classes occur.
    assert!(
        read.get() > 10 && refused.get() > 100,
        "{read:?} {refused:?}"
    );
}

/// The refinements that have a rule for a mesh.
fn refinements(planted: &Planted) -> Vec<Refinement> {
    let mut refinements = vec![Refinement::Quadrilaterals, Refinement::CutCorners];
    if planted.faces == Faces::Triangles {
        refinements.push(Refinement::Triangles);
    }
    refinements
}

#[test]
fn numbers_of_elements_are_known_before_refining() {
    type Counts = fn(Refinement, &HalfEdgeMesh, u32) -> [u128; 3];
    let law = |counts: Counts| {
        for_all_of(32, polygon_meshes(), |planted| {
            let mut sides = Sides::new(format!("{:?}", planted.faces));
            for refinement in refinements(planted) {
                let mut mesh = planted.connectivity().clone();
                for steps in 1..=2 {
                    mesh = refinement
                        .refine(&mesh)
                        .expect("it has a rule for this mesh");
                    let found = counts(refinement, planted.connectivity(), steps).map(|n| n as f64);
                    let expected = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()]
                        .map(|n| n as f64);
                    let open = !planted.connectivity().is_closed();
                    sides = if open && refinement == Refinement::CutCorners {
                        // Upper bounds only.
                        let enough = found.iter().zip(&expected).all(|(found, n)| found >= n);
                        sides.equal("bounds", [f64::from(enough)], [1.0], Rounding::none())
                    } else {
                        sides.equal("numbers", found, expected, Rounding::none())
                    };
                }
            }
            sides
        })
    };
    holds(law(Refinement::counts_after));
    rejects(
        "one step too few",
        law(|refinement, mesh, steps| refinement.counts_after(mesh, steps - 1)),
    );
    rejects(
        "every step makes four times as many",
        law(|_, mesh, steps| {
            [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()]
                .map(|n| (n as u128) << (2 * steps))
        }),
    );
}
