//! Figures of the section on convexity.

use crate::figure::Figure;

pub(super) fn all() -> Vec<Figure> {
    vec![]
}
