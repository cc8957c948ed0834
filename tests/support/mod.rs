//! What the property tests and the exact tests share.
//!
//! A test reads as a sentence:
//!
//! ```text
//! let law = |implementation: Evaluate| for_all(curves_and_parameters(), |(curve, u)| laws::end_values(implementation, &curve));
//! holds(law(|curve, u| curve.at(u)));
//! rejects("t and 1 − t swapped", law(|curve, u| curve.at(1.0 - u)));
//! ```

#[cfg(feature = "book")]
mod listed;

#[allow(
    dead_code,
    reason = "each test binary uses its own part of the mutants"
)]
pub mod mutants;
pub mod planted;

pub mod jets;

/// What a driver found: nothing, or the input on which the law fails.
pub type Outcome = Result<(), String>;

/// The law holds for every input.
#[track_caller]
pub fn holds(outcome: Outcome) {
    if let Err(counterexample) = outcome {
        panic!("the law does not hold\n{counterexample}");
    }
}

/// The law refuses this wrong implementation on some input.
#[track_caller]
pub fn rejects(mutant: &str, outcome: Outcome) {
    assert!(
        outcome.is_err(),
        "no input shows that the implementation is wrong: {mutant}"
    );
}
