//! Flattening: a polyline with vertices on the curve, and a guaranteed distance.

use thiserror::Error;

use super::bounds::{ToleranceError, euclidean_norm, segment_distance_squared};
use super::curve::BezierCurve;
use super::subdivision::{blossom_values, halved};
use crate::affine::{Affine, Interval};
use crate::law::gamma;
use crate::scalar::{Real, Scalar};

/// More chords than this are refused: the polyline would take gigabytes.
///
/// With fewer, a vertex parameter i/N is exact up to 2⁻⁵³, far below its distance 2⁻²⁶ from the next.
pub const MOST_CHORDS: usize = 1 << 26;

/// A polyline whose vertices lie on a curve, with their parameters.
///
/// There is one vertex more than chords.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline<P> {
    /// The parameters of the vertices in the domain of the curve, from its start to its end.
    pub parameters: Vec<f64>,
    /// The vertices b(u).
    pub vertices: Vec<P>,
}

impl<P> Polyline<P> {
    /// The number of chords.
    #[must_use]
    pub fn chords(&self) -> usize {
        self.vertices.len() - 1
    }
}

impl<P: Affine<Scalar = f64>> BezierCurve<P> {
    /// How many chords of equal parameter length keep the curve within `tolerance`: known in advance.
    ///
    /// ```text
    /// the least N ≥ 1 with N²·ε ≥ n(n − 1)/8·‖Δ²b‖₂
    /// ```
    ///
    /// The piece over a parameter length 1/N has second differences of at most ‖Δ²b‖/N².
    /// The rounding of bound and vertices is charged to the tolerance, so that the guarantee holds for the
    /// numbers that [`flattened_uniformly`](Self::flattened_uniformly) returns.
    ///
    /// # Errors
    ///
    /// [`FlatteningError`].
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([0.0, 0.0, 1.0])?; // t² is within 1/4 of its chord
    /// assert_eq!(curve.uniform_chord_count(0.26)?, 1);
    /// assert_eq!(curve.uniform_chord_count(0.0026)?, 10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn uniform_chord_count(&self, tolerance: f64) -> Result<usize, FlatteningError> {
        Budget::new(self, tolerance).map(|budget| budget.uniform_chords)
    }

    /// The polyline with equally spaced parameters that stays within `tolerance` of the curve.
    ///
    /// At every parameter the curve and the polyline are at most `tolerance` apart in the Euclidean distance;
    /// so every point of one has a point of the other that near.
    /// [`uniform_chord_count`](Self::uniform_chord_count) tells the number of chords in advance.
    ///
    /// # Errors
    ///
    /// [`FlatteningError`].
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, FlatteningError};
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let polyline = curve.flattened_uniformly(0.01)?;
    /// assert_eq!(polyline.chords(), curve.uniform_chord_count(0.01)?);
    /// assert_eq!(polyline.vertices[0], Point::new([0.0, 0.0]));
    ///
    /// assert!(matches!(curve.flattened_uniformly(0.0), Err(FlatteningError::Tolerance(_))));
    /// assert!(matches!(curve.flattened_uniformly(1e-16), Err(FlatteningError::BelowRounding { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `filip1986`.
    pub fn flattened_uniformly(&self, tolerance: f64) -> Result<Polyline<P>, FlatteningError> {
        let chords = self.uniform_chord_count(tolerance)?;
        let step = 1.0 / chords as f64;
        Ok(self.polyline((0..=chords).map(|i| if i == chords { 1.0 } else { i as f64 * step })))
    }

    /// A polyline of few chords that stays within `tolerance` of the curve.
    ///
    /// Each chord reaches nearly as far as it may: long where the curve is nearly straight, short where it bends.
    /// Every point of the curve is at most `tolerance` from the chord of its arc, and every point of the chord is
    /// at most that far from the arc.
    /// (The distance is from the chord as a set, not parameter by parameter.)
    ///
    /// # Method
    ///
    /// The distance from a segment is a convex function, so an arc is as near to its chord as the worst of its
    /// control points. The arc is cut into eight, whose control points are much nearer to it, which makes this
    /// bound nearly sharp. From each vertex the next is searched with the rule that the distance grows with the
    /// square of the step, until it is between 97 % and 100 % of the tolerance.
    ///
    /// # Errors
    ///
    /// [`FlatteningError`].
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// assert!(curve.flattened(0.01)?.chords() < curve.uniform_chord_count(0.01)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn flattened(&self, tolerance: f64) -> Result<Polyline<P>, FlatteningError> {
        let budget = Budget::new(self, tolerance)?;
        let points = self.control_points();
        let mut parameters = vec![0.0];
        let mut start = 0.0;
        let mut step = 1.0;
        while start < 1.0 {
            let end = budget.farthest(points, start, step);
            step = end - start;
            start = end;
            parameters.push(end);
        }
        Ok(self.polyline(parameters))
    }

    /// The polyline through the points at these local parameters.
    fn polyline(&self, parameters: impl IntoIterator<Item = f64>) -> Polyline<P> {
        let unit = self.reparametrised(Interval::unit());
        let (parameters, vertices) = parameters
            .into_iter()
            .map(|t| (self.domain().global(t), unit.at(t)))
            .unzip();
        Polyline {
            parameters,
            vertices,
        }
    }
}

/// A tolerance, and what is left of it after rounding.
struct Budget {
    /// The square of the distance that computed points may have.
    allowed_squared: f64,
    /// The chords of equal parameter length that keep the tolerance.
    uniform_chords: usize,
}

impl Budget {
    /// Checks the tolerance against the curve.
    ///
    /// # Rounding
    ///
    /// Let M be the largest coordinate and D the dimension. Inside [0, 1] a vertex, or a control point of an arc,
    /// passes 3n roundings, three halvings n each, the distance from a segment fewer than 10: each coordinate
    /// of each is wrong by at most γ·M, k = 6n + 10, the Euclidean distance between two of them by 2√D·γ·M.
    /// A second difference is wrong by at most 3·4u·M in each coordinate.
    /// All relative errors, that of a parameter i/N included, are below 2⁻²⁰.
    fn new<P: Affine<Scalar = f64>>(
        curve: &BezierCurve<P>,
        tolerance: f64,
    ) -> Result<Self, FlatteningError> {
        let degree = curve.degree();
        let size = curve
            .control_points()
            .iter()
            .flat_map(|point| point.coordinates())
            .map(Scalar::magnitude)
            .fold(0.0, f64::max);
        let root = Real::sqrt(P::DIMENSION as f64);
        let rounding = 2.0 * root * gamma(6 * degree + 10) * size;
        let factor = super::bounds::chord_factor::<f64>(degree);
        let bound = curve.chord_bound(euclidean_norm);
        // Checks that both are proper before anything is made of them.
        super::bounds::halvings(&bound, &tolerance)?;
        if tolerance < 4.0 * rounding {
            return Err(FlatteningError::BelowRounding {
                tolerance,
                least: 4.0 * rounding,
            });
        }
        let allowed = tolerance - rounding;
        let safe_bound = (bound + factor * root * gamma(3) * 4.0 * size) * (1.0 + 1e-6);
        let chords = Real::sqrt(safe_bound / allowed).ceil().max(1.0);
        if chords > MOST_CHORDS as f64 {
            return Err(FlatteningError::TooManyChords { needed: chords });
        }
        Ok(Self {
            allowed_squared: allowed * allowed * (1.0 - 1e-6),
            uniform_chords: chords as usize,
        })
    }

    /// The square of a bound for the distance of the arc over [start, end] from its chord.
    fn distance_squared<P: Affine<Scalar = f64>>(&self, points: &[P], start: f64, end: f64) -> f64 {
        let arc = blossom_values(points, &start, &end);
        let ends = [arc[0].clone(), arc[arc.len() - 1].clone()];
        let distance = |point: &P| segment_distance_squared(point, &ends[0], &ends[1]);
        let mut pieces = vec![arc];
        for _ in 0..3 {
            pieces = pieces.iter().flat_map(|piece| halved(piece)).collect();
        }
        pieces.iter().flatten().map(distance).fold(0.0, f64::max)
    }

    /// The end of a chord from `start` that nearly uses up the tolerance; `step` is a first guess.
    ///
    /// A step of 1/(2N) is always fine: control points are at most n²/8·‖Δ²‖ from the chord, which is at most twice
    /// Wang's bound n(n − 1)/8·‖Δ²‖, and half the step divides that bound by four.
    fn farthest<P: Affine<Scalar = f64>>(&self, points: &[P], start: f64, step: f64) -> f64 {
        let sure = (start + 0.5 / self.uniform_chords as f64).min(1.0);
        if points.len() < 3 {
            return 1.0;
        }
        let (mut good, mut bad) = (sure, f64::INFINITY);
        let mut trial = (start + step).clamp(sure, 1.0);
        // A few trials are enough as a rule; after any number of them `good` keeps the tolerance.
        for _ in 0..60 {
            let share = self.distance_squared(points, start, trial) / self.allowed_squared;
            if share <= 1.0 {
                good = trial;
                // The square of 97 %.
                if trial >= 1.0 || share >= 0.94 {
                    break;
                }
            } else {
                bad = trial;
            }
            // The distance grows with the square of the step, its square with the fourth power; aim at 98.5 %.
            let predicted =
                start + (trial - start) * Real::sqrt(Real::sqrt(0.97 / share.max(1e-6)));
            trial = if bad.is_infinite() {
                predicted.min(start + 2.0 * (trial - start)).min(1.0)
            } else if bad - good <= 0.01 * (good - start) {
                break;
            } else if predicted > good && predicted < bad {
                predicted
            } else {
                f64::midpoint(good, bad)
            };
        }
        good
    }
}

/// Why a curve cannot be flattened.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FlatteningError {
    /// The tolerance is not a positive finite number, or the bound of the curve is infinite.
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    /// The coordinates are so large that rounding alone can exceed the tolerance.
    #[error(
        "the tolerance {tolerance:e} is below what rounding leaves, {least:e} for these coordinates; allow more or move the curve to the origin"
    )]
    BelowRounding {
        /// The tolerance.
        tolerance: f64,
        /// The least tolerance that can be kept.
        least: f64,
    },
    /// The tolerance needs more than [`MOST_CHORDS`] chords.
    #[error("this tolerance needs {needed} chords, at most {MOST_CHORDS} are made; allow more")]
    TooManyChords {
        /// How many chords it needs.
        needed: f64,
    },
}
