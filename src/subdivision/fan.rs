//! The neighbourhood of one extraordinary point: rings of a mesh, numbered so that a step maps rings to rings.

use super::{FaceId, Mesh, MeshError, SchemeError, SurfaceScheme, VertexId};
use crate::affine::Affine;

/// What the mesh around the extraordinary point consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FanNet {
    /// Triangles around a vertex of valence k.
    Triangles,
    /// Quadrilaterals around a vertex of valence k.
    Quadrilaterals,
    /// Quadrilaterals around a face with k vertices, the dual of the net before.
    AroundFace,
}

/// k equal sectors around an extraordinary point, with a number of rings; everywhere else the mesh is regular.
///
/// A vertex has a place (s, a, b): in sector s, a steps along its first border and b along its second.
/// A refined fan has places twice as fine, so a place is the same thing before and after a step.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{Fan, FanNet, Loop};
///
/// let fan = Fan::new(FanNet::Triangles, 5, 2)?;
/// assert_eq!(fan.len(), 1 + 5 * 3);
/// // The centre is raised; one step of Loop's scheme on the fan with twice as many rings.
/// let mut heights = vec![0.0; fan.len()];
/// heights[0] = 1.0;
/// let refined = fan.refine(&Loop, &heights)?;
/// assert_eq!(refined.len(), 1 + 5 * 10);
/// assert_eq!(refined[1], 0.375, "the edge point on the first spoke");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Fan {
    net: FanNet,
    valence: usize,
    rings: usize,
    /// The corners of the faces, those of the centre as seen from the sector of the face.
    faces: Vec<Vec<Place>>,
    /// The same faces as a mesh, closed by a copy of the fan where the net surrounds a vertex, with the index of a vertex of the fan at each vertex.
    mesh: Mesh<f64>,
    partner: Vec<usize>,
}

/// Sector, steps along its first border, steps along its second.
type Place = [usize; 3];

impl Fan {
    /// The fan of this net.
    ///
    /// # Arguments
    ///
    /// `valence` k ≥ 3 and `rings` ≥ 1; smaller numbers count as these.
    ///
    /// # Errors
    ///
    /// [`MeshError::TooLarge`] beyond 2³² half-edges.
    pub fn new(net: FanNet, valence: usize, rings: usize) -> Result<Self, MeshError> {
        let (valence, rings) = (valence.max(3), rings.max(1));
        let faces = faces(net, valence, rings);
        let index = |place: &Place| index(net, valence, rings, *place) as u32;
        let lists: Vec<Vec<u32>> = faces
            .iter()
            .map(|f| f.iter().map(index).collect())
            .collect();
        let count = len(net, valence, rings);
        let (lists, partner) = match net {
            FanNet::Triangles => closed(count, lists, 0)?,
            // Two more rings keep extraordinary vertices apart.
            FanNet::Quadrilaterals => closed(count, lists, 2)?,
            FanNet::AroundFace => (lists, (0..count).collect()),
        };
        let mesh = Mesh::from_faces(vec![0.0; partner.len()], &lists)?;
        Ok(Self {
            net,
            valence,
            rings,
            faces,
            mesh,
            partner,
        })
    }

    /// The number k of sectors.
    #[must_use]
    pub fn valence(&self) -> usize {
        self.valence
    }

    /// How many rings there are.
    #[must_use]
    pub fn rings(&self) -> usize {
        self.rings
    }

    /// How many vertices there are, the centre first if there is one, then sector by sector, ring by ring.
    #[must_use]
    pub fn len(&self) -> usize {
        len(self.net, self.valence, self.rings)
    }

    /// Never: there is a ring at least.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Whether the first vertex is a centre that belongs to no sector.
    #[must_use]
    pub fn has_centre(&self) -> bool {
        self.net != FanNet::AroundFace
    }

    /// How many vertices a sector has.
    #[must_use]
    pub fn sector_len(&self) -> usize {
        sector_len(self.net, self.rings)
    }

    /// The faces, by the numbers of their vertices, counterclockwise.
    pub fn faces(&self) -> impl Iterator<Item = Vec<usize>> + '_ {
        self.faces.iter().map(|face| self.numbers(face))
    }

    /// The faces of ring `from` + 1 up to ring `to`: between the polygons after `from` and after `to` steps from the centre.
    pub fn annulus(&self, from: usize, to: usize) -> impl Iterator<Item = Vec<usize>> + '_ {
        let within = move |face: &&Vec<Place>| {
            let rings = || face.iter().map(|&place| ring(self.net, place));
            rings().all(|ring| (from..=to).contains(&ring))
        };
        self.faces
            .iter()
            .filter(within)
            .map(|face| self.numbers(face))
    }

    /// The vertices `ring` steps from the centre, counterclockwise.
    #[must_use]
    pub fn ring(&self, ring: usize) -> Vec<usize> {
        let start = sector_len(
            self.net,
            ring.saturating_sub(1) + usize::from(!self.has_centre()),
        );
        let end = sector_len(self.net, ring + usize::from(!self.has_centre()));
        let first = |sector| usize::from(self.has_centre()) + sector * self.sector_len();
        let start = if ring == 0 { 0 } else { start };
        (0..self.valence)
            .flat_map(|sector| (start..end).map(move |at| (sector, at)))
            .map(|(sector, at)| first(sector) + at)
            .collect()
    }

    fn numbers(&self, face: &[Place]) -> Vec<usize> {
        let number = |&place: &Place| index(self.net, self.valence, self.rings, place);
        face.iter().map(number).collect()
    }

    /// How many rings the fan has after a step.
    #[must_use]
    pub fn refined_rings(&self) -> usize {
        match self.net {
            FanNet::AroundFace => 2 * self.rings - 1,
            _ => 2 * self.rings,
        }
    }

    /// The fan after a step.
    ///
    /// # Errors
    ///
    /// [`MeshError::TooLarge`] beyond 2³² half-edges.
    pub fn refined(&self) -> Result<Self, MeshError> {
        Self::new(self.net, self.valence, self.refined_rings())
    }

    /// Data of this fan after one step, for the vertices of the [refined](Self::refined) fan.
    ///
    /// Near the rim the values depend on how the fan is closed: what is at least one old ring away from it, for the
    /// interpolating schemes two, does not.
    ///
    /// # Errors
    ///
    /// [`SchemeError`] as for the scheme, and if there is not one point a vertex.
    pub fn refine<P: Affine>(
        &self,
        scheme: &impl SurfaceScheme<P>,
        points: &[P],
    ) -> Result<Vec<P>, SchemeError> {
        if points.len() != self.len() {
            return Err(SchemeError::Mesh(MeshError::PointCount {
                vertices: self.len(),
                points: points.len(),
            }));
        }
        let all = self.partner.iter().map(|&own| points[own].clone());
        let coarse = Mesh::new(self.mesh.connectivity().clone(), all.collect())?;
        let refined = scheme.refine(&coarse)?;
        let rings = self.refined_rings();
        let mut result = vec![points[0].clone(); len(self.net, self.valence, rings)];
        let old = coarse.connectivity();
        let mut set = |place: Place, vertex: usize| {
            let at = index(self.net, self.valence, rings, place);
            result[at] = refined.point(VertexId(vertex as u32)).clone();
        };
        for (f, corners) in self.faces.iter().enumerate() {
            let half_edges = old.face_half_edges(FaceId(f as u32));
            let n = corners.len();
            let sum = |p: Place, q: Place| [p[0], p[1] + q[1], p[2] + q[2]];
            for (i, h) in half_edges.enumerate() {
                let (corner, next) = (corners[i], corners[(i + 1) % n]);
                if self.net == FanNet::AroundFace {
                    set(dual_corner(self.faces[f].as_slice(), i), h.index());
                } else {
                    set(sum(corner, corner), old.origin(h).index());
                    set(sum(corner, next), old.vertex_count() + old.edge(h).index());
                }
            }
            if self.net == FanNet::Quadrilaterals {
                let middle = old.vertex_count() + old.edge_count() + f;
                set(sum(corners[0], corners[2]), middle);
            }
        }
        Ok(result)
    }
}

/// How many steps a vertex is away from the centre, around a face from the vertices of that face.
fn ring(net: FanNet, [_, a, b]: Place) -> usize {
    match net {
        FanNet::Triangles => a + b,
        _ => a.max(b),
    }
}

fn sector_len(net: FanNet, rings: usize) -> usize {
    match net {
        FanNet::Triangles => rings * (rings + 1) / 2,
        FanNet::Quadrilaterals => rings * (rings + 1),
        FanNet::AroundFace => rings * rings,
    }
}

fn len(net: FanNet, valence: usize, rings: usize) -> usize {
    usize::from(net != FanNet::AroundFace) + valence * sector_len(net, rings)
}

/// The number of the vertex at a place.
fn index(net: FanNet, valence: usize, rings: usize, [s, a, b]: Place) -> usize {
    let (s, a, b) = match (net, a, b) {
        (FanNet::AroundFace, ..) => (s, a, b),
        (_, 0, 0) => return 0,
        // The second border of a sector is the first of the next one.
        (_, 0, b) => (s + 1, b, 0),
        _ => (s, a, b),
    };
    let r = ring(net, [s, a, b]);
    let along = match net {
        FanNet::Triangles => b,
        _ if a == r => b,
        _ => 2 * r - a,
    };
    let before = match net {
        FanNet::AroundFace => r * r,
        _ => sector_len(net, r - 1),
    };
    usize::from(net != FanNet::AroundFace) + (s % valence) * sector_len(net, rings) + before + along
}

fn faces(net: FanNet, valence: usize, rings: usize) -> Vec<Vec<Place>> {
    let mut faces = vec![];
    if net == FanNet::AroundFace {
        faces.push((0..valence).map(|s| [s, 0, 0]).collect());
    }
    for s in 0..valence {
        let next = (s + 1) % valence;
        match net {
            FanNet::Triangles => {
                for a in 0..rings {
                    for b in 0..rings - a {
                        faces.push(vec![[s, a, b], [s, a + 1, b], [s, a, b + 1]]);
                        if a + b + 2 <= rings {
                            faces.push(vec![[s, a + 1, b], [s, a + 1, b + 1], [s, a, b + 1]]);
                        }
                    }
                }
            }
            FanNet::Quadrilaterals | FanNet::AroundFace => {
                let cells = rings - usize::from(net == FanNet::AroundFace);
                for a in 0..cells {
                    for b in 0..cells {
                        faces.push(vec![
                            [s, a, b],
                            [s, a + 1, b],
                            [s, a + 1, b + 1],
                            [s, a, b + 1],
                        ]);
                    }
                    if net == FanNet::AroundFace {
                        faces.push(vec![
                            [s, 0, a],
                            [s, 0, a + 1],
                            [next, a + 1, 0],
                            [next, a, 0],
                        ]);
                    }
                }
            }
        }
    }
    faces
}

/// Where the new vertex at corner i of a face around the dual net lies: twice as far out, one more where the face is farther out.
fn dual_corner(face: &[Place], i: usize) -> Place {
    let [s, a, b] = face[i];
    let reaches = |k: usize| {
        usize::from(
            face.iter()
                .any(|corner| corner[0] == s && corner[k] > face[i][k]),
        )
    };
    [s, 2 * a + reaches(1), 2 * b + reaches(2)]
}

/// The disc with `bridges` further rings around it and closed by a copy of itself; of each vertex the one of the disc whose data it has.
fn closed(
    count: usize,
    disc: Vec<Vec<u32>>,
    bridges: usize,
) -> Result<(Vec<Vec<u32>>, Vec<usize>), MeshError> {
    let open = super::HalfEdgeMesh::from_faces(count, &disc)?;
    let rim: Vec<[u32; 2]> = open
        .boundary_loops()
        .into_iter()
        .flatten()
        .map(|h| [open.origin(h).0, open.destination(h).0])
        .collect();
    let mut partner: Vec<usize> = (0..count).collect();
    // The vertices of the current rim, by the vertices of the disc.
    let mut current: Vec<u32> = (0..count as u32).collect();
    let mut lists = disc.clone();
    let mut copy = |of: usize| {
        partner.push(of);
        partner.len() as u32 - 1
    };
    for _ in 0..bridges {
        let mut outer = current.clone();
        for [u, _] in &rim {
            outer[*u as usize] = copy(*u as usize);
        }
        for [u, w] in &rim {
            let [u, w] = [*u, *w].map(|v| v as usize);
            lists.push(vec![current[u], current[w], outer[w], outer[u]]);
        }
        current = outer;
    }
    for (v, twin) in current.iter_mut().enumerate() {
        if !open.is_boundary(VertexId(v as u32)) {
            *twin = copy(v);
        }
    }
    for face in disc {
        lists.push(face.iter().rev().map(|&v| current[v as usize]).collect());
    }
    Ok((lists, partner))
}
