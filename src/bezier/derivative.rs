//! Derivatives of Bézier curves of every order: hodographs, whose control points are vectors.
//!
//! ```text
//! b     control points    bᵢ                            degree n
//! b′    control vectors   n/(b − a)·Δbᵢ                 degree n − 1
//! b⁽ᵖ⁾   control vectors   n!/(n − p)!/(b − a)ᵖ·Δᵖbᵢ     degree n − p
//! ```

use std::num::NonZeroUsize;

use num_traits::{One, Zero};

use super::casteljau::CasteljauTriangle;
use super::curve::{BezierCurve, BezierError, tuple};
use crate::affine::{Affine, Linear};
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The derivative b′ with respect to the parameter of the domain [a, b].
    ///
    /// ```text
    /// b′(u) = n/(b − a) · Σᵢ (bᵢ₊₁ − bᵢ)·Bᵢⁿ⁻¹(t)
    /// ```
    ///
    /// Its control points are vectors, so its values are.
    /// The derivative of a curve of degree 0 is the constant curve of the zero vector.
    /// Where n/(b − a) times a leg is beyond the range of the number type, the control vectors are
    /// not finite; [`try_derivative`](Self::try_derivative) makes that an error.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]].map(Point::new))?;
    /// let hodograph = curve.derivative();
    /// assert_eq!(hodograph.control_points(), [Vector::from([2.0, 4.0]), Vector::from([4.0, 0.0])]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §5.3.
    #[must_use]
    pub fn derivative(&self) -> BezierCurve<P::Difference> {
        self.higher_derivative(NonZeroUsize::MIN)
    }

    /// The second derivative b″.
    ///
    /// ```text
    /// b″(u) = n(n − 1)/(b − a)² · Σᵢ (bᵢ₊₂ − 2bᵢ₊₁ + bᵢ)·Bᵢⁿ⁻²(t)
    /// ```
    ///
    /// The zero vector if n < 2.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let parabola = BezierCurve::new([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new))?;
    /// assert_eq!(parabola.second_derivative().at(0.3), Vector::from([0.0, 2.0]));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn second_derivative(&self) -> BezierCurve<P::Difference> {
        self.higher_derivative(NonZeroUsize::MIN.saturating_add(1))
    }

    /// The derivative b⁽ᵖ⁾ of any order p ≥ 1.
    ///
    /// ```text
    /// b⁽ᵖ⁾(u) = n(n − 1)⋯(n − p + 1)/(b − a)ᵖ · Σᵢ Δᵖbᵢ·Bᵢⁿ⁻ᵖ(t),   i = 0 … n − p
    /// ```
    ///
    /// `order` = p is never 0, because the derivative of order 0 is the curve itself: its control
    /// points are points, those of all others are vectors.
    /// For p > n the derivative is the constant curve of the zero vector.
    ///
    /// # Examples
    ///
    /// ```
    /// use std::num::NonZeroUsize;
    ///
    /// use cagd::bezier::BezierCurve;
    ///
    /// // t³ has the control values 0, 0, 0, 1 and the third derivative 6.
    /// let cube = BezierCurve::new([0.0, 0.0, 0.0, 1.0])?;
    /// let third = cube.higher_derivative(NonZeroUsize::new(3).expect("3 is not 0"));
    /// assert_eq!(third.control_points(), [6.0]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §5.3; `prautzsch2002`, §2.4.
    #[must_use]
    pub fn higher_derivative(&self, order: NonZeroUsize) -> BezierCurve<P::Difference> {
        if order.get() > self.degree() {
            let zero = P::Difference::from_fn(|_| P::Scalar::zero());
            return BezierCurve::trusted(self.domain().clone(), vec![zero]);
        }
        let factor = self.derivative_factor(order.get());
        let mut vectors = forward_differences(self.control_points(), order);
        for vector in &mut vectors {
            *vector = vector.scaled(factor.clone());
        }
        BezierCurve::trusted(self.domain().clone(), vectors)
    }

    /// The derivative b′, or why its control vectors are not finite.
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if n/(b − a)·(bᵢ₊₁ − bᵢ) is beyond the range of the number type.
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, BezierError};
    ///
    /// let steep = BezierCurve::new([-1e308, 1e308])?;
    /// assert!(matches!(steep.try_derivative(), Err(BezierError::NotFinite { index: 0, .. })));
    /// # Ok::<(), BezierError>(())
    /// ```
    pub fn try_derivative(&self) -> Result<BezierCurve<P::Difference>, BezierError> {
        let derivative = self.derivative();
        let broken = derivative
            .control_points()
            .iter()
            .position(|vector| !vector.coordinates().iter().all(Scalar::is_finite));
        match broken {
            None => Ok(derivative),
            Some(index) => Err(BezierError::NotFinite {
                index,
                point: tuple(&derivative.control_points()[index]),
            }),
        }
    }

    /// The derivative vectors b′(u), b″(u), …, b⁽ᴷ⁾(u), all from one triangle of de Casteljau.
    ///
    /// ```text
    /// b⁽ᵖ⁾(u) = n!/(n − p)!/(b − a)ᵖ · Δᵖb₀ⁿ⁻ᵖ
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]].map(Point::new))?;
    /// let [first, second] = curve.derivatives(0.5);
    /// assert_eq!(first, Vector::from([3.0, 2.0]));
    /// assert_eq!(second, Vector::from([2.0, -4.0]));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn derivatives<const K: usize>(&self, u: P::Scalar) -> [P::Difference; K] {
        let triangle = self.triangle(u);
        std::array::from_fn(|k| {
            let order = NonZeroUsize::MIN.saturating_add(k);
            triangle
                .forward_difference(order)
                .scaled(self.derivative_factor(order.get()))
        })
    }

    /// n(n − 1)⋯(n − p + 1)/(b − a)ᵖ, multiplied factor by factor: no partial product is larger than
    /// what the result needs.
    fn derivative_factor(&self, order: usize) -> P::Scalar {
        let length = self.domain().length();
        (0..order).fold(P::Scalar::one(), |product, j| {
            product * (P::Scalar::from_integer(self.degree() as i64 - j as i64) / length.clone())
        })
    }
}

impl<P: Affine> CasteljauTriangle<P> {
    /// The difference Δᵖb₀ⁿ⁻ᵖ over the p + 1 points of column n − p, p = `order`.
    ///
    /// In a triangle of one parameter t it is the p-th derivative with respect to t, divided by
    /// n(n − 1)⋯(n − p + 1). It is the zero vector for p > n.
    ///
    /// # Examples
    ///
    /// ```
    /// use std::num::NonZeroUsize;
    ///
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let triangle = curve.triangle(0.5);
    /// let last_leg = triangle.forward_difference(NonZeroUsize::MIN);
    /// assert_eq!(last_leg, *triangle.point(2, 1) - *triangle.point(2, 0));
    /// assert_eq!(last_leg * 3.0, curve.derivative().at(0.5));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn forward_difference(&self, order: NonZeroUsize) -> P::Difference {
        let zero = P::Difference::from_fn(|_| P::Scalar::zero());
        match self.degree().checked_sub(order.get()) {
            None => zero,
            Some(level) => forward_differences(self.column(level), order)
                .pop()
                .unwrap_or(zero),
        }
    }
}

/// The forward differences Δᵖbᵢ, i = 0 … n − p, of a list b₀ … bₙ; p = `order` ≥ 1.
///
/// ```text
/// Δ⁰bᵢ = bᵢ,   Δᵖbᵢ = Δᵖ⁻¹bᵢ₊₁ − Δᵖ⁻¹bᵢ
/// ```
///
/// Differences of points are vectors. The list is empty for p > n.
///
/// # Examples
///
/// ```
/// use std::num::NonZeroUsize;
///
/// use cagd::bezier::forward_differences;
///
/// let squares = [0.0, 1.0, 4.0, 9.0];
/// let second = forward_differences(&squares, NonZeroUsize::new(2).expect("2 is not 0"));
/// assert_eq!(second, [2.0, 2.0]);
/// ```
///
/// Source: `farin2002`, §5.3.
#[must_use]
pub fn forward_differences<P: Affine>(points: &[P], order: NonZeroUsize) -> Vec<P::Difference> {
    let mut differences: Vec<P::Difference> = points
        .windows(2)
        .map(|pair| pair[1].difference(&pair[0]))
        .collect();
    for _ in 1..order.get() {
        for i in 1..differences.len() {
            differences[i - 1] = differences[i].difference(&differences[i - 1]);
        }
        differences.pop();
    }
    differences
}
