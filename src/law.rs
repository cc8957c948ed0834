//! What a law is, and the one judge of all laws.
//!
//! A **law** is a theorem, lemma, corollary or algorithm as an executable function.
//! Its first argument is the implementation under test; the others are the inputs.
//! It returns [`Sides`]: what the statement says is equal, or ordered, with a bound for rounding.
//! [`Sides::judge`] compares them: exact numbers by `==`, rounded ones within the bound.
//! So the same function judges the library, a deliberately wrong variant, a learner's answer and
//! the control points that a reader drags.
//!
//! # Rounding bounds
//!
//! Let u = 2⁻⁵³. A sum of products in which every term passes at most k roundings has an error of at
//! most γₖ·Σ|terms| with γₖ = k·u/(1 − k·u) (`higham2002`, §3.1, lemma 3.1).
//! A law therefore states two numbers: `roundings` k, and `magnitude`, a bound for Σ|terms| on
//! both sides together. Underflow adds at most k times the smallest normal number.
//!
//! # Examples
//!
//! ```
//! use cagd::law::{Rounding, Sides};
//!
//! /// a·(b + c) = a·b + a·c
//! fn distributive(product: impl Fn(f64, f64) -> f64, a: f64, b: f64, c: f64) -> Sides<f64> {
//!     let magnitude = 2.0 * (a * b).abs().max((a * c).abs()) * 2.0;
//!     Sides::new(format!("a = {a}, b = {b}, c = {c}"))
//!         .equal("a(b + c)", [product(a, b + c)], [product(a, b) + product(a, c)], Rounding::new(3, magnitude))
//! }
//!
//! assert!(distributive(|x, y| x * y, 0.1, 0.2, 0.3).judge().is_ok());
//! let violation = distributive(|x, y| x * y + 1.0, 0.1, 0.2, 0.3).judge().unwrap_err();
//! assert!(violation.to_string().contains("a(b + c)"));
//! ```

use std::fmt;

use crate::scalar::{OrderedScalar, Scalar, UNIT_ROUNDOFF};

/// The rounding factor γₖ = k·u/(1 − k·u), u = 2⁻⁵³, of a term that passes k roundings.
#[must_use]
pub fn gamma(roundings: usize) -> f64 {
    let ku = roundings as f64 * UNIT_ROUNDOFF;
    ku / (1.0 - ku)
}

/// How far two sides of an equation over rounded numbers may be apart.
///
/// Exact numbers ignore it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounding {
    roundings: usize,
    magnitude: f64,
}

impl Rounding {
    /// At most `roundings` roundings a term, and terms whose absolute values sum to at most `magnitude`.
    ///
    /// Count both sides: k = k_left + k_right, magnitude = the larger of the two sums.
    #[must_use]
    pub fn new(roundings: usize, magnitude: f64) -> Self {
        Self {
            roundings,
            magnitude,
        }
    }

    /// The two sides are the same numbers, bit for bit, in floating point too.
    #[must_use]
    pub fn none() -> Self {
        Self::new(0, 0.0)
    }

    /// The absolute error that is allowed.
    #[must_use]
    pub fn bound(&self) -> f64 {
        if self.roundings == 0 {
            0.0
        } else {
            gamma(self.roundings) * self.magnitude + self.roundings as f64 * f64::MIN_POSITIVE
        }
    }
}

/// How the two sides of a claim compare, number by number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The left side equals the right one.
    Equal,
    /// The left side is at most the right one.
    AtMost,
}

impl fmt::Display for Relation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Equal => "=",
            Self::AtMost => "≤",
        })
    }
}

/// One claim: two sides, and how each pair of numbers compares.
#[derive(Debug, Clone)]
struct Clause<T> {
    name: String,
    relation: Relation,
    left: Vec<T>,
    right: Vec<T>,
    /// For each pair: whether the relation holds as it stands, and by how much the left exceeds the right.
    pairs: Vec<(bool, f64)>,
    rounding: Rounding,
}

/// Both sides of everything that a law claims for one input.
#[derive(Debug, Clone)]
pub struct Sides<T> {
    input: String,
    clauses: Vec<Clause<T>>,
}

impl<T: Scalar> Sides<T> {
    /// No claim yet; `input` describes the input to whoever reads a violation.
    #[must_use]
    pub fn new(input: impl fmt::Display) -> Self {
        Self {
            input: input.to_string(),
            clauses: Vec::new(),
        }
    }

    /// Claims that `left` and `right` are equal, number by number.
    ///
    /// Different lengths are a violation.
    #[must_use]
    pub fn equal(
        self,
        name: impl Into<String>,
        left: impl IntoIterator<Item = T>,
        right: impl IntoIterator<Item = T>,
        rounding: Rounding,
    ) -> Self {
        self.claim(
            name,
            Relation::Equal,
            left,
            right,
            rounding,
            |left, right| {
                // Of equal numbers the difference need not be computed, which exact numbers are slow at.
                if left == right {
                    (true, 0.0)
                } else {
                    (false, (left.clone() - right.clone()).magnitude())
                }
            },
        )
    }

    fn claim(
        mut self,
        name: impl Into<String>,
        relation: Relation,
        left: impl IntoIterator<Item = T>,
        right: impl IntoIterator<Item = T>,
        rounding: Rounding,
        compare: impl Fn(&T, &T) -> (bool, f64),
    ) -> Self {
        let left: Vec<T> = left.into_iter().collect();
        let right: Vec<T> = right.into_iter().collect();
        let pairs = left
            .iter()
            .zip(&right)
            .map(|(left, right)| compare(left, right));
        self.clauses.push(Clause {
            name: name.into(),
            relation,
            pairs: pairs.collect(),
            left,
            right,
            rounding,
        });
        self
    }

    /// Appends the claims of another law for the same input.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.clauses.extend(other.clauses);
        self
    }

    /// Compares all sides.
    ///
    /// # Errors
    ///
    /// The [`Violation`] of the first claim that does not hold. A law that compares no number at all
    /// is violated too: it would hold for every implementation.
    pub fn judge(&self) -> Result<(), Violation> {
        if self
            .clauses
            .iter()
            .all(|clause| clause.left.is_empty() && clause.right.is_empty())
        {
            return Err(Violation {
                claim: "the law compares at least one number".into(),
                input: self.input.clone(),
                left: "[]".into(),
                right: "[]".into(),
                residual: f64::NAN,
                allowed: 0.0,
            });
        }
        match self.clauses.iter().find(|clause| !clause.holds()) {
            None => Ok(()),
            Some(clause) => Err(Violation {
                claim: clause.name.clone(),
                input: self.input.clone(),
                left: list(&clause.left),
                right: list(&clause.right),
                residual: clause.residual(),
                allowed: clause.allowed(),
            }),
        }
    }

    /// Every claim with both sides and its largest residual, for display beside a figure.
    pub fn readings(&self) -> impl Iterator<Item = Reading<'_, T>> {
        self.clauses.iter().map(|clause| Reading {
            claim: &clause.name,
            relation: clause.relation,
            left: &clause.left,
            right: &clause.right,
            residual: clause.residual(),
            allowed: clause.allowed(),
            holds: clause.holds(),
        })
    }
}

impl<T: OrderedScalar> Sides<T> {
    /// Claims that `left ≤ right`, number by number.
    ///
    /// Different lengths are a violation.
    #[must_use]
    pub fn at_most(
        self,
        name: impl Into<String>,
        left: impl IntoIterator<Item = T>,
        right: impl IntoIterator<Item = T>,
        rounding: Rounding,
    ) -> Self {
        self.claim(
            name,
            Relation::AtMost,
            left,
            right,
            rounding,
            |left, right| (left <= right, (left.clone() - right.clone()).to_f64()),
        )
    }
}

impl<T: Scalar> Clause<T> {
    fn allowed(&self) -> f64 {
        if T::EXACT { 0.0 } else { self.rounding.bound() }
    }

    fn holds(&self) -> bool {
        self.left.len() == self.right.len()
            && self
                .pairs
                .iter()
                .all(|&(holds, excess)| holds || (!T::EXACT && excess <= self.allowed()))
    }

    /// The largest excess of a pair; NaN if one is NaN, −∞ if there is no pair.
    fn residual(&self) -> f64 {
        self.pairs
            .iter()
            .map(|&(_, excess)| excess)
            .fold(f64::NEG_INFINITY, |largest, excess| {
                if largest.is_nan() || largest > excess {
                    largest
                } else {
                    excess
                }
            })
    }
}

/// One claim of a law with its numbers.
#[derive(Debug, Clone, Copy)]
pub struct Reading<'a, T> {
    /// What is claimed.
    pub claim: &'a str,
    /// How the sides compare.
    pub relation: Relation,
    /// The left side.
    pub left: &'a [T],
    /// The right side.
    pub right: &'a [T],
    /// By how much the sides miss the claim at most.
    pub residual: f64,
    /// What rounding allows.
    pub allowed: f64,
    /// Whether the claim holds.
    pub holds: bool,
}

/// A law that does not hold, with all that is needed to see why.
#[derive(Debug, Clone, PartialEq)]
pub struct Violation {
    /// Which claim of the law.
    pub claim: String,
    /// The input, in readable form.
    pub input: String,
    /// The left side.
    pub left: String,
    /// The right side.
    pub right: String,
    /// By how much the two sides miss the claim.
    pub residual: f64,
    /// What rounding would have allowed.
    pub allowed: f64,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "violated: {}", self.claim)?;
        writeln!(f, "  input:    {}", self.input)?;
        writeln!(f, "  left:     {}", self.left)?;
        writeln!(f, "  right:    {}", self.right)?;
        write!(
            f,
            "  residual: {:e}, allowed {:e}",
            self.residual, self.allowed
        )
    }
}

impl std::error::Error for Violation {}

fn list<T: fmt::Display>(numbers: &[T]) -> String {
    let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
    format!("[{}]", numbers.join(", "))
}
