//! Figures of the section on affine combinations.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
