//! Figures of the section on affine maps.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
