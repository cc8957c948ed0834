//! misconception: at the boundary the walk is over; but the neighbours on the other side of h are forgotten

use cagd::subdivision::HalfEdgeTables;

/// The neighbours of the origin of the half-edge `h`.
pub fn ring(tables: &HalfEdgeTables, h: usize) -> Vec<usize> {
    let end = |h: usize| tables.origin[tables.flip[h]];
    let mut half_edges = vec![h];
    let mut current = tables.flip[tables.prev[h]];
    while current != h && tables.face[half_edges[half_edges.len() - 1]].is_some() {
        half_edges.push(current);
        current = tables.flip[tables.prev[current]];
    }
    half_edges.into_iter().map(end).collect()
}
