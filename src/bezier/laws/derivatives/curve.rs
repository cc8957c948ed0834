//! Laws of the derivatives of Bézier curves.

use std::num::NonZeroUsize;

use num_traits::One;

use super::{
    bernstein_sum, binomial_differences, derivative_by_leibniz, derivative_magnitude, factor,
};
use crate::affine::{Affine, Point};
use crate::bezier::laws::{flat, magnitude};
use crate::bezier::{BezierCurve, CasteljauTriangle};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-derivative`: b′(u) = n/(b − a)·Σᵢ Bᵢⁿ⁻¹(t)·(bᵢ₊₁ − bᵢ) = n/(b − a)·(b₁ⁿ⁻¹(t) − b₀ⁿ⁻¹(t)).
///
/// `implementation(curve, u)` must give b′(u). It is compared with the derivative by the product
/// rule, with the sum and with the last segment of the triangle. For n = 0 all are 0.
///
/// # Rounding
///
/// By the product rule 3n + 10 roundings; the sum has 1 in the difference, 3n − 2 in the polynomial,
/// n + 1 in product and sum, 3 in the factor; the triangle 3n − 3, 1 and 3. The implementation has as many as
/// the largest of them. Together at most 8n + 20.
pub fn derivative<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P::Difference,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let t = curve.domain().local(u.clone());
    let rounding = Rounding::new(8 * n + 20, derivative_magnitude(curve, 1, &u));
    let found = implementation(curve, u.clone()).coordinates().to_vec();
    let differences = binomial_differences(curve.control_points(), 1);
    let sides = Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the derivative is that by the product rule",
            found.clone(),
            derivative_by_leibniz(curve, 1, &u),
            rounding,
        )
        .equal(
            "the derivative is n/(b − a) times a Bernstein sum of the legs",
            found.clone(),
            bernstein_sum(&factor(curve, 1), &differences, &t, P::DIMENSION),
            rounding,
        );
    if n == 0 {
        return sides;
    }
    sides.equal(
        "the derivative is n/(b − a) times the last segment of the triangle",
        found,
        last_segment(curve, &u),
        rounding,
    )
}

/// n/(b − a) times the last segment b₁ⁿ⁻¹ − b₀ⁿ⁻¹ of the triangle at u, n ≥ 1.
fn last_segment<P: Affine>(curve: &BezierCurve<P>, u: &P::Scalar) -> Vec<P::Scalar> {
    let triangle = curve.triangle(u.clone());
    let column = triangle.column(curve.degree() - 1);
    let factor = factor(curve, 1);
    std::iter::zip(column[1].coordinates(), column[0].coordinates())
        .map(|(end, start)| factor.clone() * (end.clone() - start.clone()))
        .collect()
}

/// `bezier-derivative-consequences`: the hodograph is the Bézier curve of degree n − 1 over the same
/// interval with the control vectors n/(b − a)·(bᵢ₊₁ − bᵢ); at the ends it has the first and the last of them;
/// the last segment of the triangle at u has its direction, and b(u) divides it as 1 − t : t.
///
/// `implementation(curve)` must give the hodograph of a curve of degree n ≥ 1.
///
/// # Rounding
///
/// A control vector passes 4 roundings on each side. The values are bounded as in [`derivative`], b(u) on the last
/// segment by 3n on each side.
pub fn derivative_consequences<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> BezierCurve<P::Difference>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let (start, end) = (curve.domain().start(), curve.domain().end());
    let hodograph = implementation(curve);
    let factor = factor(curve, 1);
    let legs = binomial_differences(curve.control_points(), 1);
    let vectors: Vec<Vec<P::Scalar>> = legs
        .iter()
        .map(|leg| leg.iter().map(|x| factor.clone() * x.clone()).collect())
        .collect();
    let at_ends = derivative_magnitude(curve, 1, &start);
    let exact = Rounding::new(8, at_ends);
    let rounding = Rounding::new(8 * n + 20, derivative_magnitude(curve, 1, &u));
    let value = |u: &P::Scalar| hodograph.at(u.clone()).coordinates().to_vec();
    let triangle = curve.triangle(u.clone());
    let segment = triangle.column(n.saturating_sub(1));
    let t = curve.domain().local(u.clone());
    let s = P::Scalar::one() - t.clone();
    let divided = std::iter::zip(
        segment[0].coordinates(),
        segment[segment.len() - 1].coordinates(),
    )
    .map(|(first, last)| s.clone() * first.clone() + t.clone() * last.clone());
    Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the control vectors are n/(b − a) times the legs",
            flat(hodograph.control_points()),
            vectors.concat(),
            exact,
        )
        .equal(
            "b′ at the start is n/(b − a) times the first leg",
            value(&start),
            vectors.first().cloned().unwrap_or_default(),
            exact,
        )
        .equal(
            "b′ at the end is n/(b − a) times the last leg",
            value(&end),
            vectors.last().cloned().unwrap_or_default(),
            exact,
        )
        .equal(
            "the last segment of the triangle, times n/(b − a), is the value of the hodograph",
            last_segment(curve, &u),
            value(&u),
            rounding,
        )
        .equal(
            "the curve point divides the last segment as 1 − t : t",
            divided,
            bernstein_sum(&P::Scalar::one(), &points(curve), &t, P::DIMENSION),
            Rounding::new(7 * n + 8, magnitude(curve, &u)),
        )
}

/// The control points as lists of coordinates.
fn points<P: Affine>(curve: &BezierCurve<P>) -> Vec<Vec<P::Scalar>> {
    let points = curve.control_points().iter();
    points.map(|point| point.coordinates().to_vec()).collect()
}

/// `bezier-second-derivative`: b″(u) = n(n − 1)/(b − a)²·Σᵢ Bᵢⁿ⁻²(t)·(bᵢ₊₂ − 2bᵢ₊₁ + bᵢ), and at the ends
/// n(n − 1)/(b − a)² times the first and the last second difference.
///
/// `implementation(curve, u)` must give b″(u) of a curve of degree n ≥ 2.
///
/// # Rounding
///
/// As in [`derivative`] with 4p = 8 instead of 4: at most 8n + 30.
pub fn second_derivative<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P::Difference,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let differences = binomial_differences(curve.control_points(), 2);
    let factor = factor(curve, 2);
    let mut sides = Sides::new(format!("u = {u}, {curve}"));
    for (place, at) in [
        ("", u),
        (" at the start", domain.start()),
        (" at the end", domain.end()),
    ] {
        let rounding = Rounding::new(8 * n + 30, derivative_magnitude(curve, 2, &at));
        let found = implementation(curve, at.clone()).coordinates().to_vec();
        let sum = bernstein_sum(
            &factor,
            &differences,
            &domain.local(at.clone()),
            P::DIMENSION,
        );
        sides = sides
            .equal(
                format!("b″{place} is that by Leibniz's rule"),
                found.clone(),
                derivative_by_leibniz(curve, 2, &at),
                rounding,
            )
            .equal(
                format!(
                    "b″{place} is n(n − 1)/(b − a)² times a Bernstein sum of second differences"
                ),
                found,
                sum,
                rounding,
            );
    }
    sides
}

/// `bezier-higher-derivative`: b⁽ᵖ⁾ has the control vectors n!/(n − p)!/(b − a)ᵖ·Δᵖbᵢ, i = 0 … n − p.
///
/// `implementation(curve, p)` must give b⁽ᵖ⁾ as a curve; for p > n that is the zero vector.
/// The differences are compared with Σⱼ (−1)ᵖ⁻ʲ·C(p, j)·bᵢ₊ⱼ, a value with Leibniz's rule.
///
/// # Rounding
///
/// A control vector passes p roundings in repeated differences or p + 1 in the binomial sum, and 3p + 1
/// in the factor on each side: 8p + 3. A value adds 3(n − p) and the 3n + 4p + 6 of Leibniz's rule.
pub fn higher_derivative<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, NonZeroUsize) -> BezierCurve<P::Difference>,
    curve: &BezierCurve<P>,
    order: NonZeroUsize,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let (n, p) = (curve.degree(), order.get());
    let found = implementation(curve, order);
    let factor = factor(curve, p);
    let mut vectors: Vec<P::Scalar> = binomial_differences(curve.control_points(), p)
        .into_iter()
        .flatten()
        .map(|x| factor.clone() * x)
        .collect();
    if p > n {
        vectors = vec![P::Scalar::from_integer(0); P::DIMENSION];
    }
    let start = curve.domain().start();
    Sides::new(format!("p = {p}, u = {u}, {curve}"))
        .equal(
            "the control vectors are n!/(n − p)!/(b − a)ᵖ times the p-th differences",
            flat(found.control_points()),
            vectors,
            Rounding::new(8 * p + 3, derivative_magnitude(curve, p, &start)),
        )
        .equal(
            "the value is that by Leibniz's rule",
            found.at(u.clone()).coordinates().to_vec(),
            derivative_by_leibniz(curve, p, &u),
            Rounding::new(6 * n + 12 * p + 9, derivative_magnitude(curve, p, &u)),
        )
}

/// `bezier-derivatives-from-triangle`: b⁽ᵖ⁾(u) = n!/(n − p)!/(b − a)ᵖ·Δᵖb₀ⁿ⁻ᵖ, the p-th difference of
/// column n − p of the triangle at u.
///
/// `implementation(curve, u, p)` must give b⁽ᵖ⁾(u). It is compared with Leibniz's rule.
///
/// # Rounding
///
/// A point of column n − p passes 3(n − p) roundings, its difference p, the factor 3p + 1; Leibniz's
/// rule 3n + 4p + 6. Together at most 6n + 5p + 7.
pub fn derivatives_from_triangle<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar, NonZeroUsize) -> P::Difference,
    curve: &BezierCurve<P>,
    u: P::Scalar,
    order: NonZeroUsize,
) -> Sides<P::Scalar> {
    let (n, p) = (curve.degree(), order.get());
    Sides::new(format!("p = {p}, u = {u}, {curve}")).equal(
        "the p-th difference of column n − p is the p-th derivative by Leibniz's rule",
        implementation(curve, u.clone(), order)
            .coordinates()
            .to_vec(),
        derivative_by_leibniz(curve, p, &u),
        Rounding::new(6 * n + 5 * p + 7, derivative_magnitude(curve, p, &u)),
    )
}

/// `bezier-de-casteljau-worked-example`: the scheme of (0, 0), (2, 9/2), (17/2, 13/2), (11, 2) at 3/5, with
/// b(3/5), b′(3/5) and b″(3/5), against the numbers worked out by hand.
///
/// `implementation(curve, u)` must give the triangle.
///
/// # Rounding
///
/// Three levels of 3 roundings, differences 2, factor 1, and 1 in each given fraction: at most 16, of
/// terms that sum to at most 6·4·11.
pub fn de_casteljau_worked_example<T: Scalar>(
    implementation: impl Fn(&BezierCurve<Point<T, 2>>, T) -> CasteljauTriangle<Point<T, 2>>,
) -> Sides<T> {
    let thousandths = |numbers: &[[i64; 2]]| -> Vec<Point<T, 2>> {
        let point = |pair: &[i64; 2]| Point::new(pair.map(|x| T::from_ratio(x, 1000)));
        numbers.iter().map(point).collect()
    };
    let points = thousandths(&[[0, 0], [2000, 4500], [8500, 6500], [11000, 2000]]);
    let curve = BezierCurve::trusted(crate::affine::Interval::unit(), points);
    let triangle = implementation(&curve, T::from_ratio(3, 5));
    let rounding = Rounding::new(16, 264.0);
    let derivative = |order: NonZeroUsize, factor: i64| -> Vec<T> {
        let difference = triangle.forward_difference(order);
        difference
            .iter()
            .map(|x| x.clone() * T::from_integer(factor))
            .collect()
    };
    let columns = [
        (1, thousandths(&[[1200, 2700], [5900, 5700], [10000, 3800]])),
        (2, thousandths(&[[4020, 4500], [8360, 4560]])),
        (3, thousandths(&[[6624, 4536]])),
    ];
    let first = NonZeroUsize::MIN;
    let second = first.saturating_add(1);
    let mut sides = Sides::new("(0, 0), (2, 9/2), (17/2, 13/2), (11, 2) at 3/5");
    for (level, expected) in columns {
        sides = sides.equal(
            format!("column {level}"),
            flat(triangle.column(level)),
            flat(&expected),
            rounding,
        );
    }
    sides
        .equal(
            "b′(3/5) = 3·Δb₀²",
            derivative(first, 3),
            flat(&thousandths(&[[13020, 180]])),
            rounding,
        )
        .equal(
            "b″(3/5) = 6·Δ²b₀¹",
            derivative(second, 6),
            flat(&thousandths(&[[-3600, -29400]])),
            rounding,
        )
}
