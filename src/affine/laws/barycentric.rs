//! Laws of barycentric coordinates.

use num_traits::{One, Zero};

use super::{indicator, largest, sums};
use crate::affine::{
    Affine, AffineBasis, Frame, Linear, Point, Vector, plane_determinant, signed_area,
};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// Roundings of coordinates by elimination and of the combination that they give, for up to two dimensions.
///
/// Let E·λ = f with two rows (a b | e), (c d | f), |a| ≥ |c|, be solved by elimination with 3 operations a step. With
/// m = c/a, |m| ≤ 1, the unknown y passes m·b, d − m·b, m·e, f − m·e and a division: 9 roundings of terms that are at
/// most |d·y| + |b·y| + |f| + |e| together. The unknown x passes b/d′, times f′, a difference and a division, and the 5
/// of y: 9 more. Entries of E and of the right side are differences with 1 rounding each, 3 together in a product of
/// three. λ₀ = 1 − Σ λᵢ adds D, the sum Σ λᵢpᵢ adds D + 2. That is 9 + 9 + 3 + 2 + 4 = 27.
const ELIMINATION: usize = 27;

/// The sum of the magnitudes in [`ELIMINATION`]: two rows of |edges|·|λ| and the right side, every coordinate at most M,
/// every edge and the right side at most 2M; then the combination, Σ|λᵢ|·M, beside x.
fn elimination_terms<T: Scalar>(lambda: &[T], size: f64) -> f64 {
    let (_, magnitude) = sums(lambda);
    (2.0 * (2.0 * magnitude + 2.0) + magnitude + 1.0) * size
}

/// `affine-basis-barycentric-coordinates`: Σ λᵢ = 1 and Σ λᵢAᵢ = P, and there are no other such numbers.
///
/// `implementation(basis, point)` must give the coordinates λ of a point. The law asks for those of P = Σ αᵢAᵢ,
/// where α = `weights` sum to 1 without rounding.
///
/// # Rounding
///
/// Σ λᵢAᵢ misses P by elimination as derived at `ELIMINATION`, for D ≤ 2; P itself passes D + 2. By the inverse E⁻¹ of the
/// matrix of edges, that is by the coordinates of steps along the axes, this error becomes one of the λᵢ.
pub fn basis_barycentric_coordinates<T: Scalar, const D: usize>(
    implementation: impl Fn(&AffineBasis<T, D>, &Point<T, D>) -> Vec<T>,
    basis: &AffineBasis<T, D>,
    weights: &[T],
) -> Sides<T> {
    let points = basis.points();
    let combination = |weights: &[T]| {
        Point::new(std::array::from_fn(|k| {
            std::iter::zip(weights, points).fold(T::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point[k].clone()
            })
        }))
    };
    let place: Point<T, D> = combination(weights);
    let lambda = implementation(basis, &place);
    let size = largest(points).max(largest([&place]));
    let (sum, magnitude) = sums(&lambda);
    let terms = elimination_terms(&lambda, size) + elimination_terms(weights, size);
    Sides::new(format!("basis {points:?}, α = {weights:?}, P = {place}"))
        .equal(
            "the coordinates sum to 1",
            [sum],
            [T::one()],
            Rounding::new(2 * D + 2, 1.0 + 2.0 * magnitude),
        )
        .equal(
            "the coordinates give the point",
            combination(&lambda).coordinates().to_vec(),
            place.coordinates().to_vec(),
            Rounding::new(ELIMINATION, terms),
        )
        .equal(
            "no other numbers do",
            lambda,
            weights.to_vec(),
            Rounding::new(
                ELIMINATION + D + 2,
                terms * D as f64 * inverse_of_edges(basis) + 1.0 + magnitude,
            ),
        )
}

/// A bound for the entries of E⁻¹, where the columns of E are the edges of the basis: the change of a coordinate when
/// a point moves by 1 along an axis, found from a step as long as the basis is large.
fn inverse_of_edges<T: Scalar, const D: usize>(basis: &AffineBasis<T, D>) -> f64 {
    if T::EXACT {
        // Exact numbers ignore every bound.
        return 0.0;
    }
    let start = &basis.points()[0];
    let step = basis
        .frame()
        .axes()
        .iter()
        .flat_map(|axis| axis.iter().cloned())
        .max_by(|x, y| x.magnitude().total_cmp(&y.magnitude()))
        .unwrap_or_else(T::one);
    let length = step.magnitude();
    (0..D)
        .flat_map(|k| {
            let axis = Vector::from_fn(|row, _| if row == k { step.clone() } else { T::zero() });
            basis.coordinates(&start.translated(&axis))
        })
        .map(|coordinate| (coordinate.magnitude() + 1.0) / length)
        .fold(0.0, f64::max)
}

/// `affine-frame-equivalence`: P = Σ αᵢAᵢ has the Cartesian coordinates (α₁, …, α_D) in the frame of A₀ and the vectors
/// Aᵢ − A₀, and α₀ = 1 − Σ αᵢ.
///
/// `implementation(basis)` must give that frame. The weights must sum to 1 without rounding.
///
/// # Rounding
///
/// As for [`basis_barycentric_coordinates`]; the point of the frame passes D + 2 roundings.
pub fn frame_equivalence<T: Scalar, const D: usize>(
    implementation: impl Fn(&AffineBasis<T, D>) -> Frame<T, D>,
    basis: &AffineBasis<T, D>,
    weights: &[T],
) -> Sides<T> {
    let points = basis.points();
    let place = Point::<T, D>::new(std::array::from_fn(|k| {
        std::iter::zip(weights, points).fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    }));
    let frame = implementation(basis);
    let cartesian: [T; D] = std::array::from_fn(|i| weights[i + 1].clone());
    let found = frame.coordinates(&place);
    let size = largest(points).max(largest([&place]));
    let terms = elimination_terms(&found, size) + elimination_terms(weights, size);
    let roundings = ELIMINATION + D + 2;
    let coordinates = Rounding::new(
        roundings,
        (D + 1) as f64 * (terms * D as f64 * inverse_of_edges(basis) + 2.0),
    );
    let rest = found
        .iter()
        .fold(T::one(), |rest, coordinate| rest - coordinate.clone());
    Sides::new(format!("basis {points:?}, α = {weights:?}, P = {place}"))
        .equal(
            "A₀ + Σ αᵢ(Aᵢ − A₀) is the point",
            frame.point(&cartesian).coordinates().to_vec(),
            place.coordinates().to_vec(),
            Rounding::new(roundings, terms),
        )
        .equal(
            "the Cartesian coordinates are α₁, …, α_D",
            found,
            cartesian,
            coordinates,
        )
        .equal(
            "α₀ is 1 minus their sum",
            [rest],
            [weights[0].clone()],
            coordinates,
        )
}

/// `affine-frame-equivalence`, the other half: three points of the plane are an affine basis exactly if A₁ − A₀ and
/// A₂ − A₀ are a basis of the vectors, that is, if their determinant is not 0.
///
/// `implementation(points)` must tell whether they are an affine basis. The determinant must be free of rounding.
///
/// # Rounding
///
/// None: see above.
pub fn basis_of_differences<T: Scalar>(
    implementation: impl Fn(&[Point<T, 2>; 3]) -> bool,
    points: &[Point<T, 2>; 3],
) -> Sides<T> {
    let [a, b, c] = points;
    let determinant = plane_determinant(&b.difference(a), &c.difference(a));
    Sides::new(format!("{points:?}")).equal(
        "an affine basis exactly if the differences are independent",
        [indicator(implementation(points))],
        [indicator(!determinant.is_zero())],
        Rounding::none(),
    )
}

/// `affine-barycentric-on-line`: for G = αA + βB on the line, α + β = 1, B − G = α(B − A), G − A = β(B − A), and
/// (G − A) : (B − G) = β : α.
///
/// `implementation(a, b, g)` must give (α, β), or nothing if there are none; the law asks for G = (1 − t)A + tB, A ≠ B.
///
/// # Rounding
///
/// G passes 3 roundings a term, so the sides of each claim have them too; the coordinates are differences divided by
/// the longest component of B − A, 3 roundings, and each claim multiplies once and takes differences.
/// All terms are at most |1 − t| + |t| + 1 times the largest coordinate, in both vectors: the products below add 2|β|.
/// The last claim multiplies them by |α| or |β| once more. The sum of the coordinates has a rounded G in it, in units of B − A.
pub fn barycentric_on_line<P: Affine>(
    implementation: impl Fn(&P, &P, &P) -> Option<[P::Scalar; 2]>,
    [a, b]: [&P; 2],
    t: &P::Scalar,
) -> Sides<P::Scalar> {
    let g = a.lerp(b, t.clone());
    let sides = Sides::new(format!("A = {a:?}, B = {b:?}, t = {t}, G = {g:?}"));
    let Some([alpha, beta]) = implementation(a, b, &g) else {
        return sides.equal(
            "a point of the line has coordinates",
            [P::Scalar::zero()],
            [P::Scalar::one()],
            Rounding::none(),
        );
    };
    let size = largest([a, b]);
    let reach = 1.0 + t.magnitude() + (P::Scalar::one() - t.clone()).magnitude();
    let whole = b.difference(a);
    let [to_b, from_a] = [b.difference(&g), g.difference(a)];
    let scaled = |vector: &P::Difference, factor: &P::Scalar| {
        vector.scaled(factor.clone()).coordinates().to_vec()
    };
    let rounding = Rounding::new(12, 4.0 * reach * size);
    // G − A and B − G have the rounding of G, which the quotient measures in lengths |B − A|.
    let in_lengths = reach * (1.0 + 2.0 * size / largest([&whole]));
    sides
        .equal(
            "α + β = 1",
            [alpha.clone() + beta.clone()],
            [P::Scalar::one()],
            Rounding::new(12, in_lengths),
        )
        .equal(
            "B − G = α(B − A)",
            to_b.coordinates().to_vec(),
            scaled(&whole, &alpha),
            rounding,
        )
        .equal(
            "G − A = β(B − A)",
            from_a.coordinates().to_vec(),
            scaled(&whole, &beta),
            rounding,
        )
        .equal(
            "(G − A) : (B − G) = β : α",
            scaled(&from_a, &alpha),
            scaled(&to_b, &beta),
            Rounding::new(14, 4.0 * reach * reach * size * in_lengths),
        )
}

/// `affine-barycentric-in-triangle`: α = \[GBC\]/\[ABC\], β = \[AGC\]/\[ABC\], γ = \[ABG\]/\[ABC\] with signed areas.
///
/// `implementation(triangle, g)` must give (α, β, γ) with respect to corners that are not collinear.
///
/// # Rounding
///
/// Multiplied by the determinant 2\[ABC\], an error of the coordinates by elimination (see `ELIMINATION`) becomes one of its
/// residual times the edges, which are at most 2M. An area passes 5 roundings, with terms at most 8M².
pub fn barycentric_in_triangle<T: Scalar>(
    implementation: impl Fn(&[Point<T, 2>; 3], &Point<T, 2>) -> [T; 3],
    triangle: &[Point<T, 2>; 3],
    g: &Point<T, 2>,
) -> Sides<T> {
    let [a, b, c] = triangle;
    let coordinates = implementation(triangle, g);
    let size = largest(triangle).max(largest([g]));
    let terms = elimination_terms(&coordinates, size);
    let area = signed_area(a, b, c);
    let (sum, magnitude) = sums(&coordinates);
    Sides::new(format!("A = {a}, B = {b}, C = {c}, G = {g}"))
        .equal(
            "the coordinates are the ratios of the areas opposite the corners",
            coordinates.map(|coordinate| coordinate * area.clone()),
            [
                signed_area(g, b, c),
                signed_area(a, g, c),
                signed_area(a, b, g),
            ],
            Rounding::new(
                ELIMINATION + 10,
                3.0 * (4.0 * size * terms + 8.0 * size * size),
            ),
        )
        .equal(
            "they sum to 1",
            [sum * area.clone()],
            [area.clone()],
            Rounding::new(
                ELIMINATION + 10,
                3.0 * (4.0 * size * terms + 8.0 * size * size) + magnitude * area.magnitude(),
            ),
        )
}
