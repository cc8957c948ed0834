//! Wrong limit stencils.

use cagd::scalar::BigRational;
use cagd::subdivision::{LimitStencil, Mask};

/// Takes the derivative of the next order.
pub fn order_too_high(mask: &Mask<BigRational>, order: usize) -> Option<LimitStencil<BigRational>> {
    mask.limit_stencil(order + 1).ok()
}

/// Shifts the window by one.
pub fn index_off_by_one(
    mask: &Mask<BigRational>,
    order: usize,
) -> Option<LimitStencil<BigRational>> {
    mask.limit_stencil_at(order, 1, 0).ok()
}

/// Makes a step and forgets that the parameter has doubled.
pub fn half_way(mask: &Mask<BigRational>, order: usize) -> Option<LimitStencil<BigRational>> {
    mask.limit_stencil_at(order, 1, 1).ok()
}

/// Takes the scheme of the divided differences for that of the points.
pub fn scheme_of_differences(
    mask: &Mask<BigRational>,
    order: usize,
) -> Option<LimitStencil<BigRational>> {
    let shorter = mask.divided_difference_scheme(1)?;
    shorter.limit_stencil(order).ok()
}
