//! Figures of the section on points and vectors.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
