//! Wrong segments and refinements of uniform splines.

use cagd::affine::{Affine, Interval};
use cagd::bezier::BezierCurve;
use cagd::bspline::UniformSpline;
use cagd::scalar::Scalar;
use cagd::subdivision::ControlPolygon;

/// The right segment; the type that the laws ask for.
pub fn segment<P: Affine>(spline: &UniformSpline<P>, index: usize) -> BezierCurve<P> {
    spline.segment(index).expect("a segment of the spline")
}

/// Takes the control points of the spline for Bézier points.
pub fn control_points_as_bezier_points<P: Affine>(
    spline: &UniformSpline<P>,
    index: usize,
) -> BezierCurve<P> {
    let points = spline.control_points().iter().cycle().skip(index);
    let domain = segment(spline, index).domain().clone();
    BezierCurve::on(domain, points.take(spline.degree() + 1).cloned()).expect("finite points")
}

/// Gives the next segment, or the first one behind the last.
pub fn next_segment<P: Affine>(spline: &UniformSpline<P>, index: usize) -> BezierCurve<P> {
    let next = segment(spline, (index + 1) % spline.segment_count());
    next.reparametrised(segment(spline, index).domain().clone())
}

/// Takes every segment over [0, 1].
pub fn on_unit_interval<P: Affine>(spline: &UniformSpline<P>, index: usize) -> BezierCurve<P> {
    segment(spline, index).reparametrised(Interval::unit())
}

/// A spline of the same degree, closed or open, with the new points on the knots of the refined one.
fn with_points<P: Affine>(spline: &UniformSpline<P>, points: Vec<P>) -> UniformSpline<P> {
    let like = if spline.is_periodic() {
        UniformSpline::periodic(spline.degree(), points)
    } else {
        UniformSpline::new(spline.degree(), points)
    };
    like.expect("enough control points")
}

/// Halves the knot intervals but leaves the control points as they are.
pub fn not_refined<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    spline.clone()
}

/// Inserts midpoints between the control points, whatever the degree.
pub fn midpoints_inserted<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    averaged(spline, 1)
}

/// Doubles every control point, whatever the degree.
pub fn only_doubled<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    averaged(spline, 0)
}

/// Averages once more than the degree says, as the class notes do in their last summary.
pub fn averaged_once_more<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    averaged(spline, spline.degree() + 1)
}

/// Doubling and `rounds` averagings, with points repeated where too few are left.
fn averaged<P: Affine>(spline: &UniformSpline<P>, rounds: usize) -> UniformSpline<P> {
    let points = spline.control_points().to_vec();
    let polygon = if spline.is_periodic() {
        ControlPolygon::closed(points)
    } else {
        ControlPolygon::open(points)
    };
    let polygon = polygon.expect("finite points");
    let refined = polygon.lane_riesenfeld(rounds).unwrap_or(polygon);
    let mut points = refined.vertices().to_vec();
    while points.len() < spline.degree() + 1 {
        points.push(points[0].clone());
    }
    with_points(spline, points)
}

/// Takes sums in the place of means, as the class notes print the rule of degree 1.
pub fn without_one_half<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    let mut points = spline.refined().control_points().to_vec();
    for point in points.iter_mut().skip(1).step_by(2) {
        *point = P::from_fn(|k| point.coordinates()[k].clone() * P::Scalar::from_integer(2));
    }
    with_points(spline, points)
}

/// Takes the points in the opposite order.
pub fn reversed<P: Affine>(spline: &UniformSpline<P>) -> UniformSpline<P> {
    let points = spline.refined().control_points().to_vec();
    with_points(spline, points.into_iter().rev().collect())
}

/// The cubic scheme with the weights (1, 4, 1)/6 of the limit for the vertex points.
pub fn limit_weights_in_the_step<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    vertex_points(given, [1, 4, 1], 6)
}

/// The cubic scheme with the weights (1, 2, 1)/4 for the vertex points.
pub fn quarter_weights<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    vertex_points(given, [1, 2, 1], 4)
}

/// The cubic scheme that leaves the vertices where they are.
pub fn vertices_kept<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    vertex_points(given, [0, 1, 0], 1)
}

fn vertex_points<P: Affine>(
    given: &ControlPolygon<P>,
    weights: [i64; 3],
    sum: i64,
) -> ControlPolygon<P> {
    let mut vertices = given.cubic_step().expect("a leg").vertices().to_vec();
    for j in (1..vertices.len()).step_by(2) {
        let i = (j / 2 + 1) as i64;
        let near = [i - 1, i, i + 1].map(|i| given.vertex(i).expect("inside").clone());
        vertices[j] = P::from_fn(|k| {
            std::iter::zip(&near, weights).fold(P::Scalar::from_integer(0), |total, (p, weight)| {
                total + p.coordinates()[k].clone() * P::Scalar::from_ratio(weight, sum)
            })
        });
    }
    ControlPolygon::new(vertices, given.closing()).expect("finite vertices")
}
