//! misconception: next(flip(h)) is the counterclockwise neighbour of h; but it is the clockwise one

use cagd::subdivision::HalfEdgeTables;

/// The neighbours of the origin of the half-edge `h`.
pub fn ring(tables: &HalfEdgeTables, h: usize) -> Vec<usize> {
    let end = |h: usize| tables.origin[tables.flip[h]];
    let mut half_edges = vec![h];
    let mut current = tables.next[tables.flip[h]];
    while current != h {
        half_edges.push(current);
        current = tables.next[tables.flip[current]];
    }
    if let Some(outer) = half_edges.iter().position(|&h| tables.face[h].is_none()) {
        half_edges.rotate_left(outer + 1);
    }
    half_edges.into_iter().map(end).collect()
}
