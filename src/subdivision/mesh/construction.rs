//! Half-edges from lists of faces.

use super::connectivity::{Blocks, HalfEdgeMesh};
use super::{FaceId, HalfEdgeId, MeshError, VertexId};

/// No half-edge yet.
const NONE: u32 = u32::MAX;

impl HalfEdgeMesh {
    /// The mesh with these faces, each a list of its vertices counterclockwise as seen from outside.
    ///
    /// Half-edges are numbered face by face in the order of the lists, edges by their first half-edge.
    /// Time and memory are linear in the number of corners, unless many edges join vertices that all have many edges.
    ///
    /// # Errors
    ///
    /// [`MeshError`] names the first element that is not that of an oriented manifold with `vertex_count` vertices.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::HalfEdgeMesh;
    ///
    /// let tetrahedron = HalfEdgeMesh::from_faces(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
    /// assert_eq!(tetrahedron.euler_characteristic(), 2);
    ///
    /// let mixed: [&[u32]; 2] = [&[0, 1, 2, 3], &[1, 0, 4]];
    /// assert_eq!(HalfEdgeMesh::from_faces(5, &mixed)?.edge_count(), 6);
    /// # Ok::<(), cagd::subdivision::MeshError>(())
    /// ```
    pub fn from_faces<F: AsRef<[u32]>>(
        vertex_count: usize,
        faces: &[F],
    ) -> Result<Self, MeshError> {
        let (blocks, origin) = corners(vertex_count, faces)?;
        let mut faces = vec![0; vertex_count];
        for &v in &origin {
            faces[v as usize] += 1;
        }
        let mut mesh = Self {
            flip: vec![NONE; origin.len()],
            edge: vec![NONE; origin.len()],
            edge_half_edge: Vec::with_capacity(origin.len() / 2),
            vertex_half_edge: vec![NONE; vertex_count],
            boundary_next: vec![],
            boundary_prev: vec![],
            blocks,
            origin,
        };
        mesh.pair_half_edges(&faces)?;
        mesh.close_boundary();
        mesh.check_vertices(&faces)?;
        Ok(mesh)
    }

    /// Gives every edge a number and its one or two half-edges, and every vertex its first half-edge.
    ///
    /// `faces` tells how many faces each vertex has.
    ///
    /// Each edge is kept in the list of that end which has fewer faces, and a partner is looked for there.
    /// So a vertex with very many edges does not make a long list.
    fn pair_half_edges(&mut self, faces: &[u32]) -> Result<(), MeshError> {
        // Of every vertex the last half-edge of its list; of every half-edge the one before, and the other end of its edge.
        let mut last = vec![NONE; self.vertex_count()];
        let mut list = vec![(NONE, NONE); self.origin.len()];
        for f in 0..self.blocks.faces() as u32 {
            let block = self.blocks.range(f);
            for h in block.clone() {
                let next = if h + 1 == block.end {
                    block.start
                } else {
                    h + 1
                };
                let [start, end] = [h, next].map(|h| self.origin[h as usize]);
                let stored = &mut self.vertex_half_edge[start as usize];
                *stored = (*stored).min(h);
                let smaller = (faces[start as usize], start) < (faces[end as usize], end);
                let (keeper, other) = if smaller { (start, end) } else { (end, start) };
                let mut g = last[keeper as usize];
                while g != NONE && list[g as usize].1 != other {
                    g = list[g as usize].0;
                }
                if g == NONE {
                    list[h as usize] = (last[keeper as usize], other);
                    last[keeper as usize] = h;
                    self.edge[h as usize] = self.edge_half_edge.len() as u32;
                    self.edge_half_edge.push(h);
                } else {
                    self.join(g, h)?;
                    self.edge[h as usize] = self.edge[g as usize];
                }
            }
        }
        Ok(())
    }

    /// Makes two half-edges of the same edge the flips of each other.
    fn join(&mut self, h: u32, g: u32) -> Result<(), MeshError> {
        let face = |h: u32| FaceId(self.blocks.face(h));
        // Before there is a boundary, `next` runs around faces.
        let start = self.origin(HalfEdgeId(h));
        let end = || self.origin(self.next(HalfEdgeId(h)));
        let partner = self.flip[h as usize];
        if partner != NONE {
            return Err(MeshError::NonManifoldEdge {
                start,
                end: end(),
                faces: [face(h), face(partner), face(g)],
            });
        }
        if start.0 == self.origin[g as usize] {
            return Err(MeshError::InconsistentOrientation {
                start,
                end: end(),
                faces: [face(h), face(g)],
            });
        }
        self.flip[h as usize] = g;
        self.flip[g as usize] = h;
        Ok(())
    }

    /// Adds a half-edge without face beside every one that has no partner, and links them; it becomes that of its vertex.
    fn close_boundary(&mut self) {
        let first = self.blocks.half_edges();
        for h in 0..first {
            if self.flip[h] == NONE {
                let end = self.origin(self.next(HalfEdgeId(h as u32))).0;
                let beside = self.flip.len() as u32;
                self.flip[h] = beside;
                self.flip.push(h as u32);
                self.origin.push(end);
                self.edge.push(self.edge[h]);
                self.vertex_half_edge[end as usize] = beside;
            }
        }
        let count = self.origin.len() - first;
        self.boundary_next = vec![NONE; count];
        self.boundary_prev = vec![NONE; count];
        for at in 0..count {
            let destination = self.origin[self.flip[first + at] as usize];
            let next = self.vertex_half_edge[destination as usize];
            self.boundary_next[at] = next;
            self.boundary_prev[next as usize - first] = (first + at) as u32;
        }
    }

    /// Every vertex has faces, as many as `faces` tells, and they are one fan or one ring.
    fn check_vertices(&self, faces: &[u32]) -> Result<(), MeshError> {
        let corners = self.blocks.half_edges();
        for v in self.vertices() {
            let faces = faces[v.index()] as usize;
            if faces == 0 {
                return Err(MeshError::UnusedVertex { vertex: v });
            }
            let start = self.vertex_half_edge(v);
            let mut h = start;
            let mut reached = 0;
            // Where two fans touch, a vertex has two half-edges without face, and links of the boundary are missing
            // or lead from one fan to the other; so the walk ends as well when it has seen as many faces as there are.
            loop {
                reached += usize::from(h.index() < corners);
                if h.index() >= corners && self.boundary_prev[h.index() - corners] == NONE {
                    break;
                }
                h = self.around_origin(h);
                if h == start || reached > faces {
                    break;
                }
            }
            if reached != faces {
                return Err(MeshError::NonManifoldVertex {
                    vertex: v,
                    faces,
                    reached,
                });
            }
        }
        Ok(())
    }
}

/// The blocks of the faces, and the origins of their half-edges.
fn corners<F: AsRef<[u32]>>(
    vertex_count: usize,
    faces: &[F],
) -> Result<(Blocks, Vec<u32>), MeshError> {
    let Some(head) = faces.first() else {
        return Err(MeshError::Empty);
    };
    let degree = head.as_ref().len();
    let mut count = 0;
    let mut uniform = true;
    for face in faces {
        count += face.as_ref().len();
        uniform &= face.as_ref().len() == degree;
    }
    // With a boundary there are at most as many half-edges again.
    let half_edges = (count as u64).max(vertex_count as u64).saturating_mul(2);
    if half_edges > u64::from(u32::MAX) {
        return Err(MeshError::TooLarge { half_edges });
    }
    let mut origin = Vec::with_capacity(count);
    for (f, face) in faces.iter().enumerate() {
        check_face(vertex_count, FaceId::at(f), face.as_ref())?;
        origin.extend_from_slice(face.as_ref());
    }
    let blocks = if uniform {
        Blocks::Uniform {
            degree: degree as u32,
            faces: faces.len() as u32,
        }
    } else {
        let mut first = vec![0];
        let mut face_of = Vec::with_capacity(count);
        for (f, face) in faces.iter().enumerate() {
            face_of.extend(face.as_ref().iter().map(|_| f as u32));
            first.push(face_of.len() as u32);
        }
        Blocks::Mixed {
            first,
            face: face_of,
        }
    };
    Ok((blocks, origin))
}

fn check_face(vertex_count: usize, face: FaceId, vertices: &[u32]) -> Result<(), MeshError> {
    if vertices.len() < 3 {
        return Err(MeshError::FaceTooSmall {
            face,
            degree: vertices.len(),
        });
    }
    for (corner, &index) in vertices.iter().enumerate() {
        if index as usize >= vertex_count {
            return Err(MeshError::DanglingIndex {
                face,
                corner,
                index,
                vertices: vertex_count,
            });
        }
    }
    // Comparing all pairs is quick for usual faces; a long list is sorted.
    let repeated = if vertices.len() <= 8 {
        (1..vertices.len())
            .find(|&i| vertices[..i].contains(&vertices[i]))
            .map(|i| vertices[i])
    } else {
        let mut sorted = vertices.to_vec();
        sorted.sort_unstable();
        sorted
            .windows(2)
            .find(|pair| pair[0] == pair[1])
            .map(|pair| pair[0])
    };
    match repeated {
        None => Ok(()),
        Some(vertex) => Err(MeshError::RepeatedVertex {
            face,
            vertex: VertexId(vertex),
        }),
    }
}
