//! The neighbours of a vertex.

use cagd::subdivision::HalfEdgeTables;

/// The neighbours of the origin of the half-edge `h`, counterclockwise.
///
/// The first is the end of `h`; at the boundary the last is the end of the half-edge without face.
pub fn ring(tables: &HalfEdgeTables, h: usize) -> Vec<usize> {
    let end = |h: usize| tables.origin[tables.flip[h]];
    //@ solution
    let mut half_edges = vec![h];
    let mut current = tables.flip[tables.prev[h]];
    while current != h {
        half_edges.push(current);
        current = tables.flip[tables.prev[current]];
    }
    if let Some(outer) = half_edges.iter().position(|&h| tables.face[h].is_none()) {
        half_edges.rotate_left(outer + 1);
    }
    half_edges.into_iter().map(end).collect()
    //@ starter
    //| // Only the first neighbour.
    //| vec![end(h)]
    //@ end
}
