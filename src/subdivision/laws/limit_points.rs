//! Laws of limit stencils.

use num_traits::Zero;

use crate::law::{Rounding, Sides};
use crate::scalar::{BigRational, Scalar};
use crate::subdivision::{LaurentPolynomial, LimitStencil, Mask};

/// `subdivision-limit-stencils`: the stencil gives the limit of every point that is 1 among zeros, and a step changes nothing.
///
/// `implementation(mask)` must give the stencil of order r.
/// `limit(j)` is what is known otherwise: the r-th derivative at 0 of the limit of the data that are 1 at j and 0 elsewhere.
/// After a step the parameter intervals are half as long, so the stencil, applied to the refined data, gives the
/// derivative divided by 2ʳ.
pub fn limit_stencils(
    implementation: impl Fn(&Mask<BigRational>) -> Option<LimitStencil<BigRational>>,
    mask: &Mask<BigRational>,
    limit: impl Fn(i64) -> BigRational,
    data: &LaurentPolynomial<BigRational>,
) -> Sides<BigRational> {
    let sides = Sides::new(format!("{mask}, data {data}"));
    let Some(stencil) = implementation(mask) else {
        let one = <BigRational as Scalar>::from_integer(1);
        return sides.equal("there is a stencil", [], [one], Rounding::none());
    };
    let order = stencil.order();
    let applied = |data: &LaurentPolynomial<BigRational>| {
        let terms = stencil.weights().terms();
        terms.fold(BigRational::zero(), |sum, (j, weight)| {
            sum + weight * data.coefficient(j)
        })
    };
    let scale = BigRational::from_ratio(1, 1 << order);
    // No index beyond the support of the mask counts; one more on each side shows it.
    let around = -mask.support().end..=1 - mask.support().start;
    sides
        .equal(
            "the weights are the derivatives of the limits of single points",
            around.clone().map(|j| stencil.weights().coefficient(j)),
            around.map(limit),
            Rounding::none(),
        )
        .equal(
            "a step divides it by 2^r",
            [applied(&mask.apply(data))],
            [applied(data) * scale],
            Rounding::none(),
        )
}
