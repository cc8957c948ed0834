//! misconception: the half-edge without face comes first; counterclockwise the faces begin behind it, so it is the last

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
    if let Some(outer) = half_edges.iter().position(|&h| tables.face[h].is_none()) {
        half_edges.rotate_left(outer);
    }
    half_edges.into_iter().map(end).collect()
}
