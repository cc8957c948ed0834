//! One element of a PLY file.

use ply_rs_bw::ply::{ElementDef, Property, PropertyAccess, PropertyAccessResult, PropertyType};

use super::{AXES, CORNERS, FACE, VERTEX};
use crate::subdivision::files::MeshFileProblem;
use crate::subdivision::files::words::{coordinate, integer, number};

/// An element, as far as a mesh keeps it.
#[derive(Debug, Default)]
pub(super) struct Record {
    pub(super) position: [f64; 3],
    pub(super) corners: Vec<i64>,
}

impl Record {
    pub(super) fn from_line(line: &str, element: &ElementDef) -> Result<Self, MeshFileProblem> {
        let what = match element.name.as_str() {
            VERTEX => "the vertex",
            FACE => "the face",
            _ => "the element",
        };
        let mut record = Self::default();
        let all: Vec<&str> = line.split_ascii_whitespace().collect();
        let mut words = all.iter();
        let mut promised = 0_usize;
        // A missing word shows in the count below.
        for (name, property) in &element.properties {
            promised = promised.saturating_add(1);
            let Some(word) = words.next() else { continue };
            let axis = AXES.iter().position(|axis| axis == name);
            match (&property.data_type, axis) {
                (PropertyType::Scalar(_), Some(axis)) if element.name == VERTEX => {
                    record.position[axis] = coordinate(word)?;
                }
                (PropertyType::Scalar(_), _) => {
                    number(word)?;
                }
                (PropertyType::List(..), _) => {
                    let count: usize = integer(word, "the number of entries of a list")?;
                    promised = count.saturating_add(promised);
                    let entries = words.by_ref().take(count);
                    if element.name == FACE && CORNERS.contains(&name.as_str()) {
                        let vertices = entries.map(|word| integer(word, "the number of a vertex"));
                        record.corners = vertices.collect::<Result<_, _>>()?;
                    } else {
                        for word in entries {
                            number(word)?;
                        }
                    }
                }
            }
        }
        if all.len() != promised {
            return Err(MeshFileProblem::Count {
                what,
                expected: format!("{promised} numbers by the header"),
                found: all.len(),
            });
        }
        Ok(record)
    }
}

/// How the crate gives and takes the values of an element.
impl PropertyAccess for Record {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        fn widened<T: Copy + Into<i64>>(list: &[T]) -> Vec<i64> {
            list.iter().map(|&entry| entry.into()).collect()
        }
        let coordinate = match &value {
            Property::Char(x) => f64::from(*x),
            Property::UChar(x) => f64::from(*x),
            Property::Short(x) => f64::from(*x),
            Property::UShort(x) => f64::from(*x),
            Property::Int(x) => f64::from(*x),
            Property::UInt(x) => f64::from(*x),
            Property::Float(x) => f64::from(*x),
            Property::Double(x) => *x,
            list => {
                if CORNERS.contains(&name) {
                    self.corners = match list {
                        Property::ListChar(list) => widened(list),
                        Property::ListUChar(list) => widened(list),
                        Property::ListShort(list) => widened(list),
                        Property::ListUShort(list) => widened(list),
                        Property::ListInt(list) => widened(list),
                        Property::ListUInt(list) => widened(list),
                        _ => return PropertyAccessResult::UnsupportedType,
                    };
                    return PropertyAccessResult::Set;
                }
                return PropertyAccessResult::Ignored;
            }
        };
        match AXES.iter().position(|axis| *axis == name) {
            Some(axis) => {
                self.position[axis] = coordinate;
                PropertyAccessResult::Set
            }
            None => PropertyAccessResult::Ignored,
        }
    }
}
