//! The Object File Format, OFF.

use std::borrow::Cow;
use std::fmt::{self, Display};

use super::words::{Lines, coordinate, integer, number, shortest, written};
use super::{Attribute, MeshFile, MeshFileError, MeshFileProblem, Place, Polygons, Space};

/// Reads a mesh in the format OFF.
///
/// The variants with normals, colours and texture coordinates (NOFF, COFF, STOFF and their combinations) are read, too;
/// these attributes are dropped, as are the colours of faces.
/// Each vertex and each face stands on a line of its own.
///
/// # Errors
///
/// [`MeshFileError`] for a line that the format does not allow, for the binary variant and points of another dimension,
/// and for faces that are not those of a mesh.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::files::read_off;
///
/// let file = read_off(b"OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")?;
/// assert_eq!(file.mesh().connectivity().face_count(), 1);
///
/// let error = read_off(b"OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n").unwrap_err();
/// assert!(error.to_string().starts_with("line 6: the file ends after 3 of 4 vertices"));
/// # Ok::<(), cagd::subdivision::files::MeshFileError>(())
/// ```
pub fn read_off(bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let mut lines = Lines::of(bytes)?;
    let (header, place) = filled(&mut lines).unwrap_or((Cow::Borrowed(""), Place::Line(1)));
    let (extras, counts) = self::header(&header).map_err(|problem| problem.at(place))?;
    let (counts, place) = if counts.is_empty() {
        filled(&mut lines).unwrap_or((Cow::Borrowed(""), place))
    } else {
        (Cow::Borrowed(counts), place)
    };
    let [vertices, faces] = self::counts(&counts).map_err(|problem| problem.at(place))?;
    let mut polygons = Polygons::default();
    for read in 0..vertices {
        let (line, place) =
            filled(&mut lines).ok_or_else(|| ends(&lines, "vertices", vertices, read))?;
        vertex(&mut polygons, &line, extras, place).map_err(|problem| problem.at(place))?;
    }
    for read in 0..faces {
        let (line, place) = filled(&mut lines).ok_or_else(|| ends(&lines, "faces", faces, read))?;
        face(&mut polygons, &line, place).map_err(|problem| problem.at(place))?;
    }
    if let Some((line, place)) = filled(&mut lines) {
        return Err(MeshFileProblem::GoesOn {
            what: format!("{vertices} vertices and {faces} faces"),
            found: written(&line),
        }
        .at(place));
    }
    polygons.finish(0)
}

/// The next line with words on it.
fn filled<'a>(lines: &mut Lines<'a>) -> Option<(Cow<'a, str>, Place)> {
    let line = lines.find(|line| !line.trim_ascii().is_empty())?;
    Some((line, Place::Line(lines.number)))
}

fn ends(lines: &Lines, what: &str, expected: usize, found: usize) -> MeshFileError {
    MeshFileProblem::Ends {
        what: what.into(),
        expected,
        found,
    }
    .at(Place::Line(lines.number))
}

/// What the header promises behind the coordinates of each vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Extras {
    texture: bool,
    colour: bool,
    normal: bool,
}

/// What the first line says: what a vertex has, and what stands behind the name of the format.
fn header(line: &str) -> Result<(Extras, &str), MeshFileProblem> {
    let wrong = || MeshFileProblem::Header {
        expected: "`OFF`",
        found: written(line.trim_ascii()),
    };
    let (prefix, rest) = line
        .trim_ascii_start()
        .split_once("OFF")
        .ok_or_else(wrong)?;
    let mut extras = Extras::default();
    let mut letters = prefix;
    for (letter, has) in [
        ("ST", &mut extras.texture),
        ("C", &mut extras.colour),
        ("N", &mut extras.normal),
    ] {
        if let Some(behind) = letters.strip_prefix(letter) {
            (letters, *has) = (behind, true);
        }
    }
    let variant = |variant: String| {
        Err(MeshFileProblem::Variant {
            variant,
            instead: "OFF, as text and with three coordinates",
        })
    };
    let rest = rest.trim_ascii();
    match letters {
        "4" | "n" | "4n" => variant(format!("{prefix}OFF, with points of another dimension,")),
        "" if rest.starts_with("BINARY") => variant(format!("{prefix}OFF BINARY")),
        // Some files have the numbers in the same line, even without a blank.
        "" if !rest.starts_with(|letter: char| !letter.is_ascii_digit()) => Ok((extras, rest)),
        _ => Err(wrong()),
    }
}

/// The numbers of vertices and faces; that of edges may be missing and is not used.
fn counts(line: &str) -> Result<[usize; 2], MeshFileProblem> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let [vertices, faces, edges @ ..] = words.as_slice() else {
        return Err(wrong_count(words.len()));
    };
    if edges.len() > 1 {
        return Err(wrong_count(words.len()));
    }
    let count = |word: &str| integer::<usize>(word, "a number of elements");
    for edges in edges {
        count(edges)?;
    }
    return Ok([count(vertices)?, count(faces)?]);

    fn wrong_count(found: usize) -> MeshFileProblem {
        MeshFileProblem::Count {
            what: "the line behind the header",
            expected: "3 numbers, of vertices, faces and edges".into(),
            found,
        }
    }
}

fn vertex(
    polygons: &mut Polygons,
    line: &str,
    extras: Extras,
    place: Place,
) -> Result<(), MeshFileProblem> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let promised = 3 + 3 * usize::from(extras.normal) + 2 * usize::from(extras.texture);
    // A colour has three or four numbers; some files have it without announcing it.
    let colour = words.len().checked_sub(promised);
    let fits = match colour {
        Some(0) => !extras.colour,
        Some(3 | 4) => true,
        _ => false,
    };
    let ([x, y, z, more @ ..], true) = (words.as_slice(), fits) else {
        let colour = if extras.colour { 3 } else { 0 };
        return Err(MeshFileProblem::Count {
            what: "a vertex",
            expected: format!("{} numbers by the header", promised + colour),
            found: words.len(),
        });
    };
    let point = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
    for word in more {
        number(word)?;
    }
    for (attribute, has) in [
        (Attribute::Normals, extras.normal),
        (Attribute::Colours, colour != Some(0)),
        (Attribute::TextureCoordinates, extras.texture),
    ] {
        if has {
            polygons.drop_one(attribute, place);
        }
    }
    polygons.add_point(point, place);
    Ok(())
}

/// The number of corners, the vertices, and perhaps a colour.
fn face(polygons: &mut Polygons, line: &str, place: Place) -> Result<(), MeshFileProblem> {
    let mut words = line.split_ascii_whitespace();
    let degree: usize = integer(words.next().unwrap_or_default(), "the number of corners")?;
    for found in 0..degree {
        let Some(word) = words.next() else {
            return Err(MeshFileProblem::Count {
                what: "the face",
                expected: format!("{degree} vertices behind their number"),
                found,
            });
        };
        let vertex: i64 = integer(word, "the number of a vertex")?;
        let index = u32::try_from(vertex).map_err(|_| MeshFileProblem::NoVertexBefore {
            index: vertex,
            vertices: polygons.point_count(),
        })?;
        polygons.add_corner(index);
    }
    let colour: Vec<&str> = words.collect();
    if colour.len() > 4 {
        return Err(MeshFileProblem::Count {
            what: "the face",
            expected: format!("{degree} vertices and at most 4 numbers of a colour"),
            found: degree + colour.len(),
        });
    }
    for word in &colour {
        number(word)?;
    }
    if !colour.is_empty() {
        polygons.drop_one(Attribute::Colours, place);
    }
    polygons.end_face(place);
    Ok(())
}

/// A mesh in the format OFF, to be printed.
///
/// Reading it gives the same mesh: each coordinate is the shortest decimal of its number.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{files, solids};
///
/// let cube = solids::cube();
/// let text = files::as_off(&cube).to_string();
/// assert!(text.starts_with("OFF\n8 6 12\n"), "{text}");
/// assert_eq!(files::read_off(text.as_bytes())?.mesh(), &cube);
/// # Ok::<(), files::MeshFileError>(())
/// ```
pub fn as_off(mesh: &Space) -> impl Display + '_ {
    let connectivity = mesh.connectivity();
    fmt::from_fn(move |f| {
        f.write_str("OFF\n")?;
        let [vertices, faces, edges] = [
            connectivity.vertex_count(),
            connectivity.face_count(),
            connectivity.edge_count(),
        ];
        writeln!(f, "{vertices} {faces} {edges}")?;
        for point in mesh.points() {
            let [x, y, z] = [0, 1, 2].map(|k| shortest(point[k]));
            writeln!(f, "{x} {y} {z}")?;
        }
        for face in connectivity.faces() {
            write!(f, "{}", connectivity.face_degree(face))?;
            for v in connectivity.face_vertices(face) {
                write!(f, " {}", v.0)?;
            }
            f.write_str("\n")?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

    fn read(text: &str) -> MeshFile {
        read_off(text.as_bytes()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
    }

    /// The text is refused at this line with these words.
    #[track_caller]
    fn refused(text: &str, line: usize, words: &str) {
        match read_off(text.as_bytes()) {
            Ok(_) => panic!("{text:?} is read"),
            Err(error) => {
                assert_eq!(error.place, Some(Place::Line(line)), "{error}");
                assert!(error.to_string().contains(words), "{error}");
            }
        }
    }

    #[test]
    fn headers_are_written_in_many_ways() {
        let plain = read(&format!("OFF\n4 1 4\n{SQUARE}4 0 1 2 3\n"));
        for header in [
            "OFF\n4 1",
            "OFF 4 1 0",
            "OFF4 1 0",
            "# a square\n\nOFF # here\n# counts\n4 1 4",
            "\u{feff}OFF\r\n4 1 4\r",
            "OFF\r# counts\r4 1 4",
        ] {
            let text = format!("{header}\n{SQUARE}\n4 0 1 2 3\n\n");
            assert_eq!(read(&text).mesh(), plain.mesh(), "{header}");
        }
    }

    #[test]
    fn variants_drop_their_attributes() {
        let told = |text: &str| -> Vec<String> {
            let file = read(text);
            assert_eq!(file.mesh().points().len(), 3);
            file.dropped().iter().map(ToString::to_string).collect()
        };
        let triangle = |header: &str, more: &str, colour: &str| {
            format!("{header}\n3 1 0\n0 0 0{more}\n1 0 0{more}\n0 1 0{more}\n3 0 1 2{colour}\n")
        };
        let normals = "normals are left out: 3, from line 3 on";
        let colours = "colours are left out: 3, from line 3 on";
        let texture = "texture coordinates are left out: 3, from line 3 on";
        assert_eq!(told(&triangle("NOFF", " 0 0 1", "")), [normals]);
        assert_eq!(told(&triangle("COFF", " 1 0 0 1", "")), [colours]);
        assert_eq!(told(&triangle("STOFF", " 0 1", "")), [texture]);
        let all = triangle("STCNOFF", " 0 0 1 1 0 0 1 0 1", "");
        assert_eq!(told(&all), [normals, colours, texture]);
        assert_eq!(told(&triangle("OFF", " 255 0 0", "")), [colours]);
        let of_faces = "colours are left out: 1, from line 6 on";
        assert_eq!(told(&triangle("OFF", "", " 0.5 0.5 0.5")), [of_faces]);
        let unused = "OFF\n4 1 0\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n3 0 2 3\n";
        assert_eq!(
            told(unused),
            ["vertices without a face are left out: 1, from line 4 on"]
        );
    }

    #[test]
    fn broken_texts_are_refused() {
        refused("", 1, "expected `OFF`, found ``");
        refused("ply\n", 1, "expected `OFF`, found `ply`");
        refused("8 6 12\n", 1, "expected `OFF`");
        refused("XOFF\n", 1, "expected `OFF`");
        refused("OFFICE\n", 1, "expected `OFF`");
        refused("4OFF\n", 1, "another dimension");
        refused("nOFF\n3\n", 1, "another dimension");
        refused("OFF BINARY\n", 1, "OFF BINARY is not read");
        refused("OFF\n", 1, "found 0");
        refused("OFF\n4\n", 2, "found 1");
        refused("OFF\n4 1 0 0\n", 2, "found 4");
        refused("OFF\n4 one 0\n", 2, "found `one`");
        refused("OFF\n-4 1 0\n", 2, "found `-4`");
        refused(
            "OFF\n4 1 4\n0 0 0\n1 0\n",
            4,
            "a vertex has 3 numbers by the header, found 2",
        );
        refused(
            "NOFF\n4 1 4\n0 0 0\n",
            3,
            "a vertex has 6 numbers by the header, found 3",
        );
        refused(
            "COFF\n4 1 4\n0 0 0\n",
            3,
            "a vertex has 6 numbers by the header, found 3",
        );
        refused("OFF\n4 1 4\n0 0 inf\n", 3, "`inf` is not finite");
        refused("OFF\n4 1 4\n0 0 x\n", 3, "found `x`");
        let with = |faces: &str| format!("OFF\n4 1 4\n{SQUARE}{faces}\n");
        refused(&with(""), 8, "the file ends after 0 of 1 faces");
        refused(&with("x 0 1 2"), 7, "the number of corners, found `x`");
        refused(&with("3 0 1"), 7, "3 vertices behind their number, found 2");
        refused(
            &with("3 0 1 2 1 1 1 1 1"),
            7,
            "at most 4 numbers of a colour",
        );
        refused(&with("3 0 1 2 red"), 7, "found `red`");
        refused(&with("3 0 1 -2"), 7, "vertex -2");
        refused(
            &with("3 0 1 4"),
            7,
            "vertex 4, but there are only 4 vertices, counted from 0",
        );
        refused(&with("3 0 1 4294967296"), 7, "vertex 4294967296");
        refused(&with("3 0 1 1"), 7, "passes vertex 1 twice");
        refused(&with("2 0 1"), 7, "at least 3 vertices, found 2");
        refused(
            &with("3 0 1 2\n3 0 2 3"),
            8,
            "expected the end of the file after 4 vertices and 1 faces",
        );
        let two = format!("OFF\n4 2 5\n{SQUARE}3 0 1 2\n3 0 1 3\n");
        refused(&two, 8, "face 0: line 7");
    }

    #[test]
    fn promises_cost_no_memory() {
        refused(
            "OFF\n1000000000000000000 1 0\n0 0 0\n",
            4,
            "after 1 of 1000000000000000000 vertices",
        );
        refused(
            "OFF\n3 1000000000000000000 0\n0 0 0\n1 0 0\n0 1 0\n",
            6,
            "0 of 1000000000000000000",
        );
        refused(
            "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1000000000000000000 0 1 2\n",
            6,
            "found 3",
        );
        refused("OFF\n99999999999999999999 1 0\n", 2, "a number of elements");
    }
}
