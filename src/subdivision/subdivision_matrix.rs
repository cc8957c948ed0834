//! Subdivision matrices: what one step does to the rings around an extraordinary point.

use thiserror::Error;

use super::fan::{Fan, FanNet};
use super::{MeshError, SchemeError, SurfaceScheme};
use crate::affine::Affine;
use crate::scalar::Scalar;

/// The matrix A with P' = A·P for the points P of some rings around an extraordinary point, before and after a step.
///
/// It is extracted from the scheme: column j holds the new points for data that are 1 at vertex j and 0 elsewhere.
/// So it cannot disagree with the scheme.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{FanNet, Loop, SubdivisionMatrix};
///
/// let matrix = SubdivisionMatrix::<BigRational>::extract(&Loop, FanNet::Triangles, 4, 1)?;
/// assert_eq!(matrix.len(), 5);
/// assert!(matrix.row_sums().iter().all(|sum| *sum == BigRational::from_ratio(1, 1)));
/// // The eigenvalue 3/8 + cos(2π/4)/4 is double.
/// assert_eq!(matrix.multiplicity(&BigRational::from_ratio(3, 8)), 2);
/// # Ok::<(), cagd::subdivision::SubdivisionMatrixError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SubdivisionMatrix<T> {
    fan: Fan,
    rows: Vec<Vec<T>>,
}

/// Why there is no subdivision matrix.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SubdivisionMatrixError {
    /// The scheme does not refine the fan.
    #[error(transparent)]
    Scheme(#[from] SchemeError),
    /// The fan does not exist.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The new points of the rings depend on more than the rings.
    ///
    /// ```
    /// use cagd::subdivision::{Butterfly, FanNet, SubdivisionMatrix};
    /// let one_ring = SubdivisionMatrix::<f64>::extract(&Butterfly::MODIFIED, FanNet::Triangles, 6, 1);
    /// assert!(one_ring.unwrap_err().to_string().contains("take 2 rings"));
    /// ```
    #[error(
        "the new points of {rings} rings must depend on these rings alone, but one uses a vertex outside; take {} rings",
        rings + 1
    )]
    TooFewRings {
        /// How many rings.
        rings: usize,
    },
}

impl<T: Scalar + Affine<Scalar = T>> SubdivisionMatrix<T> {
    /// The matrix of a scheme for some rings around a point of valence k.
    ///
    /// # Arguments
    ///
    /// `net`: [`FanNet::Triangles`], [`FanNet::Quadrilaterals`], or [`FanNet::AroundFace`] for a scheme that makes vertices of corners;
    /// `valence` k ≥ 3; `rings` as many as the scheme needs, 1 for the smallest matrix of Loop, Catmull and Clark, Doo and Sabin,
    /// 2 for the interpolating schemes.
    ///
    /// # Errors
    ///
    /// [`SubdivisionMatrixError`] if the scheme refuses the fan, as for irrational weights in exact arithmetic, or `rings` is too small.
    pub fn extract(
        scheme: &impl SurfaceScheme<T>,
        net: FanNet,
        valence: usize,
        rings: usize,
    ) -> Result<Self, SubdivisionMatrixError> {
        let fan = Fan::new(net, valence, rings)?;
        // One more ring shows whether the rings are enough.
        let wide = Fan::new(net, valence, fan.rings() + 1)?;
        let refined = wide.refined()?;
        let (inner, new) = (embedding(&fan, &wide), embedding(&fan, &refined));
        let (centre, sector) = (usize::from(fan.has_centre()), fan.sector_len());
        // The scheme does not know where the first sector is, so the columns of one sector tell the others.
        let turned = |vertex: usize, by: usize| match vertex.checked_sub(centre) {
            None => vertex,
            Some(at) => centre + (at + by * sector) % (fan.valence() * sector),
        };
        let mut rows = vec![vec![T::zero(); fan.len()]; fan.len()];
        for (column, &vertex) in inner.iter().enumerate().take(centre + sector) {
            let mut data = vec![T::zero(); wide.len()];
            data[vertex] = T::one();
            let result = wide.refine(scheme, &data)?;
            for (row, &vertex) in new.iter().enumerate() {
                for by in 0..fan.valence() {
                    rows[turned(row, by)][turned(column, by)] = result[vertex].clone();
                }
            }
        }
        // What the rings do not see: 1 everywhere outside.
        let mut outside = vec![T::one(); wide.len()];
        inner.iter().for_each(|&vertex| outside[vertex] = T::zero());
        let result = wide.refine(scheme, &outside)?;
        if new.iter().any(|&vertex| !result[vertex].is_zero()) {
            return Err(SubdivisionMatrixError::TooFewRings { rings: fan.rings() });
        }
        Ok(Self { fan, rows })
    }
}

/// The numbers that the vertices of a fan have in a fan with more rings.
fn embedding(fan: &Fan, wide: &Fan) -> Vec<usize> {
    let centre = usize::from(fan.has_centre());
    let own = (0..fan.valence()).flat_map(|sector| {
        let start = centre + sector * wide.sector_len();
        start..start + fan.sector_len()
    });
    (0..centre).chain(own).collect()
}

impl<T: Scalar> SubdivisionMatrix<T> {
    /// The rings whose points it maps.
    #[must_use]
    pub fn fan(&self) -> &Fan {
        &self.fan
    }

    /// The number of rows and of columns.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Never: there is a ring at least.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The rows: the weights of the new points.
    #[must_use]
    pub fn rows(&self) -> &[Vec<T>] {
        &self.rows
    }

    /// The sum of every row; 1 for an affinely invariant scheme.
    #[must_use]
    pub fn row_sums(&self) -> Vec<T> {
        let sum = |row: &Vec<T>| row.iter().fold(T::zero(), |sum, a| sum + a.clone());
        self.rows.iter().map(sum).collect()
    }

    /// A·v for numbers v at the vertices; what is missing in v counts as 0.
    #[must_use]
    pub fn apply(&self, v: &[T]) -> Vec<T> {
        let product = |row: &Vec<T>| {
            row.iter()
                .zip(v)
                .fold(T::zero(), |sum, (a, x)| sum + a.clone() * x.clone())
        };
        self.rows.iter().map(product).collect()
    }

    /// l·A for weights l of the vertices; what is missing in l counts as 0.
    #[must_use]
    pub fn apply_left(&self, l: &[T]) -> Vec<T> {
        let mut product = vec![T::zero(); self.len()];
        for (row, weight) in self.rows.iter().zip(l) {
            for (sum, a) in product.iter_mut().zip(row) {
                *sum += weight.clone() * a.clone();
            }
        }
        product
    }

    /// How often λ is an eigenvalue: the dimension of the kernel of (A − λ)ⁿ, n the size of A.
    ///
    /// It is found by elimination and right in exact arithmetic only.
    #[must_use]
    pub fn multiplicity(&self, eigenvalue: &T) -> usize {
        let n = self.len();
        let mut power = self.rows.clone();
        for (i, row) in power.iter_mut().enumerate() {
            row[i] -= eigenvalue.clone();
        }
        // Once the rank stays the same, it stays so for all higher powers.
        let mut known = rank(power.clone());
        loop {
            power = product(&power, &power);
            let next = rank(power.clone());
            if next == known {
                return n - known;
            }
            known = next;
        }
    }

    /// How many independent eigenvectors λ has: the dimension of the kernel of A − λ, in exact arithmetic.
    #[must_use]
    pub fn eigenspace_dimension(&self, eigenvalue: &T) -> usize {
        let mut shifted = self.rows.clone();
        for (i, row) in shifted.iter_mut().enumerate() {
            row[i] -= eigenvalue.clone();
        }
        self.len() - rank(shifted)
    }
}

fn product<T: Scalar>(a: &[Vec<T>], b: &[Vec<T>]) -> Vec<Vec<T>> {
    let row = |row: &Vec<T>| {
        let mut sums = vec![T::zero(); b.len()];
        for (x, other) in row.iter().zip(b) {
            if x.is_zero() {
                continue;
            }
            for (sum, y) in sums.iter_mut().zip(other) {
                *sum += x.clone() * y.clone();
            }
        }
        sums
    };
    a.iter().map(row).collect()
}

/// The rank, by Gaussian elimination.
fn rank<T: Scalar>(mut rows: Vec<Vec<T>>) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..columns {
        let Some(pivot) = (rank..rows.len()).find(|&i| !rows[i][column].is_zero()) else {
            continue;
        };
        rows.swap(rank, pivot);
        let (above, below) = rows.split_at_mut(rank + 1);
        let pivot = &above[rank];
        for row in below {
            if row[column].is_zero() {
                continue;
            }
            let factor = row[column].clone() / pivot[column].clone();
            for (x, p) in row.iter_mut().zip(pivot).skip(column) {
                *x -= factor.clone() * p.clone();
            }
        }
        rank += 1;
    }
    rank
}
