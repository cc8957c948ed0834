//! Properties of symbols and difference schemes, over exact numbers.

use cagd::scalar::BigRational;
use cagd::subdivision::{LaurentPolynomial, Mask, Smoothness, laws};

use super::masks::{affine_mask, data, mask};
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::symbols as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;

/// How many masks: exact numbers are slow.
const CASES: u32 = 64;

#[test]
fn symbol() {
    type Step = fn(&Mask<Q>, &LaurentPolynomial<Q>) -> LaurentPolynomial<Q>;
    let law = |implementation: Step| {
        for_all_of(
            CASES,
            (mask(), data(), 0_usize..=3),
            |(mask, data, steps)| laws::symbol(implementation, mask, data, *steps),
        )
    };
    holds(law(Mask::apply));
    rejects("the data are not stretched", law(mutants::not_stretched));
    rejects("indices reversed", law(mutants::index_reversed));
    rejects("one rule for all", law(mutants::even_rule_only));
}

#[test]
fn sum_rules() {
    let law = |implementation: fn(&Mask<Q>) -> usize| {
        for_all_of(CASES, mask(), |mask| laws::sum_rules(implementation, mask))
    };
    holds(law(Mask::sum_rules));
    rejects("zeros at 1", law(mutants::zeros_at_one));
    rejects("one too few", law(mutants::degree_not_number));
    rejects("sums alone", law(mutants::affine_is_enough));
}

#[test]
fn difference_scheme() {
    type Scheme = fn(&Mask<Q>) -> Option<Mask<Q>>;
    type Norm = fn(&Mask<Q>, usize) -> Q;
    let law = |scheme: Scheme, norm: Norm| {
        let inputs = (affine_mask(), data(), 1_usize..=3);
        for_all_of(CASES, inputs, |(mask, data, steps)| {
            laws::difference_scheme(scheme, norm, mask, data, *steps)
        })
    };
    let (scheme, norm): (Scheme, Norm) = (Mask::difference_scheme, Mask::norm);
    holds(law(scheme, norm));
    rejects("1 − z", law(mutants::divided_by_one_minus_z, norm));
    rejects("scaled", law(mutants::scaled_by_two, norm));
    rejects(
        "largest coefficient",
        law(scheme, mutants::largest_coefficient),
    );
    rejects("without absolute values", law(scheme, mutants::signed_sums));
    rejects("power of the norm", law(scheme, mutants::power_of_the_norm));
}

#[test]
fn smoothness_criterion() {
    type Proof = fn(&Mask<Q>) -> Option<Smoothness<Q>>;
    let law = |implementation: Proof| {
        let inputs = (0_usize..=5, -2_i64..=2, data());
        for_all_of(CASES, inputs, |(degree, shift, data)| {
            let symbol = Mask::<Q>::lane_riesenfeld(*degree).symbol().shifted(*shift);
            let mask = Mask::from_symbol(symbol).expect("the coefficients of Lane and Riesenfeld");
            laws::smoothness_criterion(implementation, &mask, degree.checked_sub(1), data)
        })
    };
    holds(law(|mask| mask.smoothness(6)));
    rejects("factors alone", law(mutants::factors_alone));
    rejects("not divided", law(mutants::not_divided));
}
