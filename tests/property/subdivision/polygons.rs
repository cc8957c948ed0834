//! Random open and closed polygons, and splines over them.

use cagd::affine::Point;
use cagd::bspline::UniformSpline;
use cagd::law::{Rounding, Sides};
use cagd::subdivision::{Closing, ControlPolygon};
use proptest::prelude::*;

use crate::generators::{for_all, polygon};

/// The highest degree of a random spline.
pub const MAX_DEGREE: usize = 5;

/// A polygon of the plane.
pub type PlanePolygon = ControlPolygon<Point<f64, 2>>;

/// A uniform spline curve of the plane.
pub type PlaneSpline = UniformSpline<Point<f64, 2>>;

/// Open polygons with `open` vertices or more, and closed ones with `closed` or more, up to ten; degenerate ones too.
pub fn polygons(open: usize, closed: usize) -> impl Strategy<Value = PlanePolygon> {
    (
        polygon(),
        prop_oneof![Just(Closing::Open), Just(Closing::Closed)],
    )
        .prop_filter_map("too few vertices", move |(vertices, closing)| {
            let needed = match closing {
                Closing::Open => open,
                Closing::Closed => closed,
            };
            let enough = vertices.len() >= needed;
            enough.then(|| ControlPolygon::new(vertices, closing).expect("finite vertices"))
        })
}

/// Splines of this degree over the knots ℤ, open and periodic.
pub fn splines(degree: usize) -> impl Strategy<Value = PlaneSpline> {
    polygons(degree + 1, 1)
        .prop_map(move |polygon| polygon.spline(degree).expect("enough vertices"))
}

#[test]
fn every_class_of_polygon_occurs() {
    use std::cell::RefCell;
    use std::collections::BTreeMap;

    let counts = RefCell::new(BTreeMap::new());
    let outcome = for_all(polygons(2, 1), |polygon| {
        let vertices = polygon.vertices();
        let classes = [
            ("open", !polygon.is_closed()),
            (
                "open, shortest",
                !polygon.is_closed() && vertices.len() == 2,
            ),
            ("closed", polygon.is_closed()),
            (
                "closed, one vertex",
                polygon.is_closed() && vertices.len() == 1,
            ),
            (
                "closed, two vertices",
                polygon.is_closed() && vertices.len() == 2,
            ),
            ("ten vertices", vertices.len() == 10),
            (
                "a leg of length 0",
                polygon.legs().any(|(start, end)| start == end),
            ),
        ];
        for (class, occurs) in classes {
            *counts.borrow_mut().entry(class).or_insert(0) += i32::from(occurs);
        }
        Sides::new("statistics").equal("always", [0.0], [0.0], Rounding::none())
    });
    assert_eq!(outcome, Ok(()));
    for (class, count) in counts.into_inner() {
        assert!(count >= 2, "{count} inputs of the class «{class}»");
    }
}
