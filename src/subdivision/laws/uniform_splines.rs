//! Laws of uniform splines and their subdivision.

use crate::affine::{Affine, Linear};
use crate::bezier::BezierCurve;
use crate::bezier::bounds::maximum_norm;
use crate::bezier::laws::{flat, largest_coordinate};
use crate::bezier::subdivision::dyadic;
use crate::bspline::{UniformSpline, uniform_b_spline};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};
use crate::subdivision::ControlPolygon;

/// By how much the refinement of a spline by blossoms can enlarge numbers, while a point passes at most 8n roundings.
///
/// The arguments are less than n/2 + 2 away from the start of the segment, so a weight of step r, with the
/// denominator n + 1 − r, is at most w = (3n/2 + 2)/(n + 1 − r), and both weights sum to at most 2w + 1 in absolute value.
/// A weight passes 2 roundings, its complement one more, product and sum 2: at most 8 for both terms of a step.
fn blossom_growth(degree: usize) -> f64 {
    let reach = 1.5 * degree as f64 + 2.0;
    (1..=degree)
        .map(|denominator| 2.0 * reach / denominator as f64 + 1.0)
        .product()
}

/// The point Pᵢ of a spline, cyclically if it is periodic.
fn control_point<P: Affine>(spline: &UniformSpline<P>, i: i64) -> Option<&P> {
    let points = spline.control_points();
    let index = if spline.is_periodic() {
        i.rem_euclid(points.len() as i64)
    } else {
        i
    };
    usize::try_from(index).ok().and_then(|i| points.get(i))
}

/// `subdivision-uniform-splines`: control points are blossom values of every segment near by, the spline is Σ Pᵢ·Nⁿ(u − i),
/// and halving the knot intervals changes nothing but the control points.
///
/// `segment(spline, j)` must give segment number j as a Bézier curve over its parameter interval, `refine(spline)` the
/// same spline with twice as many knots. The spline has the knots ℤ, and 0 ≤ t < 1 is the place in segment j.
/// The B-splines on the right are computed by their recurrence.
///
/// # Rounding
///
/// Let M = max|Pᵢ|. A Bézier point passes at most 8n roundings. The blossom of the segment is asked at local arguments
/// between 1 − n and n, which enlarges by at most (2n − 1)ⁿ, with 9n roundings.
/// Values: 3n for de Casteljau; 5n for the recurrence, n + 2 for products and sum; 8n for de Boor after a refinement
/// that passes what is derived at `blossom_growth`. All parameters are exact.
pub fn uniform_splines<P: Affine<Scalar: OrderedScalar>>(
    segment: impl Fn(&UniformSpline<P>, usize) -> BezierCurve<P>,
    refine: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    spline: &UniformSpline<P>,
    index: usize,
    t: P::Scalar,
) -> Sides<P::Scalar> {
    let n = spline.degree();
    let piece = segment(spline, index);
    let largest = largest_coordinate(spline.control_points());
    let u = piece.domain().global(t.clone());
    let mut sides = Sides::new(format!("segment {index}, t = {t}, {spline:?}"));
    for l in 0..=n {
        // Pᵢ with i = index + l; counted from the start of the segment its knots are l − n + 1 … l.
        let knots: Vec<P::Scalar> = (1..=n)
            .map(|r| {
                let distance = P::Scalar::from_integer((l + r) as i64 - n as i64);
                piece.domain().start() + spline.knot_distance() * distance
            })
            .collect();
        let value = piece.blossom().at(&knots).ok();
        sides = sides.equal(
            format!("control point {l} of the segment is a value of its blossom"),
            flat(value.as_ref()),
            flat(control_point(spline, (index + l) as i64)),
            Rounding::new(17 * n, largest * (2.0 * n as f64 + 1.0).powi(n as i32)),
        );
    }
    let mut sum = vec![P::Scalar::from_integer(0); P::DIMENSION];
    for l in 0..=n {
        let weight = uniform_b_spline(n, t.clone() + P::Scalar::from_integer((n - l) as i64));
        let point = control_point(spline, (index + l) as i64);
        for (total, coordinate) in sum.iter_mut().zip(flat(point)) {
            *total += weight.clone() * coordinate;
        }
    }
    let refined = refine(spline);
    let after = refined.at(u.clone()).ok();
    sides
        .equal(
            "the spline is the sum of its control points with B-splines as weights",
            piece.at(u).coordinates().to_vec(),
            sum.clone(),
            Rounding::new(17 * n + 4, largest),
        )
        .equal(
            "the refined spline is the same curve",
            flat(after.as_ref()),
            sum,
            Rounding::new(22 * n + 4, blossom_growth(n) * largest),
        )
        .equal(
            "its knots are half as far apart",
            [refined.knot_distance() * P::Scalar::from_integer(2)],
            [spline.knot_distance()],
            Rounding::none(),
        )
}

/// The new control points of degree n by given weights: those of P̃ᵢ in `even`, those of P̃ᵢ₊₁⸝₂ in `odd`.
///
/// Each weight is (offset from i, numerator, denominator). An open spline has the new points P̃ᵢ, i = n/2 … m + 1/2.
fn by_stencils<P: Affine>(
    spline: &UniformSpline<P>,
    even: &[(i64, i64, i64)],
    odd: &[(i64, i64, i64)],
) -> Vec<P::Scalar> {
    let n = spline.degree() as i64;
    let count = spline.control_points().len() as i64;
    let new = if spline.is_periodic() {
        n..2 * count + n
    } else {
        n..2 * count
    };
    new.flat_map(|twice_i| {
        let stencil = if twice_i.rem_euclid(2) == 0 {
            even
        } else {
            odd
        };
        let mut sum = vec![P::Scalar::from_integer(0); P::DIMENSION];
        for &(offset, numerator, denominator) in stencil {
            let point = control_point(spline, twice_i.div_euclid(2) + offset);
            let weight = P::Scalar::from_ratio(numerator, denominator);
            for (total, coordinate) in sum.iter_mut().zip(flat(point)) {
                *total += weight.clone() * coordinate;
            }
        }
        sum
    })
    .collect()
}

/// Compares the control points of a refined spline with the rule of its degree.
///
/// The sum of at most 3 products passes 4 roundings, its weights are positive and sum to one.
fn follows_stencils<P: Affine>(
    refine: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    spline: &UniformSpline<P>,
    even: &[(i64, i64, i64)],
    odd: &[(i64, i64, i64)],
) -> Sides<P::Scalar> {
    let n = spline.degree();
    let magnitude = largest_coordinate(spline.control_points());
    Sides::new(format!("{spline:?}")).equal(
        format!("the rule of degree {n}"),
        flat(refine(spline).control_points()),
        by_stencils(spline, even, odd),
        Rounding::new(8 * n + 4, blossom_growth(n) * magnitude),
    )
}

/// `subdivision-uniform-degree-zero-one`: P̃ᵢ⁰ = P̃ᵢ₊₁⸝₂⁰ = Pᵢ⁰, and P̃ᵢ¹ = (Pᵢ₋₁¹ + Pᵢ¹)/2, P̃ᵢ₊₁⸝₂¹ = Pᵢ¹.
///
/// `implementation(spline)` must give the same spline with twice as many knots; its degree is 0 or 1.
///
/// # Rounding
///
/// As for [`uniform_splines`].
pub fn uniform_degree_zero_one<P: Affine>(
    implementation: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    spline: &UniformSpline<P>,
) -> Sides<P::Scalar> {
    if spline.degree() == 0 {
        follows_stencils(implementation, spline, &[(0, 1, 1)], &[(0, 1, 1)])
    } else {
        follows_stencils(
            implementation,
            spline,
            &[(-1, 1, 2), (0, 1, 2)],
            &[(0, 1, 1)],
        )
    }
}

/// `subdivision-uniform-degree-two`: P̃ᵢ² = (3Pᵢ₋₁² + Pᵢ²)/4, P̃ᵢ₊₁⸝₂² = (Pᵢ₋₁² + 3Pᵢ²)/4.
///
/// `implementation(spline)` must give the same spline with twice as many knots; its degree is 2.
///
/// # Rounding
///
/// As for [`uniform_splines`].
pub fn uniform_degree_two<P: Affine>(
    implementation: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    spline: &UniformSpline<P>,
) -> Sides<P::Scalar> {
    let (even, odd) = ([(-1, 3, 4), (0, 1, 4)], [(-1, 1, 4), (0, 3, 4)]);
    follows_stencils(implementation, spline, &even, &odd)
}

/// `subdivision-uniform-degree-three`: P̃ᵢ³ = (Pᵢ₋₂³ + 6Pᵢ₋₁³ + Pᵢ³)/8, P̃ᵢ₊₁⸝₂³ = (Pᵢ₋₁³ + Pᵢ³)/2.
///
/// `implementation(spline)` must give the same spline with twice as many knots; its degree is 3.
///
/// # Rounding
///
/// As for [`uniform_splines`].
pub fn uniform_degree_three<P: Affine>(
    implementation: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    spline: &UniformSpline<P>,
) -> Sides<P::Scalar> {
    let (even, odd) = ([(-2, 1, 8), (-1, 6, 8), (0, 1, 8)], [(-1, 1, 2), (0, 1, 2)]);
    follows_stencils(implementation, spline, &even, &odd)
}

/// `subdivision-midpoint-relation`: the new points of degree n + 1 are the midpoints of those of degree n.
///
/// `implementation(spline)` must give the same spline with twice as many knots.
/// It is asked for the splines of degree n and n + 1 with the vertices of the polygon as control points;
/// an open polygon has n + 2 vertices or more.
///
/// # Rounding
///
/// As for [`uniform_splines`], on both sides; a midpoint passes one rounding.
pub fn midpoint_relation<P: Affine>(
    implementation: impl Fn(&UniformSpline<P>) -> UniformSpline<P>,
    polygon: &ControlPolygon<P>,
    degree: usize,
) -> Sides<P::Scalar> {
    let sides = Sides::new(format!("n = {degree}, {polygon:?}"));
    let new_points = |degree: usize| {
        let spline = polygon.spline(degree).ok()?;
        Some(implementation(&spline).control_points().to_vec())
    };
    let (Some(lower), Some(higher)) = (new_points(degree), new_points(degree + 1)) else {
        return sides;
    };
    let half = P::Scalar::from_ratio(1, 2);
    let next = lower.iter().cycle().skip(1);
    let midpoints: Vec<P> = std::iter::zip(&lower, next)
        .take(if polygon.is_closed() {
            lower.len()
        } else {
            lower.len() - 1
        })
        .map(|(start, end)| start.lerp(end, half.clone()))
        .collect();
    let magnitude = largest_coordinate(polygon.vertices());
    sides.equal(
        "the points of degree n + 1 are midpoints of those of degree n",
        flat(&higher),
        flat(&midpoints),
        Rounding::new(
            8 * (2 * degree + 1) + 1,
            blossom_growth(degree + 1) * magnitude,
        ),
    )
}

/// `subdivision-lane-riesenfeld-convergence`: the refined polygon belongs to the same spline, and after k steps it is at most
/// n·d/2ᵏ away from it, where d is the longest leg; the spline is Cⁿ⁻¹.
///
/// `implementation(polygon, n)` must be one step with n ≥ 1 averagings. The polygon is closed or has n + 1 vertices.
/// Vertex j of the polygon of step k belongs to the parameter n + (j − (n − 1)/2)/2ᵏ. Each segment is tried at four
/// parameters. Lengths are measured in the maximum norm.
///
/// # Rounding
///
/// A vertex passes kn roundings, a point of a leg 3 more, a value of the spline 8n, a difference one, with terms of
/// twice max|pᵢ|. Blossoms of a segment at the arguments of the next one enlarge by at most 3ⁿ, with 12n roundings
/// after the 8n of the Bézier points.
pub fn lane_riesenfeld_convergence<P: Affine<Scalar: OrderedScalar>>(
    implementation: impl Fn(&ControlPolygon<P>, usize) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
    degree: usize,
    steps: usize,
) -> Sides<P::Scalar> {
    let n = degree;
    let refined = (0..steps).fold(polygon.clone(), |polygon, _| implementation(&polygon, n));
    let sides = Sides::new(format!("n = {n}, {steps} steps, {polygon:?}"));
    let magnitude = 2.0 * largest_coordinate(polygon.vertices());
    let rounding = Rounding::new(n * steps + 16 * n + 6, magnitude);
    let (Ok(spline), Ok(fine)) = (polygon.spline(n), refined.spline(n)) else {
        return sides.equal(
            "both polygons have splines",
            [],
            [P::Scalar::from_integer(1)],
            rounding,
        );
    };
    let length_of = |polygon: &ControlPolygon<P>| {
        polygon
            .legs()
            .map(|(start, end)| maximum_norm(&end.difference(start)))
            .collect::<Vec<_>>()
    };
    let longest = length_of(polygon)
        .into_iter()
        .fold(P::Scalar::from_integer(0), OrderedScalar::max);
    let shortened = longest * dyadic(1, steps);
    let legs = length_of(&refined);

    // Places 0, 1/4, 1/2 and 3/4 of each segment of the fine spline, counted in its knots from the start of the domain.
    let (mut values, mut fine_values, mut distances) = (vec![], vec![], vec![]);
    for quarter in 0..4 * fine.segment_count() as i64 {
        let place = P::Scalar::from_ratio(quarter, 4);
        let u = spline.domain().start() + place.clone() * dyadic(1, steps);
        let (Ok(value), Ok(fine_value)) = (spline.at(u), fine.at(fine.domain().start() + place))
        else {
            continue;
        };
        // On which leg: vertex j is at the place j − (n − 1)/2.
        let along = quarter + 2 * (n as i64 - 1);
        let (start, end) = (refined.vertex(along / 4), refined.vertex(along / 4 + 1));
        if let (Some(start), Some(end)) = (start, end) {
            let on_leg = start.lerp(end, P::Scalar::from_ratio(along % 4, 4));
            distances.push(maximum_norm(&value.difference(&on_leg)));
        }
        values.push(value);
        fine_values.push(fine_value);
    }
    let repeated = |bound: P::Scalar, count: usize| vec![bound; count];
    let far = shortened.clone() * P::Scalar::from_integer(n as i64);
    let (leg_count, distance_count) = (legs.len(), distances.len());
    sides
        .equal(
            "the refined polygon has the same spline",
            flat(&fine_values),
            flat(&values),
            rounding,
        )
        .at_most(
            "a leg is at most d/2ᵏ long",
            legs,
            repeated(shortened, leg_count),
            rounding,
        )
        .at_most(
            "polygon and spline are at most n·d/2ᵏ apart",
            distances,
            repeated(far, distance_count),
            rounding,
        )
        .and(smooth_joints(&spline))
}

/// Neighbouring segments agree in n derivatives at their knot, from order 0: over the second interval, their Bézier points
/// are the same but for the last.
fn smooth_joints<P: Affine<Scalar: OrderedScalar>>(spline: &UniformSpline<P>) -> Sides<P::Scalar> {
    let n = spline.degree();
    let magnitude = largest_coordinate(spline.control_points()) * 3_f64.powi(n as i32);
    let segments: Vec<BezierCurve<P>> = (0..spline.segment_count())
        .map_while(|j| spline.segment(j).ok())
        .collect();
    segments
        .windows(2)
        .enumerate()
        .fold(Sides::new(""), |sides, (j, pair)| {
            let continued = pair[0].blossom().control_points_on(pair[1].domain());
            sides.equal(
                format!("the segments {j} and {} meet with n − 1 derivatives", j + 1),
                flat(&continued[..n]),
                flat(&pair[1].control_points()[..n]),
                Rounding::new(28 * n, magnitude),
            )
        })
}

/// `subdivision-cubic-curve`: the cubic scheme halves the knot intervals of a cubic spline, and a vertex pᵢ has the limit
/// (pᵢ₋₁ + 4pᵢ + pᵢ₊₁)/6 with the derivative (pᵢ₊₁ − pᵢ₋₁)/2.
///
/// `implementation(polygon)` must be one step of the cubic scheme; the polygon is closed or has four vertices.
///
/// # Rounding
///
/// A new vertex passes 5 roundings, the refined spline what is derived at [`uniform_splines`], its values and
/// derivatives 24 more; a limit position of a refined polygon 5 more. The derivative has terms of twice max|pᵢ|.
pub fn cubic_curve<P: Affine<Scalar: OrderedScalar>>(
    implementation: impl Fn(&ControlPolygon<P>) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
) -> Sides<P::Scalar> {
    let sides = Sides::new(format!("{polygon:?}"));
    let new = implementation(polygon);
    let magnitude = 2.0 * largest_coordinate(polygon.vertices());
    let Ok(spline) = polygon.spline(3) else {
        return sides;
    };
    let Ok(derivative) = spline.derivative() else {
        return sides;
    };
    let limit = |polygon: &ControlPolygon<P>, i: i64| {
        let (before, here, after) = (
            polygon.vertex(i - 1)?,
            polygon.vertex(i)?,
            polygon.vertex(i + 1)?,
        );
        Some(P::from_fn(|k| {
            let coordinate = |point: &P| point.coordinates()[k].clone();
            (coordinate(before) + P::Scalar::from_integer(4) * coordinate(here) + coordinate(after))
                / P::Scalar::from_integer(6)
        }))
    };
    let half = P::Scalar::from_ratio(1, 2);
    let (mut limits, mut chords, mut new_limits, mut points, mut tangents) =
        (vec![], vec![], vec![], vec![], vec![]);
    for i in 1..=polygon.vertices().len() as i64 {
        // The vertex i belongs to the knot number i − 1 of the domain.
        let knot = spline.domain().start() + P::Scalar::from_integer(i - 1);
        let (Some(position), Ok(point), Ok(tangent)) = (
            limit(polygon, i),
            spline.at(knot.clone()),
            derivative.at(knot),
        ) else {
            continue;
        };
        let (Some(before), Some(after)) = (polygon.vertex(i - 1), polygon.vertex(i + 1)) else {
            continue;
        };
        chords.push(after.difference(before).scaled(half.clone()));
        // Its vertex point is number 2i − 1 of the refined polygon.
        new_limits.extend(limit(&new, 2 * i - 1));
        limits.push(position);
        points.push(point);
        tangents.push(tangent);
    }
    let rounding = Rounding::new(40, magnitude);
    sides
        .equal(
            "the new polygon is that of the refined spline",
            flat(new.vertices()),
            flat(spline.refined().control_points()),
            Rounding::new(30, blossom_growth(3) * magnitude),
        )
        .equal(
            "the limit of a vertex",
            flat(&limits),
            flat(&points),
            rounding,
        )
        .equal(
            "the derivative there",
            flat(&chords),
            flat(&tangents),
            rounding,
        )
        .equal(
            "the vertex point has the same limit",
            flat(&new_limits),
            flat(&limits),
            rounding,
        )
}
