//! Roots of polynomials in Bernstein form: none is missed.

use super::bernstein::binomial;
use super::curve::BezierCurve;
use super::sign_changes::sign_changes;
use super::square_free::square_free_factors;
use crate::law::gamma;
use crate::scalar::{OrderedScalar, Scalar, UNIT_ROUNDOFF};

/// The roots of a polynomial in its domain.
#[derive(Debug, Clone, PartialEq)]
pub enum Roots<T> {
    /// All control values are 0, so the polynomial vanishes everywhere.
    Everywhere,
    /// Intervals in increasing order; every root lies in one of them.
    Isolated(Vec<Root<T>>),
}

/// A small interval of parameters, and what is known about the roots in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Root<T> {
    /// Where the interval starts.
    pub low: T,
    /// Where it ends; equal to `low` if the root is known exactly.
    pub high: T,
    /// What lies in it.
    pub kind: RootKind,
}

/// What is known about the roots in an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RootKind {
    /// Certain: exactly one place, a root of this multiplicity.
    Exactly(usize),
    /// Certain: the sign changes, so there is a root; the multiplicities sum to an odd number.
    Odd,
    /// No sign change was seen: there may be roots, of even multiplicity in sum, or none.
    Possible,
}

impl RootKind {
    /// Whether there is a root for certain.
    #[must_use]
    pub fn is_certain(self) -> bool {
        self != Self::Possible
    }
}

impl<T: OrderedScalar> Root<T> {
    /// The middle of the interval.
    #[must_use]
    pub fn parameter(&self) -> T {
        (self.low.clone() + self.high.clone()) * T::from_ratio(1, 2)
    }

    /// Whether `parameter` lies in the interval; its ends belong to it.
    #[must_use]
    pub fn contains(&self, parameter: &T) -> bool {
        self.low <= *parameter && *parameter <= self.high
    }
}

impl<T> Roots<T> {
    /// The intervals; none if the polynomial vanishes everywhere.
    #[must_use]
    pub fn isolated(&self) -> &[Root<T>] {
        match self {
            Self::Everywhere => &[],
            Self::Isolated(roots) => roots,
        }
    }
}

impl<T: OrderedScalar> BezierCurve<T> {
    /// The roots of this polynomial in its domain.
    ///
    /// Exact numbers: each root in an interval of its own, with its multiplicity.
    /// `f64`: the control values are taken as they stand. A simple root is found to the last bits;
    /// near a multiple root the sign cannot be told, and an interval says so.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, RootKind, Roots};
    ///
    /// // 2t² − 3t + 1 = (2t − 1)(t − 1)
    /// let polynomial = BezierCurve::new([1.0, -0.5, 0.0])?;
    /// let roots = polynomial.roots();
    /// assert_eq!(roots.isolated().len(), 2);
    /// assert!(roots.isolated()[0].contains(&0.5));
    /// assert_eq!((roots.isolated()[1].low, roots.isolated()[1].kind), (1.0, RootKind::Exactly(1)));
    ///
    /// assert_eq!(BezierCurve::new([0.0, 0.0])?.roots(), Roots::Everywhere);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn roots(&self) -> Roots<T> {
        RootSearch::default().run(self)
    }
}

/// How to look for roots.
///
/// The polynomial is halved again and again. A piece is settled if its control values have one sign
/// (no root) or one sign change (one simple root). So no root is missed. What cannot be settled, because the piece is shorter than
/// the tolerance, the signs drown in rounding errors, or the work is used up, is reported as it is.
///
/// Source: `prautzsch2002`, §2.8; `lane1981`.
#[derive(Debug, Clone, PartialEq)]
pub struct RootSearch<T> {
    /// How long an interval may be, for a domain of length 1.
    pub tolerance: T,
    /// How often a piece may be halved, in all.
    pub halvings: usize,
    /// How far each control value may be off. It must be 0 for exact numbers.
    pub coefficient_error: f64,
}

/// Tolerance 2⁻⁵² for `f64`, as small as makes sense; 2⁻²⁰ for exact numbers, whose intervals are certain at any length.
/// Work: 4096 halvings. Two roots at the distance of the tolerance take about a hundred.
impl<T: OrderedScalar> Default for RootSearch<T> {
    fn default() -> Self {
        Self {
            tolerance: T::from_ratio(1, if T::EXACT { 1 << 20 } else { 1 << 52 }),
            halvings: 4096,
            coefficient_error: 0.0,
        }
    }
}

/// A piece of the polynomial over `low` to `high`, with an error bound for its control values.
struct Piece<T: OrderedScalar> {
    low: T,
    high: T,
    values: BezierCurve<T>,
    error: f64,
}

impl<T: OrderedScalar> RootSearch<T> {
    /// The roots of `polynomial` in its domain.
    ///
    /// Over another domain than [0, 1] the ends of an interval are rounded to the nearest numbers.
    #[must_use]
    pub fn run(&self, polynomial: &BezierCurve<T>) -> Roots<T> {
        let values = polynomial.control_points();
        if self.coefficient_error == 0.0 && values.iter().all(T::is_zero) {
            return Roots::Everywhere;
        }
        let n = polynomial.degree();
        let (at_start, at_end) = if self.coefficient_error == 0.0 {
            let zeros = |value: &&T| value.is_zero();
            (
                values.iter().take_while(zeros).count(),
                values.iter().rev().take_while(zeros).count(),
            )
        } else {
            (0, 0)
        };
        // p = tᵏ·(1 − t)ᵐ·q, where the control values of q are those of p times a quotient of binomials.
        let rest = n - at_start - at_end;
        let values: Vec<T> = (0..=rest)
            .map(|j| {
                let value = values[at_start + j].clone();
                if rest == n {
                    value
                } else {
                    value * binomial::<T>(n, (at_start + j) as i64) / binomial::<T>(rest, j as i64)
                }
            })
            .collect();
        let end = |t: T, multiplicity: usize| {
            (multiplicity > 0).then(|| Root {
                low: t.clone(),
                high: t,
                kind: RootKind::Exactly(multiplicity),
            })
        };
        let mut roots: Vec<Root<T>> = end(T::zero(), at_start)
            .into_iter()
            .chain(self.inner_roots(values, rest < n))
            .chain(end(T::one(), at_end))
            .collect();
        let domain = polynomial.domain();
        for root in &mut roots {
            root.low = domain.global(root.low.clone());
            root.high = domain.global(root.high.clone());
        }
        if domain.start() > domain.end() {
            roots.reverse();
            for root in &mut roots {
                std::mem::swap(&mut root.low, &mut root.high);
            }
        }
        Roots::Isolated(roots)
    }

    /// The roots in (0, 1).
    fn inner_roots(&self, values: Vec<T>, scaled: bool) -> Vec<Root<T>> {
        if T::EXACT {
            let mut roots: Vec<Root<T>> = square_free_factors(&values)
                .into_iter()
                .enumerate()
                .flat_map(|(k, factor)| self.isolate(factor, 0.0, k + 1))
                .collect();
            roots.sort_by(|a, b| {
                a.low
                    .partial_cmp(&b.low)
                    .unwrap_or(std::cmp::Ordering::Equal)
            });
            return roots;
        }
        // Two roundings by the quotient of binomials, and those of the binomials themselves.
        let scaling = if scaled {
            gamma(2 + 6 * values.len()) * largest(&values)
        } else {
            0.0
        };
        let error = self.coefficient_error + scaling;
        self.isolate(values, error, 1)
    }

    /// The roots in (0, 1) of a polynomial all of whose roots have the given multiplicity, if that is known.
    fn isolate(&self, values: Vec<T>, error: f64, multiplicity: usize) -> Vec<Root<T>> {
        let values = BezierCurve::trusted(crate::affine::Interval::unit(), values);
        let sign = |t: &T| certain_sign(&values.at(t.clone()), error + evaluation_error(&values));
        let mut halvings = self.halvings;
        let mut found = Vec::new();
        let mut open: Vec<(Root<T>, [Option<bool>; 2])> = Vec::new();
        let mut stack = vec![Piece {
            low: T::zero(),
            high: T::one(),
            values: values.clone(),
            error,
        }];
        while let Some(piece) = stack.pop() {
            let control_values = piece.values.control_points();
            let signs: Vec<Option<bool>> = control_values
                .iter()
                .map(|value| certain_sign(value, piece.error))
                .collect();
            let ends = [signs[0], signs[signs.len() - 1]];
            match settled_changes(control_values, &signs) {
                Some(0) => continue,
                Some(1) => {
                    let rising = signs.iter().flatten().next_back() == Some(&true);
                    let (low, high) = self.narrow(piece.low, piece.high, rising, &sign);
                    found.push(Root {
                        low,
                        high,
                        kind: RootKind::Exactly(multiplicity),
                    });
                    continue;
                }
                _ => {}
            }
            let width = piece.high.clone() - piece.low.clone();
            let drowned = !T::EXACT && signs.iter().all(Option::is_none);
            if halvings == 0 || drowned || (!T::EXACT && width <= self.tolerance) {
                let root = Root {
                    low: piece.low,
                    high: piece.high,
                    kind: RootKind::Possible,
                };
                open.push((root, ends));
                continue;
            }
            halvings -= 1;
            let middle = (piece.low.clone() + piece.high.clone()) * T::from_ratio(1, 2);
            let [left, right] = piece.values.halves();
            let error = piece.error + halving_error(&piece.values);
            if T::EXACT && right.control_points()[0].is_zero() {
                found.push(Root {
                    low: middle.clone(),
                    high: middle.clone(),
                    kind: RootKind::Exactly(multiplicity),
                });
            }
            stack.push(Piece {
                low: middle.clone(),
                high: piece.high,
                values: right,
                error,
            });
            stack.push(Piece {
                low: piece.low,
                high: middle,
                values: left,
                error,
            });
        }
        found.extend(merged(open));
        found.sort_by(|a, b| {
            a.low
                .partial_cmp(&b.low)
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        found
    }

    /// Narrows an interval with a single simple root down to the tolerance, or as far as signs are certain.
    fn narrow(
        &self,
        mut low: T,
        mut high: T,
        rising: bool,
        sign: &impl Fn(&T) -> Option<bool>,
    ) -> (T, T) {
        let half = T::from_ratio(1, 2);
        let middle = |low: &T, high: &T| (low.clone() + high.clone()) * half.clone();
        while high.clone() - low.clone() > self.tolerance {
            let t = middle(&low, &high);
            match sign(&t) {
                Some(positive) if positive == rising => high = t,
                Some(_) => low = t,
                None if T::EXACT => return (t.clone(), t),
                None => {
                    // The sign is certain on both sides of t only; approach t from each.
                    let (mut inner_low, mut inner_high) = (t.clone(), t);
                    while inner_low.clone() - low.clone() > self.tolerance {
                        let t = middle(&low, &inner_low);
                        match sign(&t) {
                            Some(positive) if positive != rising => low = t,
                            _ => inner_low = t,
                        }
                    }
                    while high.clone() - inner_high.clone() > self.tolerance {
                        let t = middle(&inner_high, &high);
                        match sign(&t) {
                            Some(positive) if positive == rising => high = t,
                            _ => inner_high = t,
                        }
                    }
                    return (low, high);
                }
            }
        }
        (low, high)
    }
}

/// Whether the number is positive, if an error of this size cannot change that. Exact 0 has no sign.
fn certain_sign<T: OrderedScalar>(value: &T, error: f64) -> Option<bool> {
    if value.is_zero() || (!T::EXACT && value.magnitude() <= error) {
        None
    } else {
        Some(*value > T::zero())
    }
}

/// The number of sign changes if it is 0 or 1 for certain; over exact numbers zeros do not count.
fn settled_changes<T: OrderedScalar>(values: &[T], signs: &[Option<bool>]) -> Option<usize> {
    if T::EXACT {
        return Some(sign_changes(values)).filter(|&changes| changes <= 1);
    }
    let certain: Vec<bool> = signs.iter().flatten().copied().collect();
    let changes = certain.windows(2).filter(|pair| pair[0] != pair[1]).count();
    // An uncertain value between two of the same sign could bring two changes, one at an end could bring one.
    let harmless = signs.iter().enumerate().all(|(i, sign)| {
        sign.is_some() || {
            let before = signs[..i].iter().rev().flatten().next();
            let after = signs[i..].iter().flatten().next();
            matches!((before, after), (Some(before), Some(after)) if before != after)
        }
    });
    (harmless && changes <= 1).then_some(changes)
}

/// Joins unsettled pieces that touch; signs at the outer ends tell whether there is a root.
fn merged<T: OrderedScalar>(open: Vec<(Root<T>, [Option<bool>; 2])>) -> Vec<Root<T>> {
    let mut clusters: Vec<(Root<T>, [Option<bool>; 2])> = Vec::new();
    for (root, ends) in open {
        match clusters.last_mut() {
            Some((last, last_ends)) if last.high == root.low => {
                last.high = root.high;
                last_ends[1] = ends[1];
            }
            _ => clusters.push((root, ends)),
        }
    }
    clusters
        .into_iter()
        .map(|(root, ends)| Root {
            kind: match ends {
                [Some(start), Some(end)] if start != end => RootKind::Odd,
                _ => RootKind::Possible,
            },
            ..root
        })
        .collect()
}

/// The largest absolute value.
pub(crate) fn largest<T: OrderedScalar>(values: &[T]) -> f64 {
    values.iter().map(Scalar::magnitude).fold(0.0, f64::max)
}

/// A value of the algorithm of de Casteljau in [0, 1] passes 3n roundings.
fn evaluation_error<T: OrderedScalar>(polynomial: &BezierCurve<T>) -> f64 {
    let n = polynomial.degree();
    gamma(3 * n) * largest(polynomial.control_points()) + 3.0 * n as f64 * f64::MIN_POSITIVE
}

/// The mean of two numbers passes two roundings at most, and a control value of a half n means.
fn halving_error<T: OrderedScalar>(polynomial: &BezierCurve<T>) -> f64 {
    let n = polynomial.degree() as f64;
    2.0 * n * UNIT_ROUNDOFF * largest(polynomial.control_points()) * (1.0 + n * UNIT_ROUNDOFF)
        + n * f64::MIN_POSITIVE
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial<const N: usize>(values: [f64; N]) -> BezierCurve<f64> {
        BezierCurve::new(values).expect("finite control values")
    }

    fn kinds(roots: &Roots<f64>) -> Vec<RootKind> {
        roots.isolated().iter().map(|root| root.kind).collect()
    }

    #[test]
    fn a_rounded_double_root_is_possible_and_a_triple_one_is_odd() {
        let double = polynomial([0.25, -0.25, 0.25]).roots();
        assert_eq!(kinds(&double), [RootKind::Possible]);
        assert!(double.isolated()[0].contains(&0.5));
        let triple = polynomial([-0.125, 0.125, -0.125, 0.125]).roots();
        assert_eq!(kinds(&triple), [RootKind::Odd]);
        assert!(triple.isolated()[0].contains(&0.5));
    }

    /// (t − 1/2)² ± 2⁻⁴⁰: no root, or two at the distance 2⁻¹⁹.
    #[test]
    fn neighbouring_roots_are_told_from_none() {
        let small = libm::exp2(-40.0);
        let near = |shift: f64| polynomial([0.25 + shift, -0.25 + shift, 0.25 + shift]).roots();
        assert_eq!(kinds(&near(small)), []);
        assert_eq!(kinds(&near(-small)), [RootKind::Exactly(1); 2]);
    }

    /// Without work left, what is unsettled is still reported.
    #[test]
    fn no_root_is_lost_when_the_work_is_used_up() {
        let search = RootSearch {
            halvings: 1,
            ..RootSearch::default()
        };
        let values = polynomial([-0.125, 0.125, -0.125, 0.125]);
        let roots = search.run(&values);
        assert_eq!(kinds(&roots), [RootKind::Odd]);
        assert!(roots.isolated()[0].contains(&0.5));
    }

    #[test]
    fn sizes_do_not_matter() {
        for scale in [1e-300, 1e-150, 1.0, 1e150, 1e300] {
            let roots = polynomial([-scale, scale, -scale, 3.0 * scale]).roots();
            assert!(
                kinds(&roots)
                    .iter()
                    .all(|kind| *kind == RootKind::Exactly(1)),
                "{scale}"
            );
            assert!(!roots.isolated().is_empty(), "{scale}");
        }
        let constant = polynomial([1e-300]).roots();
        assert_eq!(kinds(&constant), []);
    }

    #[test]
    fn a_domain_that_runs_backwards() {
        let domain = crate::affine::Interval::new(4.0, 0.0).expect("two different ends");
        let values = BezierCurve::on(domain, [-1.0, 3.0]).expect("finite control values");
        let roots = values.roots();
        assert_eq!(kinds(&roots), [RootKind::Exactly(1)]);
        assert!(roots.isolated()[0].contains(&3.0));
    }
}
