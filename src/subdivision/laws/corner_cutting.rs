//! Laws of corner cutting.

use num_traits::One;

use crate::affine::{Affine, Linear};
use crate::bezier::binomial;
use crate::bezier::bounds::maximum_norm;
use crate::bezier::laws::{flat, largest_coordinate};
use crate::bezier::subdivision::dyadic;
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};
use crate::subdivision::{ControlPolygon, SchemeKind};

/// `subdivision-approximating-interpolating`: an interpolating scheme keeps the vertices, an approximating one does not,
/// and both commute with affine maps.
///
/// `implementation(polygon)` must refine a closed polygon by a scheme of the kind `kind`.
/// The map is x ↦ ax + b, on numbers.
///
/// # Rounding
///
/// Four weights or fewer: 5 roundings a refined vertex, 2 for the map, on either side.
/// With weights whose absolute values sum to at most 2, the terms sum to at most 2(|a|·max|pᵢ| + |b|).
pub fn approximating_interpolating<T: Scalar>(
    implementation: impl Fn(&ControlPolygon<T>) -> ControlPolygon<T>,
    kind: SchemeKind,
    polygon: &ControlPolygon<T>,
    [a, b]: [T; 2],
) -> Sides<T> {
    let refined = implementation(polygon);
    let map = |x: &T| a.clone() * x.clone() + b.clone();
    let moved = ControlPolygon::trusted(
        polygon.vertices().iter().map(map).collect(),
        polygon.closing(),
    );
    let magnitude = 2.0 * (a.magnitude() * largest_coordinate(polygon.vertices()) + b.magnitude());
    let found = SchemeKind::of(|probe| Ok(implementation(probe)));
    let is_kind = T::from_integer(i64::from(found == Ok(kind)));
    let mut sides = Sides::new(format!("x ↦ {a}·x + {b}, {polygon:?}"))
        .equal(
            format!("the scheme is {kind:?}"),
            [is_kind],
            [T::one()],
            Rounding::none(),
        )
        .equal(
            "refining commutes with the affine map",
            implementation(&moved).vertices().to_vec(),
            refined.vertices().iter().map(map),
            Rounding::new(14, magnitude),
        );
    if let SchemeKind::Interpolating { first } = kind {
        let new = refined.vertices();
        let kept = (0..polygon.vertices().len()).map(|i| new[(first + 2 * i) % new.len()].clone());
        sides = sides.equal(
            "the old vertices are kept",
            kept,
            polygon.vertices().to_vec(),
            Rounding::none(),
        );
    }
    sides
}

/// `subdivision-chaikin`: cutting at 1/4 and 3/4 is doubling and averaging twice.
///
/// `implementation(polygon)` must be one step of Chaikin's algorithm; the polygon has a leg.
///
/// # Rounding
///
/// Two averagings pass 2 roundings, halves are exact; a weighted mean passes 2: one for the product with 3/4, one for the sum.
pub fn chaikin<P: Affine>(
    implementation: impl Fn(&ControlPolygon<P>) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
) -> Sides<P::Scalar> {
    let cut = implementation(polygon);
    let k = polygon.vertices().len() as i64;
    let expected_count = if polygon.is_closed() {
        2 * k
    } else {
        2 * k - 2
    };
    let averaged = middles(&middles(&polygon.doubled()));
    Sides::new(format!("{polygon:?}"))
        .equal(
            "k vertices become 2k, or 2k − 2 of an open polygon",
            [P::Scalar::from_integer(cut.vertices().len() as i64)],
            [P::Scalar::from_integer(expected_count)],
            Rounding::none(),
        )
        .equal(
            "the cuts are what averaging twice gives",
            flat(cut.vertices()),
            flat(averaged.vertices()),
            Rounding::new(4, largest_coordinate(polygon.vertices())),
        )
}

/// The midpoints of the legs.
fn middles<P: Affine>(polygon: &ControlPolygon<P>) -> ControlPolygon<P> {
    let half = P::Scalar::from_ratio(1, 2);
    let middles = polygon
        .legs()
        .map(|(start, end)| start.lerp(end, half.clone()));
    ControlPolygon::trusted(middles.collect(), polygon.closing())
}

/// What `steps` steps of a scheme make of a polygon.
fn refined<P: Affine>(
    step: impl Fn(&ControlPolygon<P>) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
    steps: usize,
) -> ControlPolygon<P> {
    (0..steps).fold(polygon.clone(), |polygon, _| step(&polygon))
}

/// `subdivision-chaikin-quarter-points`: the middle of every leg stays for ever, the limit touches the leg there,
/// and no vertex leaves the box of its leg.
///
/// `implementation(polygon)` must be one step of Chaikin's algorithm; the polygon has a leg.
/// After any number of steps the leg number 2ˢi has the same middle as the leg i, and is 2ˢ times as short.
/// The limit is the quadratic spline of the polygon, if it has three vertices or is closed.
///
/// # Rounding
///
/// A vertex passes 2 roundings a step, the middle of a leg one more, the vector of a leg one more.
/// The spline passes 16; its derivative, of degree 1, as many and one more for the difference.
pub fn chaikin_quarter_points<P: Affine<Scalar: OrderedScalar>>(
    implementation: impl Fn(&ControlPolygon<P>) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
    steps: usize,
) -> Sides<P::Scalar> {
    let magnitude = 2.0 * largest_coordinate(polygon.vertices());
    let rounding = Rounding::new(2 * steps + 20, magnitude);
    let cut = refined(&implementation, polygon, steps);
    let half = P::Scalar::from_ratio(1, 2);
    let middle = |(start, end): (&P, &P)| start.lerp(end, half.clone());
    let vector = |(start, end): (&P, &P)| end.difference(start);
    let corresponding = || cut.legs().step_by(1 << steps);
    let shorter = |leg: (&P, &P)| vector(leg).scaled(dyadic(1, steps));
    let middles: Vec<P> = polygon.legs().map(middle).collect();
    let mut sides = Sides::new(format!("{steps} steps, {polygon:?}"))
        .equal(
            "the middles of the legs stay",
            flat(&corresponding().map(middle).collect::<Vec<_>>()),
            flat(&middles),
            rounding,
        )
        .equal(
            "their legs are shortened to halves",
            flat(&corresponding().map(vector).collect::<Vec<_>>()),
            flat(&polygon.legs().map(shorter).collect::<Vec<_>>()),
            rounding,
        );
    let once = implementation(polygon);
    for (i, (start, end)) in polygon.legs().enumerate() {
        for cut in once.vertices().iter().skip(2 * i).take(2) {
            let box_of = |choose: fn(P::Scalar, P::Scalar) -> P::Scalar| {
                std::iter::zip(start.coordinates(), end.coordinates())
                    .map(|(a, b)| choose(a.clone(), b.clone()))
                    .collect::<Vec<_>>()
            };
            sides = sides
                .at_most(
                    format!("cut of leg {i} not below its box"),
                    box_of(OrderedScalar::min),
                    cut.coordinates().to_vec(),
                    Rounding::new(2, magnitude),
                )
                .at_most(
                    format!("cut of leg {i} not above its box"),
                    cut.coordinates().to_vec(),
                    box_of(OrderedScalar::max),
                    Rounding::new(2, magnitude),
                );
        }
    }
    let Ok((spline, derivative)) = polygon
        .spline(2)
        .and_then(|spline| Ok((spline.clone(), spline.derivative()?)))
    else {
        return sides;
    };
    let at_knots: Vec<(P, P::Difference)> = (0..middles.len() as i64)
        .map(|i| spline.domain().start() + P::Scalar::from_integer(i))
        .map_while(|knot| Some((spline.at(knot.clone()).ok()?, derivative.at(knot).ok()?)))
        .collect();
    sides
        .equal(
            "the limit passes through the middles",
            flat(at_knots.iter().map(|(point, _)| point)),
            flat(&middles),
            rounding,
        )
        .equal(
            "with the vectors of the legs as derivatives",
            flat(at_knots.iter().map(|(_, vector)| vector)),
            flat(&polygon.legs().map(vector).collect::<Vec<_>>()),
            rounding,
        )
}

/// `subdivision-chaikin-convergence`: after k steps the polygon is as far from the spline as its second differences say,
/// and these are the old ones over 4ᵏ.
///
/// `implementation(polygon)` must be one step of Chaikin's algorithm; the polygon is closed or has three vertices.
/// With vertex j at the parameter 2 + (j − 1/2)/2ᵏ, as far as that is in the domain, the quadratic spline is
///
/// ```text
/// s(u) = q(u) + ((λ − 1/2)²/2)·Δ²,   q(u) = (1 − λ)qⱼ + λqⱼ₊₁,
/// ```
///
/// where Δ² is the second difference at the nearer vertex. All λ in quarters are tried.
///
/// # Rounding
///
/// A vertex passes 2 roundings a step, a point of a leg 3 more, a second difference 3 more; the spline 16.
/// The parameters are exact. The terms sum to at most 4·max|pᵢ|, those of a second difference.
pub fn chaikin_convergence<P: Affine<Scalar: OrderedScalar>>(
    implementation: impl Fn(&ControlPolygon<P>) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
    steps: usize,
) -> Sides<P::Scalar> {
    let rounding = Rounding::new(2 * steps + 24, 4.0 * largest_coordinate(polygon.vertices()));
    let cut = refined(&implementation, polygon, steps);
    let mut sides = Sides::new(format!("{steps} steps, {polygon:?}"));
    let number = |n: usize| [P::Scalar::from_integer(n as i64)];
    let k = polygon.vertices().len();
    let count = if polygon.is_closed() {
        k << steps
    } else {
        ((k - 2) << steps) + 2
    };
    sides = sides.equal(
        "the number of vertices",
        number(cut.vertices().len()),
        number(count),
        Rounding::none(),
    );
    let (Ok(spline), true) = (polygon.spline(2), cut.vertices().len() == count) else {
        return sides;
    };
    // The corner that a vertex has been cut from.
    let corner = |j: usize| (0..steps).fold(j, |j, _| j.div_ceil(2));
    let scale = (0..steps).fold(P::Scalar::one(), |scale, _| {
        scale / P::Scalar::from_integer(4)
    });
    let (new, old): (Vec<_>, Vec<_>) = (0..count)
        .filter_map(|j| {
            let old = second_difference(polygon, corner(j) as i64)?;
            Some((
                second_difference(&cut, j as i64)?,
                old.scaled(scale.clone()),
            ))
        })
        .unzip();
    sides = sides.equal(
        "second differences are quartered",
        flat(&new),
        flat(&old),
        rounding,
    );

    let start = spline.domain().start();
    let length = spline.domain().length();
    let (mut on_spline, mut expected, mut distances) = (vec![], vec![], vec![]);
    for (j, (from, to)) in (0..).zip(cut.legs()) {
        for quarters in 0..=4 {
            let lambda = P::Scalar::from_ratio(quarters, 4);
            let offset = dyadic::<P::Scalar>(1, steps)
                * (P::Scalar::from_ratio(2 * j - 1, 2) + lambda.clone());
            let wrapped = if polygon.is_closed() && offset < P::Scalar::from_integer(0) {
                offset + length.clone()
            } else {
                offset
            };
            let nearer = if quarters <= 2 { j } else { j + 1 };
            let (Ok(point), Some(difference)) = (
                spline.at(start.clone() + wrapped),
                second_difference(&cut, nearer),
            ) else {
                continue;
            };
            let beside = lambda.clone() - P::Scalar::from_ratio(1, 2);
            let weight = beside.clone() * beside / P::Scalar::from_integer(2);
            let on_leg = from.lerp(to, lambda);
            distances.push(maximum_norm(&point.difference(&on_leg)));
            expected.push(on_leg.translated(&difference.scaled(weight)));
            on_spline.push(point);
        }
    }
    let largest = (0..k as i64)
        .filter_map(|i| second_difference(polygon, i))
        .map(|difference| maximum_norm(&difference))
        .fold(P::Scalar::from_integer(0), OrderedScalar::max);
    let bound = largest * scale / P::Scalar::from_integer(8);
    let bounds = vec![bound; distances.len()];
    sides
        .equal(
            "the spline is beside the leg by a multiple of the second difference",
            flat(&on_spline),
            flat(&expected),
            rounding,
        )
        .at_most(
            "the distance is at most max|Δ²|/(8·4ᵏ)",
            distances,
            bounds,
            rounding,
        )
}

/// Δ²pᵢ₋₁ = pᵢ₋₁ − 2pᵢ + pᵢ₊₁, where both neighbours are there.
fn second_difference<P: Affine>(polygon: &ControlPolygon<P>, i: i64) -> Option<P::Difference> {
    let [before, here, after] = [i - 1, i, i + 1].map(|i| polygon.vertex(i));
    let (before, here, after) = (before?, here?, after?);
    Some(after.difference(here).difference(&here.difference(before)))
}

/// `subdivision-lane-riesenfeld`: one step has the mask (1 + z)ⁿ⁺¹/2ⁿ.
///
/// `implementation(polygon, n)` must be one step with n averagings; an open polygon has more than n/2 vertices.
/// Vertex j is compared with the sum of all pᵢ with the weights C(n + 1, j + n − 2i)/2ⁿ.
///
/// # Rounding
///
/// Each averaging passes one rounding, halves are exact. A weight is exact for n ≤ 50, its product passes one rounding,
/// the sum of n/2 + 2 products at most n/2 + 1 more. All weights are positive and sum to one.
pub fn lane_riesenfeld<P: Affine>(
    implementation: impl Fn(&ControlPolygon<P>, usize) -> ControlPolygon<P>,
    polygon: &ControlPolygon<P>,
    degree: usize,
) -> Sides<P::Scalar> {
    let n = degree as i64;
    let k = polygon.vertices().len() as i64;
    let count = if polygon.is_closed() {
        2 * k
    } else {
        2 * k - n
    };
    let expected = (0..count).flat_map(|j| {
        let mut sum = vec![P::Scalar::from_integer(0); P::DIMENSION];
        // 0 ≤ j + n − 2i ≤ n + 1
        for i in (j - 1).div_euclid(2)..=(j + n).div_euclid(2) {
            let Some(vertex) = polygon.vertex(i) else {
                continue;
            };
            let weight = binomial::<P::Scalar>(degree + 1, j + n - 2 * i) * dyadic(1, degree);
            for (total, coordinate) in sum.iter_mut().zip(vertex.coordinates()) {
                *total += weight.clone() * coordinate.clone();
            }
        }
        sum
    });
    Sides::new(format!("n = {n}, {polygon:?}")).equal(
        "the weights are C(n + 1, j + n − 2i)/2ⁿ",
        flat(implementation(polygon, degree).vertices()),
        expected,
        Rounding::new(2 * degree + 3, largest_coordinate(polygon.vertices())),
    )
}
