use cagd::affine::{ConvexHull, Point};
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};

type RationalPoint = Point<BigRational, 2>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn probes() -> Vec<String> {
    let (points, parameter) = answer::counterexample();
    cagd::probes![points.clone(), parameter]
}

/// The answer as points and a number, if it is of the form that is asked for.
fn read() -> (Vec<RationalPoint>, BigRational) {
    let (points, (p, q)) = answer::counterexample();
    let input = format!("{points:?}, ({p}, {q})");
    claim("the form of the answer").input(&input).holds(
        (3..=6).contains(&points.len()),
        "three to six control points",
        format!("{} of them", points.len()),
    );
    let is_small = |n: i64| (-1000..=1000).contains(&n);
    let all_small = points
        .iter()
        .flatten()
        .chain([&p, &q])
        .all(|&n| is_small(n));
    claim("the form of the answer").input(&input).holds(
        all_small && q >= 1,
        "numbers between -1000 and 1000, and q ≥ 1",
        &input,
    );
    let whole = |xy: [i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    (points.into_iter().map(whole).collect(), fraction(p, q))
}

#[test]
fn the_parameter_is_outside() {
    let (_, t) = read();
    claim("the parameter").holds(
        t < fraction(0, 1) || t > fraction(1, 1),
        "t < 0 or t > 1",
        format!("t = {t}"),
    );
}

#[test]
fn the_points_are_not_on_a_line() {
    let (points, _) = read();
    let hull = ConvexHull::of(&points).expect("at least three points");
    claim("the control points")
        .input(format!("{points:?}"))
        .holds(
            hull.vertices().len() >= 3,
            "they do not lie on one line",
            "they do",
        );
}

#[test]
fn the_point_is_in_the_hull() {
    let (points, t) = read();
    let curve = BezierCurve::new(points.clone()).expect("at least three points");
    let hull = ConvexHull::of(&points).expect("at least three points");
    let point = curve.at(t.clone());
    let upto = |k: i64| t.clone() * fraction(k, 32);
    claim("the point b(t)")
        .input(format!("b = {points:?}, t = {t}"))
        .picture(|| {
            Picture::new()
                .given(points.clone())
                .expected((0..=32).map(|k| curve.at(fraction(k, 32))))
                .found((0..=32).map(|k| curve.at(upto(k))))
        })
        .holds(
            hull.contains(&point),
            "a point of the convex hull",
            format!("b(t) = {point}, outside of it"),
        );
}
