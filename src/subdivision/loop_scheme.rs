//! Loop's scheme for triangle meshes: its stencils and its rules.

use super::cosine::{CosineError, CosineOfTurn};
use super::lattice_mask::{LatticeIndex, LatticeMask};
use crate::scalar::Scalar;

/// The weight β = (1/k)·(5/8 − (3/8 + cos(2π/k)/4)²) of each neighbour of an inner vertex of valence k.
///
/// The vertex itself keeps the weight 1 − kβ.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::loop_beta;
///
/// assert_eq!(loop_beta::<BigRational>(6)?, BigRational::from_ratio(1, 16));
/// assert_eq!(loop_beta::<BigRational>(3)?, BigRational::from_ratio(3, 16));
/// assert!(loop_beta::<BigRational>(5).is_err(), "not a rational number");
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Arguments
///
/// `valence`: the number k ≥ 3 of edges at the vertex. The formula makes sense for 1 and 2, too.
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or β is irrational and the type holds rational numbers only.
///
/// Source: `loop1987`.
pub fn loop_beta<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    let eigenvalue = loop_subdominant_eigenvalue::<T>(valence)?;
    Ok((T::from_ratio(5, 8) - eigenvalue.clone() * eigenvalue) / count(valence))
}

/// The eigenvalue λ = 3/8 + cos(2π/k)/4 by which the neighbourhood of a vertex of valence k shrinks in each step.
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or λ is irrational and the type holds rational numbers only.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::loop_subdominant_eigenvalue;
/// assert_eq!(loop_subdominant_eigenvalue(6), Ok(0.5));
/// ```
pub fn loop_subdominant_eigenvalue<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    Ok(T::from_ratio(3, 8) + T::cosine_of_turn(1, valence)? * T::from_ratio(1, 4))
}

/// The weights of an edge point: 3/8 for each end of the edge, 1/8 for each of the two opposite vertices.
///
/// ```
/// use cagd::subdivision::loop_edge_weights;
/// assert_eq!(loop_edge_weights(), [0.375, 0.375, 0.125, 0.125]);
/// ```
#[must_use]
pub fn loop_edge_weights<T: Scalar>() -> [T; 4] {
    [3, 3, 1, 1].map(|eighths| T::from_ratio(eighths, 8))
}

/// The weights of a vertex and of its two neighbours on the boundary or along a crease: 6/8, 1/8, 1/8.
///
/// ```
/// use cagd::subdivision::loop_boundary_weights;
/// assert_eq!(loop_boundary_weights(), [0.75, 0.125, 0.125]);
/// ```
#[must_use]
pub fn loop_boundary_weights<T: Scalar>() -> [T; 3] {
    [6, 1, 1].map(|eighths| T::from_ratio(eighths, 8))
}

/// The weight ω = 3/(8β) of a vertex in its limit position (ω·v + Σ neighbours)/(ω + k).
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::loop_limit_weight;
/// assert_eq!(loop_limit_weight::<BigRational>(4)?, BigRational::from_ratio(96, 31));
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] as for [`loop_beta`].
pub fn loop_limit_weight<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    Ok(T::from_ratio(3, 8) / loop_beta(valence)?)
}

/// Loop's rules on the regular lattice Z² with edges (1, 0), (0, 1), (1, 1), as a mask.
///
/// The number at i is the weight of the old vertex 0 in the new vertex i; old vertices have even indices.
/// All weights come from [`loop_edge_weights`] and [`loop_beta`].
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{LatticeMask, loop_lattice_mask};
/// let symbol = LatticeMask::three_direction([2, 2, 2]).shifted([-2, -2]);
/// assert_eq!(loop_lattice_mask()?, symbol);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// None in practice: 6 is one of the valences where every type knows the cosine.
pub fn loop_lattice_mask<T: CosineOfTurn>() -> Result<LatticeMask<T>, CosineError> {
    let beta = loop_beta::<T>(6)?;
    let [end, _, opposite, _] = loop_edge_weights::<T>();
    let centre: (LatticeIndex, T) = ([0, 0], T::one() - beta.clone() * T::from_integer(6));
    let around = [[1, 0], [0, 1], [1, 1]].into_iter().flat_map(|[i, j]| {
        let step = |factor: i64| [factor * i, factor * j];
        [
            (step(1), end.clone()),
            (step(-1), end.clone()),
            (step(2), beta.clone()),
            (step(-2), beta.clone()),
        ]
    });
    // New vertices on the edges opposite to the old vertex 0.
    let across = [[2, 1], [1, 2], [1, -1], [-2, -1], [-1, -2], [-1, 1]];
    let across = across.map(|index| (index, opposite.clone()));
    Ok(LatticeMask::new(
        std::iter::once(centre).chain(around).chain(across),
    ))
}

fn count<T: Scalar>(valence: usize) -> T {
    T::from_integer(i64::try_from(valence).unwrap_or(i64::MAX))
}
