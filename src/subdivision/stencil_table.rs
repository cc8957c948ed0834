//! Stencils kept in memory: new points of a mesh whose connectivity stays.

use super::refiner::check_inner_valence;
use super::{FastScheme, HalfEdgeMesh, MeshError, SchemeError, VertexId, loop_beta};

/// The points of which a row is a weighted sum: old ones, and the new ones of faces.
#[derive(Clone, Copy)]
struct Sources<'a, const D: usize> {
    old: &'a [[f32; D]],
    faces: &'a [[f32; D]],
}

/// Rows with the same weights, one after the other.
///
/// The first weights belong to old points, the others to points of faces; so does what every row lists.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    weights: Vec<f32>,
    /// How many of the weights belong to old points.
    old: usize,
    rows: usize,
}

/// Stencils row by row; what rows have in common is kept once.
///
/// Nearly all rows of a fine mesh belong to few runs, so that a row costs 4 bytes for each of its points.
#[derive(Debug, Clone, Default, PartialEq)]
struct StencilTable {
    runs: Vec<Run>,
    /// The points of all rows.
    indices: Vec<u32>,
    rows: usize,
    /// The weights of the row that is added.
    weights: Vec<f32>,
}

impl StencilTable {
    /// Adds the row of these weights of old points, and of points of faces.
    fn push(
        &mut self,
        old: impl IntoIterator<Item = (u32, f32)>,
        faces: impl IntoIterator<Item = (u32, f32)>,
    ) {
        let Self {
            runs,
            indices,
            rows,
            weights,
        } = self;
        weights.clear();
        for (index, weight) in old {
            indices.push(index);
            weights.push(weight);
        }
        let old = weights.len();
        for (index, weight) in faces {
            indices.push(index);
            weights.push(weight);
        }
        *rows += 1;
        match runs.last_mut() {
            Some(run) if run.old == old && run.weights == *weights => run.rows += 1,
            _ => runs.push(Run {
                weights: weights.clone(),
                old,
                rows: 1,
            }),
        }
    }

    /// Writes the point of every row to `points`.
    fn apply<const D: usize>(&self, sources: Sources<'_, D>, points: &mut [[f32; D]]) {
        let (mut indices, mut points) = (self.indices.as_slice(), points);
        for run in &self.runs {
            let (own, rest) = indices.split_at(run.rows * run.weights.len());
            let (now, later) = points.split_at_mut(run.rows);
            // The usual sizes are known to the compiler: faces and edges, the boundary, and vertices of regular meshes.
            match (run.old, run.weights.len()) {
                (2, 2) => run.apply_sized::<2, 2, D>(own, sources, now),
                (3, 3) => run.apply_sized::<3, 3, D>(own, sources, now),
                (4, 4) => run.apply_sized::<4, 4, D>(own, sources, now),
                (2, 4) => run.apply_sized::<2, 4, D>(own, sources, now),
                (7, 7) => run.apply_sized::<7, 7, D>(own, sources, now),
                (5, 9) => run.apply_sized::<5, 9, D>(own, sources, now),
                _ => run.apply(own, sources, now),
            }
            (indices, points) = (rest, later);
        }
    }
}

impl Run {
    /// Rows with `ALL` points, `OLD` of them old.
    fn apply_sized<const OLD: usize, const ALL: usize, const D: usize>(
        &self,
        indices: &[u32],
        sources: Sources<'_, D>,
        points: &mut [[f32; D]],
    ) {
        let Some(weights) = self.weights.first_chunk::<ALL>() else {
            return;
        };
        for (point, row) in points.iter_mut().zip(indices.as_chunks::<ALL>().0) {
            let mut sum = [0.0; D];
            for k in 0..ALL {
                let list = if k < OLD { sources.old } else { sources.faces };
                add(&mut sum, weights[k], &list[row[k] as usize]);
            }
            *point = sum;
        }
    }

    fn apply<const D: usize>(
        &self,
        indices: &[u32],
        sources: Sources<'_, D>,
        points: &mut [[f32; D]],
    ) {
        for (point, row) in points.iter_mut().zip(indices.chunks(self.weights.len())) {
            let mut sum = [0.0; D];
            for (k, (&j, &weight)) in row.iter().zip(&self.weights).enumerate() {
                let list = if k < self.old {
                    sources.old
                } else {
                    sources.faces
                };
                add(&mut sum, weight, &list[j as usize]);
            }
            *point = sum;
        }
    }
}

#[inline]
fn add<const D: usize>(sum: &mut [f32; D], weight: f32, point: &[f32; D]) {
    for (sum, x) in sum.iter_mut().zip(point) {
        *sum += weight * x;
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
            after.resize(others.rows + faces.rows, [0.0; D]);
            let (other_points, face_points) = after.split_at_mut(others.rows);
            let old = Sources {
                old: before,
                faces: &[],
            };
            faces.apply(old, face_points);
            let both = Sources {
                old: before,
                faces: face_points,
            };
            others.apply(both, other_points);
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
    let mut others = StencilTable::default();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            others.push(boundary_row(mesh, v), []);
            continue;
        }
        let valence = mesh.valence(v);
        // Cosines of all turns are numbers of this type.
        let beta = loop_beta::<f64>(valence).unwrap_or(f64::NAN);
        let own = (v.0, (1.0 - valence as f64 * beta) as f32);
        let neighbours = mesh.neighbours(v).map(|w| (w.0, beta as f32));
        others.push(std::iter::once(own).chain(neighbours), []);
    }
    for e in mesh.edges() {
        let [a, b] = mesh.edge_vertices(e);
        if mesh.is_boundary_edge(e) {
            others.push([(a.0, 0.5), (b.0, 0.5)], []);
            continue;
        }
        let h = mesh.edge_half_edge(e);
        let [c, d] = [h, mesh.flip(h)].map(|h| mesh.origin(mesh.prev(h)));
        let row = [(a.0, 0.375), (b.0, 0.375), (c.0, 0.125), (d.0, 0.125)];
        others.push(row, []);
    }
    Step {
        faces: StencilTable::default(),
        others,
    }
}

fn catmull_clark_step(mesh: &HalfEdgeMesh) -> Result<Step, SchemeError> {
    let mut faces = StencilTable::default();
    for f in mesh.faces() {
        let weight = 1.0 / mesh.face_degree(f) as f32;
        faces.push(mesh.face_vertices(f).map(|v| (v.0, weight)), []);
    }
    let face = |h| mesh.face(h).map(|f| f.0);
    let mut others = StencilTable::default();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            others.push(boundary_row(mesh, v), []);
            continue;
        }
        let valence = mesh.valence(v);
        check_inner_valence(v, valence)?;
        let k = valence as f64;
        let weight = (1.0 / (k * k)) as f32;
        let own = (v.0, ((k - 2.0) / k) as f32);
        let neighbours = mesh.neighbours(v).map(|w| (w.0, weight));
        let beside = mesh.vertex_ring(v).filter_map(face).map(|f| (f, weight));
        others.push(std::iter::once(own).chain(neighbours), beside);
    }
    for e in mesh.edges() {
        let ends = mesh.edge_vertices(e).map(|v| v.0);
        let h = mesh.edge_half_edge(e);
        match (face(h), face(mesh.flip(h))) {
            (Some(c), Some(d)) => {
                others.push(ends.map(|v| (v, 0.25)), [c, d].map(|f| (f, 0.25)));
            }
            _ => others.push(ends.map(|v| (v, 0.5)), []),
        }
    }
    Ok(Step { faces, others })
}
