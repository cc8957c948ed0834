//! The number of lattice points inside a polygon, by Pick's theorem.

/// How many lattice points lie on the boundary of the simple polygon with these vertices.
pub fn boundary_points(vertices: &[[i64; 2]]) -> i64 {
    //@ solution
    let next = vertices.iter().cycle().skip(1);
    let on_edge = |(p, q): (&[i64; 2], &[i64; 2])| {
        let (mut a, mut b) = ((q[0] - p[0]).abs(), (q[1] - p[1]).abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    vertices.iter().zip(next).map(on_edge).sum()
    //@ starter
    //| // The vertices lie on the boundary; are there others?
    //| vertices.len() as i64
    //@ end
}

/// How many lattice points lie strictly inside the simple polygon with these vertices.
pub fn interior_points(vertices: &[[i64; 2]]) -> i64 {
    //@ solution
    let next = vertices.iter().cycle().skip(1);
    let determinants = vertices
        .iter()
        .zip(next)
        .map(|(p, q)| p[0] * q[1] - p[1] * q[0]);
    let twice_area = determinants.sum::<i64>().abs();
    (twice_area - boundary_points(vertices) + 2) / 2
    //@ starter
    //| // The area is missing, and the theorem.
    //| boundary_points(vertices)
    //@ end
}
