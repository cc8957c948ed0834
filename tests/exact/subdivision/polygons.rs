//! Exact polygons that prove what is linear in the vertices: one vertex 1 and the others 0.

use cagd::bspline::UniformSpline;
use cagd::scalar::BigRational;
use cagd::subdivision::{Closing, ControlPolygon};

use crate::inputs::integer;

/// The highest degree for which the rules are proved.
pub const MAX_DEGREE: usize = 8;

/// A polygon of rational numbers.
pub type Polygon = ControlPolygon<BigRational>;

/// A uniform spline with rational control values.
pub type Spline = UniformSpline<BigRational>;

/// All polygons with `least` to `most` vertices, one of them 1 and the others 0, open and closed.
pub fn unit_polygons(least: usize, most: usize) -> impl Iterator<Item = Polygon> {
    (least..=most).flat_map(|count| {
        (0..count).flat_map(move |one| {
            [Closing::Open, Closing::Closed].map(|closing| {
                let values = (0..count).map(|i| integer(i64::from(i == one)));
                ControlPolygon::new(values, closing).expect("finite vertices")
            })
        })
    })
}

/// All splines of this degree with up to 2n + 2 control values, one of them 1 and the others 0, open and periodic.
///
/// A refined control point depends on at most n + 1 neighbours, so a rule that holds for them holds for all.
pub fn unit_splines(degree: usize) -> impl Iterator<Item = Spline> {
    unit_polygons(degree + 1, 2 * degree + 2)
        .map(move |polygon| polygon.spline(degree).expect("enough vertices"))
}
