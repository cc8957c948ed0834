//! The four-point scheme: keep the points, put one between each two.

use super::mask::{Mask, MaskError};
use super::polygon::{Closing, ControlPolygon, ControlPolygonError};
use crate::affine::{Affine, Interval};
use crate::bezier::{BezierCurve, RootSearch, Roots};
use crate::scalar::{BigRational, Scalar};

impl<P: Affine> ControlPolygon<P> {
    /// One step of the four-point scheme with tension w.
    ///
    /// The old points stay. Between pᵢ and pᵢ₊₁ comes
    ///
    /// ```text
    /// −w·pᵢ₋₁ + (1/2 + w)·pᵢ + (1/2 + w)·pᵢ₊₁ − w·pᵢ₊₂
    /// ```
    ///
    /// for w = 1/16 the value at 1/2 of the cubic through the four points at −1, 0, 1, 2.
    /// A closed polygon of k points becomes one of 2k.
    /// An open polygon has two phantom points at each end, which are refined like the others:
    /// of k points 2k − 5 remain, from the second old point to the last but one.
    /// So the four phantom points determine all later ones, and the curve runs from the third point
    /// to the third last.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has fewer than 4 points,
    /// [`ControlPolygonError::NotFinite`] if w or a new point is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let cubes = ControlPolygon::open([-8.0, -1.0, 0.0, 1.0, 8.0, 27.0])?;
    /// let refined = cubes.four_point(0.0625)?;
    /// assert_eq!(refined.vertices(), [-1.0, -0.125, 0.0, 0.125, 1.0, 3.375, 8.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    ///
    /// Source: `dyn1987`; `compendium`, Algorithm 5.
    pub fn four_point(&self, tension: P::Scalar) -> Result<Self, ControlPolygonError> {
        self.needs(4, "a step of the four-point scheme")?;
        let count = self.vertices().len() as i64;
        let (first, last) = match self.closing() {
            Closing::Closed => (0, count - 1),
            Closing::Open => (1, count - 3),
        };
        let between = |i: i64| -> Option<P> {
            let [a, b, c, d] = [
                self.vertex(i - 1)?,
                self.vertex(i)?,
                self.vertex(i + 1)?,
                self.vertex(i + 2)?,
            ];
            Some(four_point_rule([a, b, c, d], tension.clone()))
        };
        let mut refined = Vec::with_capacity(2 * self.vertices().len());
        for i in first..=last {
            refined.extend(self.vertex(i).cloned());
            refined.extend(between(i));
        }
        if !self.is_closed() {
            refined.extend(self.vertex(last + 1).cloned());
        }
        Self::new(refined, self.closing())
    }

    /// The open polygon with one more point at each end, the mirror image of the second point in the end point.
    ///
    /// With it before every step, the four-point scheme has a rule for the first and the last leg.
    /// A closed polygon stays as it is.
    ///
    /// # Errors
    ///
    /// [`ControlPolygonError::TooFewVertices`] if an open polygon has a single vertex.
    ///
    /// ```
    /// use cagd::subdivision::ControlPolygon;
    ///
    /// let polygon = ControlPolygon::open([0.0, 1.0, 4.0])?;
    /// assert_eq!(polygon.with_mirrored_ends()?.vertices(), [-1.0, 0.0, 1.0, 4.0, 7.0]);
    /// # Ok::<(), cagd::subdivision::ControlPolygonError>(())
    /// ```
    pub fn with_mirrored_ends(&self) -> Result<Self, ControlPolygonError> {
        if self.is_closed() {
            return Ok(self.clone());
        }
        self.needs(2, "mirroring the ends")?;
        let points = self.vertices();
        let two = P::Scalar::from_integer(2);
        let beyond = |inner: &P, end: &P| inner.lerp(end, two.clone());
        let [before, after] = [
            beyond(&points[1], &points[0]),
            beyond(&points[points.len() - 2], &points[points.len() - 1]),
        ];
        let all = [before]
            .into_iter()
            .chain(points.iter().cloned())
            .chain([after]);
        Self::open(all)
    }
}

/// The new point between b and c of four successive points a, b, c, d.
pub fn four_point_rule<P: Affine>(points: [&P; 4], tension: P::Scalar) -> P {
    let inner = P::Scalar::from_ratio(1, 2) + tension.clone();
    let weights = [-tension.clone(), inner.clone(), inner, -tension];
    P::from_fn(|k| {
        let term = |i: usize| weights[i].clone() * points[i].coordinates()[k].clone();
        term(0) + term(1) + term(2) + term(3)
    })
}

/// The root w* = 0.19273… of 32w³ + 4w − 1, in an interval of at most this length.
///
/// The four-point scheme is C¹ exactly for 0 < w < w*.
/// The control values of the polynomial over [0, 1] are −1, 1/3, 5/3, 35, with one change of sign:
/// it has one root there.
///
/// # Examples
///
/// ```
/// use cagd::bezier::RootKind;
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::critical_tension;
///
/// let roots = critical_tension(BigRational::from_ratio(1, 1_000_000));
/// let [root] = roots.isolated() else { panic!("one root") };
/// assert_eq!(root.kind, RootKind::Exactly(1));
/// assert!(root.low > BigRational::from_ratio(192_725, 1_000_000));
/// assert!(root.high < BigRational::from_ratio(192_735, 1_000_000));
/// ```
///
/// Source: `hechler2009`.
#[must_use]
pub fn critical_tension(tolerance: BigRational) -> Roots<BigRational> {
    let values =
        [(-1, 1), (1, 3), (5, 3), (35, 1)].map(|(p, q)| <BigRational as Scalar>::from_ratio(p, q));
    let search = RootSearch {
        tolerance,
        ..RootSearch::default()
    };
    search.run(&BezierCurve::trusted(Interval::unit(), values.to_vec()))
}

/// The scheme S_b of the differences of the first divided differences of the four-point scheme:
/// the mask (−2w, 4w, 1 − 4w, 4w, −2w), whose contraction proves C¹.
///
/// # Errors
///
/// [`MaskError::NotFinite`] if w is infinite or NaN.
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{Mask, four_point_differences};
///
/// let w = BigRational::from_ratio(17, 100);
/// let divided = Mask::four_point(w.clone())?.divided_difference_scheme(1).expect("two factors 1 + z");
/// assert_eq!(Some(four_point_differences(w)?), divided.difference_scheme());
/// assert_eq!(four_point_differences(0.0625)?.symbol().coefficients(), [-0.125, 0.25, 0.75, 0.25, -0.125]);
/// # Ok::<(), cagd::subdivision::MaskError>(())
/// ```
pub fn four_point_differences<T: Scalar>(tension: T) -> Result<Mask<T>, MaskError> {
    let outer = T::from_integer(-2) * tension.clone();
    let inner = T::from_integer(4) * tension;
    let middle = T::one() - inner.clone();
    Mask::new(-3, [outer.clone(), inner.clone(), middle, inner, outer])
}
