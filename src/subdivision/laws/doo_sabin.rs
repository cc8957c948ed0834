//! Laws of Doo–Sabin subdivision.

use num_traits::{One, Zero};

use super::catmull_clark::{Refined, flat, largest, refused, shown};
use crate::affine::Affine;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;
use crate::subdivision::{CosineError, CosineOfTurn, Mesh};

/// Σ points / k.
fn centroid<P: Affine>(points: &[P]) -> P {
    let k = P::Scalar::from_integer(points.len() as i64);
    P::from_fn(|axis| {
        let coordinates = points.iter().map(|p| p.coordinates()[axis].clone());
        coordinates.fold(P::Scalar::zero(), |sum, x| sum + x) / k.clone()
    })
}

/// `subdivision-doo-sabin`: every new vertex is its face's combination, and every new face has the right corners.
///
/// `implementation(mesh)` must give the refined mesh; the new vertex of half-edge h has the number h, and the new faces
/// are those of faces, of inner edges and of inner vertices.
/// The combination is claimed as 4k·v′ᵢ = k vᵢ + 3Σ vⱼ + 2Σ cos(2π(j − i)/k) vⱼ.
///
/// # Rounding
///
/// A new point passes at most 2k + 20 roundings (16 of them for the cosine), and both sides are at most 4k·3·M.
pub fn doo_sabin<P>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    mesh: &Mesh<P>,
) -> Sides<P::Scalar>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let refined = match implementation(mesh) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let whole = |n: usize| P::Scalar::from_integer(n as i64);
    let mut found = vec![];
    let mut expected = vec![];
    let mut widest = 3;
    for f in old.faces() {
        let corners: Vec<&P> = mesh.face_points(f).collect();
        let k = corners.len();
        widest = widest.max(k);
        for (i, h) in old.face_half_edges(f).enumerate() {
            let Some(point) = refined.points().get(h.index()) else {
                continue;
            };
            for (axis, x) in point.coordinates().iter().enumerate() {
                let mut sum = whole(k) * corners[i].coordinates()[axis].clone();
                for (j, corner) in corners.iter().enumerate() {
                    let wave = P::Scalar::cosine_of_turn(j as i64 - i as i64, k);
                    let wave = match wave {
                        Ok(wave) => wave,
                        Err(error) => return refused(sides, &error),
                    };
                    let weight = whole(3) + whole(2) * wave;
                    sum += weight * corner.coordinates()[axis].clone();
                }
                found.push(whole(4 * k) * x.clone());
                expected.push(sum);
            }
        }
    }
    let counts = |numbers: Vec<usize>| numbers.into_iter().map(whole).collect::<Vec<_>>();
    let new = refined.connectivity();
    let inner_edges = old.edges().filter(|&e| !old.is_boundary_edge(e));
    let inner_vertices = old.vertices().filter(|&v| !old.is_boundary(v));
    let face_sizes = old.faces().map(|f| old.face_degree(f));
    let sizes = face_sizes
        .chain(inner_edges.map(|_| 4))
        .chain(inner_vertices.map(|v| old.valence(v)));
    let inside = new.faces().take(old.face_count());
    let corners = inside.flat_map(|f| new.face_vertices(f)).map(|v| v.index());
    sides
        .equal(
            "4k·v′ᵢ = k vᵢ + Σ (3 + 2cos(2π(j − i)/k)) vⱼ",
            found,
            expected,
            Rounding::new(
                2 * widest + 24,
                12.0 * widest as f64 * largest(mesh.points()),
            ),
        )
        .equal(
            "a face for each face, inner edge and inner vertex, with its number of corners",
            counts(new.faces().map(|f| new.face_degree(f)).collect()),
            counts(sizes.collect()),
            Rounding::none(),
        )
        .equal(
            "the new face inside a face has the corners of the face",
            counts(corners.collect()),
            counts((0..old.corner_count()).collect()),
            Rounding::none(),
        )
}

/// `subdivision-doo-sabin-properties`: the rule of a face with k sides keeps the centroid, and has the eigenvalues 1, 1/2,
/// 1/2 and 1/4: the wave cos(2πmj/k) around the face is multiplied by its own.
///
/// `implementation(corners)` must give the corners of the new face. The corners of the law are `points`, and, one
/// coordinate at a time, the waves of all frequencies m = 0, …, k − 1, written as points along the first axis.
///
/// # Rounding
///
/// A corner is a sum of k terms with weights that sum to at most 2, with 16 roundings for each cosine in it.
pub fn doo_sabin_properties<P>(
    implementation: impl Fn(&[P]) -> Result<Vec<P>, CosineError>,
    points: &[P],
) -> Sides<P::Scalar>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let k = points.len();
    let sides = Sides::new(format!("{points:?}"));
    let new = match implementation(points) {
        Ok(new) => new,
        Err(error) => return refused(sides, &error),
    };
    let roundings = 3 * k + 24;
    let sides = sides.equal(
        "the centroid stays",
        flat([&centroid(&new)]),
        flat([&centroid(points)]),
        Rounding::new(roundings, 4.0 * largest(points)),
    );
    (0..k).fold(sides, |sides, m| {
        let wave = |j: usize| P::Scalar::cosine_of_turn((m * j) as i64, k);
        let waves: Result<Vec<P::Scalar>, CosineError> = (0..k).map(wave).collect();
        let claimed = waves.and_then(|waves| {
            let corners: Vec<P> = waves
                .iter()
                .map(|x| {
                    P::from_fn(|axis| match axis {
                        0 => x.clone(),
                        _ => P::Scalar::zero(),
                    })
                })
                .collect();
            let eigenvalue = match m {
                0 => P::Scalar::one(),
                m if m == 1 || m + 1 == k => P::Scalar::from_ratio(1, 2),
                _ => P::Scalar::from_ratio(1, 4),
            };
            let expected = corners
                .iter()
                .flat_map(|p| p.coordinates())
                .map(|x| eigenvalue.clone() * x.clone());
            Ok((
                flat(&implementation(&corners)?),
                expected.collect::<Vec<_>>(),
            ))
        });
        match claimed {
            Ok((found, expected)) => sides.equal(
                format!("the eigenvalue of frequency {m}"),
                found,
                expected,
                Rounding::new(roundings + 16, 4.0),
            ),
            Err(error) => refused(sides, &error),
        }
    })
}

/// `subdivision-doo-sabin-properties`: on a regular grid one step is Chaikin's, along the rows and along the columns.
///
/// `implementation(mesh)` must give the refined mesh, with the vertex of half-edge h at number h.
/// The grid is closed: `columns` · `rows` points, row by row, each number at least 3; the mesh is the torus.
///
/// # Rounding
///
/// Each side passes at most 16 roundings of terms with weights that sum to 1.
pub fn doo_sabin_chaikin<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    columns: usize,
    rows: usize,
    points: &[P],
) -> Sides<P::Scalar> {
    let connectivity = crate::subdivision::solids::torus_quadrilaterals(columns, rows);
    let sides = Sides::new(format!("{columns} × {rows} points {points:?}"));
    let refined = Mesh::new(connectivity.clone(), points.to_vec())
        .map_err(crate::subdivision::SchemeError::from)
        .and_then(|mesh| implementation(&mesh));
    let refined = match refined {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    // The new vertex at a corner has weight 3/4 on its own row and column, 1/4 on the other row and column of the face.
    let [near, far] = [3, 1].map(|n| P::Scalar::from_ratio(n, 4));
    let mut expected = vec![];
    for h in connectivity.half_edges() {
        let Some(face) = connectivity.face(h) else {
            continue;
        };
        let place = |v: crate::subdivision::VertexId| [v.index() % columns, v.index() / columns];
        let own = place(connectivity.origin(h));
        let corners: Vec<_> = connectivity.face_vertices(face).collect();
        let dimension = points[0].coordinates().len();
        for axis in 0..dimension {
            let terms = corners.iter().map(|&v| {
                let place = place(v);
                let weight = |same: bool| if same { near.clone() } else { far.clone() };
                weight(place[0] == own[0])
                    * weight(place[1] == own[1])
                    * points[v.index()].coordinates()[axis].clone()
            });
            expected.push(terms.fold(P::Scalar::zero(), |sum, term| sum + term));
        }
    }
    sides.equal(
        "the scheme is Chaikin's in both directions",
        flat(refined.points()),
        expected,
        Rounding::new(32, 4.0 * largest(points)),
    )
}
