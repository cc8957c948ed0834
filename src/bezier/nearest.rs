//! The points of a Bézier curve nearest to a given point, none missed.
//!
//! Let g(t) = ‖b(t) − p‖² and f(t) = g′(t)/2 = ⟨b(t) − p, b′(t)⟩. Both are polynomials, and products of Bernstein
//! polynomials give their Bernstein coefficients. On every piece of the curve
//!
//! * g is at least its smallest coefficient: a piece that is too far away is dropped;
//! * if all coefficients of f have one sign, g is monotone: only the ends count;
//! * if they change sign once, from − to +, then f has one root, a minimum, found by bisection;
//! * if they change sign once, from + to −, then g has a maximum inside, and only the ends count;
//! * otherwise the piece is halved.

use thiserror::Error;

use super::curve::BezierCurve;
use super::product::bernstein_inner_product;
use crate::affine::{Point, Vector};
use crate::curves::range;
use crate::law::gamma;

/// All nearest points of a curve to a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Nearest<const D: usize> {
    /// The distance; no point of the curve is nearer by more than `tolerance`.
    pub distance: f64,
    /// The tolerance that was asked for.
    pub tolerance: f64,
    /// Where the curve has this distance, by increasing parameter; never empty.
    ///
    /// Every parameter at which the distance is smallest is in the range of one of them.
    pub feet: Vec<Foot<D>>,
}

/// A part of the curve that is nearest to a point: usually a single parameter, known up to rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct Foot<const D: usize> {
    /// The range of parameters, from the one nearer to the start of the domain to the one nearer to its end.
    ///
    /// It is wider than rounding only where the distance hardly changes, as around the centre of a circle.
    pub range: [f64; 2],
    /// A parameter of the range.
    pub parameter: f64,
    /// The point of the curve there.
    pub point: Point<f64, D>,
    /// Its distance: at most `tolerance` more than the smallest.
    pub distance: f64,
}

/// How many pieces are looked at. One with a simple minimum needs about ten; a curve of degree n has at
/// most 2n − 1 local extrema, each of which is isolated after at most 50 halvings.
const MAX_PIECES: usize = 20_000;

/// A piece of this length (of the local parameter) is not halved further: t would not change.
const SHORTEST: f64 = f64::EPSILON;

impl<const D: usize> BezierCurve<Point<f64, D>> {
    /// The points of the curve over its domain that are nearest to `point`, all of them.
    ///
    /// `tolerance` is one of distance: the result is at most that much too large, and every parameter
    /// of a nearest point is in the range of one of the feet.
    ///
    /// # Errors
    ///
    /// [`NearestError::Tolerance`] if `tolerance` is not a positive number,
    /// [`NearestError::PointNotFinite`] if `point` has a coordinate that is NaN or infinite,
    /// [`NearestError::OutOfRange`] if the distance to a control point is beyond the range of `f64`,
    /// [`NearestError::NotReached`] if rounding or the limit of work forbid the tolerance: below about
    /// n²·10⁻¹⁵ times the largest distance of a control point nothing is certain.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// // The point (0, 1) has two nearest points on the parabola y = x².
    /// let parabola = BezierCurve::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]].map(Point::new))?;
    /// let nearest = parabola.nearest(&Point::new([0.0, 1.0]), 1e-9)?;
    /// assert_eq!(nearest.feet.len(), 2);
    /// assert!((nearest.distance - 0.75f64.sqrt()).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `patrikalakis2002`, chapter 7; `farouki2012`.
    pub fn nearest(
        &self,
        point: &Point<f64, D>,
        tolerance: f64,
    ) -> Result<Nearest<D>, NearestError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(NearestError::Tolerance { found: tolerance });
        }
        if point.coordinates().iter().any(|x| !x.is_finite()) {
            return Err(NearestError::PointNotFinite {
                point: point.to_string(),
            });
        }
        let offsets: Vec<Vector<f64, D>> = self
            .control_points()
            .iter()
            .map(|control_point| *control_point - *point)
            .collect();
        if offsets.iter().flatten().any(|x| !x.is_finite()) {
            return Err(NearestError::OutOfRange);
        }
        let exponent = offsets
            .iter()
            .filter_map(|offset| range::exponent(offset.as_slice()))
            .max()
            .unwrap_or(0);
        let scaled: Vec<Vector<f64, D>> = offsets
            .iter()
            .map(|offset| offset.map(|x| libm::scalbn(x, -exponent)))
            .collect();
        let mut search = Search::new(scaled, libm::scalbn(tolerance, -exponent));
        let found = search.run();
        let foot = |candidate: &Candidate| {
            let parameter = self.domain().global(candidate.at);
            let at = self.at(parameter);
            Foot {
                range: [candidate.low, candidate.high].map(|t| self.domain().global(t)),
                parameter,
                point: at,
                distance: libm::scalbn(candidate.distance, exponent),
            }
        };
        let distance = libm::scalbn(search.best, exponent);
        if !distance.is_finite() {
            return Err(NearestError::OutOfRange);
        }
        if found.is_none() {
            return Err(NearestError::NotReached {
                tolerance,
                distance,
            });
        }
        Ok(Nearest {
            distance,
            tolerance,
            feet: search.merged().iter().map(foot).collect(),
        })
    }
}

/// Where the distance may be smallest.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Candidate {
    low: f64,
    high: f64,
    /// The parameter of [low, high] that stands for all.
    at: f64,
    distance: f64,
    /// At an inner end of a piece: a minimum only if the distance falls towards it on both sides.
    one_sided: Option<Side>,
}

/// On which side of an inner end the piece lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Before,
    After,
}

/// What the Bernstein coefficients of f say about g on a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    Falling,
    Rising,
    /// At most one minimum inside, no maximum.
    OneMinimum,
    /// At most one maximum inside, no minimum.
    OneMaximum,
    Unknown,
}

/// The search over the local parameter, for a curve scaled to the order 1, seen from the origin.
struct Search<const D: usize> {
    offsets: Vec<Vector<f64, D>>,
    tolerance: f64,
    /// The largest distance of a control point, which all rounding is relative to.
    largest: f64,
    best: f64,
    candidates: Vec<Candidate>,
}

/// A piece of the curve over the local parameters [low, high].
#[derive(Debug, Clone)]
struct Piece<const D: usize> {
    offsets: Vec<Vector<f64, D>>,
    /// The control vectors of the hodograph divided by the degree, on the piece. Their rounding is relative to those
    /// of the whole curve; the legs of a short piece, computed as differences, would be lost in the rounding of its points.
    tangents: Vec<Vector<f64, D>>,
    low: f64,
    high: f64,
}

impl<const D: usize> Search<D> {
    fn new(offsets: Vec<Vector<f64, D>>, tolerance: f64) -> Self {
        Self {
            largest: offsets.iter().map(Vector::norm).fold(0.0, f64::max),
            best: f64::INFINITY,
            candidates: Vec::new(),
            tolerance,
            offsets,
        }
    }

    fn degree(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The error of a control point of a piece: p is subtracted once, and each of at most 52 halvings
    /// rounds once a level (the product by ½ is exact).
    fn point_error(&self) -> f64 {
        gamma(52 * self.degree() + 1 + D) * self.largest
    }

    /// The error of a Bernstein coefficient of g: two such points, their inner product, three weights and a sum.
    fn square_error(&self) -> f64 {
        gamma(2 * (52 * self.degree() + 1) + 2 * self.degree() + D + 8)
            * self.largest
            * self.largest
    }

    /// The error of a Bernstein coefficient of ⟨b − p, b′⟩/n: a tangent is at most twice as large as a point.
    fn slope_error(&self) -> f64 {
        4.0 * self.square_error()
    }

    /// b(t) − p and the last leg b₁ⁿ⁻¹ − b₀ⁿ⁻¹ of the triangle of de Casteljau at t.
    fn point_and_leg(&self, t: f64) -> (Vector<f64, D>, Vector<f64, D>) {
        let mut points = self.offsets.clone();
        let mut leg = Vector::zeros();
        for level in (1..points.len()).rev() {
            if level == 1 {
                leg = points[1] - points[0];
            }
            for i in 0..level {
                points[i] = points[i] * (1.0 - t) + points[i + 1] * t;
            }
        }
        (points[0], leg)
    }

    fn distance(&self, t: f64) -> f64 {
        self.point_and_leg(t).0.norm()
    }

    fn add(&mut self, [low, high]: [f64; 2], at: f64, one_sided: Option<Side>) {
        let distance = self.distance(at);
        self.best = self.best.min(distance);
        self.candidates.push(Candidate {
            low,
            high,
            at,
            distance,
            one_sided,
        });
    }

    /// Adds an end of a piece towards which the distance falls.
    fn add_end(&mut self, t: f64, side: Side) {
        let outer = match side {
            Side::Before => t == 1.0,
            Side::After => t == 0.0,
        };
        self.add([t, t], t, (!outer).then_some(side));
    }

    /// Fills `candidates`; `None` if the limit of work or rounding stops it.
    fn run(&mut self) -> Option<()> {
        if self.tolerance <= 4.0 * self.point_error() {
            self.best = self.distance(0.0);
            return (self.largest == 0.0).then(|| self.add([0.0, 1.0], 0.0, None));
        }
        for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
            self.best = self.best.min(self.distance(t));
        }
        let pairs = self.offsets.windows(2);
        let mut stack = vec![Piece {
            offsets: self.offsets.clone(),
            tangents: pairs.map(|pair| pair[1] - pair[0]).collect(),
            low: 0.0,
            high: 1.0,
        }];
        let mut count = 0;
        while let Some(piece) = stack.pop() {
            count += 1;
            if count > MAX_PIECES {
                return None;
            }
            let squares = bernstein_inner_product(&piece.offsets, &piece.offsets);
            let lower = squares.iter().copied().fold(f64::INFINITY, f64::min);
            if lower > self.best * self.best * (1.0 + gamma(2)) + 2.0 * self.square_error() {
                continue;
            }
            match self.shape(&piece) {
                Shape::Falling => self.add_end(piece.high, Side::Before),
                Shape::Rising => self.add_end(piece.low, Side::After),
                Shape::OneMaximum => {
                    self.add_end(piece.low, Side::After);
                    self.add_end(piece.high, Side::Before);
                }
                shape => {
                    let isolated = (shape == Shape::OneMinimum)
                        .then(|| self.minimum(&piece))
                        .flatten();
                    let spread = piece.spread() + 2.0 * self.point_error();
                    if let Some([low, high]) = isolated {
                        self.add([low, high], 0.5 * (low + high), None);
                    } else if spread <= 0.5 * self.tolerance {
                        let middle = 0.5 * (piece.low + piece.high);
                        self.add([piece.low, piece.high], middle, None);
                    } else if piece.high - piece.low <= SHORTEST {
                        return None;
                    } else {
                        // The nearer half is looked at first, so that the other one may be dropped.
                        let (left, right) = piece.halves();
                        let left_is_nearer =
                            left.nearest_control_point() < right.nearest_control_point();
                        stack.extend(if left_is_nearer {
                            [right, left]
                        } else {
                            [left, right]
                        });
                    }
                }
            }
        }
        Some(())
    }

    /// The shape of the squared distance on a piece, as far as it is certain.
    fn shape(&self, piece: &Piece<D>) -> Shape {
        let slopes = bernstein_inner_product(&piece.offsets, &piece.tangents);
        let error = self.slope_error();
        if slopes.is_empty() {
            return Shape::Unknown;
        }
        if slopes.iter().all(|slope| *slope > error) {
            return Shape::Rising;
        }
        if slopes.iter().all(|slope| *slope < -error) {
            return Shape::Falling;
        }
        let mut steps = slopes.windows(2).map(|pair| pair[1] - pair[0]);
        let convex = steps.clone().all(|step| step > 2.0 * error);
        let concave = steps.all(|step| step < -2.0 * error);
        // One change of sign, with at most one coefficient between whose sign is not certain: its sign does not matter.
        let one_change = |sign: f64| {
            let before = slopes
                .iter()
                .take_while(|slope| sign * **slope < -error)
                .count();
            let after = slopes
                .iter()
                .rev()
                .take_while(|slope| sign * **slope > error)
                .count();
            before > 0 && after > 0 && before + after + 1 >= slopes.len()
        };
        if convex || one_change(1.0) {
            Shape::OneMinimum
        } else if concave || one_change(-1.0) {
            Shape::OneMaximum
        } else {
            Shape::Unknown
        }
    }

    /// The parameters of a piece with one minimum where f is 0 up to rounding; `None` if the curve is
    /// longer there than the tolerance allows.
    fn minimum(&self, piece: &Piece<D>) -> Option<[f64; 2]> {
        // A value of de Casteljau passes 3 roundings a level; leg and product as in `slope_error`.
        let error = 4.0 * gamma(2 * (3 * self.degree() + 1) + D + 2) * self.largest * self.largest;
        // The last parameter at which f is less than `bound` for certain, or an end.
        let boundary = |bound: f64| {
            let (mut low, mut high) = (piece.low, piece.high);
            while high - low > SHORTEST * 0.5 {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                let (point, leg) = self.point_and_leg(middle);
                if point.dot(&leg) < bound {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            [low, high]
        };
        let range = [boundary(-error)[0], boundary(error)[1]];
        let polygon: f64 = piece.legs().iter().map(Vector::norm).sum();
        let longest = piece.legs().iter().map(Vector::norm).fold(0.0, f64::max);
        let share = (range[1] - range[0]) / (piece.high - piece.low);
        // The speed on the piece is at most n times the longest leg.
        let length = polygon.min(share * self.degree() as f64 * longest);
        (length + 2.0 * self.point_error() <= 0.5 * self.tolerance).then_some(range)
    }

    /// The candidates that are nearest, touching ones made one, by increasing parameter.
    fn merged(&self) -> Vec<Candidate> {
        let two_sided = |candidate: &Candidate| match candidate.one_sided {
            None => true,
            Some(side) => self.candidates.iter().any(|other| {
                other.at == candidate.at && other.one_sided.is_some_and(|other| other != side)
            }),
        };
        let mut kept: Vec<Candidate> = self
            .candidates
            .iter()
            .filter(|candidate| candidate.distance <= self.best + self.tolerance)
            .filter(|candidate| two_sided(candidate))
            .copied()
            .collect();
        kept.sort_by(|a, b| a.low.total_cmp(&b.low));
        let mut merged: Vec<Candidate> = Vec::new();
        for candidate in kept {
            match merged.last_mut() {
                Some(last) if candidate.low <= last.high => {
                    last.high = last.high.max(candidate.high);
                    if candidate.distance < last.distance {
                        last.at = candidate.at;
                        last.distance = candidate.distance;
                    }
                }
                _ => merged.push(candidate),
            }
        }
        merged
    }
}

impl<const D: usize> Piece<D> {
    fn legs(&self) -> Vec<Vector<f64, D>> {
        let pairs = self.offsets.windows(2);
        pairs.map(|pair| pair[1] - pair[0]).collect()
    }

    /// Twice the largest distance of a control point from the first: no two points of the piece are
    /// farther apart.
    fn spread(&self) -> f64 {
        let distances = self
            .offsets
            .iter()
            .map(|offset| (offset - self.offsets[0]).norm());
        2.0 * distances.fold(0.0, f64::max)
    }

    fn nearest_control_point(&self) -> f64 {
        let distances = self.offsets.iter().map(Vector::norm);
        distances.fold(f64::INFINITY, f64::min)
    }

    /// The two halves.
    fn halves(&self) -> (Self, Self) {
        let middle = 0.5 * (self.low + self.high);
        let (left, right) = halves(&self.offsets);
        let (left_tangents, right_tangents) = halves(&self.tangents);
        let left = Self {
            offsets: left,
            tangents: left_tangents,
            low: self.low,
            high: middle,
        };
        let right = Self {
            offsets: right,
            tangents: right_tangents,
            low: middle,
            high: self.high,
        };
        (left, right)
    }
}

/// The control vectors of both halves, by the algorithm of de Casteljau at ½.
fn halves<const D: usize>(
    vectors: &[Vector<f64, D>],
) -> (Vec<Vector<f64, D>>, Vec<Vector<f64, D>>) {
    let mut right = vectors.to_vec();
    let mut left = Vec::with_capacity(right.len());
    for level in (1..=right.len()).rev() {
        left.push(right[0]);
        for i in 1..level {
            right[i - 1] = (right[i - 1] + right[i]) * 0.5;
        }
    }
    (left, right)
}

/// Why the nearest points are not known.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NearestError {
    /// The tolerance is not a positive number.
    #[error("the tolerance of a distance must be a positive finite number, found {found}")]
    Tolerance {
        /// The tolerance.
        found: f64,
    },
    /// The point has a coordinate that is NaN or infinite.
    #[error("the point must have finite coordinates, found {point}")]
    PointNotFinite {
        /// The point.
        point: String,
    },
    /// The distance to a control point is beyond the range of `f64`.
    #[error(
        "the distance to a control point is beyond the range of f64; scale curve and point down"
    )]
    OutOfRange,
    /// Rounding or the limit of work forbids the tolerance.
    #[error(
        "the tolerance {tolerance} was not reached; the best distance found is {distance}; ask for a larger tolerance"
    )]
    NotReached {
        /// What was asked for.
        tolerance: f64,
        /// The smallest distance that was found.
        distance: f64,
    },
}
