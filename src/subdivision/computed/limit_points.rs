//! Limit stencils of the schemes of the chapter.

use super::Computed;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};
use crate::subdivision::{LimitStencil, Mask};

pub(super) const ALL: &[Computed] = &[("limit_stencils", limit_stencils)];

/// Positions and first derivatives at the parameters that belong to vertices, and between them.
fn limit_stencils() -> String {
    let mut table = String::from("| scheme | at | point | derivative |\n|---|---|---|---|\n");
    let four_point = Mask::four_point(BigRational::from_ratio(1, 16)).ok();
    let schemes = (2..=5_usize)
        .map(|degree| {
            let name = match degree {
                2 => "Chaikin".to_string(),
                3 => "cubic".to_string(),
                _ => format!("degree\u{a0}{degree}"),
            };
            (name, Some(Mask::lane_riesenfeld(degree)))
        })
        .chain([("four\u{2011}point".to_string(), four_point)]);
    for (name, mask) in schemes {
        let Some(mask) = mask else { continue };
        let doubled_middle = mask.support().start + mask.support().end - 1;
        for (place, numerator) in [("vertex", doubled_middle), ("leg", doubled_middle + 1)] {
            let stencil = |order: usize| match mask.limit_stencil_at(order, numerator, 1) {
                Ok(stencil) => format!("${}$", weights(&stencil)),
                Err(_) => "none".to_string(),
            };
            table += &format!("| {name} | {place} | {} | {} |\n", stencil(0), stencil(1));
        }
    }
    table
}

/// The weights over their common denominator.
fn weights(stencil: &LimitStencil<BigRational>) -> String {
    let weights = stencil.weights().coefficients();
    let common = weights
        .iter()
        .fold(BigRational::from_ratio(1, 1), |common, weight| {
            let denominator = BigRational::from_integer(weight.denom().clone());
            let factor = &common / &denominator;
            // The least common multiple: the numerator of common/denominator, times the denominator.
            BigRational::from_integer(factor.numer().clone()) * denominator
        });
    let numerators: Vec<String> = weights
        .iter()
        .map(|weight| tex::fraction(&(weight * &common)))
        .collect();
    if common == BigRational::from_ratio(1, 1) {
        format!("({})", numerators.join(", "))
    } else {
        format!(r"\tfrac{{1}}{{{common}}}({})", numerators.join(", "))
    }
}
