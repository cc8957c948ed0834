//! Gauss–Legendre quadrature.

use std::sync::LazyLock;

/// The Gauss–Legendre rule with m nodes on [−1, 1]: exact for polynomials of degree at most 2m − 1.
///
/// The nodes are the roots of the Legendre polynomial Pₘ, the weights 2/((1 − x²)·Pₘ′(x)²).
/// They are computed by Newton's method, not typed.
///
/// # Examples
///
/// ```
/// use cagd::curves::GaussLegendre;
///
/// let rule = GaussLegendre::new(2);
/// // Exact for x³ + x² on [0, 1]: 1/4 + 1/3.
/// let integral = rule.integrate(0.0, 1.0, |x| x * x * x + x * x);
/// assert!((integral - 7.0 / 12.0).abs() < 1e-15);
/// ```
///
/// Source: `trefethen2013`, chapter 19.
#[derive(Debug, Clone, PartialEq)]
pub struct GaussLegendre {
    /// Pairs (node, weight), nodes increasing.
    nodes: Vec<(f64, f64)>,
}

/// The rule with 16 nodes, computed once.
pub(crate) static SIXTEEN: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(16));

impl GaussLegendre {
    /// The rule with this many nodes; one node if `count` is 0.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let count = count.max(1);
        let nodes = (1..=count).map(|k| {
            // Tricomi's estimate of the k-th largest root; Newton's method converges from there.
            let angle = std::f64::consts::PI * (k as f64 - 0.25) / (count as f64 + 0.5);
            let mut x = libm::cos(angle);
            // It doubles the right digits of a start with three of them; then rounding remains.
            for _ in 0..6 {
                let (value, slope) = legendre(count, x);
                x -= value / slope;
            }
            let (_, slope) = legendre(count, x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        });
        let mut nodes: Vec<(f64, f64)> = nodes.collect();
        nodes.reverse();
        Self { nodes }
    }

    /// The pairs (node, weight) on [−1, 1], nodes increasing. The weights are positive and sum to 2.
    #[must_use]
    pub fn nodes(&self) -> &[(f64, f64)] {
        &self.nodes
    }

    /// The approximation Σ wᵢ·f(xᵢ) of the integral of f from `start` to `end`.
    pub fn integrate(&self, start: f64, end: f64, f: impl Fn(f64) -> f64) -> f64 {
        let half = 0.5 * (end - start);
        let middle = start + half;
        let sum: f64 = self
            .nodes
            .iter()
            .map(|(x, weight)| weight * f(middle + half * x))
            .sum();
        half * sum
    }
}

/// The Legendre polynomial Pₙ, n ≥ 1, and its derivative at x, |x| < 1, by the three-term recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, value) = (
            value,
            ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
        );
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}
