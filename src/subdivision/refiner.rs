//! Loop's and Catmull and Clark's scheme for large meshes in space, in memory that is used again and again.

use super::mesh::prev_in_triangle;
use super::{HalfEdgeMesh, Mesh, SchemeError, VertexId, loop_beta};
use crate::affine::Point;

/// A mesh in space.
type Space = Mesh<Point<f64, 3>>;

/// The schemes that [`Refiner`] knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FastScheme {
    /// [`Loop`](super::Loop), without creases.
    Loop,
    /// [`CatmullClark`](super::CatmullClark), without creases.
    CatmullClark,
}

/// Refines meshes step by step and keeps the memory of every step for the next mesh.
///
/// Points and connectivity are those of the scheme itself, up to rounding: sums are formed in another order.
/// Each step passes along the edges and the faces once; the connectivity follows from closed formulas.
/// Time and memory are linear in the number of faces: beside the result a step needs 28 bytes for each old vertex.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{FastScheme, Refiner, solids};
///
/// let mut refiner = Refiner::new(FastScheme::Loop);
/// let fine = refiner.refine(&solids::octahedron(), 4)?;
/// assert_eq!(fine.connectivity().face_count(), 8 * 256);
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Refiner {
    scheme: FastScheme,
    /// The results of all steps; those behind `steps` belong to a mesh before.
    levels: Vec<Space>,
    steps: usize,
    around: Around,
}

/// What is summed up around every vertex.
#[derive(Debug, Clone, Default)]
struct Around {
    sums: Vec<[f64; 3]>,
    valences: Vec<u32>,
}

impl Around {
    fn clear(&mut self, vertices: usize) {
        self.sums.clear();
        self.sums.resize(vertices, [0.0; 3]);
        self.valences.clear();
        self.valences.resize(vertices, 0);
    }

    #[inline]
    fn add(&mut self, v: u32, point: [f64; 3]) {
        let sum = &mut self.sums[v as usize];
        *sum = plus(*sum, point);
    }

    /// Counts an edge at both of its ends, and adds to each sum the other end; gives the sum of both.
    #[inline]
    fn add_ends(&mut self, [start, end]: [u32; 2], points: &[Point<f64, 3>]) -> [f64; 3] {
        let [a, b] = [start, end].map(|v| array(&points[v as usize]));
        self.add(start, b);
        self.add(end, a);
        self.valences[start as usize] += 1;
        self.valences[end as usize] += 1;
        plus(a, b)
    }
}

impl Refiner {
    /// A refiner without memory yet.
    #[must_use]
    pub fn new(scheme: FastScheme) -> Self {
        Self {
            scheme,
            levels: vec![],
            steps: 0,
            around: Around::default(),
        }
    }

    /// The mesh after so many steps; after 0 steps it is a copy.
    ///
    /// # Errors
    ///
    /// [`SchemeError::Mesh`] for faces that the scheme does not split, for results that are too large, and for
    /// coordinates beyond the range of numbers; [`SchemeError::Valence`] for a vertex inside with two edges only.
    pub fn refine(&mut self, mesh: &Space, steps: usize) -> Result<&Space, SchemeError> {
        self.steps = 0;
        while self.levels.len() < steps.max(1) {
            self.levels.push(Mesh::buffer());
        }
        for step in 0..steps {
            let (before, after) = self.levels.split_at_mut(step);
            let old = before.last().unwrap_or(mesh);
            let (connectivity, points) = after[0].parts_mut();
            match self.scheme {
                FastScheme::Loop => {
                    old.connectivity().split_triangles_into(connectivity)?;
                    loop_points(old, &mut self.around, points);
                }
                FastScheme::CatmullClark => {
                    old.connectivity()
                        .split_into_quadrilaterals_into(connectivity)?;
                    catmull_clark_points(old, &mut self.around, points)?;
                }
            }
            after[0].check_points()?;
            self.steps = step + 1;
        }
        if steps == 0 {
            self.levels[0].clone_from(mesh);
            self.steps = 1;
        }
        Ok(&self.levels[steps.max(1) - 1])
    }

    /// The results of all steps of the last refinement, the coarsest first.
    #[must_use]
    pub fn levels(&self) -> &[Space] {
        &self.levels[..self.steps]
    }
}

#[inline]
fn array(point: &Point<f64, 3>) -> [f64; 3] {
    [point[0], point[1], point[2]]
}

#[inline]
fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
fn times(a: [f64; 3], factor: f64) -> [f64; 3] {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

/// (6v + a + b)/8 for every vertex of the boundary, a and b its neighbours along it.
fn boundary_points(mesh: &Space, points: &mut [Point<f64, 3>]) {
    let connectivity = mesh.connectivity();
    let corners = connectivity.corner_count();
    for (at, &v) in connectivity.origin[corners..].iter().enumerate() {
        let end = |h: u32| connectivity.origin[h as usize] as usize;
        let [next, prev] = [&connectivity.boundary_next, &connectivity.boundary_prev]
            .map(|table| array(&mesh.points()[end(table[at])]));
        let own = times(array(&mesh.points()[v as usize]), 6.0);
        points[v as usize] = Point::new(times(plus(own, plus(next, prev)), 0.125));
    }
}

/// A list of this length with any content.
fn resize(points: &mut Vec<Point<f64, 3>>, length: usize) {
    points.resize(length, Point::new([0.0; 3]));
}

fn loop_points(mesh: &Space, around: &mut Around, points: &mut Vec<Point<f64, 3>>) {
    let connectivity = mesh.connectivity();
    let old = mesh.points();
    let vertices = old.len();
    let corners = connectivity.corner_count() as u32;
    resize(points, vertices + connectivity.edge_count());
    around.clear(vertices);
    let HalfEdgeMesh { origin, flip, .. } = connectivity;
    let (vertex_points, edge_points) = points.split_at_mut(vertices);
    for (point, &h) in edge_points.iter_mut().zip(&connectivity.edge_half_edge) {
        let g = flip[h as usize];
        let sum = around.add_ends([h, g].map(|h| origin[h as usize]), old);
        *point = Point::new(if g < corners {
            let [c, d] = [h, g].map(|h| {
                let opposite = origin[prev_in_triangle(h) as usize];
                array(&old[opposite as usize])
            });
            plus(times(sum, 0.375), times(plus(c, d), 0.125))
        } else {
            times(sum, 0.5)
        });
    }
    let mut weights: Vec<Option<[f64; 2]>> = vec![];
    let sums = around.sums.iter().zip(&around.valences);
    for ((point, own), (&sum, &valence)) in vertex_points.iter_mut().zip(old).zip(sums) {
        let valence = valence as usize;
        if weights.len() <= valence {
            weights.resize(valence + 1, None);
        }
        let [rest, beta] = match weights[valence] {
            Some(pair) => pair,
            None => {
                // Cosines of all turns are numbers of this type; a mesh has no vertex without edges.
                let beta = loop_beta::<f64>(valence).unwrap_or(f64::NAN);
                *weights[valence].insert([1.0 - valence as f64 * beta, beta])
            }
        };
        *point = Point::new(plus(times(array(own), rest), times(sum, beta)));
    }
    boundary_points(mesh, points);
}

fn catmull_clark_points(
    mesh: &Space,
    around: &mut Around,
    points: &mut Vec<Point<f64, 3>>,
) -> Result<(), SchemeError> {
    let connectivity = mesh.connectivity();
    let old = mesh.points();
    let (vertices, edges) = (old.len(), connectivity.edge_count());
    let corners = connectivity.corner_count() as u32;
    resize(points, vertices + edges + connectivity.face_count());
    around.clear(vertices);
    let HalfEdgeMesh { origin, flip, .. } = connectivity;
    let (vertex_points, others) = points.split_at_mut(vertices);
    let (edge_points, face_points) = others.split_at_mut(edges);
    for (point, f) in face_points.iter_mut().zip(connectivity.faces()) {
        let first = connectivity.face_half_edge(f).index();
        let degree = connectivity.face_degree(f);
        let face = &origin[first..first + degree];
        let sum = face
            .iter()
            .map(|&v| array(&old[v as usize]))
            .fold([0.0; 3], plus);
        let middle = times(sum, 1.0 / degree as f64);
        *point = Point::new(middle);
        for &v in face {
            around.add(v, middle);
        }
    }
    let quadrilaterals = connectivity.uniform_face_degree() == Some(4);
    let face_of = |h: u32| {
        if quadrilaterals {
            h / 4
        } else {
            connectivity.blocks.face(h)
        }
    };
    for (point, &h) in edge_points.iter_mut().zip(&connectivity.edge_half_edge) {
        let g = flip[h as usize];
        let sum = around.add_ends([h, g].map(|h| origin[h as usize]), old);
        *point = Point::new(if g < corners {
            let [c, d] = [h, g].map(|h| array(&face_points[face_of(h) as usize]));
            times(plus(sum, plus(c, d)), 0.25)
        } else {
            times(sum, 0.5)
        });
    }
    let sums = around.sums.iter().zip(&around.valences);
    for (v, ((point, own), (&sum, &valence))) in
        vertex_points.iter_mut().zip(old).zip(sums).enumerate()
    {
        if !connectivity.is_boundary(VertexId::at(v)) {
            check_inner_valence(VertexId::at(v), valence as usize)?;
        }
        let k = f64::from(valence);
        *point = Point::new(plus(
            times(array(own), (k - 2.0) / k),
            times(sum, 1.0 / (k * k)),
        ));
    }
    boundary_points(mesh, points);
    Ok(())
}

/// Catmull and Clark's scheme has no rule for an inner vertex with two edges.
pub(super) fn check_inner_valence(vertex: VertexId, valence: usize) -> Result<(), SchemeError> {
    if valence >= 3 {
        return Ok(());
    }
    Err(SchemeError::Valence {
        scheme: "Catmull and Clark's scheme",
        vertex,
        valence,
        reason: "inside a mesh at least three edges must meet; remove the vertex",
    })
}
