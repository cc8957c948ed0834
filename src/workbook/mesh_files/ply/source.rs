//! The elements of a PLY file, one after the other.

use std::borrow::Cow;
use std::io::ErrorKind;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{ElementDef, Encoding};

use super::header::Announced;
use super::record::Record;
use super::{FACE, VERTEX, refused};
use crate::subdivision::files::words::written;
use crate::subdivision::files::{MeshFileError, MeshFileProblem, Place};

/// The elements behind the header.
pub(super) enum Source<'a> {
    Text(Lines<'a>),
    Binary {
        rest: &'a [u8],
        read: ReadElement<'a>,
    },
}

/// The lines behind the header.
pub(super) struct Lines<'a> {
    lines: std::slice::Split<'a, u8, fn(&u8) -> bool>,
    /// The number of the line that was read last.
    number: usize,
}

impl<'a> Lines<'a> {
    /// The next line with words on it.
    fn filled(&mut self) -> Option<(Cow<'a, str>, Place)> {
        for line in &mut self.lines {
            self.number += 1;
            if !line.trim_ascii().is_empty() {
                return Some((String::from_utf8_lossy(line), Place::Line(self.number)));
            }
        }
        None
    }
}

fn is_newline(byte: &u8) -> bool {
    *byte == b'\n'
}

type ReadElement<'a> =
    fn(&Parser<Record>, &mut &'a [u8], &ElementDef) -> ply_rs_bw::parser::Result<Record>;

impl<'a> Source<'a> {
    pub(super) fn of(announced: &Announced<'a>) -> Self {
        match announced.header.encoding {
            Encoding::Ascii => Self::Text(Lines {
                lines: announced.payload.split(is_newline as fn(&u8) -> bool),
                number: announced.line_count,
            }),
            Encoding::BinaryBigEndian => Self::Binary {
                rest: announced.payload,
                read: Parser::read_big_endian_element,
            },
            Encoding::BinaryLittleEndian => Self::Binary {
                rest: announced.payload,
                read: Parser::read_little_endian_element,
            },
        }
    }

    /// The next element, and where it stands.
    pub(super) fn next(
        &mut self,
        element: &ElementDef,
        number: usize,
    ) -> Result<(Record, Place), MeshFileError> {
        let ends = || MeshFileProblem::Ends {
            what: format!("elements `{}`", written(&element.name)),
            expected: element.count,
            found: number,
        };
        match self {
            Self::Text(lines) => {
                let Some((line, place)) = lines.filled() else {
                    return Err(ends().at(Place::Line(lines.number)));
                };
                let record = Record::from_line(&line, element);
                Ok((record.map_err(|problem| problem.at(place))?, place))
            }
            Self::Binary { rest, read } => {
                let place = match element.name.as_str() {
                    VERTEX => Some(Place::Vertex(number)),
                    FACE => Some(Place::Face(number)),
                    _ => None,
                };
                let record =
                    read(&Parser::new(), rest, element).map_err(|error| MeshFileError {
                        place,
                        problem: match error.kind() {
                            ErrorKind::UnexpectedEof => ends(),
                            _ => refused(&error.to_string()),
                        },
                    })?;
                Ok((record, place.unwrap_or(Place::Line(1))))
            }
        }
    }

    /// Nothing is left.
    pub(super) fn end(&mut self) -> Result<(), MeshFileError> {
        let left = |found: String| MeshFileProblem::GoesOn {
            what: "all elements of the header".into(),
            found,
        };
        match self {
            Self::Binary { rest: [], .. } => Ok(()),
            Self::Binary { rest, .. } => Err(left(format!("{} bytes", rest.len())).anywhere()),
            Self::Text(lines) => match lines.filled() {
                Some((line, place)) => Err(left(written(&line)).at(place)),
                None => Ok(()),
            },
        }
    }
}
