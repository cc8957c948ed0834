//! Subdivision: the pieces of a Bézier curve are Bézier curves.

use super::casteljau::CasteljauTriangle;
use super::curve::{BezierCurve, BezierError, tuple};
use crate::affine::{Affine, Interval};
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The two pieces at the local parameter α, each over [0, 1].
    ///
    /// ```text
    /// b(αt)            has the control points b₀⁰(α), b₀¹(α), …, b₀ⁿ(α),
    /// b((1 − α)t + α)  has the control points b₀ⁿ(α), b₁ⁿ⁻¹(α), …, bₙ⁰(α)
    /// ```
    ///
    /// They are the two sides of the triangle of de Casteljau.
    /// α is any number: for 0 < α < 1 the pieces together trace the curve once, for α = 0 or 1 one of
    /// them is a point, beyond they overlap and reach outside the domain.
    ///
    /// # Errors
    ///
    /// [`BezierError::ParameterNotFinite`] if α is NaN or infinite, [`BezierError::OutOfRange`] if a
    /// control point is beyond the range of the number type, which cannot happen for 0 ≤ α ≤ 1.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let square = BezierCurve::new([0.0, 0.0, 1.0])?; // t²
    /// let [left, right] = square.subdivided(0.5)?;
    /// assert_eq!(left.control_points(), [0.0, 0.0, 0.25]); // t²/4
    /// assert_eq!(right.control_points(), [0.25, 0.5, 1.0]); // (1 + t)²/4
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §5.4.
    pub fn subdivided(&self, alpha: P::Scalar) -> Result<[Self; 2], BezierError> {
        if !alpha.is_finite() {
            return Err(BezierError::ParameterNotFinite {
                parameter: alpha.to_string(),
            });
        }
        let triangle = CasteljauTriangle::new(self.control_points(), |_| alpha.clone());
        let piece = |points: Vec<P>| checked(Interval::unit(), points, &alpha);
        Ok([
            piece(triangle.left_side().cloned().collect())?,
            piece(triangle.right_side().cloned().collect())?,
        ])
    }

    /// The two pieces over [a, u] and [u, b]: the curve itself, in two parts.
    ///
    /// # Errors
    ///
    /// As [`subdivided`](Self::subdivided), and [`BezierError::Interval`] if `u` is an end of the domain.
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::{BezierCurve, BezierError};
    ///
    /// let curve = BezierCurve::on(Interval::new(0.0, 4.0)?, [0.0, 0.0, 16.0])?; // u²
    /// let [left, right] = curve.split(1.0)?;
    /// assert_eq!((left.at(0.5), right.at(3.0)), (0.25, 9.0));
    /// assert!(matches!(curve.split(4.0), Err(BezierError::Interval(_))));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn split(&self, u: P::Scalar) -> Result<[Self; 2], BezierError> {
        let before = Interval::new(self.domain().start(), u.clone())?;
        let after = Interval::new(u.clone(), self.domain().end())?;
        let [left, right] = self.subdivided(self.domain().local(u))?;
        Ok([left.reparametrised(before), right.reparametrised(after)])
    }

    /// The two halves b(t/2) and b((1 + t)/2), each over [0, 1].
    ///
    /// Every new control point is a mean of old ones, so the halves are always in the range of the numbers.
    /// In `f64` the mean of two numbers passes one rounding, so a coordinate is wrong by at most
    /// n·u·max|bᵢ|, u = 2⁻⁵³.
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let [left, right] = BezierCurve::new([0.0, 1.0, 0.0])?.halves();
    /// assert_eq!(left.control_points(), [0.0, 0.5, 0.5]);
    /// assert_eq!(right.control_points(), [0.5, 0.5, 0.0]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn halves(&self) -> [Self; 2] {
        halved(self.control_points()).map(|points| Self::trusted(Interval::unit(), points))
    }

    /// The same polynomial curve over `domain` [c, d], inside the old domain or not.
    ///
    /// ```text
    /// its control point cⱼ is the tip of the scheme of de Casteljau
    /// with the parameter c in n − j steps and d in j steps
    /// ```
    ///
    /// There is no division but for the map to the unit interval, and inside the domain every step is
    /// a mean: the result is as accurate as a value of the curve, 3n roundings a coordinate.
    /// It takes n³/6 steps.
    ///
    /// # Errors
    ///
    /// [`BezierError::OutOfRange`] if a control point is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::{BezierCurve, BezierError};
    ///
    /// let square = BezierCurve::new([0.0, 0.0, 1.0])?; // u²
    /// let beyond = square.restricted(Interval::new(1.0, 3.0)?)?;
    /// assert_eq!(beyond.control_points(), [1.0, 3.0, 9.0]);
    /// assert_eq!(beyond.at(2.0), 4.0);
    /// let far = square.restricted(Interval::new(0.0, 1e200)?);
    /// assert!(matches!(far, Err(BezierError::OutOfRange { .. })));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `ramshaw1989`, `prautzsch2002`, §3.3.
    pub fn restricted(&self, domain: Interval<P::Scalar>) -> Result<Self, BezierError> {
        let c = self.domain().local(domain.start());
        let d = self.domain().local(domain.end());
        let points = blossom_values(self.control_points(), &c, &d);
        let start = domain.start();
        checked(domain, points, &start)
    }

    /// The sequence of corner cutting P₀, P₁, P₂, …: the control polygons after halving every piece k times.
    ///
    /// P₀ is the control polygon, P₁ is that of both [`halves`](Self::halves), and so on without end.
    /// Pₖ has n·2ᵏ + 1 vertices, so take only a few.
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([0.0, 1.0, 0.0])?;
    /// let polygons: Vec<_> = curve.corner_cutting().take(3).collect();
    /// assert_eq!(polygons[0].vertices(), [0.0, 1.0, 0.0]);
    /// assert_eq!(polygons[1].vertices(), [0.0, 0.5, 0.5, 0.5, 0.0]);
    /// assert_eq!(polygons[2].vertices().len(), 9);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn corner_cutting(&self) -> CornerCutting<P> {
        CornerCutting {
            next: SubdividedPolygon {
                degree: self.degree(),
                step: 0,
                vertices: self.control_points().to_vec(),
            },
        }
    }
}

/// The control points of both halves.
///
/// In place: after step j the first entry is b₀ʲ and the last bₙ₋ⱼʲ.
pub(crate) fn halved<P: Affine>(control_points: &[P]) -> [Vec<P>; 2] {
    let half = P::Scalar::from_ratio(1, 2);
    let mut right = control_points.to_vec();
    let mut left = Vec::with_capacity(right.len());
    for last in (0..right.len()).rev() {
        left.push(right[0].clone());
        for i in 0..last {
            right[i] = right[i].lerp(&right[i + 1], half.clone());
        }
    }
    [left, right]
}

/// The control points over [c, d], in local parameters of the given ones.
pub(crate) fn blossom_values<P: Affine>(
    control_points: &[P],
    c: &P::Scalar,
    d: &P::Scalar,
) -> Vec<P> {
    let degree = control_points.len() - 1;
    let mut column = control_points.to_vec();
    let mut values = Vec::with_capacity(degree + 1);
    // Column n − j of the scheme at c, then j more steps at d.
    for steps in 0..=degree {
        let mut points = column.clone();
        for last in (0..points.len() - 1).rev() {
            for i in 0..=last {
                points[i] = points[i].lerp(&points[i + 1], d.clone());
            }
        }
        values.push(points.swap_remove(0));
        if steps < degree {
            column = column
                .windows(2)
                .map(|pair| pair[0].lerp(&pair[1], c.clone()))
                .collect();
        }
    }
    values.reverse();
    values
}

/// A curve with computed control points, if all are in the range of the numbers.
fn checked<P: Affine>(
    domain: Interval<P::Scalar>,
    points: Vec<P>,
    parameter: &P::Scalar,
) -> Result<BezierCurve<P>, BezierError> {
    match points
        .iter()
        .find(|point| !point.coordinates().iter().all(Scalar::is_finite))
    {
        Some(point) => Err(BezierError::OutOfRange {
            parameter: parameter.to_string(),
            value: tuple(point),
        }),
        None => Ok(BezierCurve::trusted(domain, points)),
    }
}

/// The sequence of polygons of corner cutting; see [`BezierCurve::corner_cutting`].
#[derive(Debug, Clone, PartialEq)]
pub struct CornerCutting<P> {
    next: SubdividedPolygon<P>,
}

impl<P: Affine> Iterator for CornerCutting<P> {
    type Item = SubdividedPolygon<P>;

    fn next(&mut self) -> Option<SubdividedPolygon<P>> {
        let following = self.next.cut();
        Some(std::mem::replace(&mut self.next, following))
    }
}

/// The control polygon Pₖ of all 2ᵏ pieces of a curve of degree n.
///
/// It is parametrised over [0, 1] with its n·2ᵏ + 1 vertices at equal distances.
///
/// # Examples
///
/// ```
/// use cagd::bezier::BezierCurve;
///
/// let polygon = BezierCurve::new([0.0, 1.0, 0.0])?.corner_cutting().nth(1).unwrap();
/// assert_eq!(polygon.step(), 1);
/// assert_eq!(polygon.legs(), 4);
/// assert_eq!(polygon.pieces().collect::<Vec<_>>(), [[0.0, 0.5, 0.5], [0.5, 0.5, 0.0]]);
/// assert_eq!(polygon.on_leg(0, 0.5), (0.125, 0.25), "half-way along the first of four legs");
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SubdividedPolygon<P> {
    degree: usize,
    step: usize,
    vertices: Vec<P>,
}

impl<P: Affine> SubdividedPolygon<P> {
    /// How often every piece was halved: k.
    #[must_use]
    pub fn step(&self) -> usize {
        self.step
    }

    /// The vertices, in order; the last point of a piece is the first of the next and stands once.
    #[must_use]
    pub fn vertices(&self) -> &[P] {
        &self.vertices
    }

    /// The number of legs, n·2ᵏ.
    #[must_use]
    pub fn legs(&self) -> usize {
        self.vertices.len() - 1
    }

    /// The control points of the pieces, n + 1 each; none for degree 0, whose polygon is one point.
    pub fn pieces(&self) -> impl Iterator<Item = &[P]> {
        let degree = self.degree.max(1);
        self.vertices.windows(degree + 1).step_by(degree)
    }

    /// The parameter (i + λ)/(n·2ᵏ) and the point of leg i = `leg` there, λ = `lambda` in [0, 1].
    ///
    /// # Panics
    ///
    /// If there is no such leg.
    #[must_use]
    pub fn on_leg(&self, leg: usize, lambda: P::Scalar) -> (P::Scalar, P) {
        let legs = P::Scalar::from_integer(self.legs() as i64);
        let parameter = (P::Scalar::from_integer(leg as i64) + lambda.clone()) / legs;
        let point = self.vertices[leg].lerp(&self.vertices[leg + 1], lambda);
        (parameter, point)
    }

    /// The polygon of the next step.
    fn cut(&self) -> Self {
        let mut vertices = vec![self.vertices[0].clone()];
        for piece in self.pieces() {
            let [left, right] = halved(piece);
            vertices.extend(left.into_iter().skip(1));
            vertices.extend(right.into_iter().skip(1));
        }
        Self {
            degree: self.degree,
            step: self.step + 1,
            vertices,
        }
    }
}

/// The local parameter j/2ᵏ at which piece j of step k starts.
///
/// ```
/// assert_eq!(cagd::bezier::subdivision::dyadic::<f64>(3, 2), 0.75);
/// ```
#[must_use]
pub fn dyadic<T: Scalar>(numerator: usize, power: usize) -> T {
    let half = T::from_ratio(1, 2);
    (0..power).fold(T::from_integer(numerator as i64), |number, _| {
        number * half.clone()
    })
}
