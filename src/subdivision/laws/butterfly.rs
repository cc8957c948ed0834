//! Laws of the modified Butterfly scheme.

use super::catmull_clark::{Refined, flat, largest, refused, shown};
use super::loop_scheme::{Opposite, split_in_four, weighted_sum};
use crate::affine::Point;
use crate::law::{Rounding, Sides};
use crate::subdivision::{CosineError, CosineOfTurn, Mesh};

/// The weights of the neighbours of a vertex of valence k on the edge to the first, as the statement gives them.
fn star<T: CosineOfTurn>(k: usize) -> Result<Vec<T>, CosineError> {
    let twelfths = |list: &[i64]| Ok(list.iter().map(|&n| T::from_ratio(n, 24)).collect());
    match k {
        3 => twelfths(&[10, -2, -2]),
        4 => twelfths(&[9, 0, -3, 0]),
        _ => (0..k as i64)
            .map(|j| {
                let once = T::cosine_of_turn(j, k)?;
                let twice = T::cosine_of_turn(2 * j, k)?;
                let four = T::from_integer(4);
                let sum = T::one() + once * four.clone() + twice * T::from_integer(2);
                Ok(sum / (four * T::from_integer(k as i64)))
            })
            .collect(),
    }
}

/// `subdivision-modified-butterfly`: every new point satisfies its rule.
///
/// `implementation(mesh)` must give the refined mesh, the old vertices first, then one vertex an edge in the order of the edges.
/// The stencils are collected from the lists of faces, without half-edges, and compared as 16e'.
/// At the boundary they are those of the four-point scheme, 16e' = 9(a + b) − (before + after); an end on the boundary counts
/// as regular, and a wing that is missing beyond an edge pq of a triangle pqr is p + q − r.
///
/// # Rounding
///
/// With valences up to k at most 2k + 40 roundings a term; the absolute weights of a stencil, completed wings included, sum to
/// at most 2, so the terms on both sides to at most 64 times the largest coordinate.
pub fn modified_butterfly<T: CosineOfTurn>(
    implementation: impl Fn(&Mesh<Point<T, 3>>) -> Refined<Point<T, 3>>,
    mesh: &Mesh<Point<T, 3>>,
) -> Sides<T> {
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let refined = match implementation(mesh) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let count = old.vertex_count() + old.edge_count();
    if refined.points().len() != count {
        return refused(sides, &"one point for each vertex and edge");
    }
    let opposite = Opposite::of(mesh);
    // The neighbours of an inner vertex a, counterclockwise from b on; none of a vertex on the boundary.
    let around = |a: u32, b: u32| {
        let mut ring = vec![b];
        let mut next = opposite.left_of(a, b)?;
        while next != b && ring.len() <= old.edge_count() {
            ring.push(next);
            next = opposite.left_of(a, next)?;
        }
        Some(ring)
    };
    // The vertices before and after each one along the boundary.
    let boundary = opposite.boundary();
    let sixteen = T::from_integer(16);
    let widest = old.vertices().map(|v| old.valence(v)).max().unwrap_or(3);
    let rounding = Rounding::new(2 * widest + 40, 64.0 * largest(mesh.points()));
    let (mut found, mut expected) = (vec![], vec![]);
    for e in old.edges() {
        let [a, b] = old.edge_vertices(e).map(|v| v.0);
        let mut terms = vec![];
        let mut stars = 0;
        for (a, b) in [(a, b), (b, a)] {
            let Some(ring) = around(a, b).filter(|ring| ring.len() != 6) else {
                continue;
            };
            let weights = match star::<T>(ring.len()) {
                Ok(weights) => weights,
                Err(error) => return refused(sides, &error),
            };
            stars += 1;
            terms.push((T::from_integer(12), a));
            let weights = weights.into_iter().map(|w| w * sixteen.clone());
            terms.extend(weights.zip(ring));
        }
        let sides_of_edge =
            [(a, b), (b, a)].map(|(a, b)| opposite.left_of(a, b).map(|c| [a, b, c]));
        if let [None, Some([b, a, _])] | [Some([b, a, _]), None] = sides_of_edge {
            let beyond = [boundary[&a].0, boundary[&b].1];
            terms = [a, b].map(|v| (T::from_integer(9), v)).to_vec();
            terms.extend(beyond.map(|v| (T::from_integer(-1), v)));
        } else if stars == 0 {
            for [a, b, c] in sides_of_edge.into_iter().flatten() {
                terms.extend([(T::from_integer(8), a), (T::from_integer(2), c)]);
                for (p, q, r) in [(a, c, b), (c, b, a)] {
                    match opposite.left_of(p, q) {
                        Some(wing) => terms.push((T::from_integer(-1), wing)),
                        None => terms.extend(
                            [(-1, p), (-1, q), (1, r)].map(|(n, v)| (T::from_integer(n), v)),
                        ),
                    }
                }
            }
        } else if stars == 2 {
            let half = T::from_ratio(1, 2);
            terms
                .iter_mut()
                .for_each(|(w, _)| *w = w.clone() * half.clone());
        }
        let point = &refined.points()[old.vertex_count() + e.index()];
        found.extend(flat([point]).into_iter().map(|x| x * sixteen.clone()));
        expected.extend(weighted_sum(mesh, &terms));
    }
    sides
        .equal("new points", found, expected, rounding)
        .equal(
            "old points stay",
            flat(&refined.points()[..old.vertex_count()]),
            flat(mesh.points()),
            Rounding::none(),
        )
        .and(split_in_four(mesh, &refined))
}

/// `subdivision-modified-butterfly-properties`: the eigenvalues of the star of a vertex of valence k, and cubic polynomials.
///
/// `star(k)` must give the weights of the neighbours, `refine(k)` the data of a fan of valence 6 with two rings after a step,
/// for data in the order of [`Fan`](crate::subdivision::Fan).
/// The claims: Σ sⱼ = 1/4; Σ sⱼ cos(2πjf/k) is 1/2 for the frequencies f = ±1, 1/4 for ±2 and 0 for all others; and from the values
/// of 1, x, y, x², …, y³ at the lattice points of two rings of a regular mesh the scheme makes their values at the new points of the first ring.
///
/// # Rounding
///
/// With valence k at most 2k + 40 roundings of terms of at most 1, k of them; the cubic polynomials take whole values up to 8.
pub fn modified_butterfly_properties<T: CosineOfTurn>(
    star: impl Fn(usize) -> Result<Vec<T>, CosineError>,
    regular: impl Fn(&[T]) -> Vec<T>,
    k: usize,
) -> Sides<T> {
    let sides = Sides::new(format!("valence {k}"));
    let weights = match star(k) {
        Ok(weights) => weights,
        Err(error) => return refused(sides, &error),
    };
    let rounding = Rounding::new(2 * k + 40, 2.0 * k as f64);
    let (mut found, mut expected) = (vec![], vec![]);
    for f in 0..k as i64 {
        let mut sum = T::zero();
        for (j, weight) in (0..).zip(&weights) {
            match T::cosine_of_turn(j * f, k) {
                Ok(cosine) => sum += weight.clone() * cosine,
                Err(error) => return refused(sides, &error),
            }
        }
        found.push(sum);
        let distance = f.min(k as i64 - f);
        expected.push(match distance {
            0 | 2 => T::from_ratio(1, 4),
            1 => T::from_ratio(1, 2),
            _ => T::zero(),
        });
    }
    let mut sides = sides.equal("Σ s_j cos(2πjf/k), f = 0, 1, …", found, expected, rounding);
    // Places of the fan with two rings: the centre, and in each of six sectors 1, 2, and 2 with one step aside.
    let directions: [[i64; 2]; 6] = [[1, 0], [1, 1], [0, 1], [-1, 0], [-1, -1], [0, -1]];
    let places = |rings: i64| {
        let ring = |s: usize, r: i64, b: i64| {
            let (p, q) = (directions[s], directions[(s + 1) % 6]);
            [0, 1].map(|k: usize| (r - b) * p[k] + b * q[k])
        };
        let outer = (0..6)
            .flat_map(move |s| (1..=rings).flat_map(move |r| (0..r).map(move |b| ring(s, r, b))));
        std::iter::once([0, 0]).chain(outer).collect::<Vec<_>>()
    };
    for degrees in (0..=3u32).flat_map(|m| (0..=3 - m).map(move |n| [m, n])) {
        let value = |[x, y]: [i64; 2]| x.pow(degrees[0]) * y.pow(degrees[1]);
        let data: Vec<T> = places(2)
            .into_iter()
            .map(|p| T::from_integer(value(p)))
            .collect();
        let refined = regular(&data);
        let scale = 2_i64.pow(degrees[0] + degrees[1]);
        // The refined fan has four rings; the first of them is far enough from the rim.
        let new = places(4);
        let inner = (0..new.len().min(refined.len()))
            .filter(|&i| new[i].iter().all(|x| x.abs() <= 1))
            .filter(|&i| new[i][0] * new[i][1] >= 0);
        let (found, expected): (Vec<T>, Vec<T>) = inner
            .map(|i| (refined[i].clone(), T::from_ratio(value(new[i]), scale)))
            .unzip();
        sides = sides.equal(
            format!("x^{} y^{} is reproduced", degrees[0], degrees[1]),
            found,
            expected,
            Rounding::new(20, 32.0),
        );
    }
    sides
}
