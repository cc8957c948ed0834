//! Wrong ends, images, regions and intersections of Bézier curves.

use cagd::affine::{Affine, AffineMap, BoundingBox, Interval, Line, Point};
use cagd::bezier::{BezierCurve, LineIntersections, Root, RootKind, Roots, bernstein};
use cagd::scalar::{OrderedScalar, Scalar};
use num_traits::{One, Zero, pow};

/// Mixes up t and 1 − t.
pub fn backwards<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    curve.at(curve.domain().global(P::Scalar::one() - t))
}

/// Forgets the map to the unit interval.
pub fn domain_forgotten<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    curve.reparametrised(Interval::unit()).at(u)
}

/// Stops short of both ends: runs over the middle half of the domain only.
pub fn middle_half<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u) * P::Scalar::from_ratio(1, 2) + P::Scalar::from_ratio(1, 4);
    curve.at(curve.domain().global(t))
}

/// Runs beyond both ends, over twice the domain.
pub fn beyond_the_ends<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u) * P::Scalar::from_integer(2) - P::Scalar::from_ratio(1, 2);
    curve.at(curve.domain().global(t))
}

/// Forgets the binomial coefficients, so that the weights do not sum to 1.
pub fn without_binomials<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let n = curve.degree();
    let t = curve.domain().local(u);
    let s = P::Scalar::one() - t.clone();
    weighted(curve, |i| pow(t.clone(), i) * pow(s.clone(), n - i))
}

/// Interpolates the control points at equal steps, by the polynomials of Lagrange, some of which are negative.
pub fn interpolating<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let n = curve.degree();
    let t = curve.domain().local(u);
    let node = |j: usize| P::Scalar::from_ratio(j as i64, n.max(1) as i64);
    weighted(curve, |i| {
        (0..=n)
            .filter(|&j| j != i)
            .fold(P::Scalar::one(), |product, j| {
                product * (t.clone() - node(j)) / (node(i) - node(j))
            })
    })
}

/// Leaves out the last control point.
pub fn last_point_missing<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    let n = curve.degree();
    weighted(curve, |i| {
        if i == n && n > 0 {
            P::Scalar::zero()
        } else {
            bernstein(n, i as i64, t.clone())
        }
    })
}

fn weighted<P: Affine>(curve: &BezierCurve<P>, weight: impl Fn(usize) -> P::Scalar) -> P {
    P::from_fn(|k| {
        curve
            .control_points()
            .iter()
            .enumerate()
            .fold(P::Scalar::zero(), |sum, (i, point)| {
                sum + weight(i) * point.coordinates()[k].clone()
            })
    })
}

/// A scheme that first cuts all corners: the Bézier curve of the midpoints.
pub fn through_midpoints<P: Affine>(points: &[P], domain: &Interval<P::Scalar>, u: P::Scalar) -> P {
    let half = P::Scalar::from_ratio(1, 2);
    let midpoints = points
        .windows(2)
        .map(|pair| pair[0].lerp(&pair[1], half.clone()));
    match BezierCurve::on(domain.clone(), midpoints) {
        Ok(curve) => curve.at(u),
        Err(_) => points[0].clone(),
    }
}

/// A scheme that takes the control points in the wrong order.
pub fn last_to_first<P: Affine>(points: &[P], domain: &Interval<P::Scalar>, u: P::Scalar) -> P {
    let reversed = points.iter().rev().cloned();
    BezierCurve::on(domain.clone(), reversed)
        .expect("a control polygon")
        .at(u)
}

type Image<T> = BezierCurve<Point<T, 2>>;

/// Treats points as vectors: applies the linear part alone.
pub fn translation_forgotten<T: Scalar>(curve: &Image<T>, map: &AffineMap<T, 2, 2>) -> Image<T> {
    let images = curve
        .control_points()
        .iter()
        .map(|p| Point::origin() + map.vector(&p.from_origin()));
    BezierCurve::on(curve.domain().clone(), images).expect("finite images")
}

/// Maps the first and the last control point only.
pub fn ends_mapped_only<T: Scalar>(curve: &Image<T>, map: &AffineMap<T, 2, 2>) -> Image<T> {
    let last = curve.degree();
    let image = |(i, p): (usize, &Point<T, 2>)| {
        if i == 0 || i == last {
            map.point(p)
        } else {
            p.clone()
        }
    };
    let images = curve.control_points().iter().enumerate().map(image);
    BezierCurve::on(curve.domain().clone(), images).expect("finite images")
}

/// Uses the columns of the matrix as rows.
pub fn matrix_transposed<T: Scalar>(curve: &Image<T>, map: &AffineMap<T, 2, 2>) -> Image<T> {
    let entry = |row: usize, column: usize| map.linear()[(column, row)].clone();
    let rows = [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]];
    let translation = [map.translation()[0].clone(), map.translation()[1].clone()];
    curve
        .mapped(&AffineMap::new(rows, translation))
        .expect("finite images")
}

/// Does not reverse at all.
pub fn not_reversed<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    curve.clone()
}

/// Exchanges the ends and leaves the inner control points.
pub fn ends_exchanged<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    let mut points = curve.control_points().to_vec();
    points.swap(0, curve.degree());
    BezierCurve::on(curve.domain().clone(), points).expect("a control polygon")
}

/// Reverses the control points and forgets the domain.
pub fn reversed_on_the_unit_interval<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    curve.reversed().reparametrised(Interval::unit())
}

/// The box of the two ends.
pub fn box_of_the_ends<P: Affine>(curve: &BezierCurve<P>) -> BoundingBox<P>
where
    P::Scalar: OrderedScalar,
{
    let points = curve.control_points();
    BoundingBox::of(&[points[0].clone(), points[curve.degree()].clone()]).expect("two points")
}

/// The box of a few points of the curve.
pub fn box_of_samples<P: Affine>(curve: &BezierCurve<P>) -> BoundingBox<P>
where
    P::Scalar: OrderedScalar,
{
    let samples = (0..=4).map(|k| curve.at(curve.domain().global(P::Scalar::from_ratio(k, 4))));
    BoundingBox::of(&samples.collect::<Vec<_>>()).expect("five points")
}

/// A box that starts to grow at the origin.
pub fn box_with_the_origin<P: Affine>(curve: &BezierCurve<P>) -> BoundingBox<P>
where
    P::Scalar: OrderedScalar,
{
    let origin = P::from_fn(|_| P::Scalar::zero());
    let points: Vec<P> = curve
        .control_points()
        .iter()
        .cloned()
        .chain([origin])
        .collect();
    BoundingBox::of(&points).expect("finite points")
}

type Meetings<T> = LineIntersections<T>;

/// Finds the first intersection and stops.
pub fn first_only<T: OrderedScalar>(curve: &Image<T>, line: &Line<T>) -> Meetings<T> {
    match curve
        .line_intersections(line)
        .expect("a finite line function")
    {
        LineIntersections::Parameters(roots) => {
            LineIntersections::Parameters(roots.into_iter().take(1).collect())
        }
        within => within,
    }
}

/// Looks for sign changes at nine places: misses double roots, and two roots between neighbours.
pub fn sampled<T: OrderedScalar>(curve: &Image<T>, line: &Line<T>) -> Meetings<T> {
    let samples: Vec<T> = (0..=8)
        .map(|k| curve.domain().global(T::from_ratio(k, 8)))
        .collect();
    let roots = samples.windows(2).filter(|pair| {
        let [start, end] = [&pair[0], &pair[1]].map(|u| line.value(&curve.at(u.clone())));
        start * end < T::zero()
    });
    LineIntersections::Parameters(
        roots
            .map(|pair| Root {
                low: pair[0].clone(),
                high: pair[1].clone(),
                kind: RootKind::Odd,
            })
            .collect(),
    )
}

/// Intersects the control polygon in place of the curve.
pub fn polygon_intersected<T: OrderedScalar>(curve: &Image<T>, line: &Line<T>) -> Meetings<T> {
    let n = curve.degree() as i64;
    let values: Vec<T> = curve
        .control_points()
        .iter()
        .map(|p| line.value(p))
        .collect();
    let roots = values
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair[0].clone() * pair[1].clone() <= T::zero());
    let at = |i: i64| curve.domain().global(T::from_ratio(i, n));
    LineIntersections::Parameters(
        roots
            .map(|(i, _)| Root {
                low: at(i as i64),
                high: at(i as i64 + 1),
                kind: RootKind::Odd,
            })
            .collect(),
    )
}

/// Gives every root the multiplicity 1, and each as often as the degree allows.
pub fn always_n<T: OrderedScalar>(curve: &Image<T>, line: &Line<T>) -> Meetings<T> {
    match curve
        .hyperplane_function(line)
        .expect("finite values")
        .roots()
    {
        Roots::Everywhere => LineIntersections::Within,
        Roots::Isolated(roots) => LineIntersections::Parameters(
            roots
                .into_iter()
                .map(|root| Root {
                    kind: RootKind::Exactly(curve.degree()),
                    ..root
                })
                .collect(),
        ),
    }
}
