//! Many points of one curve at once, as fast as the machine can.
//!
//! Curves of any degree are evaluated by the linear scheme
//!
//! ```text
//! v₀ = b₀,   vᵢ = vᵢ₋₁·(1 − t) + C(n, i)·tⁱ·bᵢ,   b(t) = vₙ
//! ```
//!
//! cubics by a form of their own, in blocks of parameters that fill the vector registers. The crate
//! `pulp` finds out at run time which instructions there are: it is well kept, safe to use, and the
//! same source serves AVX2, AVX-512, NEON and plain machines.
//!
//! # Rounding
//!
//! A term of the linear scheme passes one rounding for C(n, i)·bᵢ, i for tⁱ, one for their product,
//! and for each of the at most n factors 1 − t three (1 − t itself, product, sum): at most 3n + 3.
//! The cubic form passes at most 9 a term, and its terms sum to at most 5/3 of those of the Bernstein
//! form: 15. So the error is at most (3n + 6)·u·max|bᵢ|·(|t| + |1 − t|)ⁿ, u = 2⁻⁵³; in [a, b] the
//! last factor is 1.

use pulp::{Arch, Simd, WithSimd};
use thiserror::Error;

use super::bernstein::binomial;
use super::curve::BezierCurve;
use crate::affine::Point;

/// Parameters in a block: two registers of four numbers for each coordinate. Blocks of 16 and 32 were
/// slower for degree 10, whose intermediate results then no longer fit into the registers.
const BLOCK: usize = 8;

impl<const D: usize> BezierCurve<Point<f64, D>> {
    /// The points at many parameters, into interleaved memory: `points[k]` = b(`parameters[k]`).
    ///
    /// In [a, b] the error of each coordinate is at most (3n + 6)·u·max|bᵢ|, u = 2⁻⁵³ (derived in
    /// [`batch`](self)). A parameter or a result that is not finite gives coordinates that are not
    /// finite.
    ///
    /// # Errors
    ///
    /// [`BatchError`] if the lengths differ; nothing is written then.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let mut points = [Point::origin(); 3];
    /// curve.evaluate_into(&[0.0, 0.5, 1.0], &mut points)?;
    /// assert_eq!(points, [[0.0, 0.0], [2.0, 3.0], [4.0, 0.0]].map(Point::new));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluate_into(
        &self,
        parameters: &[f64],
        points: &mut [Point<f64, D>],
    ) -> Result<(), BatchError> {
        check_length(parameters.len(), points.len())?;
        Arch::new().dispatch(Batch {
            curve: self,
            parameters,
            output: Interleaved(points),
        });
        Ok(())
    }

    /// The points at many parameters, each coordinate into an array of its own:
    /// `coordinates[d][k]` is coordinate d of b(`parameters[k]`).
    ///
    /// Accuracy as for [`evaluate_into`](Self::evaluate_into); faster, because nothing has to be
    /// interleaved.
    ///
    /// # Errors
    ///
    /// [`BatchError`] if the lengths differ; nothing is written then.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 4.0], [2.0, 0.0]].map(Point::new))?;
    /// let (mut x, mut y) = ([0.0; 3], [0.0; 3]);
    /// curve.evaluate_split_into(&[0.0, 0.5, 1.0], [&mut x, &mut y])?;
    /// assert_eq!((x, y), ([0.0, 1.0, 2.0], [0.0, 2.0, 0.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluate_split_into(
        &self,
        parameters: &[f64],
        coordinates: [&mut [f64]; D],
    ) -> Result<(), BatchError> {
        for array in &coordinates {
            check_length(parameters.len(), array.len())?;
        }
        Arch::new().dispatch(Batch {
            curve: self,
            parameters,
            output: Split(coordinates),
        });
        Ok(())
    }
}

/// Why a batch cannot be evaluated.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "{parameters} parameters need room for as many points, found room for {room}; make both slices equally long"
)]
pub struct BatchError {
    /// How many parameters there are.
    pub parameters: usize,
    /// How many points fit into the output.
    pub room: usize,
}

fn check_length(parameters: usize, room: usize) -> Result<(), BatchError> {
    if parameters == room {
        Ok(())
    } else {
        Err(BatchError { parameters, room })
    }
}

/// A curve, prepared to be evaluated block by block.
///
/// Everything below is `inline(always)`: only what is inlined into the dispatched function is
/// compiled for the instructions that were found.
trait Prepared<const D: usize> {
    fn evaluate(&self, t: &[f64; BLOCK], multiply_add: impl MultiplyAdd) -> [[f64; BLOCK]; D];
}

/// The function (a, b, c) ↦ a·b + c, fused where the machine can.
trait MultiplyAdd: Fn(f64, f64, f64) -> f64 + Copy {}

impl<F: Fn(f64, f64, f64) -> f64 + Copy> MultiplyAdd for F {}

/// The cubic that everybody draws, as (1 − t)²·(b₀ + t·left) + t²·(b₃ + (1 − t)·right) with
/// left = 3b₁ − b₀ and right = 3b₂ − b₃: four multiply-adds a coordinate, exact at both ends.
struct Cubic<const D: usize> {
    start: [f64; D],
    left: [f64; D],
    right: [f64; D],
    end: [f64; D],
}

impl<const D: usize> Cubic<D> {
    fn new([b0, b1, b2, b3]: &[Point<f64, D>; 4]) -> Self {
        Self {
            start: std::array::from_fn(|d| b0[d]),
            left: std::array::from_fn(|d| 3.0 * b1[d] - b0[d]),
            right: std::array::from_fn(|d| 3.0 * b2[d] - b3[d]),
            end: std::array::from_fn(|d| b3[d]),
        }
    }
}

impl<const D: usize> Prepared<D> for Cubic<D> {
    #[inline(always)]
    fn evaluate(&self, t: &[f64; BLOCK], multiply_add: impl MultiplyAdd) -> [[f64; BLOCK]; D] {
        // The squares are computed once for all coordinates.
        let (mut s, mut s_squared, mut t_squared) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        for k in 0..BLOCK {
            s[k] = 1.0 - t[k];
            s_squared[k] = s[k] * s[k];
            t_squared[k] = t[k] * t[k];
        }
        let mut points = [[0.0; BLOCK]; D];
        for (d, values) in points.iter_mut().enumerate() {
            for k in 0..BLOCK {
                let first = multiply_add(t[k], self.left[d], self.start[d]);
                let second = multiply_add(s[k], self.right[d], self.end[d]);
                values[k] = multiply_add(s_squared[k], first, t_squared[k] * second);
            }
        }
        points
    }
}

/// A curve of any degree: the control points times their binomial coefficients.
struct Scaled<const D: usize>(Vec<[f64; D]>);

impl<const D: usize> Scaled<D> {
    fn new(points: &[Point<f64, D>]) -> Self {
        let n = points.len() - 1;
        let scaled = points.iter().enumerate().map(|(i, point)| {
            let factor: f64 = binomial(n, i as i64);
            std::array::from_fn(|d| factor * point[d])
        });
        Self(scaled.collect())
    }
}

impl<const D: usize> Prepared<D> for Scaled<D> {
    #[inline(always)]
    fn evaluate(&self, t: &[f64; BLOCK], multiply_add: impl MultiplyAdd) -> [[f64; BLOCK]; D] {
        let mut points = [[0.0; BLOCK]; D];
        for (values, first) in points.iter_mut().zip(self.0[0]) {
            *values = [first; BLOCK];
        }
        let mut power = [1.0; BLOCK];
        for coefficient in &self.0[1..] {
            for (power, t) in power.iter_mut().zip(t) {
                *power *= t;
            }
            for (values, coefficient) in points.iter_mut().zip(coefficient) {
                for k in 0..BLOCK {
                    values[k] = multiply_add(values[k], 1.0 - t[k], power[k] * coefficient);
                }
            }
        }
        points
    }
}

/// Where the points of a block go.
trait Output<const D: usize> {
    /// Whether to hide the blocks from the compiler, which would else vectorise the loop over them once
    /// more, with shuffles. Measured: arrays gain 45 %, interleaved points would lose 30 %.
    const OPAQUE: bool;

    fn write(&mut self, start: usize, count: usize, block: &[[f64; BLOCK]; D]);
}

struct Interleaved<'a, const D: usize>(&'a mut [Point<f64, D>]);

impl<const D: usize> Output<D> for Interleaved<'_, D> {
    const OPAQUE: bool = false;

    #[inline(always)]
    fn write(&mut self, start: usize, count: usize, block: &[[f64; BLOCK]; D]) {
        let points = &mut self.0[start..start + count];
        for (k, point) in points.iter_mut().enumerate() {
            *point = Point::new(std::array::from_fn(|d| block[d][k]));
        }
    }
}

struct Split<'a, const D: usize>([&'a mut [f64]; D]);

impl<const D: usize> Output<D> for Split<'_, D> {
    const OPAQUE: bool = true;

    #[inline(always)]
    fn write(&mut self, start: usize, count: usize, block: &[[f64; BLOCK]; D]) {
        for (array, values) in self.0.iter_mut().zip(block) {
            array[start..start + count].copy_from_slice(&values[..count]);
        }
    }
}

struct Batch<'a, const D: usize, O> {
    curve: &'a BezierCurve<Point<f64, D>>,
    parameters: &'a [f64],
    output: O,
}

impl<const D: usize, O: Output<D>> WithSimd for Batch<'_, D, O> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Where multiply-add is not one instruction it is a slow library call.
        if S::IS_SCALAR || cfg!(target_family = "wasm") {
            self.run(|a, b, c| a * b + c);
        } else {
            self.run(f64::mul_add);
        }
    }
}

impl<const D: usize, O: Output<D>> Batch<'_, D, O> {
    #[inline(always)]
    fn run(self, multiply_add: impl MultiplyAdd) {
        let points = self.curve.control_points();
        match points.as_array() {
            Some(points) => self.each_block(&Cubic::new(points), multiply_add),
            None => self.each_block(&Scaled::new(points), multiply_add),
        }
    }

    #[inline(always)]
    fn each_block(mut self, curve: &impl Prepared<D>, multiply_add: impl MultiplyAdd) {
        let domain = *self.curve.domain();
        let is_unit = domain.is_unit();
        let (blocks, rest) = self.parameters.as_chunks();
        let mut start = 0;
        for block in blocks {
            let mut t = if O::OPAQUE {
                *std::hint::black_box(block)
            } else {
                *block
            };
            if !is_unit {
                for t in &mut t {
                    *t = domain.local(*t);
                }
            }
            self.output
                .write(start, BLOCK, &curve.evaluate(&t, multiply_add));
            start += BLOCK;
        }
        if !rest.is_empty() {
            let mut t = [0.0; BLOCK];
            for (t, u) in t.iter_mut().zip(rest) {
                *t = domain.local(*u);
            }
            self.output
                .write(start, rest.len(), &curve.evaluate(&t, multiply_add));
        }
    }
}
