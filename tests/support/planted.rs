//! Curves that meet a line where we want them to: choose the roots, then build the polynomial.

use cagd::affine::{Hyperplane, Interval, Line, Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// A plane curve, a line, and their intersections with multiplicities.
///
/// All numbers but the parameters are whole.
pub struct Planted<T: Scalar> {
    /// The curve.
    pub curve: BezierCurve<Point<T, 2>>,
    /// The line.
    pub line: Hyperplane<T, 2>,
    /// The parameters of the intersections, increasing, and their multiplicities.
    pub intersections: Vec<(T, usize)>,
}

/// The recipe of a curve that meets a line at the fractions `roots` of its domain.
#[derive(Debug, Clone)]
pub struct Recipe {
    /// Fractions p/q from 0 to 1; one that occurs k times is a k-fold root.
    pub roots: Vec<(i64, i64)>,
    /// The positive control values of a factor without roots in the domain.
    pub factor: Vec<i64>,
    /// The normal vector of the line.
    pub normal: [i64; 2],
    /// A point of the line.
    pub foot: [i64; 2],
    /// How far the control points are along the line; repeated if there are too few.
    pub along: Vec<i64>,
    /// The ends of the domain.
    pub domain: [i64; 2],
}

impl Recipe {
    /// Follows the recipe.
    ///
    /// The scaled control values C(n, i)·bᵢ of a product are the convolution of those of its factors.
    /// The factor of the root p/q is q·t − p with the control values −p and q − p.
    pub fn build<T: Scalar>(&self) -> Planted<T> {
        let binomials = |n: usize| -> Vec<i64> {
            (0..=n)
                .map(|i| (1..=i).fold(1, |c, j| c * (n - j + 1) as i64 / j as i64))
                .collect()
        };
        let scaled_factor: Vec<i64> =
            std::iter::zip(&self.factor, binomials(self.factor.len() - 1))
                .map(|(value, binomial)| value * binomial)
                .collect();
        let scaled = self.roots.iter().fold(scaled_factor, |product, (p, q)| {
            let mut next = vec![0; product.len() + 1];
            for (i, value) in product.iter().enumerate() {
                next[i] -= p * value;
                next[i + 1] += (q - p) * value;
            }
            next
        });
        let binomials = binomials(scaled.len() - 1);
        let common = binomials.iter().fold(1, |a, b| a / gcd(a, *b) * b);
        let heights = std::iter::zip(&scaled, &binomials).map(|(value, c)| value * (common / c));
        let whole = |n: i64| T::from_integer(n);
        let [p, q] = self.normal;
        let points = heights.enumerate().map(|(i, height)| {
            let along = self.along[i % self.along.len()];
            Point::new(self.foot.map(whole))
                + Vector::from([whole(p * height - q * along), whole(q * height + p * along)])
        });
        let [start, end] = self.domain.map(whole);
        let domain = Interval::new(start, end).expect("two different ends");
        let mut roots = self.roots.clone();
        roots.sort_by_key(|(p, q)| p * (5040 / q));
        let intersections = roots.chunk_by(|a, b| a.0 * b.1 == b.0 * a.1).map(|group| {
            let (p, q) = group[0];
            (domain.global(T::from_ratio(p, q)), group.len())
        });
        let offset = whole(p * self.foot[0] + q * self.foot[1]);
        Planted {
            intersections: intersections.collect(),
            line: Line::new([whole(p), whole(q)], offset).expect("a normal vector"),
            curve: BezierCurve::on(domain, points).expect("finite control points"),
        }
    }
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}
