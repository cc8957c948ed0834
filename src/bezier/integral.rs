//! Integrals of Bézier curves.

use num_traits::Zero;

use super::curve::BezierCurve;
use crate::affine::{Affine, Linear};
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The mean value of the curve over its domain: the centroid of the control points.
    ///
    /// ```text
    /// 1/(b − a) · ∫ₐᵇ b(u) du = (b₀ + … + bₙ)/(n + 1)
    /// ```
    ///
    /// The weights 1/(n + 1) sum to 1: the mean of points is a point, whatever the origin.
    /// Every control point is scaled before the sum, so that the sum stays in range.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let arch = BezierCurve::new([[0.0, 0.0], [2.0, 6.0], [4.0, 0.0]].map(Point::new))?;
    /// let mean = arch.mean();
    /// assert!((mean - Point::new([2.0, 2.0])).norm() < 1e-15);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §6.7.
    #[must_use]
    pub fn mean(&self) -> P {
        let count = self.degree() as i64 + 1;
        let weight = P::Scalar::from_ratio(1, count);
        P::from_fn(|k| {
            self.control_points()
                .iter()
                .fold(P::Scalar::zero(), |sum, point| {
                    sum + point.coordinates()[k].clone() * weight.clone()
                })
        })
    }
}

impl<V: Linear> BezierCurve<V> {
    /// The integral of a curve of vectors or numbers over its domain.
    ///
    /// ```text
    /// ∫ₐᵇ b(u) du = (b − a)/(n + 1) · (b₀ + … + bₙ)
    /// ```
    ///
    /// The integral of a curve of points would change with the origin; it has a
    /// [`mean`](Self::mean) only.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Interval;
    /// use cagd::bezier::BezierCurve;
    ///
    /// // u² over [0, 3] has the control values 0, 0, 9 and the integral 9.
    /// let square = BezierCurve::on(Interval::new(0.0, 3.0)?, [0.0, 0.0, 9.0])?;
    /// assert_eq!(square.integral(), 9.0);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §6.7.
    #[must_use]
    pub fn integral(&self) -> V {
        let factor = self.domain().length() / Number::<V>::from_integer(self.degree() as i64 + 1);
        V::from_fn(|k| {
            self.control_points()
                .iter()
                .fold(Number::<V>::zero(), |sum, vector| {
                    sum + vector.coordinates()[k].clone() * factor.clone()
                })
        })
    }

    /// The curve whose derivative this is and that starts at `start`.
    ///
    /// ```text
    /// c₀ = start,   cᵢ₊₁ = cᵢ + (b − a)/(n + 1)·bᵢ
    /// ```
    ///
    /// Integrating vectors from a point gives points again: the inverse of
    /// [`derivative`](BezierCurve::derivative).
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let velocity = BezierCurve::new([[2.0, 4.0], [4.0, 0.0]].map(Vector::from))?;
    /// let curve = velocity.antiderivative(Point::new([1.0, 1.0]));
    /// assert_eq!(curve.control_points(), [[1.0, 1.0], [2.0, 3.0], [4.0, 3.0]].map(Point::new));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn antiderivative<Q: Affine<Scalar = V::Scalar, Difference = V>>(
        &self,
        start: Q,
    ) -> BezierCurve<Q> {
        let factor = self.domain().length() / Number::<V>::from_integer(self.degree() as i64 + 1);
        let mut points = vec![start];
        for (i, vector) in self.control_points().iter().enumerate() {
            points.push(points[i].translated(&vector.scaled(factor.clone())));
        }
        BezierCurve::trusted(self.domain().clone(), points)
    }
}

/// The numbers that coefficients are made of.
type Number<V> = <V as Affine>::Scalar;
