//! misconception: next runs around the vertex; but it runs around the face

use cagd::subdivision::HalfEdgeTables;

/// The neighbours of the origin of the half-edge `h`.
pub fn ring(tables: &HalfEdgeTables, h: usize) -> Vec<usize> {
    let end = |h: usize| tables.origin[tables.flip[h]];
    let mut vertices = vec![end(h)];
    let mut current = tables.next[h];
    while current != h {
        vertices.push(end(current));
        current = tables.next[current];
    }
    vertices
}
