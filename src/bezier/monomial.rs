//! Polynomial curves in monomial form, and the way to and from Bézier curves.

use num_traits::One;
use thiserror::Error;

use super::bernstein::binomial;
use super::curve::{BezierCurve, BezierError, tuple};
use crate::affine::{Affine, Interval, Linear};
use crate::scalar::Scalar;

/// A polynomial curve in monomial form over an interval [a, b].
///
/// ```text
/// f(u) = a₀ + Σₖ tᵏ·aₖ,   t = (u − a)/(b − a),   k = 1 … n
/// ```
///
/// The types say what the coefficients are: a₀ is a point of the curve, the others are vectors.
/// Over [0, 1] it is t = u, the usual form.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, Vector};
/// use cagd::bezier::{BezierCurve, MonomialCurve};
///
/// // The parabola (u, u²) and its control points over [0, 1].
/// let parabola = MonomialCurve::new(Point::new([0.0, 0.0]), [Vector::from([1.0, 0.0]), Vector::from([0.0, 1.0])])?;
/// assert_eq!(parabola.at(3.0), Point::new([3.0, 9.0]));
/// let curve = BezierCurve::from_monomial(&parabola)?;
/// assert_eq!(curve.control_points(), [[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MonomialCurve<P: Affine> {
    start: P,
    coefficients: Vec<P::Difference>,
    domain: Interval<P::Scalar>,
}

impl<P: Affine> MonomialCurve<P> {
    /// The curve a₀ + Σ uᵏ·aₖ over [0, 1], with a₀ = `start` and the others in order.
    ///
    /// # Errors
    ///
    /// [`MonomialError::NotFinite`] if a coefficient has a coordinate that is NaN or infinite.
    ///
    /// ```
    /// use cagd::bezier::{MonomialCurve, MonomialError};
    ///
    /// let broken = MonomialCurve::new(1.0, [2.0, f64::INFINITY]);
    /// assert!(matches!(broken, Err(MonomialError::NotFinite { index: 2, .. })));
    /// ```
    pub fn new(
        start: P,
        coefficients: impl IntoIterator<Item = P::Difference>,
    ) -> Result<Self, MonomialError> {
        Self::on(Interval::unit(), start, coefficients)
    }

    /// The curve a₀ + Σ tᵏ·aₖ in the local parameter t of `domain`.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn on(
        domain: Interval<P::Scalar>,
        start: P,
        coefficients: impl IntoIterator<Item = P::Difference>,
    ) -> Result<Self, MonomialError> {
        let coefficients: Vec<P::Difference> = coefficients.into_iter().collect();
        check_finite(0, &start)?;
        for (k, coefficient) in coefficients.iter().enumerate() {
            check_finite(k + 1, coefficient)?;
        }
        Ok(Self {
            start,
            coefficients,
            domain,
        })
    }

    /// The formal degree n: the number of coefficients after a₀. The last ones may be zero.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len()
    }

    /// The coefficient a₀, the point at the start of the domain.
    #[must_use]
    pub fn start(&self) -> &P {
        &self.start
    }

    /// The coefficients a₁ … aₙ, vectors.
    #[must_use]
    pub fn coefficients(&self) -> &[P::Difference] {
        &self.coefficients
    }

    /// The parameter interval.
    #[must_use]
    pub fn domain(&self) -> &Interval<P::Scalar> {
        &self.domain
    }

    /// The point f(u), by Horner's scheme: a₀ + t·(a₁ + t·(a₂ + …)).
    ///
    /// Its error is at most γ₂ₙ·Σ|aₖ|·|t|ᵏ. That is small relative to the coefficients, not to the point:
    /// where the curve is far from its start compared with the size of the coefficients, digits cancel.
    #[must_use]
    pub fn at(&self, u: P::Scalar) -> P {
        let t = self.domain.local(u);
        let sum = self
            .coefficients
            .iter()
            .rev()
            .cloned()
            .reduce(|sum, coefficient| coefficient.translated(&sum.scaled(t.clone())));
        match sum {
            Some(sum) => self.start.translated(&sum.scaled(t)),
            None => self.start.clone(),
        }
    }

    /// The same curve, with coefficients for the local parameter of another interval.
    ///
    /// With α and α + β the old local parameters of the new ends, and t the new local parameter, every
    /// power is expanded: (α + β·t)ᵏ = Σⱼ C(k, j)·αᵏ⁻ʲ·βʲ·tʲ.
    ///
    /// # Errors
    ///
    /// [`MonomialError::NotFinite`] if a new coefficient is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::MonomialCurve;
    ///
    /// let square = MonomialCurve::new(0.0, [0.0, 1.0])?;
    /// let shifted = square.over(Interval::new(1.0, 3.0)?)?;
    /// assert_eq!(shifted.start(), &1.0);
    /// assert_eq!(shifted.coefficients(), [4.0, 4.0], "u = 1 + 2t, u² = 1 + 4t + 4t²");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn over(&self, domain: Interval<P::Scalar>) -> Result<Self, MonomialError> {
        let shift = self.domain.local(domain.start());
        let stretch = self.domain.local(domain.end()) - shift.clone();
        let mut start = self.start.clone();
        let mut coefficients = self.coefficients.clone();
        // Each round of Horner's scheme gives one new coefficient; the first round gives the point.
        for round in 0..coefficients.len() {
            for k in (round.saturating_sub(1)..coefficients.len() - 1).rev() {
                let gain = coefficients[k + 1].scaled(shift.clone());
                coefficients[k] = coefficients[k].translated(&gain);
            }
            if round == 0 {
                start = start.translated(&coefficients[0].scaled(shift.clone()));
            }
        }
        let mut power = P::Scalar::one();
        for coefficient in &mut coefficients {
            power *= stretch.clone();
            *coefficient = coefficient.scaled(power.clone());
        }
        Self::on(domain, start, coefficients)
    }
}

impl<P: Affine> BezierCurve<P> {
    /// The monomial form of the curve, over the same domain and of the same formal degree.
    ///
    /// ```text
    /// aₖ = C(n, k)·Δᵏb₀
    /// ```
    ///
    /// Exact over exact numbers. In floating point the coefficients may exceed the control points by
    /// factors up to C(n, k)·2ᵏ, 3ⁿ in total, and the way back divides by them: of a curve of degree 10
    /// five decimal digits may be lost, of one of degree 30 all. So convert to look at a curve, not to
    /// compute with it.
    ///
    /// # Errors
    ///
    /// [`MonomialError::NotFinite`] if a coefficient is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([1.0, 2.0, 4.0])?;
    /// let form = curve.to_monomial()?;
    /// assert_eq!((form.start(), form.coefficients()), (&1.0, &[2.0, 1.0][..]), "1 + 2t + t²");
    /// assert_eq!(BezierCurve::from_monomial(&form)?, curve);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `farin2002`, §5.8.
    pub fn to_monomial(&self) -> Result<MonomialCurve<P>, MonomialError> {
        let points = self.control_points();
        let n = self.degree();
        let mut differences: Vec<P::Difference> = points
            .windows(2)
            .map(|pair| pair[1].difference(&pair[0]))
            .collect();
        let mut coefficients = Vec::with_capacity(n);
        for k in 1..=n {
            coefficients.push(differences[0].scaled(binomial(n, k as i64)));
            differences = differences
                .windows(2)
                .map(|pair| pair[1].difference(&pair[0]))
                .collect();
        }
        MonomialCurve::on(self.domain().clone(), points[0].clone(), coefficients)
    }

    /// The Bézier curve with this monomial form, over its domain.
    ///
    /// ```text
    /// bᵢ = Σₖ C(i, k)/C(n, k)·aₖ,   k = 0 … i
    /// ```
    ///
    /// For control points over another interval use [`MonomialCurve::over`] first.
    /// All weights are in [0, 1], so the error of a control point is at most γ₍₆ₙ₊₂₎·Σ|aₖ|.
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if a control point is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::{BezierCurve, MonomialCurve};
    ///
    /// let square = MonomialCurve::new(0.0, [0.0, 1.0])?;
    /// let curve = BezierCurve::from_monomial(&square.over(Interval::new(1.0, 3.0)?)?)?;
    /// assert_eq!(curve.control_points(), [1.0, 3.0, 9.0]);
    /// assert_eq!(curve.at(2.0), 4.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_monomial(form: &MonomialCurve<P>) -> Result<Self, BezierError> {
        let n = form.degree();
        let control_points = (0..=n).map(|i| {
            let terms = form.coefficients()[..i]
                .iter()
                .zip(1_usize..)
                .map(|(coefficient, k)| {
                    let weight = binomial::<P::Scalar>(i, k as i64) / binomial(n, k as i64);
                    coefficient.scaled(weight)
                });
            match terms.reduce(|sum, term| sum.translated(&term)) {
                Some(sum) => form.start().translated(&sum),
                None => form.start().clone(),
            }
        });
        Self::on(form.domain().clone(), control_points)
    }
}

/// Why there is no monomial form.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MonomialError {
    /// A coefficient is NaN or infinite.
    #[error(
        "coefficient {index} of the monomial form is not finite: {coefficient}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which coefficient, that of the power `index`.
        index: usize,
        /// The coefficient.
        coefficient: String,
    },
}

fn check_finite<P: Affine>(index: usize, coefficient: &P) -> Result<(), MonomialError> {
    if coefficient.coordinates().iter().all(Scalar::is_finite) {
        Ok(())
    } else {
        Err(MonomialError::NotFinite {
            index,
            coefficient: tuple(coefficient),
        })
    }
}
