//! Stencils kept in memory: new points of a mesh whose connectivity stays.

use super::refiner::check_inner_valence;
use super::{FastScheme, HalfEdgeMesh, MeshError, SchemeError, VertexId, loop_beta};

/// Rows of weights: row i lists (j, w), and its point is Σ w · (point j).
#[derive(Debug, Clone, PartialEq)]
struct StencilTable {
    /// Of every row where it begins, and behind them the number of all entries.
    first: Vec<u32>,
    entries: Vec<(u32, f32)>,
}

impl StencilTable {
    fn new() -> Self {
        Self {
            first: vec![0],
            entries: vec![],
        }
    }

    fn push(&mut self, row: impl IntoIterator<Item = (u32, f32)>) {
        self.entries.extend(row);
        self.first.push(self.entries.len() as u32);
    }

    /// How many points the table makes.
    fn rows(&self) -> usize {
        self.first.len() - 1
    }

    /// Appends the point of every row to `points`.
    fn extend<const D: usize>(&self, points: &mut Vec<[f32; D]>, old: &[[f32; D]]) {
        points.extend(self.first.windows(2).map(|ends| {
            let row = &self.entries[ends[0] as usize..ends[1] as usize];
            let mut sum = [0.0; D];
            for &(j, weight) in row {
                let point = &old[j as usize];
                for (sum, x) in sum.iter_mut().zip(point) {
                    *sum += weight * x;
                }
            }
            sum
        }));
    }
}

/// The stencils of several steps of a scheme on one connectivity, for control points that change.
///
/// The steps are applied one after the other: that needs fewer products than stencils over the control points.
/// Points have `D` coordinates in `f32`; four, the last of them unused, are quicker than three.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{FastScheme, StencilCascade, solids};
///
/// let octahedron = solids::octahedron::<f64>();
/// let mut cascade = StencilCascade::new(FastScheme::Loop, octahedron.connectivity(), 2)?;
/// let control: Vec<[f32; 3]> = octahedron
///     .points()
///     .iter()
///     .map(|p| [p[0] as f32, p[1] as f32, p[2] as f32])
///     .collect();
/// assert_eq!(cascade.apply(&control)?.len(), 66);
/// assert_eq!(cascade.connectivity().face_count(), 128);
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct StencilCascade<const D: usize> {
    control_points: usize,
    connectivity: HalfEdgeMesh,
    steps: Vec<Step>,
    /// The points before and after the present step.
    buffers: [Vec<[f32; D]>; 2],
}

/// One step: first the points of faces, which follow the old points; then those of old vertices and of edges, of both.
#[derive(Debug, Clone)]
struct Step {
    faces: StencilTable,
    others: StencilTable,
}

impl<const D: usize> StencilCascade<D> {
    /// The stencils of `steps` steps.
    ///
    /// # Errors
    ///
    /// [`SchemeError::Mesh`] for faces that the scheme does not split and for results that are too large,
    /// [`SchemeError::Valence`] for a vertex inside that the scheme has no rule for.
    pub fn new(
        scheme: FastScheme,
        connectivity: &HalfEdgeMesh,
        steps: usize,
    ) -> Result<Self, SchemeError> {
        let mut tables = vec![];
        let mut mesh = connectivity.clone();
        for _ in 0..steps {
            let (refined, step) = match scheme {
                FastScheme::Loop => (mesh.split_triangles()?, loop_step(&mesh)),
                FastScheme::CatmullClark => (
                    mesh.split_into_quadrilaterals()?,
                    catmull_clark_step(&mesh)?,
                ),
            };
            tables.push(step);
            mesh = refined;
        }
        Ok(Self {
            control_points: connectivity.vertex_count(),
            connectivity: mesh,
            steps: tables,
            buffers: [vec![], vec![]],
        })
    }

    /// The connectivity of the result.
    #[must_use]
    pub fn connectivity(&self) -> &HalfEdgeMesh {
        &self.connectivity
    }

    /// The points of the refined mesh for these control points.
    ///
    /// # Errors
    ///
    /// [`MeshError::PointCount`] unless there is one control point a vertex.
    pub fn apply(&mut self, control: &[[f32; D]]) -> Result<&[[f32; D]], MeshError> {
        if control.len() != self.control_points {
            return Err(MeshError::PointCount {
                vertices: self.control_points,
                points: control.len(),
            });
        }
        let [before, after] = &mut self.buffers;
        before.clear();
        before.extend_from_slice(control);
        for Step { faces, others } in &self.steps {
            let vertices = before.len();
            after.clear();
            faces.extend(after, before);
            before.append(after);
            after.reserve(others.rows() + faces.rows());
            others.extend(after, before);
            after.extend_from_slice(&before[vertices..]);
            std::mem::swap(before, after);
        }
        Ok(before)
    }
}

/// (6v + a + b)/8, a and b the neighbours of v along the boundary.
fn boundary_row(mesh: &HalfEdgeMesh, v: VertexId) -> [(u32, f32); 3] {
    let h = mesh.vertex_half_edge(v);
    let before = mesh.origin(mesh.prev(h));
    [
        (v.0, 0.75),
        (mesh.destination(h).0, 0.125),
        (before.0, 0.125),
    ]
}

fn loop_step(mesh: &HalfEdgeMesh) -> Step {
    let mut others = StencilTable::new();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            others.push(boundary_row(mesh, v));
            continue;
        }
        let valence = mesh.valence(v);
        // Cosines of all turns are numbers of this type.
        let beta = loop_beta::<f64>(valence).unwrap_or(f64::NAN);
        let own = (v.0, (1.0 - valence as f64 * beta) as f32);
        others.push(std::iter::once(own).chain(mesh.neighbours(v).map(|w| (w.0, beta as f32))));
    }
    for e in mesh.edges() {
        let [a, b] = mesh.edge_vertices(e);
        if mesh.is_boundary_edge(e) {
            others.push([(a.0, 0.5), (b.0, 0.5)]);
            continue;
        }
        let h = mesh.edge_half_edge(e);
        let [c, d] = [h, mesh.flip(h)].map(|h| mesh.origin(mesh.prev(h)));
        others.push([(a.0, 0.375), (b.0, 0.375), (c.0, 0.125), (d.0, 0.125)]);
    }
    Step {
        faces: StencilTable::new(),
        others,
    }
}

fn catmull_clark_step(mesh: &HalfEdgeMesh) -> Result<Step, SchemeError> {
    let mut faces = StencilTable::new();
    for f in mesh.faces() {
        let weight = 1.0 / mesh.face_degree(f) as f32;
        faces.push(mesh.face_vertices(f).map(|v| (v.0, weight)));
    }
    let vertices = mesh.vertex_count() as u32;
    let middle = |h| mesh.face(h).map(|f| vertices + f.0);
    let mut others = StencilTable::new();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            others.push(boundary_row(mesh, v));
            continue;
        }
        let valence = mesh.valence(v);
        check_inner_valence(v, valence)?;
        let k = valence as f64;
        let weight = (1.0 / (k * k)) as f32;
        let ring = mesh.vertex_ring(v);
        let beside = ring.flat_map(|h| [Some(mesh.destination(h).0), middle(h)]);
        let own = (v.0, ((k - 2.0) / k) as f32);
        others.push(std::iter::once(own).chain(beside.flatten().map(|j| (j, weight))));
    }
    for e in mesh.edges() {
        let [a, b] = mesh.edge_vertices(e);
        let h = mesh.edge_half_edge(e);
        match (middle(h), middle(mesh.flip(h))) {
            (Some(c), Some(d)) => others.push([a.0, b.0, c, d].map(|j| (j, 0.25))),
            _ => others.push([(a.0, 0.5), (b.0, 0.5)]),
        }
    }
    Ok(Step { faces, others })
}
