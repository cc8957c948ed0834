//! Figures of the section on areas.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
