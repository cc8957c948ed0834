//! The weights of Loop's scheme by valence.

use super::{Computed, VALENCES, exact_or_decimal};
use crate::scalar::BigRational;
use crate::subdivision::{CosineError, CosineOfTurn, loop_beta, loop_limit_weight};

pub(super) const ALL: &[Computed] = &[("loop_weights", loop_weights)];

/// β, the weight of the vertex itself, and both weights of the limit.
fn loop_weights() -> String {
    let mut table = String::from(
        "| $k$ | $\\beta$ | $1 - k\\beta$ | limit: vertex | limit: each neighbour |\n|--:|--:|--:|--:|--:|\n",
    );
    for valence in VALENCES {
        let (exact, decimal) = (row::<BigRational>(valence), row::<f64>(valence));
        let Ok(decimal) = decimal else { continue };
        let cells: Vec<String> = (0..decimal.len())
            .map(|i| exact_or_decimal(exact.as_ref().ok().map(|row| &row[i]), decimal[i]))
            .collect();
        table += &format!("| {valence} | {} |\n", cells.join(" | "));
    }
    table
}

fn row<T: CosineOfTurn>(valence: usize) -> Result<[T; 4], CosineError> {
    let k = T::from_integer(valence as i64);
    let beta = loop_beta::<T>(valence)?;
    let omega = loop_limit_weight::<T>(valence)?;
    let whole = omega.clone() + k.clone();
    Ok([
        beta.clone(),
        T::one() - k * beta,
        omega / whole.clone(),
        T::one() / whole,
    ])
}
