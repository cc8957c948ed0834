//! misconception: the area is complete at the last vertex, so the edge back to the first is not needed

/// How many lattice points lie on the boundary.
pub fn boundary_points(vertices: &[[i64; 2]]) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let on_edge = |(p, q): (&[i64; 2], &[i64; 2])| {
        let (mut a, mut b) = ((q[0] - p[0]).abs(), (q[1] - p[1]).abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    vertices.iter().zip(next).map(on_edge).sum()
}

/// How many lattice points lie inside.
pub fn interior_points(vertices: &[[i64; 2]]) -> i64 {
    let edges = vertices.windows(2);
    let sum: i64 = edges.map(|e| e[0][0] * e[1][1] - e[0][1] * e[1][0]).sum();
    (sum.abs() - boundary_points(vertices) + 2) / 2
}
