//! Half-edges from lists of faces.

use super::connectivity::{Blocks, HalfEdgeMesh};
use super::{FaceId, MeshError, VertexId};

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
        let (blocks, mut origin) = corners(vertex_count, faces)?;
        let mut flip = pair_half_edges(vertex_count, &blocks, &origin)?;
        let (edge, edge_half_edge) = number_edges(&blocks, &mut flip, &mut origin);
        let mut mesh = Self {
            blocks,
            origin,
            flip,
            edge,
            boundary_next: vec![],
            boundary_prev: vec![],
            vertex_half_edge: vec![NONE; vertex_count],
            edge_half_edge,
        };
        mesh.link();
        mesh.check_vertices()?;
        Ok(mesh)
    }

    /// Gives every vertex a half-edge, one without face if it has one, and links those without face.
    fn link(&mut self) {
        for (h, &v) in self.origin.iter().enumerate() {
            let stored = &mut self.vertex_half_edge[v as usize];
            if *stored == NONE || h >= self.blocks.half_edges() {
                *stored = h as u32;
            }
        }
        let first = self.blocks.half_edges();
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

    /// Every vertex has faces, and they are one fan or one ring.
    fn check_vertices(&self) -> Result<(), MeshError> {
        let corners = self.blocks.half_edges();
        let mut faces = vec![0_u32; self.vertex_count()];
        for &v in &self.origin[..corners] {
            faces[v as usize] += 1;
        }
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

/// Of every half-edge with a face its flip; [`NONE`] at the boundary.
///
/// Each edge is put into the basket of that end which has fewer corners, and partners are found in the baskets.
/// So a vertex with very many edges does not make a long basket.
fn pair_half_edges(
    vertex_count: usize,
    blocks: &Blocks,
    origin: &[u32],
) -> Result<Vec<u32>, MeshError> {
    let mut corners = vec![0_u32; vertex_count];
    for &v in origin {
        corners[v as usize] += 1;
    }
    let mut ends = Vec::with_capacity(origin.len());
    for f in 0..blocks.faces() as u32 {
        let vertices = &origin[blocks.range(f).start as usize..blocks.range(f).end as usize];
        for (i, &start) in vertices.iter().enumerate() {
            let end = *vertices.get(i + 1).unwrap_or(&vertices[0]);
            let smaller = (corners[start as usize], start) < (corners[end as usize], end);
            ends.push(if smaller { (start, end) } else { (end, start) });
        }
    }
    // Counting sort: afterwards the basket of v lies between fill[v − 1] and fill[v].
    let mut fill = vec![0_u32; vertex_count + 1];
    for &(keeper, _) in &ends {
        fill[keeper as usize + 1] += 1;
    }
    for v in 0..vertex_count {
        fill[v + 1] += fill[v];
    }
    let mut baskets = vec![(0_u32, 0_u32); origin.len()];
    for (h, &(keeper, other)) in ends.iter().enumerate() {
        let place = &mut fill[keeper as usize];
        baskets[*place as usize] = (other, h as u32);
        *place += 1;
    }
    let mut flip = vec![NONE; origin.len()];
    let mut start = 0;
    for &end in &fill[..vertex_count] {
        let basket = &baskets[start..end as usize];
        for (i, &(other, h)) in basket.iter().enumerate() {
            for &(another, g) in &basket[i + 1..] {
                if other == another {
                    join(blocks, origin, &mut flip, h, g)?;
                }
            }
        }
        start = end as usize;
    }
    Ok(flip)
}

/// Makes two half-edges of the same edge the flips of each other.
fn join(
    blocks: &Blocks,
    origin: &[u32],
    flip: &mut [u32],
    h: u32,
    g: u32,
) -> Result<(), MeshError> {
    let end_of = |h: u32| {
        let block = blocks.range(blocks.face(h));
        origin[if h + 1 == block.end {
            block.start
        } else {
            h + 1
        } as usize]
    };
    let face = |h: u32| FaceId(blocks.face(h));
    let (start, end) = (VertexId(origin[h as usize]), VertexId(end_of(h)));
    for (half, third) in [(h, g), (g, h)] {
        let partner = flip[half as usize];
        if partner != NONE {
            return Err(MeshError::NonManifoldEdge {
                start,
                end,
                faces: [face(half), face(partner), face(third)],
            });
        }
    }
    if origin[h as usize] == origin[g as usize] {
        return Err(MeshError::InconsistentOrientation {
            start,
            end,
            faces: [face(h), face(g)],
        });
    }
    flip[h as usize] = g;
    flip[g as usize] = h;
    Ok(())
}

/// Adds the half-edges of the boundary and numbers the edges: the edge of every half-edge, a half-edge of every edge.
fn number_edges(
    blocks: &Blocks,
    flip: &mut Vec<u32>,
    origin: &mut Vec<u32>,
) -> (Vec<u32>, Vec<u32>) {
    let corners = flip.len();
    let mut edge = vec![NONE; corners];
    let mut edge_half_edge = Vec::with_capacity(corners / 2);
    for h in 0..corners {
        if flip[h] == NONE {
            let block = blocks.range(blocks.face(h as u32));
            let next = if h as u32 + 1 == block.end {
                block.start
            } else {
                h as u32 + 1
            };
            flip[h] = flip.len() as u32;
            flip.push(h as u32);
            origin.push(origin[next as usize]);
            edge.push(NONE);
        }
        if edge[h] == NONE {
            let e = edge_half_edge.len() as u32;
            edge[h] = e;
            edge[flip[h] as usize] = e;
            edge_half_edge.push(h as u32);
        }
    }
    (edge, edge_half_edge)
}
