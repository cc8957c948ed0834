//! Vectors scaled by powers of two, so that products of coordinates stay in range.

/// A vector as 2^`exponent` times coordinates of which the largest absolute value is in [1, 2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scaled<const D: usize> {
    pub(crate) coordinates: [f64; D],
    pub(crate) exponent: i32,
}

impl<const D: usize> Scaled<D> {
    /// `None` for the zero vector. The coordinates must be finite.
    ///
    /// Scaling is exact, but for coordinates 2¹⁰²² times smaller than the largest: those may lose digits
    /// that are far below the unit roundoff of the vector.
    pub(crate) fn new(coordinates: &[f64]) -> Option<Self> {
        let exponent = exponent(coordinates)?;
        Some(Self {
            coordinates: std::array::from_fn(|k| libm::scalbn(coordinates[k], -exponent)),
            exponent,
        })
    }

    /// The squared length, in [1, 4D).
    pub(crate) fn square(&self) -> f64 {
        self.coordinates.iter().map(|x| x * x).sum()
    }
}

/// The exponent e with 2ᵉ ≤ max|xₖ| < 2ᵉ⁺¹; `None` if all are 0.
pub(crate) fn exponent(coordinates: &[f64]) -> Option<i32> {
    let largest = coordinates.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    (largest != 0.0).then(|| libm::ilogb(largest))
}

/// The Euclidean length of a vector, without overflow or underflow on the way.
pub(crate) fn length(coordinates: &[f64]) -> f64 {
    let Some(exponent) = exponent(coordinates) else {
        return 0.0;
    };
    // In this range no square overflows, and none that counts underflows.
    if (-400..400).contains(&exponent) {
        return libm::sqrt(coordinates.iter().map(|x| x * x).sum());
    }
    let square: f64 = coordinates
        .iter()
        .map(|x| libm::scalbn(*x, -exponent))
        .map(|x| x * x)
        .sum();
    libm::scalbn(libm::sqrt(square), exponent)
}

/// a·d − b·c with a relative error of at most 2u, by two fused multiply-adds.
///
/// Without them the rounding of the products would be all that is left of a small determinant.
/// (Kahan's method; the bound is that of Jeannerod, Louvet and Muller, `jeannerod2013`.)
pub(crate) fn determinant(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = b * c;
    let error = f64::mul_add(-b, c, product);
    let difference = f64::mul_add(a, d, -product);
    difference + error
}

/// The cross product, each coordinate with a relative error of at most 2u.
pub(crate) fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [
        determinant(a[1], a[2], b[1], b[2]),
        determinant(a[2], a[0], b[2], b[0]),
        determinant(a[0], a[1], b[0], b[1]),
    ]
}
