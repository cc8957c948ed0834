//! Symbols and difference schemes, over rationals.

use cagd::scalar::BigRational;
use cagd::subdivision::{LaurentPolynomial, Mask, Smoothness, laws};

use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::symbols as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;

/// The schemes of Lane and Riesenfeld of degree 0 to 12, and four-point schemes.
pub fn schemes() -> Vec<Mask<Q>> {
    let splines = (0..=12).map(Mask::lane_riesenfeld);
    let tensions = [(0, 1), (1, 16), (1, 8), (17, 100), (1, 1), (-1, 16)];
    let four_point =
        tensions.map(|(p, q)| Mask::four_point(ratio(p, q)).expect("a finite tension"));
    splines.chain(four_point).collect()
}

/// A single 1 at an index around 0: both sides of what is linear in the data are proved by these.
fn unit_data() -> impl Iterator<Item = LaurentPolynomial<Q>> {
    (-1..=1).map(|i| LaurentPolynomial::one().shifted(i))
}

#[test]
fn symbol() {
    type Step = fn(&Mask<Q>, &LaurentPolynomial<Q>) -> LaurentPolynomial<Q>;
    let inputs: Vec<_> = schemes()
        .into_iter()
        .flat_map(|mask| unit_data().map(move |data| (mask.clone(), data)))
        .collect();
    let law = |implementation: Step| {
        for_each(&inputs, |(mask, data)| {
            laws::symbol(implementation, mask, data, 3)
        })
    };
    holds(law(Mask::apply));
    rejects("the data are not stretched", law(mutants::not_stretched));
    rejects("indices reversed", law(mutants::index_reversed));
    rejects("one rule for all", law(mutants::even_rule_only));
}

#[test]
fn sum_rules() {
    let law = |implementation: fn(&Mask<Q>) -> usize| {
        for_each(schemes(), |mask| laws::sum_rules(implementation, mask))
    };
    holds(law(Mask::sum_rules));
    rejects("zeros at 1", law(mutants::zeros_at_one));
    rejects("one too few", law(mutants::degree_not_number));
    rejects("sums alone", law(mutants::affine_is_enough));
}

/// For the norms the data matter, for the equation single points are enough.
#[test]
fn difference_scheme() {
    type Scheme = fn(&Mask<Q>) -> Option<Mask<Q>>;
    type Norm = fn(&Mask<Q>, usize) -> Q;
    let zigzag = LaurentPolynomial::new(-2, [1, -1, 1, -1, 1].map(integer));
    let inputs: Vec<_> = schemes()
        .into_iter()
        .flat_map(|mask| {
            let data = unit_data().chain([zigzag.clone()]);
            data.map(move |data| (mask.clone(), data))
        })
        .collect();
    let law = |scheme: Scheme, norm: Norm| {
        for_each(&inputs, |(mask, data)| {
            laws::difference_scheme(scheme, norm, mask, data, 2)
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

/// Degree n is proved to be Cⁿ⁻¹ for n ≤ 12; of the four-point schemes those within reach of six steps.
#[test]
fn smoothness_criterion() {
    type Proof = fn(&Mask<Q>) -> Option<Smoothness<Q>>;
    let four_point = |p, q| Mask::four_point(ratio(p, q)).expect("a finite tension");
    let mut inputs: Vec<(Mask<Q>, Option<usize>)> = (0..=12_usize)
        .map(|degree| (Mask::lane_riesenfeld(degree), degree.checked_sub(1)))
        .collect();
    inputs.extend([
        (four_point(0, 1), Some(0)),
        (four_point(1, 100), Some(1)),
        (four_point(1, 16), Some(1)),
        (four_point(1, 8), Some(1)),
        (four_point(17, 100), Some(1)),
        (four_point(1, 4), Some(0)),
        (four_point(1, 1), None),
    ]);
    let data = LaurentPolynomial::new(-1, [1, -2, 3].map(integer));
    let law = |implementation: Proof| {
        for_each(&inputs, |(mask, order)| {
            laws::smoothness_criterion(implementation, mask, *order, &data)
        })
    };
    holds(law(|mask| mask.smoothness(6)));
    rejects("factors alone", law(mutants::factors_alone));
    rejects("a single step", law(mutants::one_step_only));
    rejects("not divided", law(mutants::not_divided));
}
