//! Stencils kept in memory: new points of a mesh whose connectivity stays.

use super::refiner::check_inner_valence;
use super::{FastScheme, HalfEdgeMesh, MeshError, SchemeError, VertexId, loop_beta};

/// The points of which a row is a weighted sum: old ones, and the new ones of faces.
#[derive(Clone, Copy)]
struct Sources<'a, const D: usize> {
    old: &'a [[f32; D]],
    faces: &'a [[f32; D]],
}

/// How the rows of a run weigh their points.
///
/// A row lists its points in three groups, each with one weight: two groups of old points, then one of points of faces.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Groups {
    weights: [f32; 3],
    sizes: [usize; 3],
}

/// Rows with the same weights, one after the other.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    groups: Groups,
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
}

/// A group of a row: the weight of its points, and their indices.
type Group<I> = (f32, I);

/// No points.
const NONE: Group<[u32; 0]> = (0.0, []);

impl StencilTable {
    /// Adds a row: two groups of old points, and one of points of faces.
    fn push(
        &mut self,
        first: Group<impl IntoIterator<Item = u32>>,
        second: Group<impl IntoIterator<Item = u32>>,
        faces: Group<impl IntoIterator<Item = u32>>,
    ) {
        let groups = Groups {
            weights: [first.0, second.0, faces.0],
            sizes: [self.list(first.1), self.list(second.1), self.list(faces.1)],
        };
        self.rows += 1;
        match self.runs.last_mut() {
            Some(run) if run.groups == groups => run.rows += 1,
            _ => self.runs.push(Run { groups, rows: 1 }),
        }
    }

    /// Appends indices and returns how many they are.
    fn list(&mut self, indices: impl IntoIterator<Item = u32>) -> usize {
        let before = self.indices.len();
        self.indices.extend(indices);
        self.indices.len() - before
    }

    /// Writes the point of every row to `points`.
    fn apply<const D: usize>(&self, sources: Sources<'_, D>, points: &mut [[f32; D]]) {
        let (mut indices, mut points) = (self.indices.as_slice(), points);
        for run in &self.runs {
            let size: usize = run.groups.sizes.iter().sum();
            let (own, rest) = indices.split_at(run.rows * size);
            let (now, later) = points.split_at_mut(run.rows);
            // The usual sizes are known to the compiler: faces and edges, the boundary, and vertices of regular meshes.
            match run.groups.sizes {
                [2, 0, 0] => run.apply_sized::<2, 0, 0, 2, D>(own, sources, now),
                [3, 0, 0] => run.apply_sized::<3, 0, 0, 3, D>(own, sources, now),
                [4, 0, 0] => run.apply_sized::<4, 0, 0, 4, D>(own, sources, now),
                [1, 2, 0] => run.apply_sized::<1, 2, 0, 3, D>(own, sources, now),
                [2, 2, 0] => run.apply_sized::<2, 2, 0, 4, D>(own, sources, now),
                [1, 6, 0] => run.apply_sized::<1, 6, 0, 7, D>(own, sources, now),
                [2, 0, 2] => run.apply_sized::<2, 0, 2, 4, D>(own, sources, now),
                [1, 4, 4] => run.apply_sized::<1, 4, 4, 9, D>(own, sources, now),
                _ => run.apply(own, sources, now),
            }
            (indices, points) = (rest, later);
        }
    }
}

impl Run {
    /// Rows with `A`, `B` and `C` points in their groups, `ALL` together.
    fn apply_sized<
        const A: usize,
        const B: usize,
        const C: usize,
        const ALL: usize,
        const D: usize,
    >(
        &self,
        indices: &[u32],
        Sources { old, faces }: Sources<'_, D>,
        points: &mut [[f32; D]],
    ) {
        const { assert!(A > 0 && A + B + C == ALL, "the groups are the row") };
        let weights = self.groups.weights;
        for (point, row) in points.iter_mut().zip(indices.as_chunks::<ALL>().0) {
            // With bounds that the compiler knows, the loops become one chain of additions.
            let mut sum = weighted(weights[0], old, row, 0, A);
            if B > 0 {
                add(&mut sum, &weighted(weights[1], old, row, A, A + B));
            }
            if C > 0 {
                add(&mut sum, &weighted(weights[2], faces, row, A + B, ALL));
            }
            *point = sum;
        }
    }

    /// Rows with groups of any size.
    fn apply<const D: usize>(
        &self,
        indices: &[u32],
        Sources { old, faces }: Sources<'_, D>,
        points: &mut [[f32; D]],
    ) {
        let Groups { weights, sizes } = self.groups;
        let size = sizes.iter().sum();
        for (point, row) in points.iter_mut().zip(indices.chunks(size)) {
            let mut sum = [0.0; D];
            let mut start = 0;
            for ((list, weight), size) in [old, old, faces].into_iter().zip(weights).zip(sizes) {
                if size > 0 {
                    add(&mut sum, &weighted(weight, list, row, start, start + size));
                }
                start += size;
            }
            *point = sum;
        }
    }
}

/// The sum of the points that a row lists from `start` up to `end`, start < end, times their weight.
#[inline]
fn weighted<const D: usize>(
    weight: f32,
    list: &[[f32; D]],
    row: &[u32],
    start: usize,
    end: usize,
) -> [f32; D] {
    let mut sum = list[row[start] as usize];
    for k in start + 1..end {
        add(&mut sum, &list[row[k] as usize]);
    }
    for x in &mut sum {
        *x *= weight;
    }
    sum
}

#[inline]
fn add<const D: usize>(sum: &mut [f32; D], point: &[f32; D]) {
    for (sum, x) in sum.iter_mut().zip(point) {
        *sum += x;
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
fn push_boundary_vertex(table: &mut StencilTable, mesh: &HalfEdgeMesh, v: VertexId) {
    let h = mesh.vertex_half_edge(v);
    let along = [mesh.destination(h).0, mesh.origin(mesh.prev(h)).0];
    table.push((0.75, [v.0]), (0.125, along), NONE);
}

fn loop_step(mesh: &HalfEdgeMesh) -> Step {
    let mut others = StencilTable::default();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            push_boundary_vertex(&mut others, mesh, v);
            continue;
        }
        let valence = mesh.valence(v);
        // Cosines of all turns are numbers of this type.
        let beta = loop_beta::<f64>(valence).unwrap_or(f64::NAN);
        let own = (1.0 - valence as f64 * beta) as f32;
        let neighbours = mesh.neighbours(v).map(|w| w.0);
        others.push((own, [v.0]), (beta as f32, neighbours), NONE);
    }
    for e in mesh.edges() {
        let ends = mesh.edge_vertices(e).map(|v| v.0);
        if mesh.is_boundary_edge(e) {
            others.push((0.5, ends), NONE, NONE);
            continue;
        }
        let h = mesh.edge_half_edge(e);
        let opposite = [h, mesh.flip(h)].map(|h| mesh.origin(mesh.prev(h)).0);
        others.push((0.375, ends), (0.125, opposite), NONE);
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
        faces.push((weight, mesh.face_vertices(f).map(|v| v.0)), NONE, NONE);
    }
    let face = |h| mesh.face(h).map(|f| f.0);
    let mut others = StencilTable::default();
    for v in mesh.vertices() {
        if mesh.is_boundary(v) {
            push_boundary_vertex(&mut others, mesh, v);
            continue;
        }
        let valence = mesh.valence(v);
        check_inner_valence(v, valence)?;
        let k = valence as f64;
        let weight = (1.0 / (k * k)) as f32;
        let own = ((k - 2.0) / k) as f32;
        let neighbours = mesh.neighbours(v).map(|w| w.0);
        let beside = mesh.vertex_ring(v).filter_map(face);
        others.push((own, [v.0]), (weight, neighbours), (weight, beside));
    }
    for e in mesh.edges() {
        let ends = mesh.edge_vertices(e).map(|v| v.0);
        let h = mesh.edge_half_edge(e);
        match (face(h), face(mesh.flip(h))) {
            (Some(c), Some(d)) => others.push((0.25, ends), NONE, (0.25, [c, d])),
            _ => others.push((0.5, ends), NONE, NONE),
        }
    }
    Ok(Step { faces, others })
}
