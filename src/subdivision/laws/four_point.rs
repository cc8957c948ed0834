//! Laws of the four-point scheme.

use num_traits::{One, Zero};

use crate::affine::{Affine, Point};
use crate::law::{Rounding, Sides};
use crate::scalar::{BigRational, OrderedScalar, Scalar};
use crate::subdivision::local_matrix::determinant;
use crate::subdivision::{
    Closing, ControlPolygon, ControlPolygonError, LaurentPolynomial, LocalMatrix, Mask,
};

type Refined<P> = Result<ControlPolygon<P>, ControlPolygonError>;

fn ratio(p: i64, q: i64) -> BigRational {
    <BigRational as Scalar>::from_ratio(p, q)
}

fn flat<P: Affine>(points: &[P]) -> Vec<P::Scalar> {
    let coordinates = points.iter().flat_map(|p| p.coordinates().iter().cloned());
    coordinates.collect()
}

fn magnitude<P: Affine>(points: &[P]) -> f64 {
    let coordinates = points.iter().flat_map(|p| p.coordinates());
    coordinates.map(Scalar::magnitude).fold(0.0, f64::max)
}

/// `subdivision-four-point-scheme`: the old points stay, and each new one is the value at 1/2 of the cubic through its
/// four neighbours, moved by w − 1/16 times their third-order defect.
///
/// `implementation(polygon, w)` must make one step. The cubic is computed by the scheme of Aitken and Neville.
/// An open polygon of n points keeps the second to the last but one.
///
/// # Rounding
///
/// The rule: w + 1/2, 4 products, 3 sums, at most 5 roundings a term. Aitken: three levels of `lerp` with weights that
/// are exact or of size ≤ 2 with one rounding, at most 4 a level; then the defect, 3 sums, 2 products and a sum.
/// The weights of a level sum to at most 4 in absolute value in the first and 2 in the others, so terms sum to
/// at most 16·max|p|, and those of the defect to 8·(|w| + 1)·max|p|.
pub fn four_point_scheme<P: Affine>(
    implementation: impl Fn(&ControlPolygon<P>, P::Scalar) -> Refined<P>,
    polygon: &ControlPolygon<P>,
    tension: P::Scalar,
) -> Sides<P::Scalar> {
    let whole = P::Scalar::from_integer;
    let sides = Sides::new(format!("w = {tension}, {polygon:?}"));
    let Ok(refined) = implementation(polygon, tension.clone()) else {
        return sides.equal("the polygon is refined", [], [whole(1)], Rounding::none());
    };
    let count = polygon.vertices().len() as i64;
    let legs = match polygon.closing() {
        Closing::Closed => 0..count,
        Closing::Open => 1..count - 2,
    };
    let vertex = |i: i64| polygon.vertex(i).cloned();
    let kept: Vec<P> = match polygon.closing() {
        Closing::Closed => polygon.vertices().to_vec(),
        Closing::Open => polygon.vertices()[1..polygon.vertices().len() - 1].to_vec(),
    };
    let excess = tension.clone() - P::Scalar::from_ratio(1, 16);
    let expected = |i: i64| -> Option<P> {
        let points = [vertex(i - 1)?, vertex(i)?, vertex(i + 1)?, vertex(i + 2)?];
        let middle = neville_at_half(&points);
        Some(P::from_fn(|k| {
            let [a, b, c, d] = points.each_ref().map(|p| p.coordinates()[k].clone());
            middle.coordinates()[k].clone() + excess.clone() * ((b + c) - (a + d))
        }))
    };
    let new: Vec<P> = legs.filter_map(expected).collect();
    let found = |parity: usize| -> Vec<P> {
        let all = refined.vertices().iter();
        all.skip(parity).step_by(2).cloned().collect()
    };
    let size = magnitude(polygon.vertices()) * (16.0 + 8.0 * (tension.magnitude() + 1.0));
    sides
        .equal(
            "old points stay",
            flat(&found(0)),
            flat(&kept),
            Rounding::none(),
        )
        .equal(
            "new points lie on cubics",
            flat(&found(1)),
            flat(&new),
            Rounding::new(5 + 12 + 6, size),
        )
        .equal(
            "it stays open or closed",
            [whole(i64::from(refined.is_closed()))],
            [whole(i64::from(polygon.is_closed()))],
            Rounding::none(),
        )
}

/// The value at 1/2 of the cubic through four points at −1, 0, 1, 2.
fn neville_at_half<P: Affine>(points: &[P; 4]) -> P {
    let half = |p: i64| P::Scalar::from_ratio(p, 2);
    let sixth = |p: i64| P::Scalar::from_ratio(p, 6);
    let [a, b, c, d] = points;
    // Over [i, i + m] the parameter 1/2 is at the fraction (1/2 − i)/m.
    let linear = [a.lerp(b, half(3)), b.lerp(c, half(1)), c.lerp(d, half(-1))];
    let quadratic = [
        linear[0].lerp(&linear[1], P::Scalar::from_ratio(3, 4)),
        linear[1].lerp(&linear[2], P::Scalar::from_ratio(1, 4)),
    ];
    quadratic[0].lerp(&quadratic[1], sixth(3))
}

/// `subdivision-four-point-convergence`: with w = 1/16 the points stay, cubics are kept, quartics are not, and
/// 4ᵏ times the second difference at a single point 1 among zeros is −2 − 3k/2.
///
/// `implementation(polygon, w)` must make one step. `cubic` holds the coefficients of 1, t, t², t³.
///
/// # Rounding
///
/// A step has at most 5 roundings a term, and weights whose absolute values sum to 5/4.
/// The values of the cubic come by Horner's scheme, 6 roundings; the parameters are dyadic and exact.
/// The second difference has 2 more, but is multiplied by 4ᵏ.
pub fn four_point_convergence<T: OrderedScalar>(
    implementation: impl Fn(&ControlPolygon<T>, T) -> Refined<T>,
    cubic: &[T; 4],
    steps: u32,
) -> Sides<T> {
    let sixteenth = T::from_ratio(1, 16);
    let refine = |polygon: ControlPolygon<T>| {
        (0..steps).try_fold(polygon, |polygon, _| {
            implementation(&polygon, sixteenth.clone())
        })
    };
    let value = |t: T| {
        let horner = |sum: T, c: &T| sum * t.clone() + c.clone();
        cubic.iter().rev().fold(T::zero(), horner)
    };
    let whole = T::from_integer;
    // Two phantom points at each end; what is left begins at 0 and ends at 3.
    let open = |f: &dyn Fn(i64) -> T| ControlPolygon::open((-2..=5).map(f));
    let kept = open(&|i| value(whole(i))).and_then(&refine);
    let quartic = open(&|i| whole(i * i * i * i)).and_then(&refine);
    let single = open(&|i| whole(i64::from(i == 1))).and_then(&refine);
    let sides = Sides::new(format!("{steps} steps, the cubic {cubic:?}"));
    let (Ok(kept), Ok(quartic), Ok(single)) = (kept, quartic, single) else {
        return sides.equal("the polygons are refined", [], [whole(1)], Rounding::none());
    };
    let parts = 1_i64 << steps;
    // After k steps the point number i, with the remaining phantom points, belongs to the parameter (i − 2)/2ᵏ.
    let parameters = (0..kept.vertices().len() as i64).map(|i| T::from_ratio(i - 2, parts));
    let coefficients: f64 = cubic.iter().map(Scalar::magnitude).sum();
    let growth = f64::from(steps).exp2();
    let rounding = Rounding::new(5 * steps as usize + 12, 2.0 * growth * 125.0 * coefficients);
    let at = |polygon: &ControlPolygon<T>, parameter: i64, beside: i64| {
        let index = 2 + parameter * parts + beside;
        polygon.vertex(index).cloned().unwrap_or_else(T::zero)
    };
    let second = at(&single, 1, 1) - whole(2) * at(&single, 1, 0) + at(&single, 1, -1);
    let scale = whole(parts * parts);
    let sides = sides
        .equal(
            "cubics are kept",
            kept.vertices().to_vec(),
            parameters.map(value),
            rounding,
        )
        .equal(
            "points stay",
            (0..=3).map(|i| at(&quartic, i, 0)),
            (0..=3).map(|i| whole(i * i * i * i)),
            Rounding::none(),
        )
        .equal(
            "4^k times the second difference",
            [second * scale.clone()],
            [-(whole(2) + T::from_ratio(3 * i64::from(steps), 2))],
            Rounding::new(5 * steps as usize + 5, 4.0 * growth * scale.magnitude()),
        );
    if steps == 0 {
        return sides;
    }
    sides.equal(
        "of t⁴ the value at 1/2 becomes −1/2",
        [at(&quartic, 0, parts / 2)],
        [T::from_ratio(-1, 2)],
        Rounding::none(),
    )
}

/// `subdivision-four-point-tension`: weights, ‖S_b²‖ and the determinant that is 0 at w*.
///
/// `implementation(w)` must give the mask of the scheme; 0 < w < 1/2.
pub fn four_point_tension(
    implementation: impl Fn(BigRational) -> Option<Mask<BigRational>>,
    tension: &BigRational,
) -> Sides<BigRational> {
    let sides = Sides::new(format!("w = {tension}"));
    let w = || tension.clone();
    let whole = |n: i64| ratio(n, 1);
    let missing = |sides: Sides<BigRational>, what: &str| {
        sides.equal(what, [], [BigRational::one()], Rounding::none())
    };
    let Some(mask) = implementation(w()) else {
        return missing(sides, "there is a mask");
    };
    let sum = |parity: i64| {
        let rule = mask.rule(parity).into_iter();
        rule.fold(BigRational::zero(), |sum, (_, weight)| sum + weight)
    };
    let sides = sides.equal(
        "the weights of both rules sum to 1",
        [sum(0), sum(1)],
        [whole(1), whole(1)],
        Rounding::none(),
    );
    let Some(b) = mask
        .divided_difference_scheme(1)
        .and_then(|scheme| scheme.difference_scheme())
    else {
        return missing(sides, "(1 + z)² divides the symbol");
    };
    let square = w() * w();
    let cube = square.clone() * w();
    let formula = OrderedScalar::max(
        whole(1) - whole(4) * w(),
        whole(4) * w() + whole(16) * square.clone(),
    );
    let contractive = |holds: bool| [whole(i64::from(holds))];
    // Four successive differences give the next four, in two ways.
    let start = b.support().start;
    let window = |first: i64| -> Vec<Vec<BigRational>> {
        let row = |i: i64| (0..4).map(|j| b.coefficient(i - 2 * j)).collect();
        (first..first + 4).map(row).collect()
    };
    let [b0, b1] = [window(start + 3), window(start + 4)];
    let mut defect: Vec<Vec<BigRational>> = (0..4)
        .map(|i| {
            let entry = |j: usize| -> BigRational {
                let product = (0..4).map(|k| &b0[i][k] * &b1[k][j]);
                -product.sum::<BigRational>()
            };
            (0..4).map(entry).collect()
        })
        .collect();
    for (i, row) in defect.iter_mut().enumerate() {
        row[i] += BigRational::one();
    }
    let norm = b.norm(2);
    sides
        .equal(
            "‖S_b²‖ = max(1 − 4w, 4w + 16w²)",
            [norm.clone()],
            [formula],
            Rounding::none(),
        )
        .equal(
            "it is below 1 exactly for w < (√5 − 1)/8, that is 16w² + 4w < 1",
            contractive(norm < whole(1)),
            contractive(whole(16) * square.clone() + whole(4) * w() < whole(1)),
            Rounding::none(),
        )
        .equal(
            "det(I − B₀B₁) = (32w³ + 4w − 1)(32w³ − 16w² − 1)",
            [determinant(defect)],
            [(whole(32) * cube.clone() + whole(4) * w() - whole(1))
                * (whole(32) * cube - whole(16) * square - whole(1))],
            Rounding::none(),
        )
}

/// The norms ‖S_bᴸ‖ of the four-point scheme with w = 1/16 for L = 1, …, 6 as numerators over 64, for k = 1,
/// computed by hand.
const FIRST_ORDER_NORMS: [i64; 6] = [64, 48, 32, 20, 12, 7];

/// `subdivision-four-point-analysis`: the norms for k = 1 and k = 2, the eigenvalues, and what they say of any data.
///
/// `norm(mask, L)` must give the norm of L steps, `matrix(mask)` the local subdivision matrix.
/// The tables were computed with pencil and paper. `data` are numbers on the whole parameters, 0 elsewhere.
pub fn four_point_analysis(
    norm: impl Fn(&Mask<BigRational>, usize) -> BigRational,
    matrix: impl Fn(&Mask<BigRational>) -> LocalMatrix<BigRational>,
    data: &LaurentPolynomial<BigRational>,
) -> Sides<BigRational> {
    let whole = |n: i64| ratio(n, 1);
    let mask = Mask::from_symbol(
        LaurentPolynomial::one_plus_z_to(4)
            .shifted(-3)
            .scaled(&ratio(-1, 16)),
    );
    let mask = mask.and_then(|power| {
        let rest = LaurentPolynomial::new(0, [1, -4, 1].map(whole));
        Mask::from_symbol(power.symbol() * &rest)
    });
    let sides = Sides::new(format!("data {data}"));
    let scheme = |order: usize| mask.as_ref().ok()?.divided_difference_scheme(order);
    let (Ok(mask), Some(first), Some(second)) = (&mask, scheme(1), scheme(2)) else {
        return sides.equal("the symbol factors", [], [whole(1)], Rounding::none());
    };
    let steps = 1..=6_usize;
    let differences =
        |scheme: &Mask<BigRational>| scheme.difference_scheme().unwrap_or_else(|| scheme.clone());
    let norms = |scheme: &Mask<BigRational>| -> Vec<BigRational> {
        steps.clone().map(|l| norm(scheme, l)).collect()
    };
    let table = FIRST_ORDER_NORMS.map(|n| ratio(n, 64));
    let local = matrix(mask);
    let eigenvalues = [(1, 1), (1, 2), (1, 4), (1, 4), (1, 8)].map(|(p, q)| ratio(p, q));
    let samples = || (0..=5).map(whole);
    let characteristic = |at: BigRational| {
        let factors = eigenvalues.iter().map(|eigenvalue| eigenvalue - &at);
        factors.product::<BigRational>()
    };
    // Δ(2ʲΔpʲ) after j steps, for any data.
    let delta = |p: &LaurentPolynomial<BigRational>| p - &p.shifted(1);
    let size = |p: &LaurentPolynomial<BigRational>| {
        let values = p.coefficients().iter().map(OrderedScalar::abs);
        values.fold(BigRational::zero(), OrderedScalar::max)
    };
    let mut refined = data.clone();
    let mut found = Vec::new();
    for l in 1..=6 {
        refined = mask.apply(&refined);
        found.push(size(&delta(&delta(&refined)).scaled(&whole(1 << l))));
    }
    let before = size(&delta(&delta(data)));
    sides
        .equal(
            "norms for k = 1",
            norms(&differences(&first)),
            table.clone(),
            Rounding::none(),
        )
        .equal(
            "norms for k = 2",
            norms(&differences(&second)),
            vec![whole(1); 6],
            Rounding::none(),
        )
        .equal(
            "norms of the second divided differences",
            norms(&second),
            (2..=7).map(whole),
            Rounding::none(),
        )
        .equal(
            "eigenvalues 1, 1/2, 1/4, 1/4, 1/8",
            samples().map(|at| local.characteristic(&at)),
            samples().map(characteristic),
            Rounding::none(),
        )
        .equal(
            "a single eigenvector for 1/4",
            [whole(local.right_eigenvectors(&ratio(1, 4)).len() as i64)],
            [whole(1)],
            Rounding::none(),
        )
        .at_most(
            "neighbouring first divided differences get closer by the norms",
            found,
            table.map(|norm| norm * before.clone()),
            Rounding::none(),
        )
}

/// `subdivision-linear-precision`: the points o + sⱼ·d are refined to o + s′ᵢ·d, where s′ is what the numbers s are refined to.
///
/// `points(mask, …)` and `numbers(mask, …)` must make one step for a closed polygon.
/// So they stay on the line through o in the direction d.
///
/// # Rounding
///
/// o + s·d has 2 roundings and a size of at most |o| + |s|·|d|; a rule of m weights has m more.
/// Weights have absolute values that sum to at most ‖S‖.
pub fn linear_precision<T: OrderedScalar>(
    points: impl Fn(&Mask<T>, &[Point<T, 2>]) -> Option<Vec<Point<T, 2>>>,
    numbers: impl Fn(&Mask<T>, &[T]) -> Option<Vec<T>>,
    mask: &Mask<T>,
    line: &[Point<T, 2>; 2],
    places: &[T],
) -> Sides<T> {
    let sides = Sides::new(format!("{mask}, {line:?}, {places:?}"));
    let [start, end] = line;
    let direction = end.difference(start);
    let on_line = |s: &T| start.clone() + direction.clone() * s.clone();
    let polygon: Vec<Point<T, 2>> = places.iter().map(on_line).collect();
    let (Some(refined), Some(moved)) = (points(mask, &polygon), numbers(mask, places)) else {
        return sides.equal("the polygon is refined", [], [T::one()], Rounding::none());
    };
    let expected: Vec<Point<T, 2>> = moved.iter().map(on_line).collect();
    let reach = places.iter().map(Scalar::magnitude).fold(0.0, f64::max);
    let size = magnitude(&line[..1]) + 2.0 * reach * magnitude(line);
    let weights = mask.norm(1).magnitude();
    let length = mask.symbol().coefficients().len();
    sides.equal(
        "points on a line stay on it",
        flat(&refined),
        flat(&expected),
        Rounding::new(2 * length + 6, 2.0 * weights.max(1.0) * size),
    )
}
