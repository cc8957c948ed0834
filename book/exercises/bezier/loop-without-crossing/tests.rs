use cagd::affine::{BoundingBox, Orient, Point, Turn, Vector};
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};

type Plane = Point<BigRational, 2>;

fn number(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn polygon() -> [Plane; 4] {
    answer::control_points().map(|xy| Point::new(xy.map(number)))
}

fn probes() -> Vec<String> {
    cagd::probes![answer::control_points()]
}

/// The polygon and, as what was found, its curve.
fn picture() -> Picture {
    let curve = BezierCurve::new(polygon()).expect("four points");
    let parameters = (0..=64).map(|k| BigRational::from_ratio(k, 64));
    Picture::new()
        .given(polygon())
        .found(parameters.map(|t| curve.at(t)))
}

/// Whether two segments have a point in common, their ends included.
fn meet([a, b]: [&Plane; 2], [c, d]: [&Plane; 2]) -> bool {
    let turn = |p, q, r| BigRational::turn(p, q, r);
    let separates = |p, q, r, s| turn(p, q, r) != turn(p, q, s) || turn(p, q, r) == Turn::Straight;
    let on_one_line = turn(a, b, c) == Turn::Straight && turn(a, b, d) == Turn::Straight;
    if on_one_line {
        // Two segments on a line meet if their boxes do.
        let bounds =
            |p: &Plane, q: &Plane| BoundingBox::of(&[p.clone(), q.clone()]).expect("two points");
        return bounds(a, b).meets(&bounds(c, d));
    }
    separates(a, b, c, d) && separates(c, d, a, b)
}

#[test]
fn the_polygon_does_not_meet_itself() {
    let b = polygon();
    let zero = number(0);
    let mut found = String::new();
    for (i, leg) in b.windows(2).enumerate() {
        if leg[0] == leg[1] {
            found = format!("leg {i} is a point");
        }
    }
    for (i, corner) in b.windows(3).enumerate() {
        let (leg, next) = (
            corner[1].clone() - corner[0].clone(),
            corner[2].clone() - corner[1].clone(),
        );
        let back = BigRational::turn(&corner[0], &corner[1], &corner[2]) == Turn::Straight
            && leg.dot(&next) < zero;
        if back {
            found = format!("leg {} runs back along leg {i}", i + 1);
        }
    }
    if meet([&b[0], &b[1]], [&b[2], &b[3]]) {
        found = "the first and the last leg meet".into();
    }
    claim("the control polygon")
        .input(format!("{:?}", answer::control_points()))
        .picture(picture)
        .holds(found.is_empty(), "it does not meet itself", found);
}

#[test]
fn the_curve_crosses_itself() {
    let [b0, b1, b2, b3] = polygon();
    // b(t) = b₀ + a₁t + a₂t² + a₃t³, and (b(t) − b(s))/(t − s) = a₁ + a₂u + a₃v for u = s + t, v = s² + st + t².
    let three = number(3);
    let a1 = (b1.clone() - b0.clone()) * three.clone();
    let a2 = (b2.clone() - b1.clone()) * three.clone() - a1.clone();
    let a3 = (b3 - b0) - (b2 - b1) * three;
    let cross = |v: &Vector<BigRational, 2>, w: &Vector<BigRational, 2>| {
        v[0].clone() * w[1].clone() - v[1].clone() * w[0].clone()
    };
    let determinant = cross(&a2, &a3);
    let found = if determinant == number(0) {
        "no two parameters have the same point".to_owned()
    } else {
        let u = -cross(&a1, &a3) / determinant.clone();
        let v = -cross(&a2, &a1) / determinant;
        // s and t are the zeros of x² − ux + p.
        let p = u.clone() * u.clone() - v;
        let discriminant = u.clone() * u.clone() - number(4) * p.clone();
        let inside = u >= number(0)
            && u <= number(2)
            && p >= number(0)
            && number(1) - u.clone() + p >= number(0);
        let root = OrderedScalar::to_f64(&discriminant).abs().sqrt();
        let u = OrderedScalar::to_f64(&u);
        let [s, t] = [(u - root) / 2.0, (u + root) / 2.0];
        if discriminant < number(0) {
            "no two real parameters have the same point".to_owned()
        } else if discriminant == number(0) {
            format!("a cusp at t = {t:.3}")
        } else if !inside {
            format!("b(s) = b(t) only for s = {s:.3} and t = {t:.3}")
        } else {
            String::new()
        }
    };
    claim("the curve of these control points")
        .input(format!("{:?}", answer::control_points()))
        .picture(picture)
        .holds(
            found.is_empty(),
            "b(s) = b(t) for some 0 ≤ s < t ≤ 1",
            found,
        );
}
