//! Barycentric coordinates on a line, in a space of any dimension.

use num_traits::{One, Zero};
use thiserror::Error;

use super::Affine;
use super::combination::written;
use crate::law::gamma;
use crate::scalar::Scalar;

/// The barycentric coordinates (α, β) of a point G of the line through A and B.
///
/// ```text
/// G = α·A + β·B,   α + β = 1,   α = (B − G)/(B − A),   β = (G − A)/(B − A)
/// ```
///
/// The quotient of two vectors on one line is taken in the coordinate in which A and B are farthest apart.
///
/// # Errors
///
/// [`LineCoordinatesError`] if A = B, if G is not on the line (for rounded numbers: not even up to the rounding of
/// a point α·A + β·B), or if a coordinate is not finite.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, line_coordinates};
///
/// let [a, b] = [[0.0, 0.0], [4.0, 2.0]].map(Point::new);
/// assert_eq!(line_coordinates(&a, &b, &Point::new([1.0, 0.5]))?, [0.75, 0.25]);
/// assert_eq!(line_coordinates(&a, &b, &Point::new([8.0, 4.0]))?, [-1.0, 2.0]);
///
/// assert!(line_coordinates(&a, &a, &b).unwrap_err().to_string().contains("both are (0, 0)"));
/// assert!(line_coordinates(&a, &b, &Point::new([1.0, 1.0])).is_err());
/// # Ok::<(), cagd::affine::LineCoordinatesError>(())
/// ```
pub fn line_coordinates<P: Affine>(
    a: &P,
    b: &P,
    g: &P,
) -> Result<[P::Scalar; 2], LineCoordinatesError> {
    for (name, point) in [("A", a), ("B", b), ("G", g)] {
        if !point.coordinates().iter().all(Scalar::is_finite) {
            return Err(LineCoordinatesError::NotFinite {
                name,
                point: written(point),
            });
        }
    }
    let direction = b.difference(a);
    let way = direction.coordinates();
    let longest = (0..P::DIMENSION)
        .filter(|&k| !way[k].is_zero())
        .max_by(|&j, &k| way[j].magnitude().total_cmp(&way[k].magnitude()))
        .ok_or_else(|| LineCoordinatesError::SamePoint { point: written(a) })?;
    let ratio = |from: &P, to: &P| {
        to.difference(from).coordinates()[longest].clone() / way[longest].clone()
    };
    let [alpha, beta] = [ratio(g, b), ratio(a, g)];
    // Of a term 2 + 1 + 1 roundings by the quotient, the product and the sum, and 3 of a G that was computed as (1 − t)A + tB.
    // Those in the coordinate of the quotient move the point along the line, which is steepest there.
    let terms = |k: usize| {
        let term =
            |weight: &P::Scalar, point: &P| weight.magnitude() * point.coordinates()[k].magnitude();
        term(&alpha, a) + term(&beta, b) + term(&P::Scalar::one(), g)
    };
    let allowed = |k: usize| gamma(2 * (4 + 3)) * (terms(k) + terms(longest)) + f64::MIN_POSITIVE;
    let misses = |k: usize| {
        let [a, b, g] = [a, b, g].map(|point| point.coordinates()[k].clone());
        let defect = alpha.clone() * a + beta.clone() * b - g;
        if P::Scalar::EXACT {
            !defect.is_zero()
        } else {
            // An overflow misses too.
            !defect.is_finite() || defect.magnitude() > allowed(k)
        }
    };
    if (0..P::DIMENSION).any(misses) {
        return Err(LineCoordinatesError::OffTheLine {
            start: written(a),
            end: written(b),
            point: written(g),
        });
    }
    Ok([alpha, beta])
}

/// Why a point has no barycentric coordinates with respect to two others.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LineCoordinatesError {
    /// The two points are one.
    #[error("a line needs two different points A and B, both are {point}; move one of them")]
    SamePoint {
        /// The common place.
        point: String,
    },
    /// The point is not on the line.
    #[error(
        "{point} is not on the line through {start} and {end}, so no weights of these two give it; take three points as a basis"
    )]
    OffTheLine {
        /// The point A.
        start: String,
        /// The point B.
        end: String,
        /// The point G.
        point: String,
    },
    /// A coordinate is NaN or infinite.
    #[error("the point {name} = {point} is not finite; every coordinate must be a finite number")]
    NotFinite {
        /// The name of the point.
        name: &'static str,
        /// The point.
        point: String,
    },
}
