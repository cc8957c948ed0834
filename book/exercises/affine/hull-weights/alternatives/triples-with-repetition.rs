//! All triples with repetitions, so that points and segments are triples too.

use cagd::affine::{AffineBasis, Point};
use cagd::scalar::OrderedScalar;

/// Convex weights on a segment, which may be a point.
fn on_segment<T: OrderedScalar>(
    p: &Point<T, 2>,
    q: &Point<T, 2>,
    x: &Point<T, 2>,
) -> Option<[T; 2]> {
    if p == x {
        return Some([T::one(), T::zero()]);
    }
    let (whole, part) = (q.clone() - p.clone(), x.clone() - p.clone());
    let k = (0..2).find(|&k| !whole[k].is_zero())?;
    let ratio = part[k].clone() / whole[k].clone();
    let fits = T::zero() <= ratio && ratio <= T::one() && whole * ratio.clone() == part;
    fits.then(|| [T::one() - ratio.clone(), ratio])
}

/// Convex weights.
pub fn hull_weights<T: OrderedScalar>(points: &[Point<T, 2>], x: &Point<T, 2>) -> Option<Vec<T>> {
    let n = points.len();
    let triples = (0..n * n * n).map(|m| [m / n / n, m / n % n, m % n]);
    for triple in triples {
        let corners = triple.map(|i| points[i].clone());
        let found = match AffineBasis::new(corners.clone()) {
            Ok(basis) => basis.coordinates(x),
            Err(_) => match on_segment(&corners[0], &corners[1], x) {
                Some([a, b]) => vec![a, b, T::zero()],
                None => continue,
            },
        };
        if found.iter().all(|weight| *weight >= T::zero()) {
            let mut weights = vec![T::zero(); n];
            for (i, weight) in triple.into_iter().zip(found) {
                weights[i] += weight;
            }
            return Some(weights);
        }
    }
    None
}
