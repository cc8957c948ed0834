//! Two points of a set whose segment leaves it, for four sets.

use cagd::scalar::{BigRational, Scalar};

/// Two points P and Q of a set, and a number t for which (1 − t)P + tQ does not belong to it.
pub struct Witness {
    /// The coordinates of P.
    pub p: [i64; 2],
    /// The coordinates of Q.
    pub q: [i64; 2],
    /// Where on the segment from P to Q: 0 ≤ t ≤ 1.
    pub t: BigRational,
}

/// For the ring 4 ≤ x² + y² ≤ 25.
pub fn ring() -> Witness {
    //@ solution
    Witness {
        p: [-3, 0],
        q: [3, 0],
        t: BigRational::from_ratio(1, 2),
    }
    //@ starter
    //| // These two points belong to the ring, and so does the point half-way.
    //| Witness { p: [3, 0], q: [3, 2], t: BigRational::from_ratio(1, 2) }
    //@ end
}

/// For the crescent x² + y² ≤ 25, (x − 4)² + y² ≥ 25.
pub fn crescent() -> Witness {
    //@ solution
    Witness {
        p: [0, -5],
        q: [0, 5],
        t: BigRational::from_ratio(1, 2),
    }
    //@ starter
    //| // Nothing is chosen here yet.
    //| Witness { p: [0, 0], q: [0, 0], t: BigRational::from_ratio(1, 2) }
    //@ end
}

/// For the discs with radius 3 around (4, 0) and (−4, 0).
pub fn two_discs() -> Witness {
    //@ solution
    Witness {
        p: [-4, 0],
        q: [4, 0],
        t: BigRational::from_ratio(1, 2),
    }
    //@ starter
    //| // Nor here.
    //| Witness { p: [0, 0], q: [0, 0], t: BigRational::from_ratio(1, 2) }
    //@ end
}

/// For the circle line x² + y² = 25.
pub fn circle_line() -> Witness {
    //@ solution
    Witness {
        p: [3, 4],
        q: [5, 0],
        t: BigRational::from_ratio(1, 2),
    }
    //@ starter
    //| // Nor here.
    //| Witness { p: [0, 0], q: [0, 0], t: BigRational::from_ratio(1, 2) }
    //@ end
}
