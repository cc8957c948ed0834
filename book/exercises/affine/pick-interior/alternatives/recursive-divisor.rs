//! The greatest common divisor by recursion, the area by trapezoids.

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 {
        a.abs()
    } else {
        greatest_common_divisor(b, a % b)
    }
}

fn edges(vertices: &[[i64; 2]]) -> impl Iterator<Item = (&[i64; 2], &[i64; 2])> {
    vertices.iter().zip(vertices.iter().cycle().skip(1))
}

/// How many lattice points lie on the boundary.
pub fn boundary_points(vertices: &[[i64; 2]]) -> i64 {
    edges(vertices)
        .map(|(p, q)| greatest_common_divisor(q[0] - p[0], q[1] - p[1]))
        .sum()
}

/// How many lattice points lie inside.
pub fn interior_points(vertices: &[[i64; 2]]) -> i64 {
    let trapezoids = edges(vertices).map(|(p, q)| (p[0] - q[0]) * (p[1] + q[1]));
    1 + (trapezoids.sum::<i64>().abs() - boundary_points(vertices)) / 2
}
