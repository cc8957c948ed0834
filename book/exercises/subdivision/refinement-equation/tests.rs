use cagd::bspline::uniform_b_spline;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};

type Q = BigRational;

fn fraction(p: i64, q: i64) -> Q {
    <Q as Scalar>::from_ratio(p, q)
}

/// Degrees up to 4, with the thirds and the quarters in [0, n + 1].
fn inputs() -> impl Iterator<Item = (usize, Q)> {
    (0..=4_usize).flat_map(|n| {
        let end = n as i64 + 1;
        let of = move |q: i64| (0..=q * end).map(move |p| (n, fraction(p, q)));
        of(3).chain(of(4))
    })
}

fn right(n: usize, u: Q) -> Q {
    uniform_b_spline(n, u)
}

fn doubled(n: usize, u: Q) -> Q {
    right(n, u) * fraction(2, 1)
}

fn next_degree(n: usize, u: Q) -> Q {
    right(n + 1, u)
}

fn shifted(n: usize, u: Q) -> Q {
    right(n, u - fraction(1, 1))
}

/// A triangle over [0, n + 1] whose shifts sum to 1 wherever they do.
fn triangle(n: usize, u: Q) -> Q {
    let half = fraction(n as i64 + 1, 2);
    let distance = if u > half { &u - &half } else { &half - &u };
    if distance < half {
        (&half - distance) / (&half * &half)
    } else {
        fraction(0, 1)
    }
}

/// The right values at the knots, joined by straight lines.
fn right_at_knots(n: usize, u: Q) -> Q {
    let (mut knot, one) = (fraction(-20, 1), fraction(1, 1));
    while &knot + &one <= u {
        knot += &one;
    }
    let t = &u - &knot;
    let next = &knot + &one;
    right(n, knot) * (one - &t) + right(n, next) * t
}

fn accepts(b_spline: fn(usize, Q) -> Q) -> bool {
    inputs().all(|(n, u)| answer::law(b_spline, n, &u).judge().is_ok())
}

fn probes() -> Vec<String> {
    cagd::probes![
        accepts(right),
        accepts(doubled),
        accepts(next_degree),
        accepts(shifted),
        accepts(triangle),
        accepts(right_at_knots),
        answer::law(right, 2, &fraction(1, 2)).judge().is_ok(),
        answer::law(right, 0, &fraction(1, 4)).judge().is_ok(),
        answer::law(right, 0, &fraction(3, 4)).judge().is_ok(),
    ]
}

fn fails(what: &str, b_spline: fn(usize, Q) -> Q) {
    claim("the law on a wrong function").input(what).holds(
        !accepts(b_spline),
        "the law is violated for some degree up to 4 and some u",
        "it holds for all of them",
    );
}

/// Why: degree 0 can be checked by hand: one interval is two halves.
#[test]
fn it_holds_for_degree_zero() {
    for quarters in 0..=4 {
        claim("the law on the B-spline of degree 0").law(&answer::law(
            right,
            0,
            &fraction(quarters, 4),
        ));
    }
}

/// Why: the right function must be accepted, at knots and between them.
#[test]
fn it_holds_for_b_splines() {
    for (n, u) in inputs() {
        claim("the law on the B-splines").law(&answer::law(right, n, &u));
    }
}

#[test]
fn it_fails_for_multiples() {
    fails("twice the B-spline", doubled);
}

/// Why: all B-splines sum to 1 with their shifts, so the first claim alone tells the degree.
#[test]
fn it_fails_for_the_next_degree() {
    fails("the B-spline of degree n + 1", next_degree);
}

/// Why: other functions that are nearly right.
#[test]
fn it_fails_for_other_functions() {
    fails("the B-spline moved by 1", shifted);
    fails("a triangle over [0, n + 1]", triangle);
    fails(
        "the right values at the knots, joined by lines",
        right_at_knots,
    );
}
