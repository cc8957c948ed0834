//! Which mutant an answer behaves like.

use std::fs;

use super::CheckingError;
use super::check::Checker;
use super::compile::Source;
use super::library::{hex, replace};
use super::verdict::Misconception;
use crate::book::exercise::{Exercise, Tested};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The name of a mutant and its values.
type OfMutant = (String, Vec<String>);

/// What each mutant does on the probe inputs.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Probes {
    mutants: Vec<OfMutant>,
}

/// How far two rounded numbers may be apart, relative to the larger, and still count as the same behaviour.
///
/// Ways of computing the same differ by some units of rounding, misconceptions by much more.
const ALIKE: f64 = 1e-9;

/// The misconception whose mutant gives the same values on the probe inputs as this answer.
///
/// # Errors
///
/// A mutant cannot be compiled or run at all.
pub fn recognise(
    checker: &Checker,
    exercise: &Exercise,
    tested: &Tested,
    found: &[String],
) -> Result<Option<Misconception>, CheckingError> {
    let probes = probes_of_mutants(checker, exercise, tested)?;
    let alike = probes
        .mutants
        .iter()
        .find(|(_, values)| behave_alike(values, found));
    Ok(alike.and_then(|(name, _)| {
        let mutant = tested.mutants.iter().find(|mutant| mutant.name == *name)?;
        Some(Misconception {
            mutant: mutant.name.clone(),
            text: mutant.misconception.clone(),
        })
    }))
}

/// Runs the mutants once; the values are kept until exercise or library change.
fn probes_of_mutants(
    checker: &Checker,
    exercise: &Exercise,
    tested: &Tested,
) -> Result<Probes, CheckingError> {
    let mut digest = Sha256::new();
    digest.update(&checker.library().fingerprint);
    digest.update(&tested.tests.text);
    for mutant in &tested.mutants {
        digest.update([0]);
        digest.update(&mutant.text);
    }
    let key = hex(&digest.finalize());
    let name = format!("{}-{}", exercise.name.chapter(), exercise.name.name());
    let file = checker
        .library()
        .work
        .with_file_name("probes")
        .join(format!("{name}-{}.json", &key[..16]));
    if let Some(known) = fs::read(&file)
        .ok()
        .and_then(|bytes| serde_json::from_slice(&bytes).ok())
    {
        return Ok(known);
    }
    let sources: Vec<Source> = tested.mutants.iter().map(Source::from).collect();
    // A reader waits for the first wrong answer to an exercise.
    let found = checker.probes(tested, &sources.iter().collect::<Vec<_>>())?;
    let named = tested.mutants.iter().zip(found);
    let mutants = named
        .filter_map(|(mutant, values)| Some((mutant.name.clone(), values?)))
        .collect();
    let probes = Probes { mutants };
    let text = serde_json::to_vec(&probes).map_err(|e| CheckingError::file(&file, &e.into()))?;
    replace(&file, &text)?;
    Ok(probes)
}

/// Whether two answers do the same on all probe inputs.
pub(crate) fn behave_alike(a: &[String], b: &[String]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_value(a, b))
}

/// Whether two shown values are the same: the same text around the same numbers, up to rounding.
fn same_value(a: &str, b: &str) -> bool {
    if a == b {
        return true;
    }
    // Whole numbers and fractions are exact; only decimals may differ.
    let split = |text: &str| -> Vec<String> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || ".+-/".contains(c);
        text.split_inclusive(|c| !is_part(c))
            .map(str::to_owned)
            .collect()
    };
    let (a, b) = (split(a), split(b));
    a.len() == b.len()
        && a.iter().zip(&b).all(|(a, b)| {
            let number = |text: &str| {
                let text = text.trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.');
                text.parse::<f64>().ok()
            };
            let rounded = |text: &str| text.contains('.') || text.contains('e');
            a == b
                || match (number(a), number(b)) {
                    (Some(x), Some(y)) if rounded(a) || rounded(b) => {
                        (x - y).abs() <= ALIKE * x.abs().max(y.abs()).max(1.0)
                    }
                    _ => false,
                }
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_makes_no_difference_and_values_do() {
        assert!(same_value("(0.30000000000000004, 1)", "(0.3, 1)"));
        assert!(!same_value("(0.31, 1)", "(0.3, 1)"));
        assert!(!same_value("1/3", "1/4"));
        assert!(!same_value("[1, 2]", "[1, 2, 3]"));
        assert!(same_value("panics", "panics"));
        assert!(!same_value("panics", "0.5"));
        assert!(!same_value("0.5", "nothing"));
    }
}
