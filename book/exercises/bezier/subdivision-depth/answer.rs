//! How many halvings a tolerance needs.

use cagd::affine::Point;
use cagd::scalar::OrderedScalar;

/// The least number of halvings after which the chord bound of every piece is at most `tolerance`, which is positive.
pub fn depth<T: OrderedScalar>(b: &[Point<T, 2>], tolerance: T) -> usize {
    //@ solution
    let n = b.len() as i64 - 1;
    let mut largest = T::zero();
    for p in b.windows(3) {
        let v = (p[2].clone() - p[1].clone()) - (p[1].clone() - p[0].clone());
        largest = largest.max(v[0].abs()).max(v[1].abs());
    }
    let mut bound = T::from_ratio(n * (n - 1), 8) * largest;
    let mut halvings = 0;
    while bound > tolerance {
        bound /= T::from_integer(4);
        halvings += 1;
    }
    halvings
    //@ starter
    //| // This is right for straight lines.
    //| let _ = (b, tolerance);
    //| 0
    //@ end
}
