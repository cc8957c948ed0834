//! Worked numbers of affine maps.

use super::Computed;
use crate::affine::{AffineMap, Line, Point, Vector};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[("map_examples", map_examples)];

type Map = AffineMap<BigRational, 2, 2>;

/// What each of the named maps of the plane keeps.
fn map_examples() -> String {
    let whole = |n: i64| <BigRational as Scalar>::from_integer(n);
    let pair = |x: i64, y: i64| [x, y].map(whole);
    let axis = Line::new(pair(0, 1), whole(0)).expect("a normal vector");
    let onto_axis = |along: [BigRational; 2]| {
        Map::parallel_projection(&axis, &Vector::from(along)).expect("a direction that leaves it")
    };
    let maps = [
        ("identity", Map::identity()),
        (
            "translation by $(2, 1)$",
            Map::translating(Vector::from(pair(2, 1))),
        ),
        ("scaling by $2$ and $3$", Map::scaling(pair(2, 3))),
        (
            "homothety with $k = -1$ from $(1, 1)$",
            Map::homothety(&Point::new(pair(1, 1)), whole(-1)),
        ),
        (
            "rotation with $\\cos\\varphi = \\frac35$",
            Map::rational_rotation(BigRational::from_ratio(1, 2)),
        ),
        ("shear with $a = 2$", Map::shear(whole(2))),
        (
            "orthogonal projection onto the first axis",
            onto_axis(pair(0, 1)),
        ),
        ("projection onto it along $(1, -2)$", onto_axis(pair(1, -2))),
    ];
    let says = |holds: bool| if holds { "yes" } else { "no" };
    let mut table = String::from(
        "| map | determinant | affinity | keeps distances | twice is once |\n|---|---|---|---|---|\n",
    );
    for (name, map) in maps {
        table += &format!(
            "| {name} | ${}$ | {} | {} | {} |\n",
            tex::fraction(&map.determinant()),
            says(map.is_affinity()),
            says(map.is_motion()),
            says(map.is_idempotent())
        );
    }
    table
}
