//! What is read, dropped and refused.

use ply_rs_bw::ply::Encoding;

use super::*;
use crate::affine::Point;
use crate::subdivision::solids;
use crate::workbook::mesh_files::Space;

const HEADER: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                      property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
const TRIANGLE: &str = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

fn read(text: &str) -> MeshFile {
    read_ply(text.as_bytes()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

fn text() -> String {
    format!("{HEADER}{TRIANGLE}")
}

/// The triangle with this instead of that is refused at this line with these words.
#[track_caller]
fn refused(that: &str, this: &str, line: usize, words: &str) {
    let text = text();
    assert!(text.contains(that), "{that:?}");
    match read_ply(text.replacen(that, this, 1).as_bytes()) {
        Ok(_) => panic!("{this:?} is read"),
        Err(error) => {
            assert_eq!(error.place, Some(Place::Line(line)), "{error}");
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}

#[test]
fn texts_are_read() {
    let plain = read(&text());
    assert_eq!(plain.mesh().connectivity().face_count(), 1);
    assert_eq!(read(&text().replace('\n', "\r\n")).mesh(), plain.mesh());
    let commented = text().replace(
        "element vertex",
        "comment a b c\nobj_info d\nelement vertex",
    );
    assert_eq!(read(&commented).mesh(), plain.mesh());
    let faces_first = "ply\nformat ascii 1.0\nelement face 1\nproperty list uint8 uint32 vertex_indices\n\
                       element vertex 3\nproperty float64 z\nproperty float64 y\nproperty float64 x\nend_header\n\
                       3 0 1 2\n0 0 0.0\n0 0 1.0\n0 1. .0\n";
    assert_eq!(read(faces_first).mesh(), plain.mesh());
}

#[test]
fn what_is_dropped_is_told_with_its_line_of_the_header() {
    let text = text()
        .replace("property float z\n", "property float z\nproperty float nx\nproperty float ny\nproperty uchar red\nproperty float confidence\n")
        .replace("end_header", "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\nelement camera 2\nproperty float f\nend_header")
        .replace("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "0 0 0 0 1 9 nan\n1 0 0 0 1 9 1\n0 1 0 0 1 9 1\n3 0 1 2 2 0.5 1\n7\n1\n2\n");
    let file = read(&text);
    let told: Vec<String> = file.dropped().iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "normals are left out: 3, from line 7 on",
            "colours are left out: 3, from line 9 on",
            "properties `confidence` are left out: 3, from line 10 on",
            "texture coordinates are left out: 1, from line 13 on",
            "edges are left out: 1, from line 14 on",
            "elements `camera` are left out: 2, from line 16 on",
        ]
    );
}

#[test]
fn broken_headers_are_refused() {
    refused("ply\n", "PLY\n", 1, "expected `ply`, found `PLY`");
    refused(
        "format ascii 1.0",
        "format morse 1.0",
        2,
        "`format morse 1.0`",
    );
    refused(
        "element vertex 3",
        "element vertex many",
        3,
        "`element vertex many`",
    );
    refused(
        "property float y",
        "property real y",
        5,
        "`property real y`",
    );
    refused(
        "property float y",
        "property float x",
        5,
        "announced this before",
    );
    refused(
        "element face 1",
        "element vertex 1",
        7,
        "announced this before",
    );
    refused("end_header\n", "", 12, "no end");
    refused(
        "property float z\n",
        "",
        3,
        "the element `vertex` has no property `z`",
    );
    refused(
        "vertex_index",
        "corners",
        7,
        "the element `face` has no property `vertex_indices`",
    );
    refused("uchar int", "uchar float", 8, "wrong type");
    refused("float x", "list uchar float x", 4, "wrong type");
    let no_format = text().replace("format ascii 1.0\n", "");
    let error = read_ply(no_format.as_bytes()).expect_err("the format is missing");
    assert!(error.to_string().contains("format"), "{error}");
    assert!(read_ply(b"").is_err());
}

#[test]
fn broken_texts_are_refused() {
    refused(
        "1 0 0\n",
        "1 0\n",
        11,
        "the vertex has 3 numbers by the header, found 2",
    );
    refused(
        "1 0 0\n",
        "1 0 0 0\n",
        11,
        "the vertex has 3 numbers by the header, found 4",
    );
    refused("1 0 0\n", "1 nan 0\n", 11, "`nan` is not finite");
    refused("1 0 0\n", "1 one 0\n", 11, "found `one`");
    refused(
        "3 0 1 2",
        "4 0 1 2",
        13,
        "the face has 5 numbers by the header, found 4",
    );
    refused("3 0 1 2", "18446744073709551615 0 1 2", 13, "found 4");
    refused(
        "3 0 1 2",
        "3 0 1 2.5",
        13,
        "the number of a vertex, found `2.5`",
    );
    refused(
        "3 0 1 2",
        "3 0 1 3",
        13,
        "vertex 3, but there are only 3 vertices, counted from 0",
    );
    refused("3 0 1 2", "3 0 1 -1", 13, "vertex -1");
    refused("3 0 1 2", "3 0 1 1", 13, "passes vertex 1 twice");
    refused("3 0 1 2", "2 0 1", 13, "at least 3 vertices, found 2");
    refused(
        "3 0 1 2\n",
        "",
        13,
        "the file ends after 0 of 1 elements `face`",
    );
    refused(
        "3 0 1 2\n",
        "3 0 1 2\n3 0 2 1\n",
        14,
        "expected the end of the file",
    );
    refused(
        "vertex 3",
        "vertex 1000000000000000000",
        13,
        "3 numbers by the header, found 4",
    );
}

fn binary(mesh: &Space, encoding: Encoding) -> Vec<u8> {
    let mut bytes = vec![];
    write_ply(mesh, encoding, &mut bytes).expect("a list takes all bytes");
    bytes
}

#[test]
fn all_encodings_are_read_and_written() {
    let cube = solids::cube();
    for encoding in [
        Encoding::Ascii,
        Encoding::BinaryBigEndian,
        Encoding::BinaryLittleEndian,
    ] {
        let bytes = binary(&cube, encoding);
        let file = read_ply(&bytes).unwrap_or_else(|error| panic!("{encoding:?}: {error}"));
        assert_eq!(file.mesh(), &cube);
    }
}

#[test]
fn a_face_may_have_more_corners_than_a_byte_counts() {
    let circle = (0..300).map(|i| f64::from(i) * 0.02);
    let points = circle.map(|t| Point::new([libm::cos(t), libm::sin(t), 0.0]));
    let corners: Vec<u32> = (0..300).collect();
    let polygon = Space::from_faces(points.collect(), &[corners]).expect("a polygon");
    for encoding in [Encoding::Ascii, Encoding::BinaryLittleEndian] {
        let file = read_ply(&binary(&polygon, encoding)).expect("it is whole");
        assert_eq!(file.mesh(), &polygon);
    }
}

#[test]
fn binary_data_are_refused_at_the_element() {
    let bytes = binary(&solids::cube(), Encoding::BinaryLittleEndian);
    let header = bytes.len() - 8 * 24 - 6 * 17;
    let refused = |bytes: &[u8]| read_ply(bytes).expect_err("it is broken");
    // Each vertex has 24 bytes, each face 17.
    let cut = refused(&bytes[..header + 3 * 24 + 5]);
    assert_eq!(cut.place, Some(Place::Vertex(3)));
    assert!(cut.to_string().contains("after 3 of 8"), "{cut}");
    let cut = refused(&bytes[..bytes.len() - 1]);
    assert_eq!(cut.place, Some(Place::Face(5)));

    let longer = refused(&[&bytes[..], &[0; 9]].concat());
    assert!(longer.to_string().contains("found `9 bytes`"), "{longer}");

    let mut infinite = bytes.clone();
    infinite[header + 24..][..8].copy_from_slice(&f64::NEG_INFINITY.to_le_bytes());
    let infinite = refused(&infinite);
    assert_eq!(infinite.place, Some(Place::Vertex(1)));
    assert!(
        infinite.to_string().contains("`-inf` is not finite"),
        "{infinite}"
    );

    let mut dangling = bytes.clone();
    let last = dangling.len() - 4;
    dangling[last..].copy_from_slice(&8_i32.to_le_bytes());
    let dangling = refused(&dangling);
    assert_eq!(dangling.place, Some(Place::Face(5)));
    assert!(dangling.to_string().contains("vertex 8"), "{dangling}");
}

#[test]
fn promises_cost_no_memory() {
    let header = "ply\nformat binary_little_endian 1.0\nelement nothing 1000000000000000000\n\
                  element vertex 1000000000000000000\nproperty float x\nproperty float y\nproperty float z\n\
                  element face 1\nproperty list uint uint vertex_index\nend_header\n";
    let error = read_ply(&[header.as_bytes(), &[0; 30]].concat()).expect_err("it is cut off");
    assert_eq!(error.place, Some(Place::Vertex(2)));
    let header = header.replace("vertex 1000000000000000000", "vertex 1");
    let error = read_ply(&[header.as_bytes(), &[255; 16]].concat()).expect_err("no vertex is NaN");
    assert_eq!(error.place, Some(Place::Vertex(0)));
    let error = read_ply(&[header.as_bytes(), &[0; 12], &[255; 8]].concat());
    assert_eq!(
        error.map_err(|error| error.place),
        Err(Some(Place::Face(0)))
    );
}
