//! Laws of Catmull–Clark subdivision, its limits and creases.

use num_traits::{One, Zero};

use crate::affine::Affine;
use crate::law::{Rounding, Sides};
use crate::scalar::{Real, Scalar};
use crate::subdivision::{
    CatmullClark, Creases, HalfEdgeMesh, Mesh, SchemeError, SurfaceScheme, VertexId, VertexRule,
    catmull_clark_tangent_factor,
};

/// What a scheme makes of a mesh.
pub type Refined<P> = Result<Mesh<P>, SchemeError>;

/// The coordinates of points, one after another.
pub(super) fn flat<'a, P: Affine>(points: impl IntoIterator<Item = &'a P>) -> Vec<P::Scalar> {
    let points = points.into_iter();
    points.flat_map(|p| p.coordinates().to_vec()).collect()
}

/// The largest absolute value of a coordinate.
pub(super) fn largest<P: Affine>(points: &[P]) -> f64 {
    let coordinates = points.iter().flat_map(|p| p.coordinates());
    coordinates.map(Scalar::magnitude).fold(0.0, f64::max)
}

/// Σ weight · point, by coordinates.
fn sum<'a, P: Affine>(terms: impl IntoIterator<Item = (P::Scalar, &'a P)>) -> Vec<P::Scalar> {
    let mut total: Vec<P::Scalar> = vec![];
    for (weight, point) in terms {
        let coordinates = point.coordinates();
        total.resize(coordinates.len(), P::Scalar::zero());
        for (total, x) in total.iter_mut().zip(coordinates) {
            *total = total.clone() + weight.clone() * x.clone();
        }
    }
    total
}

/// What a reader sees of a mesh.
pub(super) fn shown<P: Affine>(mesh: &Mesh<P>) -> String {
    format!(
        "faces {:?}, points {:?}",
        mesh.connectivity().face_lists(),
        mesh.points()
    )
}

/// A violation for an implementation that refuses its input: 1 = 0.
pub(super) fn refused<T: Scalar>(sides: Sides<T>, error: &impl std::fmt::Display) -> Sides<T> {
    sides.equal(
        format!("the scheme is defined here ({error})"),
        [T::one()],
        [T::zero()],
        Rounding::none(),
    )
}

/// `subdivision-catmull-clark`: every new point satisfies its rule.
///
/// `implementation(mesh)` must give the refined mesh, with the old vertices first, then the edges, then the faces.
/// The rules are claimed without fractions: m·f′ = Σ vertices of the face, 4·e′ = ends + face points beside it,
/// k·v′ = F + 2R + (k − 3)v with edge midpoints, 2·e′ = a + b and 8·v′ = a + 6v + b on the boundary.
///
/// # Rounding
///
/// A new point is a mean of means: with valences and faces up to n, at most 2n + 8 roundings of terms whose absolute
/// values sum to at most 8·n·M on both sides, where n·v′ is the largest claim.
pub fn catmull_clark<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    mesh: &Mesh<P>,
) -> Sides<P::Scalar> {
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let refined = match implementation(mesh) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let (v_count, e_count) = (old.vertex_count(), old.edge_count());
    let sides = sides.equal(
        "one point for each vertex, edge and face",
        [P::Scalar::from_integer(refined.points().len() as i64)],
        [P::Scalar::from_integer(
            (v_count + e_count + old.face_count()) as i64,
        )],
        Rounding::none(),
    );
    if refined.points().len() != v_count + e_count + old.face_count() {
        return sides;
    }
    let widest = old
        .vertices()
        .map(|v| old.valence(v))
        .chain(old.faces().map(|f| old.face_degree(f)))
        .max()
        .unwrap_or(3);
    let rounding = Rounding::new(2 * widest + 8, 8.0 * widest as f64 * largest(mesh.points()));
    let whole = |n: usize| P::Scalar::from_integer(n as i64);
    let one = P::Scalar::one;
    let new = refined.points();
    let face_point = |f: usize| &new[v_count + e_count + f];
    let mut found = [vec![], vec![], vec![]];
    let mut expected = [vec![], vec![], vec![]];
    let [vertices, edges, faces] = [0, 1, 2];
    for f in old.faces() {
        found[faces].extend(sum([(whole(old.face_degree(f)), face_point(f.index()))]));
        expected[faces].extend(sum(mesh.face_points(f).map(|p| (one(), p))));
    }
    for e in old.edges() {
        let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
        let h = old.edge_half_edge(e);
        let beside = [h, old.flip(h)].into_iter().filter_map(|h| old.face(h));
        let beside: Vec<&P> = beside.map(|f| face_point(f.index())).collect();
        let point = &new[v_count + e.index()];
        let boundary = beside.len() < 2;
        let count = if boundary { 2 } else { 4 };
        found[edges].extend(sum([(whole(count), point)]));
        let around = beside.into_iter().filter(|_| !boundary);
        expected[edges].extend(sum([a, b].into_iter().chain(around).map(|p| (one(), p))));
    }
    for v in old.vertices() {
        let (own, point) = (mesh.point(v), &new[v.index()]);
        let ring: Vec<_> = old.vertex_ring(v).collect();
        let end = |h| mesh.point(old.destination(h));
        if old.is_boundary(v) {
            let along = [ring[0], ring[ring.len() - 1]].map(end);
            found[vertices].extend(sum([(whole(8), point)]));
            let terms = [(one(), along[0]), (whole(6), own), (one(), along[1])];
            expected[vertices].extend(sum(terms));
            continue;
        }
        let k = ring.len();
        let share = one() / whole(k);
        let terms = ring.iter().flat_map(|&h| {
            let face = old.face(h).map(|f| (share.clone(), face_point(f.index())));
            // 2R = (2/k) Σ (v + e)/2.
            face.into_iter()
                .chain([(share.clone(), own), (share.clone(), end(h))])
        });
        let rest = (whole(k) - whole(3), own);
        found[vertices].extend(sum([(whole(k), point)]));
        expected[vertices].extend(sum(terms.chain([rest])));
    }
    let names = [
        "k·v′ = F + 2R + (k − 3)v",
        "4·e′ = ends and face points",
        "m·f′ = Σ vertices",
    ];
    let claims = names.into_iter().zip(found.into_iter().zip(expected));
    claims.fold(sides, |sides, (name, (found, expected))| {
        sides.equal(name, found, expected, rounding)
    })
}

/// `subdivision-catmull-clark-properties`: on a regular grid one step is the cubic subdivision of rows, then of columns.
///
/// `implementation(mesh)` must give the refined mesh in the order of [`catmull_clark`].
/// The grid is closed: `points` has `columns` · `rows` of them, row by row, each number at least 3; the mesh is the torus.
///
/// # Rounding
///
/// Each side passes at most 16 roundings of terms with weights that sum to 1.
///
/// # Panics
///
/// If there are not `columns` · `rows` points.
pub fn catmull_clark_properties<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    columns: usize,
    rows: usize,
    points: &[P],
) -> Sides<P::Scalar> {
    assert_eq!(
        points.len(),
        columns * rows,
        "one point for each place of the grid"
    );
    tensor_product(implementation, cubic_step, columns, rows, points)
}

/// One step of the cubic scheme on a closed polygon, old vertices first.
fn cubic_step<P: Affine>(polygon: &[P]) -> [Vec<P>; 2] {
    let k = polygon.len();
    let at = |terms: &[(i64, usize)], whole: i64| {
        P::from_fn(|axis| {
            terms.iter().fold(P::Scalar::zero(), |sum, &(weight, i)| {
                sum + P::Scalar::from_ratio(weight, whole)
                    * polygon[i % k].coordinates()[axis].clone()
            })
        })
    };
    let vertex = |i| at(&[(1, i + k - 1), (6, i), (1, i + 1)], 8);
    let edge = |i| at(&[(1, i), (1, i + 1)], 2);
    [(0..k).map(vertex).collect(), (0..k).map(edge).collect()]
}

/// Both ways of refining a closed grid of quadrilaterals agree: the scheme, and the rule for curves on rows and columns.
///
/// `step` refines a closed polygon: what becomes of its vertices, and of its edges from each vertex to the next.
pub(super) fn tensor_product<P: Affine>(
    implementation: impl Fn(&Mesh<P>) -> Refined<P>,
    step: impl Fn(&[P]) -> [Vec<P>; 2],
    columns: usize,
    rows: usize,
    points: &[P],
) -> Sides<P::Scalar> {
    let connectivity = crate::subdivision::solids::torus_quadrilaterals(columns, rows);
    let sides = Sides::new(format!("{columns} × {rows} points {points:?}"));
    let refined = Mesh::new(connectivity.clone(), points.to_vec())
        .map_err(SchemeError::from)
        .and_then(|mesh| implementation(&mesh));
    let refined = match refined {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    // finer[y][x] for half-integers: even places are old rows and columns.
    let interleaved = |[vertices, edges]: [Vec<P>; 2]| -> Vec<P> {
        vertices
            .into_iter()
            .zip(edges)
            .flat_map(|(v, e)| [v, e])
            .collect()
    };
    let by_rows: Vec<Vec<P>> = points
        .chunks_exact(columns)
        .map(|row| interleaved(step(row)))
        .collect();
    let by_columns: Vec<Vec<P>> = (0..2 * columns)
        .map(|x| {
            let column: Vec<P> = by_rows.iter().map(|row| row[x].clone()).collect();
            interleaved(step(&column))
        })
        .collect();
    let expected = |x: usize, y: usize| &by_columns[x % (2 * columns)][y % (2 * rows)];
    let place = |v: VertexId| [2 * (v.index() % columns), 2 * (v.index() / columns)];
    // The middle of places that are neighbours on the torus.
    let middle = |places: &[[usize; 2]]| {
        let along = |axis: usize, around: usize| {
            let values: Vec<usize> = places.iter().map(|place| place[axis]).collect();
            let (low, high) = values
                .iter()
                .fold((usize::MAX, 0), |(low, high), &x| (low.min(x), high.max(x)));
            if low == high {
                low
            } else if high - low == 2 {
                low + 1
            } else {
                around - 1
            }
        };
        [along(0, 2 * columns), along(1, 2 * rows)]
    };
    let places = connectivity
        .vertices()
        .map(place)
        .chain(
            connectivity
                .edges()
                .map(|e| middle(&connectivity.edge_vertices(e).map(place))),
        )
        .chain(connectivity.faces().map(|f| {
            let corners: Vec<_> = connectivity.face_vertices(f).map(place).collect();
            middle(&corners)
        }));
    let expected: Vec<&P> = places.map(|[x, y]| expected(x, y)).collect();
    sides.equal(
        "the scheme refines rows and columns",
        flat(refined.points()),
        flat(expected),
        Rounding::new(32, 4.0 * largest(points)),
    )
}

/// `subdivision-catmull-clark-limit`: where a vertex ends, is known from the start and stays the same in each step.
///
/// `implementation(mesh, v)` must give the limit position of an inner vertex of a mesh of quadrilaterals.
///
/// # Rounding
///
/// The position passes at most 2k + 6 roundings, multiplied by k(k + 5); a step before adds at most 2k + 8.
pub fn catmull_clark_limit<P: Affine>(
    implementation: impl Fn(&Mesh<P>, VertexId) -> Result<P, SchemeError>,
    mesh: &Mesh<P>,
    v: VertexId,
) -> Sides<P::Scalar> {
    let sides = Sides::new(format!("{v}, {}", shown(mesh)));
    let known = || {
        let star = CatmullClark.star(mesh, v)?;
        let now = implementation(mesh, v)?;
        let later = implementation(&CatmullClark.refine(mesh)?, v)?;
        Ok::<_, SchemeError>((star, now, later))
    };
    let (star, now, later) = match known() {
        Ok(known) => known,
        Err(error) => return refused(sides, &error),
    };
    let k = star.neighbours.len();
    let whole = |n: usize| P::Scalar::from_integer(n as i64);
    let around = |weight: usize, list: &[VertexId]| -> Vec<(P::Scalar, &P)> {
        list.iter()
            .map(|&v| (whole(weight), mesh.point(v)))
            .collect()
    };
    let terms = [(whole(k * k), mesh.point(v))]
        .into_iter()
        .chain(around(4, &star.neighbours))
        .chain(around(1, &star.opposite));
    let size = largest(mesh.points());
    sides
        .equal(
            format!("k(k + 5)·v∞ = k²v + 4Σe + Σf at {v}"),
            sum([(whole(k * (k + 5)), &now)]),
            sum(terms),
            Rounding::new(2 * k + 8, 2.0 * (k * (k + 5)) as f64 * size),
        )
        .equal(
            format!("a step does not move the limit of {v}"),
            later.coordinates().to_vec(),
            now.coordinates().to_vec(),
            Rounding::new(4 * k + 14, 2.0 * size),
        )
}

/// `subdivision-catmull-clark-limit`: a step shrinks both tangents by the same factor λ = (A + 4)/16.
///
/// `implementation(mesh, v)` must give the tangents at an inner vertex of a mesh of quadrilaterals.
///
/// # Rounding
///
/// The weights of the tangents are at most A + 2 ≤ 9, with 2k terms and at most 12 roundings each for A and the waves
/// beside 2k + 4 of the sum; a step before adds 2k + 8.
pub fn catmull_clark_tangents<P>(
    implementation: impl Fn(&Mesh<P>, VertexId) -> Result<[P::Difference; 2], SchemeError>,
    mesh: &Mesh<P>,
    v: VertexId,
) -> Sides<P::Scalar>
where
    P: Affine,
    P::Scalar: Real,
{
    let sides = Sides::new(format!("{v}, {}", shown(mesh)));
    let known = || {
        let now = implementation(mesh, v)?;
        let later = implementation(&CatmullClark.refine(mesh)?, v)?;
        Ok::<_, SchemeError>((now, later))
    };
    let (now, later) = match known() {
        Ok(known) => known,
        Err(error) => return refused(sides, &error),
    };
    let k = mesh.connectivity().valence(v);
    let lambda = (catmull_clark_tangent_factor::<P::Scalar>(k) + P::Scalar::from_integer(4))
        / P::Scalar::from_integer(16);
    let shrunk = |vectors: &[P::Difference; 2]| -> Vec<P::Scalar> {
        flat(vectors).into_iter().map(|x| lambda * x).collect()
    };
    let size = largest(mesh.points());
    let rounding = Rounding::new(4 * k + 40, 2.0 * 9.0 * 2.0 * k as f64 * size);
    sides.equal(
        "t₁′ = λt₁ and t₂′ = λt₂",
        flat(&later),
        shrunk(&now),
        rounding,
    )
}

/// `subdivision-creases`: sharp edges are halved, crease vertices follow the cubic rule for curves, corners stay, and the
/// tags are passed on.
///
/// `implementation(mesh, creases)` must give the refined mesh and its creases; old vertices keep their numbers, the point
/// of edge e is number V + e, and the halves of edge e are 2e and 2e + 1.
///
/// # Rounding
///
/// The rules are means with at most 4 roundings; the claims are multiplied by 8.
pub fn creases<P: Affine>(
    implementation: impl Fn(&Mesh<P>, &Creases) -> Result<(Mesh<P>, Creases), SchemeError>,
    mesh: &Mesh<P>,
    creases: &Creases,
) -> Sides<P::Scalar> {
    let old = mesh.connectivity();
    let sides = Sides::new(format!("{creases:?}, {}", shown(mesh)));
    let (refined, finer) = match implementation(mesh, creases) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let rounding = Rounding::new(8, 16.0 * largest(mesh.points()));
    let whole = P::Scalar::from_integer;
    let one = P::Scalar::one;
    let [mut halved, mut middles, mut found, mut expected] = [const { vec![] }; 4];
    for e in old.edges().filter(|&e| creases.is_sharp(old, e)) {
        let Some(point) = refined.points().get(old.vertex_count() + e.index()) else {
            continue;
        };
        let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
        halved.extend(sum([(whole(2), point)]));
        middles.extend(sum([(one(), a), (one(), b)]));
    }
    for v in old.vertices() {
        let (own, point) = (mesh.point(v), &refined.points()[v.index()]);
        let terms = match creases.rule(old, v) {
            VertexRule::Smooth => continue,
            VertexRule::Corner => vec![(whole(8), own)],
            VertexRule::Crease([a, b]) => {
                vec![
                    (one(), mesh.point(a)),
                    (whole(6), own),
                    (one(), mesh.point(b)),
                ]
            }
        };
        found.extend(sum([(whole(8), point)]));
        expected.extend(sum(terms));
    }
    let tags = |list: Vec<bool>| -> Vec<P::Scalar> {
        list.into_iter().map(|tag| whole(i64::from(tag))).collect()
    };
    let sharp = |mesh: &HalfEdgeMesh, creases: &Creases| -> Vec<bool> {
        mesh.edges().map(|e| creases.is_sharp(mesh, e)).collect()
    };
    let inherited = |tags: Vec<bool>| -> Vec<bool> {
        let mut inherited: Vec<bool> = tags.into_iter().flat_map(|tag| [tag; 2]).collect();
        inherited.resize(refined.connectivity().edge_count(), false);
        inherited
    };
    let corners = |creases: &Creases| -> Vec<P::Scalar> {
        creases.corners().map(|v| whole(v.index() as i64)).collect()
    };
    sides
        .equal("2·e′ = a + b on a sharp edge", halved, middles, rounding)
        .equal(
            "8·v′ = a + 6v + b on a crease, v′ = v at a corner",
            found,
            expected,
            rounding,
        )
        .equal(
            "the halves of sharp edges are sharp, and no others",
            tags(sharp(refined.connectivity(), &finer)),
            tags(inherited(sharp(old, creases))),
            Rounding::none(),
        )
        .equal(
            "corners stay corners",
            corners(&finer),
            corners(creases),
            Rounding::none(),
        )
}
