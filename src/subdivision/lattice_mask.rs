//! Masks of schemes on the lattice Z², as Laurent polynomials in two variables.

use std::collections::BTreeMap;

use crate::scalar::Scalar;

/// A place of the lattice Z².
pub type LatticeIndex = [i64; 2];

/// Finitely many numbers on the lattice Z²: the Laurent polynomial Σ a_ij xⁱ yʲ.
///
/// It stands for a mask as well as for data.
/// Data p with p(x, y) = Σ p_ij xⁱ yʲ are refined by a mask a to a(x, y)·p(x², y²).
///
/// # Examples
///
/// ```
/// use cagd::subdivision::LatticeMask;
///
/// // Bilinear interpolation: (1 + x)²(1 + y)²/(4xy).
/// let mask = LatticeMask::three_direction([2, 2, 0]).shifted([-1, -1]);
/// let spike = LatticeMask::new([([0, 0], 1.0)]);
/// let refined = mask.refine(&spike);
/// assert_eq!(refined.coefficient([0, 0]), 1.0);
/// assert_eq!(refined.coefficient([1, 0]), 0.5);
/// assert_eq!(refined.coefficient([-1, 1]), 0.25);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LatticeMask<T> {
    /// Without zeros.
    coefficients: BTreeMap<LatticeIndex, T>,
}

impl<T: Scalar> LatticeMask<T> {
    /// The array with these numbers; where an index occurs twice, they are added.
    #[must_use]
    pub fn new(terms: impl IntoIterator<Item = (LatticeIndex, T)>) -> Self {
        let mut coefficients = BTreeMap::new();
        for (index, number) in terms {
            let sum = coefficients.entry(index).or_insert_with(T::zero);
            *sum += number;
        }
        coefficients.retain(|_, number| !number.is_zero());
        Self { coefficients }
    }

    /// 4·((1 + x)/2)^l ((1 + y)/2)^m ((1 + xy)/2)^n: the mask of the box spline M_lmn with directions (1, 0), (0, 1), (1, 1).
    #[must_use]
    pub fn three_direction(multiplicities: [usize; 3]) -> Self {
        let half = T::from_ratio(1, 2);
        let mut mask = Self::new([([0, 0], T::from_integer(4))]);
        for (direction, multiplicity) in [[1, 0], [0, 1], [1, 1]].into_iter().zip(multiplicities) {
            let factor = Self::new([([0, 0], half.clone()), (direction, half.clone())]);
            for _ in 0..multiplicity {
                mask = mask.product(&factor);
            }
        }
        mask
    }

    /// The number at an index, 0 where nothing is stored.
    #[must_use]
    pub fn coefficient(&self, index: LatticeIndex) -> T {
        self.coefficients
            .get(&index)
            .cloned()
            .unwrap_or_else(T::zero)
    }

    /// All numbers that are not 0, with their indices.
    pub fn terms(&self) -> impl Iterator<Item = (LatticeIndex, &T)> {
        self.coefficients
            .iter()
            .map(|(&index, number)| (index, number))
    }

    /// The product of two Laurent polynomials.
    #[must_use]
    pub fn product(&self, other: &Self) -> Self {
        Self::new(self.terms().flat_map(|(i, a)| {
            other
                .terms()
                .map(move |(j, b)| ([i[0] + j[0], i[1] + j[1]], a.clone() * b.clone()))
        }))
    }

    /// The product with x^i y^j: every number moved by (i, j).
    #[must_use]
    pub fn shifted(&self, by: LatticeIndex) -> Self {
        Self::new(
            self.terms()
                .map(|(i, a)| ([i[0] + by[0], i[1] + by[1]], a.clone())),
        )
    }

    /// Data after one step of the scheme with this mask: a(x, y)·p(x², y²).
    #[must_use]
    pub fn refine(&self, data: &Self) -> Self {
        let spread = Self {
            coefficients: data
                .terms()
                .map(|(i, p)| (i.map(|k| 2 * k), p.clone()))
                .collect(),
        };
        self.product(&spread)
    }

    /// The sums over the four classes of indices modulo 2, in the order (0, 0), (1, 0), (0, 1), (1, 1).
    ///
    /// The weights of the four rules; a scheme is affinely invariant if all four are 1.
    #[must_use]
    pub fn coset_sums(&self) -> [T; 4] {
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|class: LatticeIndex| {
            self.terms()
                .filter(|(index, _)| index.map(|k| k.rem_euclid(2)) == class)
                .fold(T::zero(), |sum, (_, a)| sum + a.clone())
        })
    }
}
