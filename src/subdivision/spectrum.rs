//! Eigenvalues and eigenvectors of subdivision matrices, by the Fourier transform over the sectors.

use nalgebra::linalg::Schur;
use nalgebra::{DMatrix, DVector};
use num_traits::Zero;

use super::subdivision_matrix::SubdivisionMatrix;
use crate::affine::Point;
use crate::scalar::{Complex64, Scalar};

/// An eigenvalue of a subdivision matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eigenvalue {
    /// The number λ.
    pub value: Complex64,
    /// The frequency: the eigenvector turns by this many k-ths of a turn from one sector to the next.
    pub frequency: usize,
}

/// All eigenvalues of a subdivision matrix, the largest first, each as often as its multiplicity says.
///
/// Data that are the same in all sectors but for the factor e^(2πi·f/k) from one to the next are mapped to such data,
/// so the matrix falls into one block for each frequency f = 0, …, k − 1.
/// The blocks are as small as a sector; their eigenvalues come from nalgebra's Schur decomposition.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{FanNet, Loop, Spectrum, SubdivisionMatrix};
///
/// let matrix = SubdivisionMatrix::extract(&Loop, FanNet::Triangles, 5, 1)?;
/// let spectrum = Spectrum::of(&matrix);
/// let lambda = 3.0 / 8.0 + (std::f64::consts::TAU / 5.0).cos() / 4.0;
/// assert!((spectrum.eigenvalues()[0].value.re - 1.0).abs() < 1e-12);
/// assert!((spectrum.subdominant().value.re - lambda).abs() < 1e-12);
/// assert_eq!(spectrum.subdominant().frequency, 1);
/// # Ok::<(), cagd::subdivision::SubdivisionMatrixError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    eigenvalues: Vec<Eigenvalue>,
}

impl Spectrum {
    /// The eigenvalues of this matrix.
    #[must_use]
    pub fn of(matrix: &SubdivisionMatrix<f64>) -> Self {
        let valence = matrix.fan().valence();
        let mut eigenvalues: Vec<Eigenvalue> = (0..=valence / 2)
            .flat_map(|frequency| {
                let values = eigenvalues(frequency_block(matrix, frequency));
                // The block of k − f is the conjugate of that of f.
                let mirrored = (valence - frequency) % valence;
                values.into_iter().flat_map(move |value| {
                    let own = Eigenvalue { value, frequency };
                    let other = Eigenvalue {
                        value: value.conj(),
                        frequency: mirrored,
                    };
                    std::iter::once(own).chain((mirrored != frequency).then_some(other))
                })
            })
            .collect();
        eigenvalues.sort_by(|a, b| b.value.magnitude().total_cmp(&a.value.magnitude()));
        Self { eigenvalues }
    }

    /// All eigenvalues, the largest in absolute value first.
    #[must_use]
    pub fn eigenvalues(&self) -> &[Eigenvalue] {
        &self.eigenvalues
    }

    /// The largest eigenvalue after the first, 1, with the smaller of its frequencies.
    #[must_use]
    pub fn subdominant(&self) -> Eigenvalue {
        let second = self.eigenvalues[1];
        let twin = self.eigenvalues[2];
        if twin.frequency < second.frequency
            && (twin.value - second.value.conj()).magnitude() < SAME
        {
            twin
        } else {
            second
        }
    }

    /// Whether 1 > λ₁ = λ₂ > |λ₃| with λ₁ real and positive: what Reif's criterion supposes of the eigenvalues.
    ///
    /// Numbers count as equal when they differ by less than 10⁻⁹: rounding moves the first eigenvalues by some 10⁻¹⁴,
    /// and those of the schemes of this chapter are at least 10⁻² apart for valences up to 12.
    #[must_use]
    pub fn has_subdominant_pair(&self) -> bool {
        let [one, first, second, third] = [0, 1, 2, 3].map(|i: usize| self.eigenvalues[i].value);
        (one - 1.0).magnitude() < SAME
            && (first - second).magnitude() < SAME
            && first.im.abs() < SAME
            && first.re > SAME
            && first.re < 1.0 - SAME
            && third.magnitude() < first.re - SAME
    }
}

/// Eigenvalues nearer to each other than this count as equal.
const SAME: f64 = 1e-9;

/// The block of a frequency: what the matrix does to data with the factor e^(2πi·f·s/k) in sector s.
fn frequency_block(matrix: &SubdivisionMatrix<f64>, frequency: usize) -> DMatrix<Complex64> {
    let fan = matrix.fan();
    let (valence, sector) = (fan.valence(), fan.sector_len());
    // The centre is in all sectors at once, so it takes part at frequency 0 alone.
    let centre = usize::from(fan.has_centre());
    let shown = if frequency == 0 { centre } else { 0 };
    let size = shown + sector;
    DMatrix::from_fn(size, size, |i, j| {
        let row = &matrix.rows()[if i < shown { 0 } else { centre + i - shown }];
        if j < shown {
            return Complex64::from(row[0]);
        }
        let entries = (0..valence)
            .map(|s| row[centre + s * sector + j - shown] * unit_root(s * frequency, valence));
        entries.fold(Complex64::zero(), |sum, entry| sum + entry)
    })
}

/// e^(2πi·part/parts).
fn unit_root(part: usize, parts: usize) -> Complex64 {
    let angle = std::f64::consts::TAU * (part % parts) as f64 / parts as f64;
    Complex64::new(libm::cos(angle), libm::sin(angle))
}

fn eigenvalues(block: DMatrix<Complex64>) -> Vec<Complex64> {
    // An empty block has no eigenvalue; the iteration of a finite one ends.
    if block.is_empty() {
        return vec![];
    }
    let (_, triangular) = Schur::new(block).unpack();
    triangular.diagonal().iter().copied().collect()
}

/// A right eigenvector of a subdivision matrix as points of the plane, the first vertex of the first sector at (1, 0).
///
/// For a frequency f from 1 to k − 1 the complex numbers of an eigenvector of its block, turned from sector to sector,
/// are the places of the vertices: real and imaginary parts are two real eigenvectors.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{FanNet, Loop, Spectrum, SubdivisionMatrix, eigenvector};
///
/// let matrix = SubdivisionMatrix::extract(&Loop, FanNet::Triangles, 4, 1)?;
/// let net = eigenvector(&matrix, Spectrum::of(&matrix).subdominant());
/// for (found, expected) in net.iter().zip([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]) {
///     assert!((found[0] - expected[0]).abs() < 1e-12 && (found[1] - expected[1]).abs() < 1e-12);
/// }
/// # Ok::<(), cagd::subdivision::SubdivisionMatrixError>(())
/// ```
#[must_use]
pub fn eigenvector(matrix: &SubdivisionMatrix<f64>, eigenvalue: Eigenvalue) -> Vec<Point<f64, 2>> {
    let fan = matrix.fan();
    let block = frequency_block(matrix, eigenvalue.frequency);
    let size = block.nrows();
    let shown = size - fan.sector_len();
    // Inverse iteration. The shift keeps the system regular; each round reduces all other parts by the ratio of
    // the shift and the distance to the next eigenvalue, which is below 10⁻⁸.
    let shift = eigenvalue.value + Complex64::new(1e-10, 0.0);
    let shifted = block - DMatrix::from_diagonal_element(size, size, shift);
    let elimination = shifted.lu();
    let mut vector = DVector::from_element(size, Complex64::new(1.0, 0.5));
    for _ in 0..4 {
        if let Some(next) = elimination.solve(&vector) {
            vector = &next / Complex64::from(next.norm());
        }
    }
    let first = vector[shown];
    let vector = if first.magnitude() > SAME {
        vector / first
    } else {
        vector
    };
    let point = |z: Complex64| Point::new([z.re, z.im]);
    let mut net = vec![];
    if fan.has_centre() {
        let zero = Complex64::zero();
        net.push(point(if shown == 1 { vector[0] } else { zero }));
    }
    for s in 0..fan.valence() {
        let turn = unit_root(s * eigenvalue.frequency, fan.valence());
        net.extend((shown..size).map(|i| point(vector[i] * turn)));
    }
    net
}
