//! misconception: the neighbours are a cycle at every vertex; at the boundary the cycle has a gap, and the list must not run across it

use cagd::subdivision::HalfEdgeTables;

/// The neighbours of the origin of the half-edge `h`.
pub fn ring(tables: &HalfEdgeTables, h: usize) -> Vec<usize> {
    let end = |h: usize| tables.origin[tables.flip[h]];
    let mut half_edges = vec![h];
    let mut current = tables.flip[tables.prev[h]];
    while current != h {
        half_edges.push(current);
        current = tables.flip[tables.prev[current]];
    }
    half_edges.into_iter().map(end).collect()
}
