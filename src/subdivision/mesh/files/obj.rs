//! Wavefront OBJ.

use std::fmt::{self, Display};

use super::words::{Lines, coordinate, integer, number, shortest, written};
use super::{Attribute, MeshFile, MeshFileError, MeshFileProblem, Place, Polygons, Space};

/// Reads a mesh in the format OBJ.
///
/// Vertices `v` and faces `f` are read, also with negative numbers and with those of texture coordinates and normals.
/// A face may name vertices that follow later.
/// Other statements of the format are dropped.
///
/// # Errors
///
/// [`MeshFileError`] for a line that the format does not allow, and for faces that are not those of a mesh.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::files::read_obj;
///
/// let file = read_obj(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
/// assert_eq!(file.mesh().connectivity().face_count(), 1);
///
/// let error = read_obj(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n").unwrap_err();
/// assert!(error.to_string().starts_with("line 5: the face names vertex 4, but there are only 3 vertices"));
/// # Ok::<(), cagd::subdivision::files::MeshFileError>(())
/// ```
pub fn read_obj(bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let mut lines = Lines::of(bytes)?;
    let mut polygons = Polygons::default();
    while let Some(mut line) = lines.next() {
        let place = Place::Line(lines.number);
        // A line that ends in a backslash goes on in the next one.
        while line.ends_with('\\') {
            let begun = line.to_mut();
            begun.pop();
            begun.push(' ');
            if let Some(more) = lines.next() {
                begun.push_str(&more);
            }
        }
        let mut words = line.split_ascii_whitespace();
        if let Some(keyword) = words.next() {
            let words: Vec<&str> = words.collect();
            statement(&mut polygons, keyword, &words, place).map_err(|p| p.at(place))?;
        }
    }
    polygons.finish(1)
}

fn statement(
    polygons: &mut Polygons,
    keyword: &str,
    words: &[&str],
    place: Place,
) -> Result<(), MeshFileProblem> {
    let dropped = match keyword {
        "v" => return vertex(polygons, words, place),
        "f" => return face(polygons, words, place),
        "vn" => Attribute::Normals,
        "vt" => Attribute::TextureCoordinates,
        "g" | "o" => Attribute::Groups,
        "s" | "mg" => Attribute::SmoothingGroups,
        "usemtl" | "mtllib" | "usemap" | "maplib" => Attribute::Materials,
        "l" => Attribute::Edges,
        "p" => Attribute::Points,
        "vp" | "cstype" | "deg" | "bmat" | "step" | "curv" | "curv2" | "surf" | "parm" | "trim"
        | "hole" | "scrv" | "sp" | "end" | "con" => Attribute::FreeForms,
        "bevel" | "c_interp" | "d_interp" | "lod" | "shadow_obj" | "trace_obj" | "ctech"
        | "stech" => Attribute::Display,
        _ => {
            return Err(MeshFileProblem::Statement {
                found: written(keyword),
            });
        }
    };
    polygons.drop_one(dropped, place);
    Ok(())
}

/// `v x y z`, behind it a weight or a colour.
fn vertex(polygons: &mut Polygons, words: &[&str], place: Place) -> Result<(), MeshFileProblem> {
    let ([x, y, z, more @ ..], 3 | 4 | 6 | 7) = (words, words.len()) else {
        return Err(MeshFileProblem::Count {
            what: "a vertex",
            expected: "3 coordinates, with a weight 4 numbers, with a colour 6 or 7".into(),
            found: words.len(),
        });
    };
    let point = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
    for word in more {
        number(word)?;
    }
    match more.len() {
        0 => {}
        1 => polygons.drop_one(Attribute::Weights, place),
        _ => polygons.drop_one(Attribute::Colours, place),
    }
    polygons.add_point(point, place);
    Ok(())
}

/// `f` and the corners, each `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
fn face(polygons: &mut Polygons, words: &[&str], place: Place) -> Result<(), MeshFileProblem> {
    const CORNER: &str = "the number of a vertex, alone or as a/b, a//c or a/b/c";
    for word in words {
        let mut parts = word.split('/');
        let vertex: i64 =
            integer(parts.next().unwrap_or_default(), CORNER).map_err(|_| no_corner(word))?;
        let attributes: Vec<&str> = parts.collect();
        let sound = |part: &&str| part.is_empty() || part.parse::<i64>().is_ok();
        if attributes.len() > 2 || !attributes.iter().all(sound) {
            return Err(no_corner(word));
        }
        polygons.add_corner(index(vertex, polygons.point_count())?);
    }
    polygons.end_face(place);
    return Ok(());

    fn no_corner(word: &str) -> MeshFileProblem {
        MeshFileProblem::Word {
            expected: CORNER,
            found: written(word),
        }
    }
}

/// The vertex, counted from 0: from 1 in the file, or backwards from −1.
fn index(number: i64, vertices: usize) -> Result<u32, MeshFileProblem> {
    let index = match number {
        1.. => Some(number - 1),
        0 => None,
        // No list has more vertices than there are 64-bit integers.
        _ => number.checked_add_unsigned(vertices as u64),
    };
    index
        .and_then(|index| u32::try_from(index).ok())
        .ok_or(MeshFileProblem::NoVertexBefore {
            index: number,
            vertices,
        })
}

/// A mesh in the format OBJ, to be printed.
///
/// Reading it gives the same mesh: each coordinate is the shortest decimal of its number.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{files, solids};
///
/// let cube = solids::cube();
/// let text = files::as_obj(&cube).to_string();
/// assert!(text.ends_with("f 4 1 5 8\n"), "{text}");
/// assert_eq!(files::read_obj(text.as_bytes())?.mesh(), &cube);
/// # Ok::<(), files::MeshFileError>(())
/// ```
pub fn as_obj(mesh: &Space) -> impl Display + '_ {
    fmt::from_fn(|f| {
        for point in mesh.points() {
            let [x, y, z] = [0, 1, 2].map(|k| shortest(point[k]));
            writeln!(f, "v {x} {y} {z}")?;
        }
        for face in mesh.connectivity().faces() {
            f.write_str("f")?;
            for v in mesh.connectivity().face_vertices(face) {
                write!(f, " {}", u64::from(v.0) + 1)?;
            }
            f.write_str("\n")?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    fn read(text: &str) -> MeshFile {
        read_obj(text.as_bytes()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
    }

    /// The text is refused at this line with these words.
    #[track_caller]
    fn refused(text: &str, line: usize, words: &str) {
        match read_obj(text.as_bytes()) {
            Ok(_) => panic!("{text:?} is read"),
            Err(error) => {
                assert_eq!(error.place, Some(Place::Line(line)), "{error}");
                assert!(error.to_string().contains(words), "{error}");
            }
        }
    }

    #[test]
    fn corners_are_written_in_many_ways() {
        let plain = read(&format!("{SQUARE}f 1 2 3 4\n"));
        for face in [
            "f 1/1 2/2 3/3 4/4",
            "f 1//1 2//1 3//1 4//1",
            "f 1/1/1 2/2/1 3/3/1 4/4/1",
            "f -4 -3 -2 -1",
            "f 1 2 \\\n3 4",
            "\tf 1  2 3\t4 # a square",
        ] {
            assert_eq!(
                read(&format!("{SQUARE}{face}\n")).mesh(),
                plain.mesh(),
                "{face}"
            );
        }
        let faces_first = format!("f 1 2 3 4\n{SQUARE}");
        assert_eq!(read(&faces_first).mesh(), plain.mesh());
    }

    #[test]
    fn lines_end_as_on_any_machine() {
        let text = format!("\u{feff}# a square\n\n{SQUARE}f 1 2 \\\n3 4\ns off");
        let unix = read(&text);
        for end in ["\r\n", "\r"] {
            let other = read(&text.replace('\n', end));
            assert_eq!(other, unix, "{end:?}");
        }
        refused("# c\rv 0 0 zero\r", 2, "expected a number, found `zero`");
        refused("# c\r\rv 0 0 0\n\rv 1 0 one\r\n", 5, "found `one`");
    }

    #[test]
    fn what_is_dropped_is_told_with_its_first_line() {
        let text = "mtllib a.mtl\no square\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\n\
                    vn 0 0 1\nvt 0 0\nvt 1 0\nusemtl red\ns off\nf 1/1/1 2/2/1 3/1/1 4/1/1\nl 1 2\nv 8 8 8\n";
        let file = read(text);
        let told: Vec<String> = file.dropped().iter().map(ToString::to_string).collect();
        assert_eq!(
            told,
            [
                "materials are left out: 2, from line 1 on",
                "groups and objects are left out: 1, from line 2 on",
                "colours are left out: 2, from line 3 on",
                "normals are left out: 1, from line 8 on",
                "texture coordinates are left out: 2, from line 9 on",
                "smoothing groups are left out: 1, from line 12 on",
                "edges are left out: 1, from line 14 on",
                "vertices without a face are left out: 2, from line 7 on",
            ]
        );
        assert_eq!(file.mesh().points().len(), 4);
    }

    #[test]
    fn letters_that_are_not_utf_8_do_no_harm_in_names() {
        let text = [b"# caf\xE9\no caf\xE9\n", SQUARE.as_bytes(), b"f 1 2 3 4\n"].concat();
        assert_eq!(
            read_obj(&text).map(|file| file.mesh().points().len()),
            Ok(4)
        );
        let broken = [b"v 0 0 \xE9\n", SQUARE.as_bytes(), b"f 1 2 3 4\n"].concat();
        assert_eq!(
            read_obj(&broken).map_err(|error| error.place),
            Err(Some(Place::Line(1)))
        );
    }

    #[test]
    fn broken_lines_are_refused() {
        refused("v 0 0\n", 1, "found 2");
        refused("v 0 0 0 0 0\n", 1, "found 5");
        refused("v 0 0 0 1 1 x\n", 1, "expected a number, found `x`");
        refused("# c\n\nv 0 0 zero\n", 3, "expected a number, found `zero`");
        refused("v 0 nan 0\n", 1, "`nan` is not finite");
        refused("v 0 1e999 0\n", 1, "`1e999` is not finite");
        refused("v 0 0 0 \\\n x\nv 1\n", 1, "found `x`");
        refused("vertex 0 0 0\n", 1, "no statement `vertex`");
        refused(&format!("{SQUARE}f 1 2 a\n"), 5, "found `a`");
        refused(&format!("{SQUARE}f 1 2 3/a\n"), 5, "found `3/a`");
        refused(&format!("{SQUARE}f 1 2 3/1/1/1\n"), 5, "found `3/1/1/1`");
        refused(&format!("{SQUARE}f 0 1 2\n"), 5, "vertex 0");
        refused(
            &format!("{SQUARE}f 1 2 -5\n"),
            5,
            "vertex -5, but 4 vertices",
        );
        refused(
            &format!("{SQUARE}f 1 2 9223372036854775807\n"),
            5,
            "9223372036854775807",
        );
        refused(
            &format!("{SQUARE}f 1 2 3\nf 1 3 5\n"),
            6,
            "vertex 5, but there are only 4",
        );
    }

    #[test]
    fn lists_that_are_no_mesh_are_refused_at_the_line_of_the_face() {
        refused(
            &format!("{SQUARE}f 1 2 3\nf\n"),
            6,
            "at least 3 vertices, found 0",
        );
        refused(
            &format!("{SQUARE}f 1 2\n"),
            5,
            "face 0 needs at least 3 vertices, found 2",
        );
        refused(
            &format!("{SQUARE}f 1 2 3 2\n"),
            5,
            "face 0 passes vertex 1 twice",
        );
        let reversed = format!("{SQUARE}f 1 2 3\n\n\nf 1 2 4\n");
        refused(
            &reversed,
            8,
            "face 0: line 5, face 1: line 8, vertex 0: line 1, vertex 1: line 2",
        );
        let third = format!("{SQUARE}v 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
        refused(&third, 8, "more than two faces");
        let touching = format!("{SQUARE}v 0 0 1\nf 1 2 3\nf 1 4 5\n");
        refused(&touching, 1, "the 2 faces at vertex 0");
    }

    #[test]
    fn vertices_keep_the_numbers_of_the_file_in_messages() {
        // Vertices 0 and 1 have no face.
        let text = format!("v 9 9 9\nv 9 9 9\n{SQUARE}f 3 4 5 4\n");
        refused(&text, 7, "face 0 passes vertex 3 twice");
        refused(&text, 7, "vertex 3: line 4");
    }

    #[test]
    fn texts_without_a_face_are_refused() {
        for text in ["", "\n\n", "# nothing\n", SQUARE] {
            let error = read_obj(text.as_bytes()).expect_err("there is no face");
            assert_eq!(error.place, None);
            assert!(error.to_string().contains("found none"), "{error}");
        }
        let utf_16 = read_obj(b"\xFF\xFEv\0 \0").expect_err("another encoding");
        assert_eq!(utf_16.problem, MeshFileProblem::Utf16);
    }

    #[test]
    fn coordinates_are_written_in_the_shortest_decimal() {
        let shown = |x: f64| shortest(x).to_string();
        assert_eq!(
            [0.1, -0.0, 1.0, 1e300, 5e-324, 1.0 / 3.0].map(shown),
            ["0.1", "-0", "1", "1e300", "5e-324", "0.3333333333333333"]
        );
    }
}
