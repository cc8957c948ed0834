//! The paths through the triangle of de Casteljau, from a control point to the tip.

use crate::scalar::Scalar;

/// One step of a path: from bᵢʲ to a point of the next column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Step {
    /// To bᵢʲ⁺¹, where bᵢʲ has the weight 1 − t.
    Same,
    /// To bᵢ₋₁ʲ⁺¹, where bᵢʲ has the weight t.
    Up,
}

/// A path of n steps from the control point b_k to the tip b₀ⁿ.
///
/// # Examples
///
/// ```
/// use cagd::bezier::TrianglePaths;
///
/// let path = TrianglePaths::new(3, 1).next().expect("there is a path");
/// assert_eq!(path.points(), [(0, 1), (1, 0), (2, 0), (3, 0)], "b₁⁰, b₀¹, b₀², b₀³ as (level, index)");
/// assert_eq!(path.weight(0.25), 0.25 * 0.75 * 0.75);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct TrianglePath {
    steps: Vec<Step>,
}

impl TrianglePath {
    /// The path with these steps.
    #[must_use]
    pub fn new(steps: Vec<Step>) -> Self {
        Self { steps }
    }

    /// The steps, from the control point on.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The index k of the control point at which the path starts: the number of steps [`Step::Up`].
    #[must_use]
    pub fn start(&self) -> usize {
        self.steps.iter().filter(|&&step| step == Step::Up).count()
    }

    /// The points bᵢʲ on the path as pairs (j, i), the control point first and the tip last.
    #[must_use]
    pub fn points(&self) -> Vec<(usize, usize)> {
        let mut index = self.start();
        let mut points = vec![(0, index)];
        for (level, step) in self.steps.iter().enumerate() {
            index -= usize::from(*step == Step::Up);
            points.push((level + 1, index));
        }
        points
    }

    /// The product of the weights of all steps: what one unit of the control point contributes to the
    /// tip along this path.
    #[must_use]
    pub fn weight<T: Scalar>(&self, t: T) -> T {
        let s = T::one() - t.clone();
        self.steps
            .iter()
            .fold(T::one(), |product, step| match step {
                Step::Same => product * s.clone(),
                Step::Up => product * t.clone(),
            })
    }
}

/// All C(n, k) paths from b_k to the tip of a triangle of degree n.
///
/// They come in lexicographic order, those that step up late last; none if k > n.
///
/// # Examples
///
/// ```
/// use cagd::bezier::{TrianglePaths, bernstein};
///
/// let weights: Vec<f64> = TrianglePaths::new(3, 1).map(|path| path.weight(0.5)).collect();
/// assert_eq!(weights, [0.125; 3], "three paths with the weight t·(1 − t)²");
/// assert_eq!(weights.iter().sum::<f64>(), bernstein(3, 1, 0.5));
/// ```
///
/// Source: `class-notes`, chapter 4.
#[derive(Debug, Clone)]
pub struct TrianglePaths {
    next: Option<Vec<Step>>,
}

impl TrianglePaths {
    /// The paths from the control point b_k with k = `start` in a triangle of degree n = `degree`.
    #[must_use]
    pub fn new(degree: usize, start: usize) -> Self {
        let next = degree.checked_sub(start).map(|same| {
            let mut steps = vec![Step::Up; start];
            steps.resize(start + same, Step::Same);
            steps
        });
        Self { next }
    }
}

impl Iterator for TrianglePaths {
    type Item = TrianglePath;

    fn next(&mut self) -> Option<TrianglePath> {
        let current = self.next.take()?;
        // The next arrangement: the last pair (Up, Same) is exchanged, and what follows starts anew
        // with its steps up first.
        let last_pair = current
            .windows(2)
            .rposition(|pair| pair == [Step::Up, Step::Same]);
        self.next = last_pair.map(|i| {
            let mut steps = current.clone();
            steps.swap(i, i + 1);
            steps[i + 2..].sort_unstable_by(|a, b| b.cmp(a));
            steps
        });
        Some(TrianglePath::new(current))
    }
}
