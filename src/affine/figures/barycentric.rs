//! Figures of the section on barycentric coordinates.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
