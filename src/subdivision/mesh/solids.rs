//! Meshes to begin with: regular solids, tori, plates with holes, discs around one vertex.
//!
//! The faces run counterclockwise as seen from outside, of a disc as seen from above.

use super::{HalfEdgeMesh, Mesh, MeshError};
use crate::affine::{Affine, Point};
use crate::scalar::{Real, Scalar};

type Space<T> = Mesh<Point<T, 3>>;

/// A mesh of this module: its lists are known to be right.
fn known<P: Affine, F: AsRef<[u32]>>(points: Vec<P>, faces: &[F]) -> Mesh<P> {
    Mesh::from_faces(points, faces).expect("the lists in this module are those of manifolds")
}

fn whole<T: Scalar>(points: &[[i64; 3]]) -> Vec<Point<T, 3>> {
    let point = |&place: &[i64; 3]| Point::new(place.map(T::from_integer));
    points.iter().map(point).collect()
}

/// The regular tetrahedron in every second corner of the cube [−1, 1]³.
#[must_use]
pub fn tetrahedron<T: Scalar>() -> Space<T> {
    known(
        whole(&[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]),
        &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
    )
}

/// The regular octahedron with vertices ±1 on the axes; all valences are 4.
#[must_use]
pub fn octahedron<T: Scalar>() -> Space<T> {
    known(
        whole(&[
            [1, 0, 0],
            [0, 1, 0],
            [-1, 0, 0],
            [0, -1, 0],
            [0, 0, 1],
            [0, 0, -1],
        ]),
        &[
            [0, 1, 4],
            [1, 2, 4],
            [2, 3, 4],
            [3, 0, 4],
            [1, 0, 5],
            [2, 1, 5],
            [3, 2, 5],
            [0, 3, 5],
        ],
    )
}

/// The cube [−1, 1]³; all valences are 3.
#[must_use]
pub fn cube<T: Scalar>() -> Space<T> {
    known(
        whole(&[
            [-1, -1, -1],
            [1, -1, -1],
            [1, 1, -1],
            [-1, 1, -1],
            [-1, -1, 1],
            [1, -1, 1],
            [1, 1, 1],
            [-1, 1, 1],
        ]),
        &[
            [0, 3, 2, 1],
            [4, 5, 6, 7],
            [0, 1, 5, 4],
            [1, 2, 6, 5],
            [2, 3, 7, 6],
            [3, 0, 4, 7],
        ],
    )
}

/// The regular icosahedron with circumradius 1; all valences are 5.
#[must_use]
pub fn icosahedron<T: Real>() -> Space<T> {
    let golden = (T::one() + T::from_integer(5).sqrt()) / T::from_integer(2);
    let length = (golden * golden + T::one()).sqrt();
    let (short, long, zero) = (T::one() / length, golden / length, T::zero());
    let points = [
        [-short, long, zero],
        [short, long, zero],
        [-short, -long, zero],
        [short, -long, zero],
        [zero, -short, long],
        [zero, short, long],
        [zero, -short, -long],
        [zero, short, -long],
        [long, zero, -short],
        [long, zero, short],
        [-long, zero, -short],
        [-long, zero, short],
    ];
    known(
        points.map(Point::new).to_vec(),
        &[
            [0, 11, 5],
            [0, 5, 1],
            [0, 1, 7],
            [0, 7, 10],
            [0, 10, 11],
            [1, 5, 9],
            [5, 11, 4],
            [11, 10, 2],
            [10, 7, 6],
            [7, 1, 8],
            [3, 9, 4],
            [3, 4, 2],
            [3, 2, 6],
            [3, 6, 8],
            [3, 8, 9],
            [4, 9, 5],
            [2, 4, 11],
            [6, 2, 10],
            [8, 6, 7],
            [9, 8, 1],
        ],
    )
}

/// The quadrilaterals of a grid with `columns` × `rows` cells, closed to a torus; vertex (i, j) is i + j·columns.
///
/// `columns` and `rows` below 3 count as 3, for two neighbours would have two edges.
#[must_use]
pub fn torus_quadrilaterals(columns: usize, rows: usize) -> HalfEdgeMesh {
    let (columns, rows) = (columns.max(3), rows.max(3));
    let vertex = |i: usize, j: usize| (i % columns + (j % rows) * columns) as u32;
    let faces: Vec<[u32; 4]> = (0..columns * rows)
        .map(|cell| {
            let (i, j) = (cell % columns, cell / columns);
            [
                vertex(i, j),
                vertex(i + 1, j),
                vertex(i + 1, j + 1),
                vertex(i, j + 1),
            ]
        })
        .collect();
    HalfEdgeMesh::from_faces(columns * rows, &faces)
        .expect("a grid with three rows and columns at least is a torus")
}

/// The same torus with every quadrilateral cut into two triangles by its diagonal from (i, j) to (i + 1, j + 1); all valences are 6.
#[must_use]
pub fn torus_triangles(columns: usize, rows: usize) -> HalfEdgeMesh {
    let quadrilaterals = torus_quadrilaterals(columns, rows);
    let faces: Vec<[u32; 3]> = quadrilaterals
        .face_lists()
        .iter()
        .flat_map(|face| halved(face))
        .collect();
    HalfEdgeMesh::from_faces(quadrilaterals.vertex_count(), &faces)
        .expect("a grid with three rows and columns at least is a torus")
}

fn halved(quadrilateral: &[u32]) -> [[u32; 3]; 2] {
    let [a, b, c, d] = [0, 1, 2, 3].map(|k: usize| quadrilateral[k]);
    [[a, b, c], [a, c, d]]
}

/// Points on a round torus around the z-axis, for the vertices of [`torus_quadrilaterals`] and [`torus_triangles`].
///
/// The first index runs around the axis, the second around the tube, which has radius 1 and distance 2 from the axis.
#[must_use]
pub fn torus_points<T: Real>(columns: usize, rows: usize) -> Vec<Point<T, 3>> {
    let (columns, rows) = (columns.max(3), rows.max(3));
    let turn =
        |k: usize, n: usize| T::from_f64(std::f64::consts::TAU) * T::from_ratio(k as i64, n as i64);
    let point = |at: usize| {
        let (around_axis, around_tube) = (turn(at % columns, columns), turn(at / columns, rows));
        let radius = T::from_integer(2) + around_tube.cos();
        Point::new([
            radius * around_axis.cos(),
            radius * around_axis.sin(),
            around_tube.sin(),
        ])
    };
    (0..columns * rows).map(point).collect()
}

/// A round torus of quadrilaterals.
#[must_use]
pub fn torus<T: Real>(columns: usize, rows: usize) -> Space<T> {
    Mesh::new(
        torus_quadrilaterals(columns, rows),
        torus_points(columns, rows),
    )
    .expect("one finite point a vertex")
}

/// A plate of unit cubes with a row of holes: a closed surface of quadrilaterals, whose genus is the number of holes.
///
/// It lies in [0, 2·holes + 1] × [0, 3] × [0, 1]; the valences are 3 to 5, with whole coordinates.
#[must_use]
pub fn plate_with_holes<T: Scalar>(holes: usize) -> Space<T> {
    let filled = |i: i64, j: i64, k: i64| {
        let inside = (0..=2 * holes as i64).contains(&i) && (0..3).contains(&j) && k == 0;
        inside && !(i % 2 == 1 && j == 1)
    };
    solid(2 * holes as i64 + 1, 3, 1, filled)
}

/// The surface of a set of unit cubes; `filled(i, j, k)` says whether cube [i, i + 1] × [j, j + 1] × [k, k + 1] belongs to it.
fn solid<T: Scalar>(
    width: i64,
    depth: i64,
    height: i64,
    filled: impl Fn(i64, i64, i64) -> bool,
) -> Space<T> {
    // The direction in which a side looks, and its corners, counterclockwise as seen from there.
    const SIDES: [([i64; 3], [[i64; 3]; 4]); 6] = [
        ([-1, 0, 0], [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]]),
        ([1, 0, 0], [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]]),
        ([0, -1, 0], [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]),
        ([0, 1, 0], [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]]),
        ([0, 0, -1], [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]]),
        ([0, 0, 1], [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]),
    ];
    let mut vertices = std::collections::BTreeMap::new();
    let mut places = vec![];
    let mut faces: Vec<[u32; 4]> = vec![];
    for cell in 0..width * depth * height {
        let (i, j, k) = (cell % width, cell / width % depth, cell / (width * depth));
        if !filled(i, j, k) {
            continue;
        }
        for (direction, corners) in SIDES {
            if filled(i + direction[0], j + direction[1], k + direction[2]) {
                continue;
            }
            faces.push(corners.map(|corner| {
                let place = [i + corner[0], j + corner[1], k + corner[2]];
                *vertices.entry(place).or_insert_with(|| {
                    places.push(place);
                    places.len() as u32 - 1
                })
            }));
        }
    }
    known(whole(&places), &faces)
}

/// `valence` triangles around vertex 0: a disc whose inner vertex has that valence; below 3 it counts as 3.
///
/// The other vertices follow counterclockwise.
#[must_use]
pub fn triangle_fan(valence: usize) -> HalfEdgeMesh {
    let k = valence.max(3) as u32;
    let faces: Vec<[u32; 3]> = (0..k).map(|i| [0, 1 + i, 1 + (i + 1) % k]).collect();
    HalfEdgeMesh::from_faces(k as usize + 1, &faces).expect("a fan is a disc")
}

/// `valence` quadrilaterals around vertex 0; below 3 it counts as 3.
///
/// The neighbours of vertex 0 have odd numbers, the opposite corners of the quadrilaterals even ones, counterclockwise.
#[must_use]
pub fn quadrilateral_fan(valence: usize) -> HalfEdgeMesh {
    let k = valence.max(3) as u32;
    let faces: Vec<[u32; 4]> = (0..k)
        .map(|i| [0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % (2 * k)])
        .collect();
    HalfEdgeMesh::from_faces(2 * k as usize + 1, &faces).expect("a fan is a disc")
}

/// A square grid of `columns` × `rows` quadrilaterals; vertex (i, j) is i + j·(columns + 1) and lies at (i, j, 0).
#[must_use]
pub fn grid<T: Scalar>(columns: usize, rows: usize) -> Space<T> {
    let (columns, rows) = (columns.max(1), rows.max(1));
    let vertex = |i: usize, j: usize| (i + j * (columns + 1)) as u32;
    let points = (0..(columns + 1) * (rows + 1)).map(|at| {
        let place = [at % (columns + 1), at / (columns + 1), 0];
        Point::new(place.map(|x| T::from_integer(x as i64)))
    });
    let faces: Vec<[u32; 4]> = (0..columns * rows)
        .map(|cell| {
            let (i, j) = (cell % columns, cell / columns);
            [
                vertex(i, j),
                vertex(i + 1, j),
                vertex(i + 1, j + 1),
                vertex(i, j + 1),
            ]
        })
        .collect();
    known(points.collect(), &faces)
}

/// The same mesh with every face cut into triangles by the diagonals from its first corner.
///
/// # Errors
///
/// [`MeshError`] if such a diagonal joins vertices that are joined by an edge already.
pub fn triangulated<P: Affine>(mesh: &Mesh<P>) -> Result<Mesh<P>, MeshError> {
    let mut faces: Vec<[u32; 3]> = vec![];
    for face in mesh.connectivity().face_lists() {
        let diagonals = face[1..].windows(2);
        faces.extend(diagonals.map(|pair| [face[0], pair[0], pair[1]]));
    }
    Mesh::from_faces(mesh.points().to_vec(), &faces)
}
