//! Areas by random points.

use thiserror::Error;

use super::{Affine, BoundingBox, Point};

/// Estimates the area (in dimension D the volume) of a set by random points of a box that contains it.
///
/// ```text
/// |M| ≈ |Q|·h/N,   h of N independent uniform points of Q lie in M
/// ```
///
/// The estimate is unbiased: its mean is the true area. Its standard error is |Q|·√(p(1 − p)/N) with p = |M|/|Q|,
/// so one more digit takes a hundred times as many points, in every dimension.
///
/// The points come from a seed, so that a run can be repeated; another seed gives other points.
///
/// # Errors
///
/// [`MonteCarloError`] without samples, or if the box has no area or one beyond the range of `f64`.
///
/// # Examples
///
/// ```
/// use cagd::affine::{BoundingBox, Point, monte_carlo};
///
/// let square = BoundingBox::of(&[[0.0, 0.0], [1.0, 1.0]].map(Point::new))?;
/// let in_quarter_disc = |x: &Point<f64, 2>| x[0] * x[0] + x[1] * x[1] <= 1.0;
/// let estimate = monte_carlo(&square, 10_000, 1, in_quarter_disc)?;
/// let error = (estimate.area() - std::f64::consts::FRAC_PI_4).abs();
/// assert!(error <= 4.0 * estimate.standard_error());
/// assert!(0.0 < estimate.standard_error() && estimate.standard_error() <= 0.005);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Source: `metropolis1949`.
pub fn monte_carlo<const D: usize>(
    bounds: &BoundingBox<Point<f64, D>>,
    samples: usize,
    seed: u64,
    contains: impl Fn(&Point<f64, D>) -> bool,
) -> Result<MonteCarloEstimate, MonteCarloError> {
    let box_area: f64 = bounds.size().iter().product();
    if samples == 0 {
        return Err(MonteCarloError::NoSamples);
    }
    if !(box_area > 0.0 && box_area.is_finite()) {
        return Err(MonteCarloError::BoxArea { found: box_area });
    }
    let points = UniformPoints::new(*bounds, seed).take(samples);
    Ok(MonteCarloEstimate {
        box_area,
        samples,
        hits: points.filter(|point| contains(point)).count(),
    })
}

/// What [`monte_carlo`] found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MonteCarloEstimate {
    /// The area |Q| of the box.
    pub box_area: f64,
    /// The number N of points.
    pub samples: usize,
    /// The number h of those in the set.
    pub hits: usize,
}

impl MonteCarloEstimate {
    /// The estimated area |Q|·h/N.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.box_area * self.share()
    }

    /// The estimated standard error |Q|·√(q(1 − q)/N) with q = h/N in place of the unknown p.
    ///
    /// It is 0, and says nothing, if all points are in the set or none is.
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        let share = self.share();
        self.box_area * libm::sqrt(share * (1.0 - share) / self.samples as f64)
    }

    /// An error that is exceeded with a probability of at most `probability`, whatever the set is:
    /// |Q|·√(ln(2/probability)/(2N)).
    ///
    /// ```
    /// use cagd::affine::MonteCarloEstimate;
    ///
    /// let estimate = MonteCarloEstimate { box_area: 1.0, samples: 10_000, hits: 7_854 };
    /// assert!(estimate.error_bound(0.01) < 0.017);
    /// assert!(estimate.error_bound(0.01) > 2.0 * estimate.standard_error());
    /// ```
    ///
    /// Source: `hoeffding1963`, theorem 1.
    #[must_use]
    pub fn error_bound(&self, probability: f64) -> f64 {
        self.box_area * libm::sqrt(libm::log(2.0 / probability) / (2.0 * self.samples as f64))
    }

    fn share(&self) -> f64 {
        self.hits as f64 / self.samples as f64
    }
}

/// Why there is no estimate.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MonteCarloError {
    /// No point was asked for.
    #[error("an estimate needs at least one random point, found 0 samples")]
    NoSamples,
    /// The box has no area, or none that `f64` can hold.
    #[error(
        "the box of the random points has the area {found}; it must be positive and finite, so choose another box around the set"
    )]
    BoxArea {
        /// The area.
        found: f64,
    },
}

/// Independent random points, uniformly distributed in a box. They never end.
///
/// ```
/// use cagd::affine::{BoundingBox, Point, UniformPoints};
///
/// let square = BoundingBox::of(&[[2.0, 2.0], [3.0, 4.0]].map(Point::new))?;
/// let points: Vec<_> = UniformPoints::new(square, 7).take(100).collect();
/// assert!(points.iter().all(|point| square.contains(point)));
/// assert_eq!(points, UniformPoints::new(square, 7).take(100).collect::<Vec<_>>(), "the same seed");
/// assert_ne!(points[0], UniformPoints::new(square, 8).next().unwrap(), "another seed");
/// # Ok::<(), cagd::affine::BoundingBoxError>(())
/// ```
#[derive(Debug, Clone)]
pub struct UniformPoints<const D: usize> {
    bounds: BoundingBox<Point<f64, D>>,
    random: SplitMix64,
}

impl<const D: usize> UniformPoints<D> {
    /// The points of `seed` in `bounds`.
    #[must_use]
    pub fn new(bounds: BoundingBox<Point<f64, D>>, seed: u64) -> Self {
        Self {
            bounds,
            random: SplitMix64::new(seed),
        }
    }
}

impl<const D: usize> Iterator for UniformPoints<D> {
    type Item = Point<f64, D>;

    fn next(&mut self) -> Option<Self::Item> {
        let (low, high) = (self.bounds.low(), self.bounds.high());
        Some(Affine::from_fn(|k| {
            low[k].lerp(&high[k], self.random.in_unit_interval())
        }))
    }
}

/// A generator of pseudo-random numbers, five lines long and the same on every machine.
///
/// Source: `steele2014`.
#[derive(Debug, Clone)]
pub(crate) struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// The generator of this seed.
    pub(crate) fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// One of `choices`, each about equally likely; `None` if there are none.
    pub(crate) fn choose<T: Copy>(&mut self, choices: &[T]) -> Option<T> {
        let index = self.next().checked_rem(choices.len() as u64)?;
        choices.get(index as usize).copied()
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A multiple of 2⁻⁵³ in [0, 1), each equally likely.
    fn in_unit_interval(&mut self) -> f64 {
        const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
        (self.next() >> 11) as f64 * STEP
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers for the seed 1234567, as published with the reference implementation.
    #[test]
    fn random_numbers_are_those_of_the_reference() {
        let mut random = SplitMix64::new(1_234_567);
        let found: Vec<u64> = (0..5).map(|_| random.next()).collect();
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn boxes_and_samples_that_give_no_estimate_are_refused() {
        let area = |corners: [[f64; 2]; 2], samples: usize| {
            let bounds = BoundingBox::of(&corners.map(Point::new)).expect("finite corners");
            monte_carlo(&bounds, samples, 0, |_| true).map(|estimate| estimate.area())
        };
        assert_eq!(area([[0.0, 0.0], [2.0, 3.0]], 5), Ok(6.0));
        assert_eq!(
            area([[0.0, 0.0], [2.0, 3.0]], 0),
            Err(MonteCarloError::NoSamples)
        );
        for corners in [[[0.0, 0.0], [2.0, 0.0]], [[0.0, 0.0], [1e200, 1e200]]] {
            assert!(matches!(
                area(corners, 5),
                Err(MonteCarloError::BoxArea { .. })
            ));
        }
    }
}
