//! Exact input that proves an identity for its degree.
//!
//! Both sides of an identity are polynomials in t of degree at most m, so m + 1 parameters prove it
//! for all t. Where both sides are linear in the control points, it is enough to take one control
//! value 1 and the others 0.

use cagd::affine::{Affine, Interval};
use cagd::bezier::BezierCurve;
use cagd::law::Sides;
use cagd::scalar::{BigRational, Scalar};

use crate::support::Outcome;

/// The highest degree for which identities are proved.
pub const MAX_DEGREE: usize = 12;

/// Runs a law on every input.
pub fn for_each<I>(
    inputs: impl IntoIterator<Item = I>,
    law: impl Fn(&I) -> Sides<BigRational>,
) -> Outcome {
    let mut count = 0;
    for input in inputs {
        count += 1;
        law(&input)
            .judge()
            .map_err(|violation| violation.to_string())?;
    }
    assert!(count > 0, "there is no input at all");
    Ok(())
}

/// The whole number n.
pub fn integer(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

/// The fraction p/q.
pub fn ratio(p: i64, q: i64) -> BigRational {
    <BigRational as Scalar>::from_ratio(p, q)
}

/// The interval [a, b] with whole ends.
pub fn interval(a: i64, b: i64) -> Interval<BigRational> {
    Interval::new(integer(a), integer(b)).expect("two different ends")
}

/// The n + 1 curves of degree n whose control values are 0 but for a single 1, over [0, 1].
pub fn unit_curves(degree: usize) -> impl Iterator<Item = BezierCurve<BigRational>> {
    unit_curves_on(Interval::unit(), degree)
}

/// The n + 1 curves of degree n whose control values are 0 but for a single 1, over `domain`.
pub fn unit_curves_on(
    domain: Interval<BigRational>,
    degree: usize,
) -> impl Iterator<Item = BezierCurve<BigRational>> {
    (0..=degree).map(move |one| {
        let values = (0..=degree).map(|i| integer(i64::from(i == one)));
        BezierCurve::on(domain.clone(), values).expect("a control polygon")
    })
}

/// Unit curves of every degree up to `max_degree` over [0, 1], and up to half of that over [2, 5],
/// each at the parameters a, a + 1, …, a + n.
///
/// They prove an identity that is linear in the control points and of degree at most n in t.
/// The second interval tells whether the map to the unit interval is right; a few degrees show that.
pub fn unit_curves_and_parameters(
    max_degree: usize,
) -> impl Iterator<Item = (BezierCurve<BigRational>, BigRational)> {
    let domains = [
        (Interval::unit(), max_degree),
        (interval(2, 5), max_degree / 2),
    ];
    domains.into_iter().flat_map(|(domain, max_degree)| {
        (0..=max_degree).flat_map(move |degree| {
            let domain = domain.clone();
            unit_curves_on(domain.clone(), degree).flat_map(move |curve| {
                let start = domain.start();
                (0..=degree as i64).map(move |k| (curve.clone(), start.clone() + integer(k)))
            })
        })
    })
}

/// A point with whole coordinates.
pub fn at<P: Affine<Scalar = BigRational>>(coordinates: &[i64]) -> P {
    P::from_fn(|k| integer(coordinates[k]))
}
