//! Laws of lines and hyperplanes that meet a curve.

use super::super::magnitude;
use crate::affine::{Hyperplane, Orient, Point, Turn};
use crate::bezier::{BezierCurve, LineIntersections, RootKind, sign_changes};
use crate::law::{Rounding, Sides, gamma};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-line-intersections`: a curve of degree n that is not in a line meets it at most n times,
/// at the roots of ⟨b(u), m⟩ − c.
///
/// `implementation(curve, line)` must give every intersection in the domain.
/// `planted` are intersections with their multiplicities that whoever built the curve knows; `all`
/// says that there are no others.
///
/// # Rounding
///
/// None: the intervals must contain the planted parameters. Choose input whose line function is computed without rounding.
pub fn line_intersections<T: OrderedScalar, const D: usize>(
    implementation: impl Fn(&BezierCurve<Point<T, D>>, &Hyperplane<T, D>) -> LineIntersections<T>,
    curve: &BezierCurve<Point<T, D>>,
    line: &Hyperplane<T, D>,
    planted: &[(T, usize)],
) -> Sides<T> {
    let count = |n: usize| T::from_integer(n as i64);
    let sides = Sides::new(format!("{line:?}, {curve}, planted {planted:?}"));
    let values = curve.control_points().iter().map(|b| line.value(b));
    let found = implementation(curve, line);
    let LineIntersections::Parameters(roots) = &found else {
        return sides.equal(
            "the curve lies in the line, so its control points do",
            values,
            vec![T::zero(); curve.degree() + 1],
            Rounding::none(),
        );
    };
    let multiplicity = |kind: RootKind| match kind {
        RootKind::Exactly(multiplicity) => multiplicity,
        RootKind::Odd => 1,
        RootKind::Possible => 0,
    };
    let certain: usize = roots.iter().map(|root| multiplicity(root.kind)).sum();
    let in_all: usize = planted.iter().map(|(_, multiplicity)| multiplicity).sum();
    let missed = |(parameter, _): &&(T, usize)| !roots.iter().any(|root| root.contains(parameter));
    let isolated = roots.windows(2).filter(|pair| pair[0].high > pair[1].low);
    let sides = sides
        .equal(
            "no planted intersection is missed",
            [count(planted.iter().filter(missed).count())],
            [T::zero()],
            Rounding::none(),
        )
        .equal(
            "the intervals are in order and do not overlap",
            [count(isolated.count())],
            [T::zero()],
            Rounding::none(),
        )
        .at_most(
            "there are at most n, and no more certain ones than planted",
            [count(certain), count(certain)],
            [count(curve.degree()), count(in_all)],
            Rounding::none(),
        );
    if T::EXACT {
        sides.equal(
            "over exact numbers all multiplicities are found",
            roots.iter().map(|root| count(multiplicity(root.kind))),
            planted.iter().map(|(_, multiplicity)| count(*multiplicity)),
            Rounding::none(),
        )
    } else {
        sides
    }
}

/// `bezier-variation-diminishing`: along the curve ⟨b(u), m⟩ − c changes its sign at most as often as
/// along the control polygon.
///
/// `implementation(curve, u)` must give the point at u. `parameters` are increasing parameters of the
/// domain; the sign changes from one to the next are counted.
///
/// # Rounding
///
/// Rounding is monotone, so local parameters stay in [0, 1] and in order.
/// A value on the curve passes 3n roundings for the point and D + 1 for the line; if it is not larger
/// than their effect it does not count. A value at a control point passes
/// D + 1; if it is not larger, it counts as whatever sign gives more changes.
/// The rest is counting.
pub fn variation_diminishing<T: OrderedScalar, const D: usize>(
    implementation: impl Fn(&BezierCurve<Point<T, D>>, T) -> Point<T, D>,
    curve: &BezierCurve<Point<T, D>>,
    hyperplane: &Hyperplane<T, D>,
    parameters: &[T],
) -> Sides<T> {
    let normal = hyperplane
        .normal()
        .iter()
        .map(Scalar::magnitude)
        .sum::<f64>();
    let size = parameters
        .iter()
        .map(|u| magnitude(curve, u))
        .fold(0.0, f64::max);
    let terms = normal * size + hyperplane.offset().magnitude();
    let threshold = |roundings: usize| {
        if T::EXACT {
            0.0
        } else {
            gamma(roundings) * terms + roundings as f64 * f64::MIN_POSITIVE
        }
    };
    let on_curve: Vec<T> = parameters
        .iter()
        .map(|u| hyperplane.value(&implementation(curve, u.clone())))
        .filter(|value| value.magnitude() > threshold(3 * curve.degree() + D + 1))
        .collect();
    let on_polygon: Vec<T> = curve
        .control_points()
        .iter()
        .map(|point| hyperplane.value(point))
        .collect();
    let changes = |n: usize| T::from_integer(n as i64);
    Sides::new(format!("{hyperplane:?}, {curve}")).at_most(
        "the curve crosses at most as often as its polygon",
        [changes(sign_changes(&on_curve))],
        [changes(most_sign_changes(&on_polygon, threshold(D + 1)))],
        Rounding::none(),
    )
}

/// The sign changes, where a number that is not larger than `threshold` takes the sign that gives most.
///
/// With threshold 0 zeros do not count.
fn most_sign_changes<T: OrderedScalar>(values: &[T], threshold: f64) -> usize {
    if threshold == 0.0 {
        return sign_changes(values);
    }
    // The most changes of a sequence that ends with +, and of one that ends with −.
    let mut best: [Option<usize>; 2] = [Some(0), Some(0)];
    for (i, value) in values.iter().enumerate() {
        let uncertain = value.magnitude() <= threshold;
        let may_be = [
            uncertain || *value > T::zero(),
            uncertain || *value < T::zero(),
        ];
        let step = |sign: usize| {
            let stay = best[sign];
            let change = best[1 - sign].map(|count| count + usize::from(i > 0));
            may_be[sign].then(|| stay.max(change)).flatten()
        };
        best = [step(0), step(1)];
    }
    best.into_iter().flatten().max().unwrap_or(0)
}

/// `bezier-variation-diminishing`, its consequence: if any three control points, in order, turn left
/// or are on a line, so do any three points of the curve.
///
/// `implementation(curve, u)` must give the point at u. `parameters` are increasing parameters of the domain.
/// For exact numbers: rounding may turn a straight way to the right.
pub fn convex_polygon_convex_curve<T: Orient>(
    implementation: impl Fn(&BezierCurve<Point<T, 2>>, T) -> Point<T, 2>,
    curve: &BezierCurve<Point<T, 2>>,
    parameters: &[T],
) -> Sides<T> {
    let points: Vec<_> = parameters
        .iter()
        .map(|u| implementation(curve, u.clone()))
        .collect();
    let polygon = right_turns(curve.control_points());
    let on_curve = if polygon == 0 {
        right_turns(&points)
    } else {
        0
    };
    Sides::new(curve).equal(
        "no three points of the curve turn right if no three control points do",
        [T::from_integer(on_curve)],
        [T::zero()],
        Rounding::none(),
    )
}

/// How many triples, in order, turn right.
fn right_turns<T: Orient>(points: &[Point<T, 2>]) -> i64 {
    let mut count = 0;
    for i in 0..points.len() {
        for j in i + 1..points.len() {
            for k in j + 1..points.len() {
                count += i64::from(T::turn(&points[i], &points[j], &points[k]) == Turn::Right);
            }
        }
    }
    count
}
