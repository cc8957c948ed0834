//! Arc length of Bézier curves with a guaranteed error, and its inverse.
//!
//! A piece of the curve is either *tame*: its speed is analytic so far around the piece that 16 nodes
//! of Gauss and Legendre leave an error below rounding, by a bound that is computed from the control vectors.
//! Or it is enclosed between its chord and its control polygon, and halved.
//! Around a cusp no piece is tame, but the pieces there shrink so fast that few are needed.

use super::casteljau::CasteljauTriangle;
use super::curve::BezierCurve;
use crate::affine::{Point, Vector};
use crate::curves::arc_length::{check_tolerance, invert};
use crate::curves::quadrature::SIXTEEN;
use crate::curves::range;
use crate::curves::{ArcLength, ArcLengthError, Certainty, Rectifiable};
use crate::law::gamma;

/// How many pieces there are at most: enough for 60 halvings towards each of 60 cusps.
const MAX_PIECES: usize = 4096;

impl<const D: usize> BezierCurve<Point<f64, D>> {
    /// The arc length, with a guaranteed error of at most `tolerance`.
    ///
    /// `error` of the result bounds the distance to the true length, rounding included. It is often
    /// much smaller than `tolerance`. The length does not depend on the domain.
    ///
    /// # Why the error is guaranteed
    ///
    /// Let v be the hodograph of a piece, written over x ∈ [−1, 1] as v(x) = Σ aₖ·xᵏ, and let
    /// R = Σₖ₌₁ ‖aₖ‖·rᵏ with r = 17/8. The ellipse E with foci ±1 and half axes 17/8 and 15/8 lies in |x| ≤ r.
    /// There |⟨v, v⟩ − ‖a₀‖²| ≤ 2‖a₀‖R + R². If R < (√2 − 1)‖a₀‖ this is less than ‖a₀‖², so
    /// that √⟨v, v⟩ is analytic in E and at most M = ‖a₀‖ + R there. Its Chebyshev series, cut after degree 31, misses
    /// it by at most 2M·4⁻³¹/3 on [−1, 1] (`trefethen2013`, theorem 8.2, ρ = 4). The rule with 16 nodes is exact for
    /// degree 31 and its weights are positive with the sum 2, so its error is at most 4 times
    /// that: 8M/(3·4³¹) < M·10⁻¹⁸. Such a piece is tame.
    ///
    /// Every other piece is at least as long as its chord and at most as long as its control polygon
    /// (`gravesen1997`); half the difference bounds the error of their mean.
    ///
    /// # Errors
    ///
    /// [`ArcLengthError::Tolerance`] if `tolerance` is not a positive number,
    /// [`ArcLengthError::NotFinite`] if the control polygon is longer than the largest number,
    /// [`ArcLengthError::NotReached`] if rounding (about 10⁻¹⁴ of the control polygon's length) or the limit of work forbid it.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// // The parabola (t, t²) from 0 to 1 has the length √5/2 + asinh(2)/4.
    /// let parabola = BezierCurve::new([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new))?;
    /// let length = parabola.arc_length(1e-13)?;
    /// let closed_form = 5f64.sqrt() / 2.0 + 2f64.asinh() / 4.0;
    /// assert!((length.value - closed_form).abs() <= length.error + f64::EPSILON);
    /// assert!(length.error <= 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `gravesen1997` (chord and polygon), `trefethen2013` (quadrature).
    pub fn arc_length(&self, tolerance: f64) -> Result<ArcLength, ArcLengthError> {
        // The subtraction of two control points rounds once, the scaling by the degree once.
        length_of(self.legs(), 2, tolerance)
    }

    /// The parameter at which the curve has the length `length` from its start.
    ///
    /// The length up to the parameter misses `length` by at most `tolerance`: guaranteed, because it is
    /// measured by [`arc_length`](Self::arc_length) on the restricted curve.
    ///
    /// # Errors
    ///
    /// As [`arc_length`](Self::arc_length), and [`ArcLengthError::Beyond`] if `length` is negative or
    /// longer than the curve.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::ArcLengthError;
    ///
    /// let arch = BezierCurve::new([[0.0, 0.0], [0.0, 2.0], [4.0, 2.0], [4.0, 0.0]].map(Point::new))?;
    /// let half = arch.arc_length(1e-12)?.value / 2.0;
    /// let middle = arch.parameter_at_length(half, 1e-10)?;
    /// assert!((middle - 0.5).abs() < 1e-10, "the arch is symmetric");
    /// assert!(matches!(arch.parameter_at_length(-1.0, 1e-10), Err(ArcLengthError::Beyond { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parameter_at_length(&self, length: f64, tolerance: f64) -> Result<f64, ArcLengthError> {
        let domain = self.domain();
        let legs = self.legs();
        invert(
            (domain.start(), domain.end()),
            length,
            tolerance,
            |u| Rectifiable::speed(self, u),
            |u, tolerance| {
                // The legs up to t are t times the left side of the triangle over the legs: 3 roundings a level,
                // 3 for t itself in each factor, and 1 for the product.
                let t = domain.local(u);
                let left: Vec<Vector<f64, D>> = if legs.is_empty() {
                    Vec::new()
                } else {
                    let triangle = CasteljauTriangle::new(&legs, |_| t);
                    triangle.left_side().map(|leg| leg * t).collect()
                };
                length_of(left, 6 * self.degree() + 6, tolerance)
            },
        )
    }

    /// The legs bᵢ₊₁ − bᵢ of the control polygon.
    fn legs(&self) -> Vec<Vector<f64, D>> {
        let pairs = self.control_points().windows(2);
        pairs.map(|pair| pair[1] - pair[0]).collect()
    }
}

/// The length of the curve whose control polygon has these legs; each has passed so many roundings.
fn length_of<const D: usize>(
    legs: Vec<Vector<f64, D>>,
    roundings: usize,
    tolerance: f64,
) -> Result<ArcLength, ArcLengthError> {
    check_tolerance(tolerance)?;
    let degree = legs.len() as f64;
    let longest = legs
        .iter()
        .map(|leg| range::length(leg.as_slice()))
        .fold(0.0, |m, x| if x > m || x.is_nan() { x } else { m });
    if !(longest * degree).is_finite() {
        return Err(ArcLengthError::NotFinite);
    }
    let Some(exponent) = legs
        .iter()
        .filter_map(|leg| range::exponent(leg.as_slice()))
        .max()
    else {
        return Ok(ArcLength {
            value: 0.0,
            error: 0.0,
            certainty: Certainty::Guaranteed,
        });
    };
    // Scaling by a power of two is exact; the largest control vector has a length of the order 1.
    let vectors: Vec<Vector<f64, D>> = legs
        .iter()
        .map(|leg| leg.map(|x| libm::scalbn(x, -exponent) * degree))
        .collect();
    // An error of γₖ·‖leg‖ in each leg changes the length by at most the sum of these errors.
    let lost = gamma(roundings) * degree * libm::scalbn(longest, -exponent);
    let goal = libm::scalbn(tolerance, -exponent);
    let mut pieces = vec![Piece::new(vectors, 0)];
    loop {
        let value: f64 = pieces.iter().map(|piece| piece.value).sum();
        let rounding = gamma(pieces.len()) * value + lost;
        let error = pieces.iter().map(|piece| piece.error).sum::<f64>() + rounding;
        // The last two factors round once each, and the sum of errors as often as there are pieces.
        let error = libm::scalbn(error, exponent) * (1.0 + gamma(pieces.len() + 4));
        let value = libm::scalbn(value, exponent);
        let result = ArcLength {
            value,
            error,
            certainty: Certainty::Guaranteed,
        };
        if !value.is_finite() {
            return Err(ArcLengthError::NotFinite);
        }
        if error <= tolerance {
            return Ok(result);
        }
        // Halve every piece that has more than its share of the error, the worst in any case.
        let wild: Vec<usize> = (0..pieces.len()).filter(|&k| !pieces[k].tame).collect();
        let worst = wild.iter().map(|&k| pieces[k].error).fold(0.0, f64::max);
        let share = worst.min(goal / (2 * wild.len().max(1)) as f64);
        let halve: Vec<usize> = wild
            .into_iter()
            .filter(|&k| pieces[k].error >= share && pieces[k].error > 0.0)
            .collect();
        if halve.is_empty() || pieces.len() + halve.len() > MAX_PIECES {
            return Err(ArcLengthError::NotReached {
                tolerance,
                value,
                error,
            });
        }
        for k in halve {
            let (left, right) = pieces[k].halves();
            pieces[k] = left;
            pieces.push(right);
        }
    }
}

/// A piece of the curve over an interval of length 2^−`depth`.
#[derive(Debug, Clone)]
struct Piece<const D: usize> {
    /// The control vectors of the hodograph, with respect to the parameter of the whole curve.
    vectors: Vec<Vector<f64, D>>,
    depth: i32,
    value: f64,
    error: f64,
    /// Whether quadrature has reached all that can be reached.
    tame: bool,
}

impl<const D: usize> Piece<D> {
    fn new(vectors: Vec<Vector<f64, D>>, depth: i32) -> Self {
        let width = libm::scalbn(1.0, -depth);
        let count = vectors.len() as f64;
        let lengths = vectors.iter().map(Vector::norm);
        let upper = lengths.clone().sum::<f64>() / count;
        let largest = lengths.fold(0.0, f64::max);
        let mean = vectors.iter().sum::<Vector<f64, D>>() / count;
        let lower = mean.norm().min(upper);
        // Control vectors have passed two roundings a level in `depth` triangles; sums and lengths the others.
        let degree = vectors.len() - 1;
        let passed = 2 * degree * depth as usize;
        let mut piece = Self {
            value: width * 0.5 * (lower + upper),
            error: width
                * (0.5 * (upper - lower) + gamma(passed + vectors.len() + D + 6) * largest),
            vectors,
            depth,
            tame: false,
        };
        if let Some((speed, quadrature)) = piece.tame_speed() {
            piece.tame = true;
            piece.value = width * 0.5 * speed;
            // A value of de Casteljau passes 3 roundings a level, a length D + 2; nodes and weights are taken to
            // be right up to 8 roundings, which their test confirms, and a shift of a node by γ₈ changes
            // the hodograph by at most γ₈·2·degree·largest; the sum of 16 terms has 17.
            let roundings = passed + 3 * degree + D + 2 + 8 + 16 * degree + 17;
            piece.error = width * (0.5 * quadrature + gamma(roundings) * largest);
        }
        piece
    }

    /// The integral of the speed over x ∈ [−1, 1] and the error of the quadrature, if the piece is tame.
    fn tame_speed(&self) -> Option<(f64, f64)> {
        const SEMI_AXIS: f64 = 17.0 / 8.0;
        let degree = self.vectors.len() - 1;
        // aₖ = C(m, k)·Δᵏb₀ᵐ⁻ᵏ/2ᵏ from the triangle at ½; only bounds are needed, so that rounding is covered by the
        // strict inequality below: 0.4 instead of √2 − 1 = 0.414….
        let mut column = self.vectors.clone();
        let mut triangle = vec![column.clone()];
        for level in 1..=degree {
            for i in 0..=degree - level {
                column[i] = (column[i] + column[i + 1]) * 0.5;
            }
            column.truncate(degree + 1 - level);
            triangle.push(column.clone());
        }
        let centre = column[0].norm();
        let mut rest = 0.0;
        let mut factor = 1.0;
        for k in 1..=degree {
            factor *= SEMI_AXIS * 0.5 * (degree + 1 - k) as f64 / k as f64;
            let mut differences = triangle[degree - k].clone();
            for _ in 0..k {
                for i in 1..differences.len() {
                    differences[i - 1] = differences[i] - differences[i - 1];
                }
                differences.pop();
            }
            rest += factor * differences[0].norm();
        }
        let largest = self.vectors.iter().map(Vector::norm).fold(0.0, f64::max);
        // What rounding can add to `rest`: each difference of order k at most 2ᵏ terms, each bounded by `largest`.
        let uncertain =
            gamma(8 * (degree + 1)) * largest * libm::pow(1.0 + 2.0 * SEMI_AXIS, degree as f64);
        if rest + uncertain >= 0.4 * (centre - uncertain) {
            return None;
        }
        let speed = SIXTEEN.integrate(-1.0, 1.0, |x| self.value(0.5 * (1.0 + x)).norm());
        let bound = centre + rest + uncertain;
        Some((speed, bound * 8.0 / 3.0 * libm::scalbn(1.0, -62)))
    }

    /// The hodograph at the parameter t ∈ [0, 1] of the piece, by the algorithm of de Casteljau.
    fn value(&self, t: f64) -> Vector<f64, D> {
        let mut vectors = self.vectors.clone();
        for level in (1..vectors.len()).rev() {
            for i in 0..level {
                vectors[i] = vectors[i] * (1.0 - t) + vectors[i + 1] * t;
            }
        }
        vectors[0]
    }

    /// The two halves of the piece, by the algorithm of de Casteljau at ½.
    fn halves(&self) -> (Self, Self) {
        let mut right = self.vectors.clone();
        let mut left = Vec::with_capacity(right.len());
        for level in (1..=right.len()).rev() {
            left.push(right[0]);
            for i in 1..level {
                right[i - 1] = (right[i - 1] + right[i]) * 0.5;
            }
        }
        (
            Self::new(left, self.depth + 1),
            Self::new(right, self.depth + 1),
        )
    }
}
