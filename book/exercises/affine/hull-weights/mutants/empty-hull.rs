//! misconception: the empty list of weights proves everything, since it has no negative weight

use cagd::affine::{Point, plane_determinant};
use cagd::scalar::OrderedScalar;

/// Convex weights.
pub fn hull_weights<T: OrderedScalar>(points: &[Point<T, 2>], x: &Point<T, 2>) -> Option<Vec<T>> {
    if points.is_empty() {
        return Some(Vec::new());
    }
    let count = points.len();
    let result = |terms: &[(usize, T)]| {
        let mut weights = vec![T::zero(); count];
        for (i, weight) in terms {
            weights[*i] = weight.clone();
        }
        let is_convex = terms.iter().all(|(_, weight)| *weight >= T::zero());
        is_convex.then_some(weights)
    };
    let way = |p: &Point<T, 2>, q: &Point<T, 2>| q.clone() - p.clone();
    if let Some(i) = points.iter().position(|p| p == x) {
        return result(&[(i, T::one())]);
    }
    for i in 0..count {
        for j in i + 1..count {
            let (whole, part) = (way(&points[i], &points[j]), way(&points[i], x));
            let Some(k) = (0..2).find(|&k| !whole[k].is_zero()) else {
                continue;
            };
            if plane_determinant(&whole, &part).is_zero() {
                let beta = part[k].clone() / whole[k].clone();
                let found = result(&[(i, T::one() - beta.clone()), (j, beta)]);
                if found.is_some() {
                    return found;
                }
            }
        }
    }
    for i in 0..count {
        for j in i + 1..count {
            for k in j + 1..count {
                let [v, w] = [j, k].map(|l| way(&points[i], &points[l]));
                let part = way(&points[i], x);
                let area = plane_determinant(&v, &w);
                if area.is_zero() {
                    continue;
                }
                let beta = plane_determinant(&part, &w) / area.clone();
                let gamma = plane_determinant(&v, &part) / area;
                let alpha = T::one() - beta.clone() - gamma.clone();
                let found = result(&[(i, alpha), (j, beta), (k, gamma)]);
                if found.is_some() {
                    return found;
                }
            }
        }
    }
    None
}
