//! The proof that a box holds exactly one intersection, or none.

use super::range::Range;
use crate::affine::{Affine, Point, Vector};
use crate::bezier::BezierCurve;
use crate::bezier::subdivision::blossom_values;
use crate::law::gamma;

/// Two curves over [0, 1] with their derivatives; coordinates below 2.
pub(super) struct Pair {
    pub(super) curves: [BezierCurve<Point<f64, 2>>; 2],
    pub(super) derivatives: [BezierCurve<Vector<f64, 2>>; 2],
}

/// What is known about the intersections in a box of parameters.
pub(super) enum Verdict {
    /// There is none.
    Empty,
    /// There is exactly one, and it lies in this smaller box.
    Unique([Range; 2]),
    /// Nothing is known.
    Unknown,
}

impl Pair {
    pub(super) fn new(curves: [BezierCurve<Point<f64, 2>>; 2]) -> Self {
        let derivatives = [curves[0].derivative(), curves[1].derivative()];
        Self {
            curves,
            derivatives,
        }
    }

    /// Tries to prove that F(s, t) = p(s) − q(t) has no zero, or exactly one, in the box X.
    ///
    /// ```text
    /// K = m − Y·F(m) + (I − Y·F′(X))·(X − m),   m the middle of X, Y near the inverse of F′(m)
    /// ```
    ///
    /// contains every zero that X does; if K lies inside X there is exactly one (`krawczyk1969`).
    /// The derivatives over X lie in the box of the control vectors of their pieces, and everything is rounded outwards.
    pub(super) fn judge(&self, within: [Range; 2]) -> Verdict {
        let Some(image) = self.contracted(&within) else {
            return Verdict::Unknown;
        };
        let [Some(s), Some(t)] = [0, 1].map(|k| image[k].common(&within[k])) else {
            return Verdict::Empty;
        };
        if !(0..2).all(|k| within[k].covers_strictly(&image[k])) {
            return Verdict::Unknown;
        }
        // Each further step squares the width until rounding stops it.
        let mut smaller = [s, t];
        for _ in 0..8 {
            let Some(image) = self.contracted(&smaller) else {
                break;
            };
            let [Some(s), Some(t)] = [0, 1].map(|k| image[k].common(&smaller[k])) else {
                break;
            };
            let shrinks = s.width() + t.width() < 0.5 * (smaller[0].width() + smaller[1].width());
            smaller = [s, t];
            if !shrinks {
                break;
            }
        }
        Verdict::Unique(smaller)
    }

    /// Whether Newton's method finds a zero in or near the box that can be proved in some small box around it.
    pub(super) fn crosses_somewhere(&self, within: &[Range; 2]) -> bool {
        let mut place = within.map(|range| range.middle());
        let near = within.map(|range| range.widened(0.25 * range.width()));
        for _ in 0..20 {
            let [s, t] = place;
            let value = self.curves[0].at(s) - self.curves[1].at(t);
            let [p, q] = [self.derivatives[0].at(s), self.derivatives[1].at(t)];
            let determinant = p[1] * q[0] - p[0] * q[1];
            let step = [
                (q[1] * value[0] - q[0] * value[1]) / determinant,
                (p[1] * value[0] - p[0] * value[1]) / determinant,
            ];
            if !step.iter().all(|x| x.is_finite()) {
                return false;
            }
            place = [0, 1].map(|k| (place[k] + step[k]).clamp(near[k].low(), near[k].high()));
        }
        // From an eighth of the box down to 2⁻⁴⁰ of it: below, rounding is larger than the box.
        (1..=13).any(|power| {
            let share = 2f64.powi(-3 * power);
            let around = [0, 1].map(|k| Range::around(place[k], share * within[k].width()));
            matches!(self.judge(around), Verdict::Unique(_))
        })
    }

    /// The box K; `None` if the middle matrix has no inverse.
    fn contracted(&self, within: &[Range; 2]) -> Option<[Range; 2]> {
        let middle = within.map(|range| range.middle());
        let [p, q] = [0, 1].map(|k| self.value(k, middle[k]));
        let [dp, dq] = [0, 1].map(|k| self.slope(k, &within[k]));
        let value = [p[0] - q[0], p[1] - q[1]];
        let zero = Range::new(0.0, 0.0);
        let matrix = [[dp[0], zero - dq[0]], [dp[1], zero - dq[1]]];
        let [[a, b], [c, d]] = matrix.map(|row| row.map(|entry| entry.middle()));
        let determinant = a * d - b * c;
        let inverse = [
            [d / determinant, -b / determinant],
            [-c / determinant, a / determinant],
        ];
        if !inverse.iter().flatten().all(|entry| entry.is_finite()) {
            return None;
        }
        let number = |x: f64| Range::new(x, x);
        let offset = [0, 1].map(|k| within[k] - number(middle[k]));
        let image = [0, 1].map(|i| {
            let row = inverse[i].map(number);
            let mut sum = number(middle[i]) - (row[0] * value[0] + row[1] * value[1]);
            for j in 0..2 {
                let product = row[0] * matrix[0][j] + row[1] * matrix[1][j];
                let unit = number(if i == j { 1.0 } else { 0.0 });
                sum = sum + (unit - product) * offset[j];
            }
            sum
        });
        let finite = image
            .iter()
            .all(|range| range.low().is_finite() && range.high().is_finite());
        finite.then_some(image)
    }

    /// The point of curve `k` at the parameter `t`, as a box with its rounding: 3n roundings of terms below 2·spreadⁿ.
    fn value(&self, k: usize, t: f64) -> [Range; 2] {
        let curve = &self.curves[k];
        let point = curve.at(t);
        let error = error(curve.degree(), 2.0, &Range::new(t, t));
        [0, 1].map(|i| Range::around(point[i], error))
    }

    /// A box around the derivative of curve `k` over a range of parameters.
    fn slope(&self, k: usize, over: &Range) -> [Range; 2] {
        let derivative = &self.derivatives[k];
        let vectors = blossom_values(derivative.control_points(), &over.low(), &over.high());
        // The control vectors have coordinates below 4n and passed two roundings themselves.
        let degree = derivative.degree();
        let error = error(degree + 1, 4.0 * (degree as f64 + 1.0), over);
        [0, 1].map(|i| {
            let around = |vector: &Vector<f64, 2>| Range::around(vector.coordinates()[i], error);
            vectors
                .iter()
                .map(around)
                .reduce(|hull, range| hull.hull(&range))
                .unwrap_or_else(|| Range::new(0.0, 0.0))
        })
    }
}

/// The rounding error of a value whose control points are at most `size`: γ₃ₙ₊₃·size·(|t| + |1 − t|)ⁿ.
fn error(degree: usize, size: f64, over: &Range) -> f64 {
    let spread = [over.low(), over.high()]
        .map(|t| t.abs() + (1.0 - t).abs())
        .into_iter()
        .fold(1.0, f64::max);
    gamma(3 * degree + 3) * size * spread.powi(degree as i32) * 1.001
}
