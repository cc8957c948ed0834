//! Wrong ways to a curve point.

use cagd::affine::{Affine, Interval, Linear};
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, MonomialCurve, Step, TrianglePath, TrianglePaths, bernstein,
    bernstein_matrix, monomial_matrix,
};
use cagd::scalar::Scalar;
use nalgebra::DMatrix;
use num_traits::{One, Zero, pow};

/// Mixes up t and 1 − t.
pub fn parameter_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    curve.at(curve.domain().global(P::Scalar::one() - t))
}

/// Forgets the map to the unit interval.
pub fn domain_forgotten<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    weighted(curve, |i| bernstein(curve.degree(), i as i64, u.clone()))
}

/// Sums tⁱ(1 − t)ⁿ⁻ⁱ·bᵢ without the binomial coefficients.
pub fn no_binomials<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    let s = P::Scalar::one() - t.clone();
    weighted(curve, |i| {
        pow(t.clone(), i) * pow(s.clone(), curve.degree() - i)
    })
}

/// Reads bᵢ₊₁ for bᵢ, as the sum of the notes does for i = 1, and repeats the last point.
pub fn index_off_by_one<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let points = curve.control_points();
    let shifted = points.iter().skip(1).chain(points.last()).cloned();
    let shifted = BezierCurve::on(curve.domain().clone(), shifted).expect("finite control points");
    shifted.at(u)
}

/// Takes (1 − t)ⁿ out of the sum for every t, so that t/(1 − t) grows without bound.
pub fn powers_of_the_quotient<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    let s = P::Scalar::one() - t.clone();
    let n = curve.degree();
    let factor = pow(s.clone(), n);
    weighted(curve, |i| {
        factor.clone() * cagd::bezier::binomial(n, i as i64) * pow(t.clone() / s.clone(), i)
    })
}

/// The sum of the control points with any weights.
fn weighted<P: Affine>(curve: &BezierCurve<P>, weight: impl Fn(usize) -> P::Scalar) -> P {
    let weights: Vec<P::Scalar> = (0..=curve.degree()).map(weight).collect();
    P::from_fn(|k| {
        std::iter::zip(&weights, curve.control_points())
            .map(|(weight, point)| weight.clone() * point.coordinates()[k].clone())
            .reduce(|sum, term| sum + term)
            .expect("a curve has control points")
    })
}

/// The scheme with midpoints, whatever t is.
pub fn midpoints<P: Affine>(curve: &BezierCurve<P>, _: P::Scalar) -> CasteljauTriangle<P> {
    let middle = P::Scalar::from_ratio(1, 2);
    curve.triangle(curve.domain().global(middle))
}

/// Forgets the last path.
pub fn path_missing(n: usize, k: usize) -> Vec<TrianglePath> {
    let mut paths: Vec<TrianglePath> = TrianglePaths::new(n, k).collect();
    if paths.len() > 1 {
        paths.pop();
    }
    paths
}

/// As many paths as there should be, all the same.
pub fn one_path_repeated(n: usize, k: usize) -> Vec<TrianglePath> {
    let paths: Vec<TrianglePath> = TrianglePaths::new(n, k).collect();
    vec![paths[0].clone(); paths.len()]
}

/// Takes n − k steps up instead of k.
pub fn steps_swapped(n: usize, k: usize) -> Vec<TrianglePath> {
    TrianglePaths::new(n, k)
        .map(|path| {
            let steps = path.steps().iter().map(|step| match step {
                Step::Same => Step::Up,
                Step::Up => Step::Same,
            });
            TrianglePath::new(steps.collect())
        })
        .collect()
}

/// Σ coefficientₖ·tᵏ⁺¹: the powers start at 1.
pub fn powers_shifted<T: Scalar>(coefficients: &[T], t: T) -> T {
    horner(coefficients, t.clone()) * t
}

/// Leaves out the highest power.
pub fn highest_power_missing<T: Scalar>(coefficients: &[T], t: T) -> T {
    horner(&coefficients[..coefficients.len() - 1], t)
}

fn horner<T: Scalar>(coefficients: &[T], t: T) -> T {
    coefficients
        .iter()
        .rev()
        .fold(T::zero(), |sum, coefficient| {
            sum * t.clone() + coefficient.clone()
        })
}

/// The coefficients of the powers without the alternating sign.
pub fn signs_forgotten<T: cagd::scalar::OrderedScalar>(n: usize) -> DMatrix<T> {
    bernstein_matrix::<T>(n).map(|entry| entry.abs())
}

/// Rows in the order of rising powers.
pub fn rows_reversed<T: Scalar>(n: usize) -> DMatrix<T> {
    let matrix = bernstein_matrix::<T>(n);
    DMatrix::from_fn(n + 1, n + 1, |row, i| matrix[(n - row, i)].clone())
}

/// Both changes of basis, the way back without division by C(n, k).
pub fn way_back_not_divided<T: Scalar>(n: usize) -> (DMatrix<T>, DMatrix<T>) {
    let back = DMatrix::from_fn(n + 1, n + 1, |i, column| {
        cagd::bezier::binomial(i, (n - column) as i64)
    });
    (bernstein_matrix(n), back)
}

/// Both changes of basis, the columns of the way back in the order of rising powers.
pub fn way_back_rising<T: Scalar>(n: usize) -> (DMatrix<T>, DMatrix<T>) {
    let back = monomial_matrix::<T>(n);
    let rising = DMatrix::from_fn(n + 1, n + 1, |i, k| back[(i, n - k)].clone());
    (bernstein_matrix(n), rising)
}

/// The plain differences of the control points, without the factor C(n, k).
pub fn differences_without_factor<P: Affine>(curve: &BezierCurve<P>) -> MonomialCurve<P> {
    let form = curve.to_monomial().expect("the coefficients are in range");
    let n = curve.degree();
    let plain = form
        .coefficients()
        .iter()
        .zip(1_i64..)
        .map(|(vector, k)| vector.scaled(P::Scalar::one() / cagd::bezier::binomial(n, k)));
    MonomialCurve::on(curve.domain().clone(), form.start().clone(), plain)
        .expect("smaller coefficients")
}

/// The right coefficients for the wrong interval.
pub fn form_on_unit_interval<P: Affine>(curve: &BezierCurve<P>) -> MonomialCurve<P> {
    let form = curve.to_monomial().expect("the coefficients are in range");
    MonomialCurve::new(form.start().clone(), form.coefficients().to_vec())
        .expect("the same coefficients")
}

/// Takes the coefficients over [0, 1] for those over the interval.
pub fn not_re_expanded<P: Affine>(
    form: &MonomialCurve<P>,
    interval: Interval<P::Scalar>,
) -> BezierCurve<P> {
    let curve = BezierCurve::from_monomial(form).expect("finite coefficients");
    curve.reparametrised(interval)
}

/// Takes the partial sums of the coefficients for control points, without C(i, k)/C(n, k).
pub fn partial_sums<P: Affine>(
    form: &MonomialCurve<P>,
    interval: Interval<P::Scalar>,
) -> BezierCurve<P> {
    let form = form.over(interval.clone()).expect("finite coefficients");
    let mut point = form.start().clone();
    let mut points = vec![point.clone()];
    for coefficient in form.coefficients() {
        point = point.translated(coefficient);
        points.push(point.clone());
    }
    BezierCurve::on(interval, points).expect("finite control points")
}

/// Treats the curve as if its degree were smaller: the highest power is lost.
pub fn last_coefficient_dropped<P: Affine>(
    form: &MonomialCurve<P>,
    interval: Interval<P::Scalar>,
) -> BezierCurve<P> {
    let mut coefficients = form.coefficients().to_vec();
    if let Some(last) = coefficients.last_mut() {
        *last = last.scaled(P::Scalar::zero());
    }
    let form = MonomialCurve::on(form.domain().clone(), form.start().clone(), coefficients)
        .expect("finite coefficients");
    let form = form.over(interval).expect("finite coefficients");
    BezierCurve::from_monomial(&form).expect("finite coefficients")
}
