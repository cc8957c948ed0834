use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::butterfly_weights;

fn probes() -> Vec<String> {
    cagd::probes![answer::counterexample().to_vec()]
}

/// The answer, and the height of the new point.
fn read() -> ([i64; 8], BigRational) {
    let heights = answer::counterexample();
    let [end, opposite, wing] = butterfly_weights::<BigRational>();
    let weights = [&end, &end, &opposite, &opposite, &wing, &wing, &wing, &wing];
    let new = heights
        .iter()
        .zip(weights)
        .fold(BigRational::from_ratio(0, 1), |sum, (&h, w)| {
            sum + w.clone() * BigRational::from_ratio(h, 1)
        });
    (heights, new)
}

/// Why: it refutes the claim already.
#[test]
fn below_the_lowest() {
    let (heights, new) = read();
    let lowest = heights.iter().min().copied().unwrap_or(0);
    claim("the height of the new point")
        .input(format!("{heights:?}"))
        .holds(
            new < BigRational::from_ratio(lowest, 1),
            format!("a height below the lowest one, {lowest}"),
            new.to_string(),
        );
}

#[test]
fn as_far_below_as_possible() {
    let (heights, new) = read();
    claim("the lowest height that a new point can have")
        .input(format!("{heights:?}"))
        .holds(
            new <= BigRational::from_ratio(-4, 1),
            "a height below which no other heights lead",
            new.to_string(),
        );
}

#[test]
fn numbers_as_asked() {
    let heights = answer::counterexample();
    claim("the form of the answer")
        .input(format!("{heights:?}"))
        .holds(
            heights.iter().all(|h| (0..=16).contains(h)),
            "heights from 0 to 16",
            format!("{heights:?}"),
        );
}
