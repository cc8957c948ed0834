//! Laws of areas.

use super::magnitudes::largest;
use crate::affine::{
    BoundingBox, LatticeCount, LatticePoint, LatticePolygon, MonteCarloEstimate, Orient, Point,
    Turn,
};
use crate::law::{Rounding, Sides, gamma};
use crate::scalar::Scalar;

/// `affine-triangle-area-determinant`: the signed area \[R P Q\] is half the determinant with the rows (1, R), (1, P), (1, Q);
/// its sign is the orientation; it changes the sign if two corners are exchanged.
///
/// `implementation(R, P, Q)` must give the signed area.
///
/// # Rounding
///
/// The signed area passes 4 roundings, its terms are at most 4·s², s the largest coordinate; the determinant of three rows, written out,
/// passes 7, and its six terms are at most s². Where the area is within the bound, its sign says nothing.
pub fn triangle_area_determinant<T: Orient>(
    implementation: impl Fn(&Point<T, 2>, &Point<T, 2>, &Point<T, 2>) -> T,
    r: &Point<T, 2>,
    p: &Point<T, 2>,
    q: &Point<T, 2>,
) -> Sides<T> {
    let size = largest([r, p, q].into_iter().flat_map(Point::coordinates));
    let terms = 8.0 * size * size;
    let rounding = Rounding::new(12, terms);
    let area = implementation(r, p, q);
    let minor = |a: &Point<T, 2>, b: &Point<T, 2>| {
        a[0].clone() * b[1].clone() - a[1].clone() * b[0].clone()
    };
    let rows = minor(p, q) - minor(r, q) + minor(r, p);
    let turn = match T::turn(r, p, q) {
        Turn::Left => 1,
        Turn::Straight => 0,
        Turn::Right => -1,
    };
    let unclear = !T::EXACT && area.magnitude() <= gamma(4) * terms + 4.0 * f64::MIN_POSITIVE;
    let sign = if unclear {
        turn
    } else {
        i64::from(area > T::zero()) - i64::from(area < T::zero())
    };
    Sides::new(format!("R = {r}, P = {p}, Q = {q}"))
        .equal(
            "the area is half the determinant of the rows (1, x, y)",
            [area.clone()],
            [rows * T::from_ratio(1, 2)],
            rounding,
        )
        .equal(
            "two corners exchanged change the sign",
            [
                implementation(r, q, p),
                implementation(p, r, q),
                implementation(q, p, r),
            ],
            vec![-area.clone(); 3],
            rounding,
        )
        .equal(
            "the sign is the orientation",
            [T::from_integer(sign)],
            [T::from_integer(turn)],
            Rounding::none(),
        )
}

/// `affine-pick-theorem`: area(P) = I + R/2 − 1.
///
/// `implementation(P)` must count the lattice points inside and on the boundary.
///
/// # Rounding
///
/// None: all numbers are halves of whole numbers below 2⁵³.
pub fn pick_theorem<T: Scalar>(
    implementation: impl Fn(&LatticePolygon) -> LatticeCount,
    polygon: &LatticePolygon,
) -> Sides<T> {
    let count = implementation(polygon);
    Sides::new(format!("vertices {:?}, {count:?}", polygon.vertices())).equal(
        "the area is I + R/2 − 1",
        [polygon.area::<T>()],
        [count.pick_area()],
        Rounding::none(),
    )
}

/// `affine-pick-theorem`, its proof: the polygon falls into 2I + R − 2 triangles without further lattice points, each of area 1/2.
///
/// `implementation(P)` must give the triangles.
///
/// # Rounding
///
/// None, see [`pick_theorem`].
pub fn primitive_triangles<T: Scalar>(
    implementation: impl Fn(&LatticePolygon) -> Vec<[LatticePoint; 3]>,
    polygon: &LatticePolygon,
) -> Sides<T> {
    let triangles = implementation(polygon);
    let count = polygon.count();
    let twice = |[p, q, r]: &[LatticePoint; 3]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let number = |n: usize| T::from_integer(n as i64);
    Sides::new(format!("vertices {:?}", polygon.vertices()))
        .equal(
            "each triangle has the area 1/2",
            triangles
                .iter()
                .map(|triangle| T::from_ratio(twice(triangle).abs(), 2)),
            vec![T::from_ratio(1, 2); triangles.len()],
            Rounding::none(),
        )
        .equal(
            "there are 2I + R − 2 of them",
            [number(triangles.len())],
            [number(2 * count.interior + count.boundary) - number(2)],
            Rounding::none(),
        )
        .equal(
            "together they have the area of the polygon",
            [number(triangles.len()) * T::from_ratio(1, 2)],
            [polygon.area()],
            Rounding::none(),
        )
}

/// `affine-figure-pick`: the triangle (0, 0), (2, 1), (1, 3) has I = 2, R = 3 and the area 5/2.
///
/// `implementation(P)` must count the lattice points inside and on the boundary.
///
/// # Rounding
///
/// None, see [`pick_theorem`].
pub fn figure_pick<T: Scalar>(
    implementation: impl Fn(&LatticePolygon) -> LatticeCount,
    triangle: &LatticePolygon,
) -> Sides<T> {
    let count = implementation(triangle);
    let number = |n: usize| T::from_integer(n as i64);
    Sides::new(format!("vertices {:?}", triangle.vertices()))
        .equal(
            "two points inside and three on the boundary",
            [number(count.interior), number(count.boundary)],
            [number(2), number(3)],
            Rounding::none(),
        )
        .equal(
            "the area is 5/2, by the determinant and by the count",
            [triangle.area::<T>(), count.pick_area()],
            vec![T::from_ratio(5, 2); 2],
            Rounding::none(),
        )
}

/// `affine-monte-carlo-area`: |M| ≈ |Q|·h/N, with the standard error |Q|·√(p(1 − p)/N).
///
/// `implementation(Q, N, seed, contains)` must give the estimate; `area` is the true area of the set.
///
/// With a probability of at least 1 − 10⁻¹² the error is at most |Q|·√(ln(2·10¹²)/(2N)), whatever the set is (`hoeffding1963`,
/// theorem 1). The seeds of a test are fixed: it fails always or never, and would fail once in 10¹² choices of seeds.
///
/// # Rounding
///
/// The estimate passes D + 1 roundings, its standard error 4 more and a root.
pub fn monte_carlo_area<const D: usize>(
    implementation: impl Fn(
        &BoundingBox<Point<f64, D>>,
        usize,
        u64,
        &dyn Fn(&Point<f64, D>) -> bool,
    ) -> MonteCarloEstimate,
    bounds: &BoundingBox<Point<f64, D>>,
    (samples, seed): (usize, u64),
    contains: &dyn Fn(&Point<f64, D>) -> bool,
    area: f64,
) -> Sides<f64> {
    let estimate = implementation(bounds, samples, seed, contains);
    let count = samples as f64;
    let whole: f64 = bounds.size().iter().product();
    let share = estimate.hits as f64 / count;
    let allowed = whole * libm::sqrt(libm::log(2.0e12) / (2.0 * count));
    let rounding = Rounding::new(D + 8, 2.0 * whole);
    // In units of the box, whose square might be beyond the range of `f64`.
    let relative_error = estimate.standard_error() / whole;
    Sides::new(format!(
        "N = {samples}, seed {seed}, box {bounds:?}, area {area}"
    ))
    .equal(
        "all N points were drawn",
        [estimate.samples as f64],
        [count],
        Rounding::none(),
    )
    .equal(
        "the estimate is |Q|·h/N",
        [estimate.area()],
        [whole * share],
        rounding,
    )
    .at_most(
        "the estimate is near the area",
        [(estimate.area() - area).abs()],
        [allowed],
        rounding,
    )
    .equal(
        "the standard error, in boxes, squared is q(1 − q)/N with q = h/N",
        [relative_error * relative_error * count],
        [share * (1.0 - share)],
        Rounding::new(2 * (D + 8), 1.0),
    )
}
