//! Laws of Kobbelt's scheme.

use num_traits::Zero;

use super::catmull_clark::{Refined, flat, largest, refused, shown, tensor_product};
use crate::affine::Affine;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;
use crate::subdivision::Mesh;

/// `subdivision-kobbelt`: with the virtual points, both ways to a face point give the same at every face of a vertex.
///
/// `implementation(neighbours, opposite)` must give the point beyond the vertex on the edge to `neighbours[0]`; the law
/// rotates the lists for the other edges. With α = 9/16 and β = −1/16 it claims for each i
///
/// ```text
/// αβ(vᵢ + lᵢ₋₁) + β²qᵢ₋₂ = αβ(vᵢ₊₁ + lᵢ₊₂) + β²qᵢ₊₂,
/// ```
///
/// what the two ways do not share; and v₀ = l₂ for four neighbours.
///
/// # Arguments
///
/// `neighbours` and `opposite`: n ≥ 3 points each, counterclockwise, qⱼ in the face of lⱼ and lⱼ₊₁.
///
/// # Rounding
///
/// A virtual point is a sum of 2n terms, each with a weight that passes at most 5 roundings and is at most 4/n + 1; the
/// law multiplies by αβ and adds two terms.
///
/// # Panics
///
/// If the lists differ in length.
pub fn kobbelt<P: Affine>(
    implementation: impl Fn(&[P], &[P]) -> P,
    neighbours: &[P],
    opposite: &[P],
) -> Sides<P::Scalar> {
    assert_eq!(
        neighbours.len(),
        opposite.len(),
        "as many opposite points as neighbours"
    );
    let n = neighbours.len();
    let size = largest(neighbours).max(largest(opposite));
    let virtual_points: Vec<P> = (0..n)
        .map(|i| {
            let rotated = |points: &[P]| [&points[i..], &points[..i]].concat();
            implementation(&rotated(neighbours), &rotated(opposite))
        })
        .collect();
    let [side, corner] = [-9, 1].map(|part| P::Scalar::from_ratio(part, 256));
    let way = |near: [&P; 2], far: &P| -> Vec<P::Scalar> {
        let coordinates = near[0].coordinates().iter().zip(near[1].coordinates());
        coordinates
            .zip(far.coordinates())
            .map(|((a, b), c)| side.clone() * (a.clone() + b.clone()) + corner.clone() * c.clone())
            .collect()
    };
    let around = |points: &'_ [P], i: usize| points[i % n].clone();
    let rounding = Rounding::new(2 * n + 12, 14.0 * size);
    let input = format!("neighbours {neighbours:?}, opposite {opposite:?}");
    let sides = (0..n).fold(Sides::new(input), |sides, i| {
        let one = [&virtual_points[i], &around(neighbours, i + n - 1)];
        let other = [&virtual_points[(i + 1) % n], &around(neighbours, i + 2)];
        sides.equal(
            format!("both ways in face {i}"),
            way(one, &around(opposite, i + n - 2)),
            way(other, &around(opposite, i + 2)),
            rounding,
        )
    });
    match n {
        4 => sides.equal(
            "the vertex straight beyond",
            flat([&virtual_points[0]]),
            flat([&neighbours[2]]),
            rounding,
        ),
        _ => sides,
    }
}

/// `subdivision-kobbelt`: an edge or face whose vertices are regular has the product weights.
///
/// `implementation(mesh)` must give the refined mesh: old vertices, edge points, face points.
/// The grid is closed: `columns` · `rows` points, row by row, each number at least 3; the mesh is the torus.
///
/// # Rounding
///
/// Each side passes at most 40 roundings of terms whose weights have absolute values that sum to at most (5/4)².
pub fn kobbelt_tensor_product<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    columns: usize,
    rows: usize,
    points: &[P],
) -> Sides<P::Scalar> {
    tensor_product(implementation, four_point_step, columns, rows, points)
}

/// One step of the four-point scheme on a closed polygon, old vertices first.
fn four_point_step<P: Affine>(polygon: &[P]) -> [Vec<P>; 2] {
    let k = polygon.len();
    let edge = |i: usize| {
        P::from_fn(|axis| {
            let terms = [(-1, i + k - 1), (9, i), (9, i + 1), (-1, i + 2)];
            terms
                .into_iter()
                .fold(P::Scalar::zero(), |sum, (weight, i)| {
                    sum + P::Scalar::from_ratio(weight, 16)
                        * polygon[i % k].coordinates()[axis].clone()
                })
        })
    };
    [polygon.to_vec(), (0..k).map(edge).collect()]
}

/// `subdivision-kobbelt-properties`: old vertices are kept, every face is split into four, and new vertices are regular.
///
/// `implementation(mesh)` must give the refined mesh, old vertices first.
///
/// # Rounding
///
/// None: old vertices stay as they are.
pub fn kobbelt_properties<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    mesh: &Mesh<P>,
) -> Sides<P::Scalar> {
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let refined = match implementation(mesh) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let new = refined.connectivity();
    let whole = |n: usize| P::Scalar::from_integer(n as i64);
    let valences = old.vertices().map(|v| old.valence(v));
    let regular = std::iter::repeat_n(4, old.edge_count() + old.face_count());
    sides
        .equal(
            "old vertices are kept",
            flat(refined.points().iter().take(old.vertex_count())),
            flat(mesh.points()),
            Rounding::none(),
        )
        .equal(
            "every face is split into four",
            [whole(new.face_count())],
            [whole(4 * old.face_count())],
            Rounding::none(),
        )
        .equal(
            "old valences stay, new vertices are regular",
            new.vertices().map(|v| whole(new.valence(v))),
            valences.chain(regular).map(whole),
            Rounding::none(),
        )
}
