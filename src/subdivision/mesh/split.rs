//! Splitting faces: the connectivity after one step, by closed formulas for the numbers of all elements.
//!
//! Both refinements halve every edge: edge e becomes 2e, at the origin of its half-edge with the smaller number, and 2e + 1.
//! A half-edge of the boundary becomes two with consecutive numbers; those with a face become, with V vertices, E edges
//! and D half-edges with a face before,
//!
//! ```text
//!                     triangles into four             faces into quadrilaterals
//! vertices            v, and V + e for edge e         v, V + e for edge e, and V + E + f for face f
//! faces               4f + c at corner c, 4f + 3      h at the origin of half-edge h
//! first half of h     3(h + ⌊h/3⌋)                    4h
//! second half of h    first half of next(h), plus 2   first half of next(h), plus 3
//! new edge of h       2E + h cuts off its corner      2E + h joins the middles of edge(h) and of the face
//! ```

use super::connectivity::{Blocks, HalfEdgeMesh};
use super::{FaceId, MeshError};

/// The numbers of the two halves of a half-edge.
#[derive(Clone, Copy)]
struct Halves<First, Next> {
    /// How many half-edges have a face, before.
    corners: u32,
    /// The same, after.
    refined_corners: u32,
    /// The number of vertices of the new faces.
    degree: u32,
    /// The first half of a half-edge with a face.
    first_of_corner: First,
    /// The next half-edge around a face.
    next: Next,
}

impl<First: Fn(u32) -> u32, Next: Fn(u32) -> u32> Halves<First, Next> {
    /// The half at the origin of a half-edge.
    #[inline]
    fn first(&self, h: u32) -> u32 {
        if h < self.corners {
            (self.first_of_corner)(h)
        } else {
            self.refined_corners + 2 * (h - self.corners)
        }
    }

    /// The half at the end of a half-edge.
    #[inline]
    fn second(&self, h: u32) -> u32 {
        if h < self.corners {
            (self.first_of_corner)((self.next)(h)) + self.degree - 1
        } else {
            self.refined_corners + 2 * (h - self.corners) + 1
        }
    }
}

#[inline]
fn next_in_triangle(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

#[inline]
pub(in crate::subdivision) fn prev_in_triangle(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

#[inline]
fn next_in_quadrilateral(h: u32) -> u32 {
    (h & !3) | ((h + 1) & 3)
}

#[inline]
fn prev_in_quadrilateral(h: u32) -> u32 {
    (h & !3) | (h.wrapping_sub(1) & 3)
}

impl HalfEdgeMesh {
    /// A mesh without elements, whose memory a refinement can use again and again.
    #[must_use]
    pub(in crate::subdivision) fn buffer() -> Self {
        Self {
            blocks: Blocks::Uniform {
                degree: 3,
                faces: 0,
            },
            origin: vec![],
            flip: vec![],
            edge: vec![],
            boundary_next: vec![],
            boundary_prev: vec![],
            vertex_half_edge: vec![],
            edge_half_edge: vec![],
        }
    }

    /// Splits every triangle into four at the middles of its edges; the numbers are those of Loop's scheme.
    ///
    /// Vertex v stays v, and the middle of edge e becomes vertex V + e.
    /// Triangle f becomes 4f + c at its corner c, and 4f + 3 in the middle.
    ///
    /// # Errors
    ///
    /// [`MeshError::FaceDegree`] for a face that is not a triangle, [`MeshError::TooLarge`] beyond 2³² half-edges.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::HalfEdgeMesh;
    ///
    /// let triangle = HalfEdgeMesh::from_faces(3, &[[0, 1, 2]])?;
    /// let split = triangle.split_triangles()?;
    /// assert_eq!(split.face_lists(), [[0, 3, 5], [1, 4, 3], [2, 5, 4], [3, 4, 5]]);
    /// # Ok::<(), cagd::subdivision::MeshError>(())
    /// ```
    pub fn split_triangles(&self) -> Result<Self, MeshError> {
        let mut refined = Self::buffer();
        self.split_triangles_into(&mut refined)?;
        Ok(refined)
    }

    /// As [`split_triangles`](Self::split_triangles), in the memory of `refined`.
    pub(in crate::subdivision) fn split_triangles_into(
        &self,
        refined: &mut Self,
    ) -> Result<(), MeshError> {
        self.check_face_degree(3)?;
        let triangles = self.face_count() as u32;
        let edges = self.edge_count();
        self.size(
            refined,
            3,
            4 * u64::from(triangles),
            self.vertex_count() + edges,
        )?;
        let halves = Halves {
            corners: 3 * triangles,
            refined_corners: 12 * triangles,
            degree: 3,
            first_of_corner: |h: u32| 3 * (h + h / 3),
            next: next_in_triangle,
        };
        let vertices = self.vertex_count() as u32;
        let new_edges = 2 * edges as u32;
        let new = refined.origin.chunks_exact_mut(12);
        let new = new.zip(refined.flip.chunks_exact_mut(12));
        let new = new.zip(refined.edge.chunks_exact_mut(12));
        let (old_origin, _) = self.origin.as_chunks::<3>();
        let (old_flip, _) = self.flip.as_chunks::<3>();
        let (old_edge, _) = self.edge.as_chunks::<3>();
        let old = old_origin.iter().zip(old_flip).zip(old_edge);
        for (f, (((origin, flip), edge), ((old_origin, old_flip), old_edge))) in
            (0..triangles).zip(new.zip(old))
        {
            let middle = old_edge.map(|e| vertices + e);
            let child = 12 * f;
            for c in 0..3 {
                let (next, prev) = ((c + 1) % 3, (c + 2) % 3);
                let (h, p) = (3 * f + c as u32, 3 * f + prev as u32);
                let corner = 3 * c..3 * c + 3;
                origin[corner.clone()].copy_from_slice(&[old_origin[c], middle[c], middle[prev]]);
                flip[corner.clone()].copy_from_slice(&[
                    halves.second(old_flip[c]),
                    child + 9 + prev as u32,
                    halves.first(old_flip[prev]),
                ]);
                edge[corner].copy_from_slice(&[
                    2 * old_edge[c] + u32::from(h > old_flip[c]),
                    new_edges + h,
                    2 * old_edge[prev] + u32::from(p < old_flip[prev]),
                ]);
                origin[9 + c] = middle[c];
                flip[9 + c] = child + 3 * next as u32 + 1;
                edge[9 + c] = new_edges + 3 * f + next as u32;
            }
        }
        self.split_boundary(refined, &halves);
        self.link_refined(refined, &halves, |h| 3 * (h + h / 3) + 1);
        Ok(())
    }

    /// Splits every face into quadrilaterals at its middle and the middles of its edges; the numbers are those of Catmull and Clark's scheme.
    ///
    /// Vertex v stays v, the middle of edge e becomes vertex V + e, the middle of face f vertex V + E + f.
    /// Quadrilateral h lies at the origin of half-edge h, from there to the middle of its edge.
    ///
    /// # Errors
    ///
    /// [`MeshError::TooLarge`] beyond 2³² half-edges.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::HalfEdgeMesh;
    ///
    /// let triangle = HalfEdgeMesh::from_faces(3, &[[0, 1, 2]])?;
    /// let split = triangle.split_into_quadrilaterals()?;
    /// assert_eq!(split.face_lists(), [[0, 3, 6, 5], [1, 4, 6, 3], [2, 5, 6, 4]]);
    /// # Ok::<(), cagd::subdivision::MeshError>(())
    /// ```
    pub fn split_into_quadrilaterals(&self) -> Result<Self, MeshError> {
        let mut refined = Self::buffer();
        self.split_into_quadrilaterals_into(&mut refined)?;
        Ok(refined)
    }

    /// As [`split_into_quadrilaterals`](Self::split_into_quadrilaterals), in the memory of `refined`.
    pub(in crate::subdivision) fn split_into_quadrilaterals_into(
        &self,
        refined: &mut Self,
    ) -> Result<(), MeshError> {
        match &self.blocks {
            Blocks::Uniform { degree: 4, .. } => {
                self.split_with(refined, next_in_quadrilateral, prev_in_quadrilateral, |h| {
                    h / 4
                })
            }
            Blocks::Uniform { degree: 3, .. } => {
                self.split_with(refined, next_in_triangle, prev_in_triangle, |h| h / 3)
            }
            blocks => self.split_with(
                refined,
                |h| self.next(super::HalfEdgeId(h)).0,
                |h| self.prev(super::HalfEdgeId(h)).0,
                |h| blocks.face(h),
            ),
        }
    }

    fn split_with(
        &self,
        refined: &mut Self,
        next: impl Fn(u32) -> u32 + Copy,
        prev: impl Fn(u32) -> u32 + Copy,
        face: impl Fn(u32) -> u32 + Copy,
    ) -> Result<(), MeshError> {
        let corners = self.corner_count() as u32;
        let (edges, faces) = (self.edge_count(), self.face_count());
        self.size(
            refined,
            4,
            u64::from(corners),
            self.vertex_count() + edges + faces,
        )?;
        let halves = Halves {
            corners,
            refined_corners: 4 * corners,
            degree: 4,
            first_of_corner: |h: u32| 4 * h,
            next,
        };
        let vertices = self.vertex_count() as u32;
        let face_points = vertices + edges as u32;
        let new_edges = 2 * edges as u32;
        let new = refined.origin.as_chunks_mut::<4>().0.iter_mut();
        let new = new.zip(refined.flip.as_chunks_mut::<4>().0);
        let new = new.zip(refined.edge.as_chunks_mut::<4>().0);
        for (h, ((origin, flip), edge)) in (0..corners).zip(new) {
            let (n, p) = (next(h), prev(h));
            let at = |list: &[u32], h: u32| list[h as usize];
            let (e, e_before) = (at(&self.edge, h), at(&self.edge, p));
            let (flip_h, flip_p) = (at(&self.flip, h), at(&self.flip, p));
            *origin = [
                at(&self.origin, h),
                vertices + e,
                face_points + face(h),
                vertices + e_before,
            ];
            *flip = [
                halves.second(flip_h),
                4 * n + 2,
                4 * p + 1,
                halves.first(flip_p),
            ];
            *edge = [
                2 * e + u32::from(h > flip_h),
                new_edges + h,
                new_edges + p,
                2 * e_before + u32::from(p < flip_p),
            ];
        }
        self.split_boundary(refined, &halves);
        self.link_refined(refined, &halves, |h| (4 * h + 1).min(4 * next(h) + 2));
        let face_half_edges = &mut refined.vertex_half_edge[face_points as usize..];
        for (f, stored) in self.faces().zip(face_half_edges) {
            *stored = 4 * self.face_half_edge(f).0 + 2;
        }
        Ok(())
    }

    /// The half-edges along the boundary, two for one.
    fn split_boundary(
        &self,
        refined: &mut Self,
        halves: &Halves<impl Fn(u32) -> u32, impl Fn(u32) -> u32>,
    ) {
        let vertices = self.vertex_count() as u32;
        let first = halves.refined_corners as usize;
        let corners = halves.corners as usize;
        for (at, b) in (corners..self.half_edge_count()).enumerate() {
            let pair = [2 * at, 2 * at + 1];
            let [one, two] = pair.map(|at| first + at);
            let (e, flip) = (self.edge[b], self.flip[b]);
            refined.origin[one] = self.origin[b];
            refined.origin[two] = vertices + e;
            refined.flip[one] = halves.second(flip);
            refined.flip[two] = halves.first(flip);
            // The number of b is larger than that of its flip.
            refined.edge[one] = 2 * e + 1;
            refined.edge[two] = 2 * e;
            refined.boundary_next[pair[0]] = two as u32;
            refined.boundary_next[pair[1]] = halves.first(self.boundary_next[at]);
            refined.boundary_prev[pair[0]] = halves.second(self.boundary_prev[at]);
            refined.boundary_prev[pair[1]] = one as u32;
        }
    }

    /// A half-edge of every old vertex, of the middle of every edge, and of every edge.
    fn link_refined(
        &self,
        refined: &mut Self,
        halves: &Halves<impl Fn(u32) -> u32, impl Fn(u32) -> u32>,
        new_edge: impl Fn(u32) -> u32,
    ) {
        let (old, middles) = refined.vertex_half_edge.split_at_mut(self.vertex_count());
        for (stored, &h) in old.iter_mut().zip(&self.vertex_half_edge) {
            *stored = halves.first(h);
        }
        let (pieces, inner) = refined.edge_half_edge.split_at_mut(2 * self.edge_count());
        let pieces = pieces.as_chunks_mut::<2>().0;
        for ((piece, middle), &h) in pieces.iter_mut().zip(middles).zip(&self.edge_half_edge) {
            let g = self.flip[h as usize];
            // At the boundary g has no face, and neither has its second half, which starts at the middle.
            *middle = halves.second(g);
            *piece = [
                halves.first(h).min(halves.second(g)),
                halves.second(h).min(halves.first(g)),
            ];
        }
        for (h, stored) in (0..halves.corners).zip(inner) {
            *stored = new_edge(h);
        }
    }

    /// Makes the lists of `refined` as long as they will be; what they hold is written over.
    fn size(
        &self,
        refined: &mut Self,
        degree: u32,
        faces: u64,
        vertices: usize,
    ) -> Result<(), MeshError> {
        let corners = u64::from(degree) * faces;
        let boundary = 2 * self.boundary_next.len();
        let half_edges = corners + boundary as u64;
        if half_edges > u64::from(u32::MAX) {
            return Err(MeshError::TooLarge { half_edges });
        }
        refined.blocks = Blocks::Uniform {
            degree,
            faces: faces as u32,
        };
        let half_edges = half_edges as usize;
        for list in [&mut refined.origin, &mut refined.flip, &mut refined.edge] {
            resize(list, half_edges);
        }
        resize(&mut refined.boundary_next, boundary);
        resize(&mut refined.boundary_prev, boundary);
        resize(&mut refined.vertex_half_edge, vertices);
        resize(
            &mut refined.edge_half_edge,
            2 * self.edge_count() + self.corner_count(),
        );
        Ok(())
    }

    /// All faces have this number of vertices.
    pub(in crate::subdivision) fn check_face_degree(
        &self,
        expected: usize,
    ) -> Result<(), MeshError> {
        let wrong = |f: &FaceId| self.face_degree(*f) != expected;
        let found = match &self.blocks {
            Blocks::Uniform { degree, .. } if *degree as usize == expected => None,
            _ => self.faces().find(wrong),
        };
        match found {
            None => Ok(()),
            Some(face) => Err(MeshError::FaceDegree {
                face,
                expected,
                found: self.face_degree(face),
            }),
        }
    }
}

/// A list of this length with any content; memory that is there is used again, and new memory is not written twice.
fn resize(list: &mut Vec<u32>, length: usize) {
    if length > list.capacity() {
        *list = vec![0; length];
    } else {
        list.resize(length, 0);
    }
}

#[cfg(test)]
mod tests {
    use crate::subdivision::{HalfEdgeMesh, solids};

    /// All equations between the elements, and the numbers of the blocks.
    fn check(mesh: &HalfEdgeMesh) {
        for h in mesh.half_edges() {
            assert_eq!(mesh.flip(mesh.flip(h)), h);
            assert_ne!(mesh.flip(h), h);
            assert_eq!(mesh.prev(mesh.next(h)), h);
            assert_eq!(mesh.next(mesh.prev(h)), h);
            assert_eq!(mesh.face(mesh.next(h)), mesh.face(h));
            assert_eq!(mesh.origin(mesh.flip(h)), mesh.origin(mesh.next(h)));
            assert_eq!(mesh.edge(h), mesh.edge(mesh.flip(h)));
            assert_eq!(mesh.origin(mesh.around_origin(h)), mesh.origin(h));
            let stored = mesh.vertex_half_edge(mesh.origin(h));
            assert_eq!(mesh.origin(stored), mesh.origin(h));
            assert!(mesh.face(h).is_some() || stored == h);
            let e = mesh.edge(h);
            assert_eq!(mesh.edge_half_edge(e), h.min(mesh.flip(h)));
        }
    }

    #[test]
    fn splitting_gives_the_mesh_of_its_faces() {
        let fan = solids::triangle_fan(7);
        let pentagon: [&[u32]; 3] = [&[0, 1, 2, 3, 4], &[1, 0, 5], &[2, 1, 5, 6]];
        let mixed = HalfEdgeMesh::from_faces(7, &pentagon).unwrap();
        let quadrilaterals = solids::quadrilateral_fan(5);
        let torus = solids::torus_triangles(3, 4);
        let rebuilt = |mesh: &HalfEdgeMesh| {
            check(mesh);
            let again = HalfEdgeMesh::from_faces(mesh.vertex_count(), &mesh.face_lists()).unwrap();
            check(&again);
            for h in mesh.half_edges().take(mesh.corner_count()) {
                let with_face = mesh.face(mesh.flip(h)).map(|_| mesh.flip(h));
                let expected = again.face(again.flip(h)).map(|_| again.flip(h));
                assert_eq!(with_face, expected);
            }
            assert_eq!(mesh.boundary_loops().len(), again.boundary_loops().len());
            assert_eq!(mesh.edge_count(), again.edge_count());
        };
        for mesh in [&fan, &mixed, &quadrilaterals, &torus] {
            let mut refined = mesh.clone();
            for _ in 0..2 {
                rebuilt(&refined);
                refined = refined.split_into_quadrilaterals().unwrap();
                assert_eq!(refined.euler_characteristic(), mesh.euler_characteristic());
            }
            rebuilt(&refined);
        }
        for mesh in [&fan, &torus] {
            let refined = mesh.split_triangles().unwrap().split_triangles().unwrap();
            assert_eq!(refined.euler_characteristic(), mesh.euler_characteristic());
            rebuilt(&refined);
        }
        assert!(mixed.split_triangles().is_err());
    }
}
