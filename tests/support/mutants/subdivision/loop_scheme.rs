//! Wrong ideas of Loop's scheme.

use cagd::scalar::OrderedScalar;
use cagd::subdivision::{CosineOfTurn, LatticeMask, box_spline_222, loop_lattice_mask};

/// Leaves old vertices where they are and puts new ones into the middles of edges.
pub fn linear_mask<T: CosineOfTurn>() -> LatticeMask<T> {
    LatticeMask::three_direction([1, 1, 1]).shifted([-1, -1])
}

/// Swaps the weights of the ends of an edge and of the opposite vertices.
pub fn edge_weights_swapped<T: CosineOfTurn>() -> LatticeMask<T> {
    let mask = loop_lattice_mask::<T>().expect("valence 6");
    let (eighth, three) = (T::from_ratio(1, 8), T::from_ratio(3, 8));
    LatticeMask::new(mask.terms().map(|(index, weight)| {
        let swapped = match weight {
            w if *w == eighth => three.clone(),
            w if *w == three => eighth.clone(),
            w => w.clone(),
        };
        (index, swapped)
    }))
}

/// Has the diagonals run the other way.
pub fn other_diagonal<T: OrderedScalar>(x: &[T; 2]) -> T {
    box_spline_222(&[x[0].clone(), -x[1].clone()])
}

/// Starts at the origin instead of having its centre there.
pub fn not_centred<T: OrderedScalar>(x: &[T; 2]) -> T {
    let two = T::from_integer(2);
    box_spline_222(&[x[0].clone() - two.clone(), x[1].clone() - two])
}

/// The piecewise linear function with the right values at lattice points and twice the width.
pub fn hat<T: OrderedScalar>(x: &[T; 2]) -> T {
    let values = |i, j| box_spline_222(&[T::from_integer(i), T::from_integer(j)]);
    let height = |i: i64, j: i64| {
        let [u, v] = [
            x[0].clone() - T::from_integer(i),
            x[1].clone() - T::from_integer(j),
        ];
        let zero = T::zero();
        let largest = u.clone().max(v.clone()).max(zero.clone());
        let smallest = u.min(v).min(zero.clone());
        (T::one() - (largest - smallest)).max(zero)
    };
    (-1..=1)
        .flat_map(|i| (-1..=1).map(move |j| (i, j)))
        .fold(T::zero(), |sum, (i, j)| sum + values(i, j) * height(i, j))
}
