//! What a PLY file announces in its header.

use std::borrow::Cow;
use std::collections::BTreeMap;

use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, PropertyType, ScalarType};

use super::record::Record;
use super::{AXES, CORNERS, FACE, VERTEX, refused};
use crate::subdivision::files::words::written;
use crate::subdivision::files::{Attribute, MeshFileError, MeshFileProblem, Place, Polygons};

/// What the header says, and what stands behind it.
pub(super) struct Announced<'a> {
    pub(super) header: Header,
    /// The line of every element and, with its second name, of every property.
    lines: BTreeMap<[String; 2], usize>,
    pub(super) line_count: usize,
    /// What stands behind the header.
    pub(super) payload: &'a [u8],
}

impl<'a> Announced<'a> {
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, MeshFileError> {
        let mut text: Vec<Cow<str>> = vec![];
        let mut lines = BTreeMap::new();
        let mut element = String::new();
        let mut rest = bytes;
        loop {
            let end = rest.iter().position(|&byte| byte == b'\n');
            let (line, behind) = match end {
                Some(end) => (&rest[..end], &rest[end + 1..]),
                None => (rest, &[][..]),
            };
            let line = String::from_utf8_lossy(line.trim_ascii_end());
            let number = text.len() + 1;
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            if number == 1 && words != ["ply"] {
                return Err(MeshFileProblem::Header {
                    expected: "`ply`",
                    found: written(&line),
                }
                .at(Place::Line(1)));
            }
            let name = match words.as_slice() {
                ["element", name, ..] => {
                    element = (*name).to_owned();
                    Some([element.clone(), String::new()])
                }
                ["property", .., name] => Some([element.clone(), (*name).to_owned()]),
                _ => None,
            };
            if let Some(name) = name
                && lines.insert(name, number).is_some()
            {
                return Err(refused("the header has announced this before").at(Place::Line(number)));
            }
            let is_last = words == ["end_header"];
            text.push(line);
            if is_last {
                rest = behind;
                break;
            }
            if behind.is_empty() {
                return Err(refused("the header has no end, `end_header`").at(Place::Line(number)));
            }
            rest = behind;
        }
        let header_text = text.join("\n");
        let mut reader = Reader::new(header_text.as_bytes());
        let header = Parser::<Record>::new().read_header(&mut reader);
        let header = header.map_err(|error| match error.line() {
            Some(line) => MeshFileProblem::Statement {
                found: text
                    .get(line.saturating_sub(1))
                    .map_or_else(String::new, |line| written(line)),
            }
            .at(Place::Line(line)),
            None => refused(&error.to_string()).anywhere(),
        })?;
        Ok(Self {
            header,
            lines,
            line_count: text.len(),
            payload: rest,
        })
    }

    /// The line of an element, or of one of its properties.
    fn place(&self, element: &ElementDef, property: &str) -> Place {
        let name = [element.name.clone(), property.to_owned()];
        Place::Line(self.lines.get(&name).copied().unwrap_or(1))
    }

    /// Notes what is not kept of an element.
    pub(super) fn drop_attributes(&self, element: &ElementDef, polygons: &mut Polygons) {
        if element.count == 0 {
            return;
        }
        let (name, count) = (element.name.as_str(), element.count);
        if name != VERTEX && name != FACE {
            let attribute = match name {
                "edge" => Attribute::Edges,
                "material" => Attribute::Materials,
                _ => Attribute::Other(format!("elements `{}`", written(name))),
            };
            polygons.drop_all(attribute, count, self.place(element, ""));
            return;
        }
        let mut told = vec![];
        for property in element.properties.keys() {
            let attribute = attribute(name, property);
            // The three numbers of a normal are one attribute.
            if let Some(attribute) = attribute.filter(|attribute| !told.contains(attribute)) {
                polygons.drop_all(attribute.clone(), count, self.place(element, property));
                told.push(attribute);
            }
        }
    }

    /// The element has the properties of its name, of the right types.
    pub(super) fn check(&self, element: &ElementDef) -> Result<(), MeshFileError> {
        let found = |names: &[&str]| {
            let properties = element.properties.values();
            properties
                .map(|p| &p.data_type)
                .zip(element.properties.keys())
                .find(|(_, name)| names.contains(&name.as_str()))
        };
        let needed: &[&[&str]] = match element.name.as_str() {
            VERTEX => &[&AXES[..1], &AXES[1..2], &AXES[2..]],
            FACE => &[&CORNERS],
            _ => &[],
        };
        for names in needed {
            let Some((data_type, name)) = found(names) else {
                let text = format!(
                    "the element `{}` has no property `{}`",
                    element.name, names[0]
                );
                return Err(refused(&text).at(self.place(element, "")));
            };
            let fits = match data_type {
                PropertyType::Scalar(_) => element.name == VERTEX,
                PropertyType::List(_, ScalarType::Float | ScalarType::Double) => false,
                PropertyType::List(..) => element.name == FACE,
            };
            if !fits {
                let text = format!("the property `{name}` has the wrong type");
                return Err(refused(&text).at(self.place(element, name)));
            }
        }
        Ok(())
    }
}

/// What a property means that a mesh does not keep; `None` for what it keeps.
fn attribute(element: &str, property: &str) -> Option<Attribute> {
    let kept: &[&str] = if element == VERTEX { &AXES } else { &CORNERS };
    if kept.contains(&property) {
        return None;
    }
    Some(match property {
        "nx" | "ny" | "nz" => Attribute::Normals,
        "red" | "green" | "blue" | "alpha" => Attribute::Colours,
        "s" | "t" | "u" | "v" | "texture_u" | "texture_v" | "texcoord" | "texnumber" => {
            Attribute::TextureCoordinates
        }
        name => Attribute::Other(format!("properties `{}`", written(name))),
    })
}
