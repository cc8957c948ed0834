//! Smoothness as a computation: schemes for differences, and their norms.

use super::laurent::LaurentPolynomial;
use super::mask::Mask;
use crate::bezier::binomial;
use crate::scalar::{OrderedScalar, Scalar};

impl<T: Scalar> Mask<T> {
    /// The scheme b of the differences Δpᵢ = pᵢ − pᵢ₋₁, where a(z) = (1 + z)·b(z).
    ///
    /// ΔSₐp = S_bΔp. `None` unless a(−1) = 0; that is tested without a tolerance.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let chaikin: Mask<f64> = Mask::lane_riesenfeld(2);
    /// assert_eq!(chaikin.difference_scheme(), Some(Mask::new(0, [0.25, 0.5, 0.25])?));
    /// assert_eq!(Mask::new(0, [1.0, 3.0])?.difference_scheme(), None);
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    #[must_use]
    pub fn difference_scheme(&self) -> Option<Self> {
        let quotient = self.symbol().divided_by_one_plus(T::one())?;
        Self::from_symbol(quotient).ok()
    }

    /// The scheme of the divided differences 2^(jk)·Δᵏpʲ of order k after j steps: 2ᵏ·a(z)/(1 + z)ᵏ.
    ///
    /// `None` unless (1 + z)ᵏ divides a(z).
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let cubic: Mask<f64> = Mask::lane_riesenfeld(3);
    /// assert_eq!(cubic.divided_difference_scheme(1), Some(Mask::lane_riesenfeld(2)));
    /// assert_eq!(cubic.divided_difference_scheme(5), None);
    /// ```
    #[must_use]
    pub fn divided_difference_scheme(&self, order: usize) -> Option<Self> {
        let two = T::from_integer(2);
        let symbol = (0..order).try_fold(self.symbol().clone(), |symbol, _| {
            Some(symbol.divided_by_one_plus(T::one())?.scaled(&two))
        })?;
        Self::from_symbol(symbol).ok()
    }

    /// How many sum rules hold: the largest m for which (1 + z)ᵐ divides a(z).
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// assert_eq!(Mask::four_point(0.0625)?.sum_rules(), 4);
    /// assert_eq!(Mask::four_point(0.125)?.sum_rules(), 2);
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    #[must_use]
    pub fn sum_rules(&self) -> usize {
        let quotients =
            std::iter::successors(Some(self.clone()), |mask| mask.difference_scheme()).skip(1);
        quotients.count()
    }

    /// The symbol e of what a step moves the polygon: fᵏ⁺¹ − fᵏ at the new parameters is S_eΔpᵏ.
    ///
    /// fᵏ is the polygon over the parameters i/2ᵏ, and (1 − z²)·e(z) = a(z) − z⁻¹(1 + z)²/2.
    /// `None` unless a(1) = 2 and a(−1) = 0.
    ///
    /// ```
    /// use cagd::subdivision::{LaurentPolynomial, Mask};
    ///
    /// let moved = Mask::four_point(0.0625)?.displacement().expect("the rules sum to 1");
    /// // (p₀ − p₋₁)/16 − (p₂ − p₁)/16 from the middle of p₀p₁ to the new point
    /// assert_eq!(moved, LaurentPolynomial::new(-3, [-0.0625, 0.0, 0.0, 0.0, 0.0625]));
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    #[must_use]
    pub fn displacement(&self) -> Option<LaurentPolynomial<T>> {
        let half = T::from_ratio(1, 2);
        let midpoints = LaurentPolynomial::new(-1, [half.clone(), T::one(), half]);
        (self.symbol() - &midpoints)
            .divided_by_one_plus(T::one())?
            .divided_by_one_plus(-T::one())
    }
}

impl<T: OrderedScalar> Mask<T> {
    /// The norm ‖Sᴸ‖ of L steps: how much they can enlarge the largest absolute value of bounded data.
    ///
    /// It is the largest sum of absolute values of the weights of one of the 2ᴸ rules,
    /// max over r of Σⱼ |a⁽ᴸ⁾ at r + 2ᴸj|.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let second = Mask::new(-2, [-0.125, 0.25, 0.75, 0.25, -0.125])?;
    /// assert_eq!([1, 2, 3].map(|steps| second.norm(steps)), [1.0, 0.75, 0.5]);
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    ///
    /// Source: `dyn-levin2002`, §3.
    #[must_use]
    pub fn norm(&self, steps: usize) -> T {
        self.steps(steps)
            .norm(1 << steps.min(usize::BITS as usize - 1))
    }

    /// The smallest number of steps, at most `max_steps`, with a norm below 1.
    ///
    /// `None` says that there is none so small; the scheme may be contractive all the same.
    #[must_use]
    pub fn contraction(&self, max_steps: usize) -> Option<Contraction<T>> {
        (1..=max_steps)
            .map(|steps| Contraction {
                steps,
                norm: self.norm(steps),
            })
            .find(|contraction| contraction.norm < T::one())
    }

    /// The largest k for which the limits are proved to be Cᵏ by a norm of at most `max_steps` steps.
    ///
    /// With a(1) = 2 and a(z) = 2⁻ᵏ(1 + z)ᵏ⁺¹·b(z), the limits are Cᵏ if ‖S_bᴸ‖ < 1 for some L.
    /// `None` if not even continuity is proved.
    /// With exact numbers this is a proof; in `f64` the norms are rounded.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::scalar::{BigRational, Scalar};
    /// use cagd::subdivision::Mask;
    ///
    /// let sixteenth = BigRational::from_ratio(1, 16);
    /// let proved = Mask::four_point(sixteenth)?.smoothness(6).expect("convergence");
    /// assert_eq!((proved.order, proved.contraction.steps), (1, 2));
    /// assert_eq!(proved.contraction.norm, BigRational::from_ratio(3, 4));
    ///
    /// let duplication: Mask<BigRational> = Mask::lane_riesenfeld(0);
    /// assert_eq!(duplication.smoothness(6), None);
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    ///
    /// Source: `dyn1991`; `dyn-levin2002`, §4.
    #[must_use]
    pub fn smoothness(&self, max_steps: usize) -> Option<Smoothness<T>> {
        if self.symbol().at(T::one()) != Some(T::from_integer(2)) {
            return None;
        }
        (0..self.sum_rules()).rev().find_map(|order| {
            let difference_scheme = self.divided_difference_scheme(order)?.difference_scheme()?;
            let contraction = difference_scheme.contraction(max_steps)?;
            Some(Smoothness {
                order,
                difference_scheme,
                contraction,
            })
        })
    }
}

/// Some steps of a scheme whose norm is below 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Contraction<T> {
    /// How many steps, L.
    pub steps: usize,
    /// Their norm ‖Sᴸ‖ < 1.
    pub norm: T,
}

/// A proof that the limits of a scheme are Cᵏ.
#[derive(Debug, Clone, PartialEq)]
pub struct Smoothness<T> {
    /// The order k.
    pub order: usize,
    /// The scheme b of the differences of the k-th divided differences.
    pub difference_scheme: Mask<T>,
    /// Its contraction.
    pub contraction: Contraction<T>,
}

/// A bound for ‖S_bᴸ‖ that holds for all masks b = (1 − s)·`start` + s·`end`, 0 ≤ s ≤ 1, at once.
///
/// The coefficients of the symbol of L steps are polynomials of degree L in s.
/// A sum of absolute values is convex, so it is at most the largest one of the Bernstein coefficients:
/// the norm is bounded by the L + 1 norms of the “control masks”.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{Mask, norm_between};
///
/// let mask = |w: f64| Mask::new(-2, [-2.0 * w, 4.0 * w, 1.0 - 4.0 * w, 4.0 * w, -2.0 * w]);
/// let bound = norm_between(&mask(0.0625)?, &mask(0.125)?, 2);
/// assert!(bound >= mask(0.0625)?.norm(2) && bound >= mask(0.125)?.norm(2));
/// assert_eq!(bound, 0.75);
/// # Ok::<(), cagd::subdivision::MaskError>(())
/// ```
#[must_use]
pub fn norm_between<T: OrderedScalar>(start: &Mask<T>, end: &Mask<T>, steps: usize) -> T {
    // Σₘ sᵐ(1 − s)ᴸ⁻ᵐ·scaled[m] is the symbol; the Bernstein coefficient is scaled[m]/C(L, m).
    let mut scaled = vec![LaurentPolynomial::one()];
    for _ in 0..steps {
        let zero = LaurentPolynomial::zero();
        let from_start = scaled.iter().map(|p| start.apply(p)).chain([zero.clone()]);
        let from_end = [zero]
            .into_iter()
            .chain(scaled.iter().map(|p| end.apply(p)));
        scaled = from_start.zip(from_end).map(|(a, b)| &a + &b).collect();
    }
    let rules = 1 << steps.min(usize::BITS as usize - 1);
    (0_i64..)
        .zip(&scaled)
        .map(|(m, p)| p.norm(rules) / binomial::<T>(steps, m))
        .fold(T::zero(), OrderedScalar::max)
}
