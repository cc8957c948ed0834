//! misconception: an edge has gcd + 1 lattice points, and these numbers are added, so that each vertex counts twice

/// How many lattice points lie on the boundary.
pub fn boundary_points(vertices: &[[i64; 2]]) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let on_edge = |(p, q): (&[i64; 2], &[i64; 2])| {
        let (mut a, mut b) = ((q[0] - p[0]).abs(), (q[1] - p[1]).abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a + 1
    };
    vertices.iter().zip(next).map(on_edge).sum()
}

/// How many lattice points lie inside.
pub fn interior_points(vertices: &[[i64; 2]]) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let determinants = vertices
        .iter()
        .zip(next)
        .map(|(p, q)| p[0] * q[1] - p[1] * q[0]);
    let sum = determinants.sum::<i64>();
    let boundary = boundary_points(vertices);
    (sum.abs() - boundary + 2) / 2
}
