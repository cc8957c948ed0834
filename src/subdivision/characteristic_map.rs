//! The characteristic map of a scheme at an extraordinary point, and its test.

use super::fan::{Fan, FanNet};
use super::spectrum::{Eigenvalue, Spectrum, eigenvector};
use super::subdivision_matrix::{SubdivisionMatrix, SubdivisionMatrixError};
use super::{SchemeError, SurfaceScheme};
use crate::affine::{Point, signed_area};

/// The plane net of the subdominant eigenvectors around an extraordinary point.
///
/// The limit of this net over the ring between two refinements is the characteristic map.
/// [`test`](Self::test) looks at a refined net: this is a test in numbers, and proves nothing.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{Butterfly, CharacteristicMap, FanNet, Loop};
///
/// let smooth = CharacteristicMap::of(&Loop, FanNet::Triangles, 9)?;
/// let test = smooth.test(&Loop, 2)?;
/// assert!(test.passed());
///
/// // The eight-point stencil alone winds around a vertex of valence 9 twice.
/// let map = CharacteristicMap::of(&Butterfly::UNMODIFIED, FanNet::Triangles, 9)?;
/// let test = map.test(&Butterfly::UNMODIFIED, 2)?;
/// assert_eq!(test.winding_number, 2);
/// assert!(!test.passed());
/// # Ok::<(), cagd::subdivision::SubdivisionMatrixError>(())
/// ```
///
/// Source: `reif1995`, `peters2008`.
#[derive(Debug, Clone, PartialEq)]
pub struct CharacteristicMap {
    fan: Fan,
    net: Vec<Point<f64, 2>>,
    spectrum: Spectrum,
}

/// What the [test](CharacteristicMap::test) found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CharacteristicMapTest {
    /// Whether 1 > λ₁ = λ₂ > |λ₃|.
    pub subdominant_pair: bool,
    /// How many faces of the refined ring were looked at.
    pub faces: usize,
    /// How many of them have a corner that does not turn counterclockwise.
    pub not_positive: usize,
    /// How often the inner border of the ring runs around the centre.
    pub winding_number: i64,
}

impl CharacteristicMapTest {
    /// A double subdominant eigenvalue, all faces positively oriented, and winding number 1.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.subdominant_pair && self.not_positive == 0 && self.winding_number == 1
    }
}

/// Rings that a net needs so that the rim has no influence up to ring 2, whatever the number of steps.
///
/// A step of an interpolating scheme makes one old ring at the rim wrong, the next step half of that, and so on: less than two rings.
const RINGS: usize = 4;

impl CharacteristicMap {
    /// The characteristic map of a scheme at a point of valence k.
    ///
    /// # Errors
    ///
    /// As [`SubdivisionMatrix::extract`].
    pub fn of(
        scheme: &impl SurfaceScheme<f64>,
        net: FanNet,
        valence: usize,
    ) -> Result<Self, SubdivisionMatrixError> {
        let matrix = SubdivisionMatrix::extract(scheme, net, valence, RINGS)?;
        let spectrum = Spectrum::of(&matrix);
        Ok(Self {
            fan: matrix.fan().clone(),
            net: eigenvector(&matrix, spectrum.subdominant()),
            spectrum,
        })
    }

    /// The eigenvalue by which the net shrinks in each step.
    #[must_use]
    pub fn eigenvalue(&self) -> Eigenvalue {
        self.spectrum.subdominant()
    }

    /// All eigenvalues of the matrix of these rings.
    #[must_use]
    pub fn spectrum(&self) -> &Spectrum {
        &self.spectrum
    }

    /// The rings of the net.
    #[must_use]
    pub fn fan(&self) -> &Fan {
        &self.fan
    }

    /// The places of the vertices of [`fan`](Self::fan).
    #[must_use]
    pub fn net(&self) -> &[Point<f64, 2>] {
        &self.net
    }

    /// The ring between two refinements, after some steps, as polygons of the plane.
    ///
    /// # Errors
    ///
    /// [`SchemeError`] if the net cannot be refined.
    pub fn ring(
        &self,
        scheme: &impl SurfaceScheme<Point<f64, 2>>,
        steps: usize,
    ) -> Result<CharacteristicRing, SchemeError> {
        let (mut fan, mut points) = (self.fan.clone(), self.net.clone());
        for _ in 0..steps {
            points = fan.refine(scheme, &points)?;
            fan = fan.refined()?;
        }
        // One old ring, from the first to the second, and its inner border.
        let (from, to) = (1 << steps, 2 << steps);
        let at = |vertices: Vec<usize>| vertices.into_iter().map(|v| points[v]).collect();
        Ok(CharacteristicRing {
            faces: fan.annulus(from, to).map(at).collect(),
            inner_border: at(fan.ring(from)),
        })
    }

    /// Whether all faces of the ring, refined some times, are positively oriented, and its inner border winds around the centre once.
    ///
    /// # Errors
    ///
    /// [`SchemeError`] if the net cannot be refined.
    pub fn test(
        &self,
        scheme: &impl SurfaceScheme<Point<f64, 2>>,
        steps: usize,
    ) -> Result<CharacteristicMapTest, SchemeError> {
        let ring = self.ring(scheme, steps)?;
        let wrong = ring.faces.iter().filter(|face| !is_positive(face)).count();
        Ok(CharacteristicMapTest {
            subdominant_pair: self.spectrum.has_subdominant_pair(),
            faces: ring.faces.len(),
            not_positive: wrong,
            winding_number: winding_number(&ring.inner_border),
        })
    }
}

/// The refined ring of a characteristic map.
#[derive(Debug, Clone, PartialEq)]
pub struct CharacteristicRing {
    /// The faces, each by its corners.
    pub faces: Vec<Vec<Point<f64, 2>>>,
    /// The inner border, counterclockwise in the fan.
    pub inner_border: Vec<Point<f64, 2>>,
}

/// Whether every corner of a polygon turns counterclockwise.
fn is_positive(face: &[Point<f64, 2>]) -> bool {
    let n = face.len();
    (0..n).all(|i| {
        let [a, b, c] = [i, i + 1, i + 2].map(|j| &face[j % n]);
        signed_area(a, b, c) > 0.0
    })
}

/// How often a closed polygon runs around the origin, counterclockwise.
fn winding_number(polygon: &[Point<f64, 2>]) -> i64 {
    let next = polygon.iter().cycle().skip(1);
    let angles = polygon.iter().zip(next).map(|(p, q)| {
        let (cross, dot) = (p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
        libm::atan2(cross, dot)
    });
    libm::round(angles.sum::<f64>() / std::f64::consts::TAU) as i64
}
