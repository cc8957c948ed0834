//! Worked numbers of points and vectors.

use super::Computed;
use crate::affine::point_seen_from;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[("twice_a_point", twice_a_point)];

/// What readers with different origins find for “2 · P”, and for a translation of P, on the number line.
fn twice_a_point() -> String {
    let whole = <BigRational as Scalar>::from_integer;
    let point = whole(2);
    let mut table = String::from(
        "| origin | $P - O$ | $2\\,(P - O)$ | “twice” the point $P = 2$ |\n|--:|--:|--:|--:|\n",
    );
    for origin in [0, 1, 2, 5].map(whole) {
        let way = point.clone() - origin.clone();
        let double = point_seen_from(&origin, &[(whole(2), point.clone())]);
        let cells = [origin, way.clone(), way * whole(2), double]
            .map(|number| format!("${}$", tex::fraction(&number)));
        table += &format!("| {} |\n", cells.join(" | "));
    }
    table
}
