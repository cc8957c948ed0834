//! misconception: the centre of the ring belongs to it, so a segment that goes out from there leaves the set in the hole

use cagd::scalar::{BigRational, Scalar};

/// Two points and where on their segment.
pub struct Witness {
    /// The coordinates of P.
    pub p: [i64; 2],
    /// The coordinates of Q.
    pub q: [i64; 2],
    /// Where on the segment.
    pub t: BigRational,
}

/// A witness.
pub fn ring() -> Witness {
    Witness {
        p: [0, 0],
        q: [3, 0],
        t: BigRational::from_ratio(1, 3),
    }
}

/// A witness.
pub fn crescent() -> Witness {
    Witness {
        p: [0, -5],
        q: [0, 5],
        t: BigRational::from_ratio(1, 2),
    }
}

/// A witness.
pub fn two_discs() -> Witness {
    Witness {
        p: [-4, 0],
        q: [4, 0],
        t: BigRational::from_ratio(1, 2),
    }
}

/// A witness.
pub fn circle_line() -> Witness {
    Witness {
        p: [3, 4],
        q: [5, 0],
        t: BigRational::from_ratio(1, 2),
    }
}
