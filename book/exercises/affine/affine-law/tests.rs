use cagd::check::claim;
use cagd::law::Sides;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Terms = Vec<(BigRational, BigRational)>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

/// The terms with these numerators of the weights and parameters.
fn terms(denominator: i64, terms: &[(i64, i64)]) -> Terms {
    terms
        .iter()
        .map(|&(weight, t)| (fraction(weight, denominator), fraction(t, 1)))
        .collect()
}

fn list(terms: &Terms) -> String {
    let pairs: Vec<String> = terms
        .iter()
        .map(|(weight, t)| format!("({weight}, {t})"))
        .collect();
    pairs.join(", ")
}

fn square(t: &BigRational) -> BigRational {
    t * t
}

/// The identity with one wrong value.
fn wrong_only_at(place: i64) -> impl Fn(&BigRational) -> BigRational {
    move |t| {
        if *t == fraction(place, 1) {
            t + fraction(1, 1)
        } else {
            t.clone()
        }
    }
}

fn says(sides: &Sides<BigRational>) -> &'static str {
    if sides.judge().is_ok() {
        "holds"
    } else {
        "violated"
    }
}

fn probes() -> Vec<String> {
    let law = |f: &dyn Fn(&BigRational) -> BigRational, terms: Terms| {
        says(&answer::keeps_affine_combinations(f, &terms)).to_owned()
    };
    cagd::probes![
        law(&|t| t + fraction(1, 1), terms(2, &[(1, 0), (1, 2)])),
        law(&square, terms(2, &[(1, 0), (1, 2)])),
        law(&wrong_only_at(3), terms(4, &[(1, 0), (3, 4)])),
        law(&square, terms(1, &[(2, 0), (-1, 3)])),
        law(&wrong_only_at(6), terms(3, &[(1, 0), (1, 3), (1, 6)])),
        law(&wrong_only_at(4), terms(4, &[(1, 0), (3, 4)])),
    ]
}

fn must_hold(name: &str, f: impl Fn(&BigRational) -> BigRational, terms: &Terms) {
    claim(format!("the law for the affine map {name}"))
        .input(format!("terms {}", list(terms)))
        .law(&answer::keeps_affine_combinations(f, terms));
}

fn must_be_violated(name: &str, f: impl Fn(&BigRational) -> BigRational, terms: &Terms) {
    let sides = answer::keeps_affine_combinations(f, terms);
    claim(format!("the law for {name}, which is not affine"))
        .input(format!("terms {}", list(terms)))
        .holds(sides.judge().is_err(), "both sides differ", "the law holds");
}

/// Why: a translation is affine, but not linear.
#[test]
fn a_translation_is_affine() {
    let next = |t: &BigRational| t + fraction(1, 1);
    must_hold("f(t) = t + 1", next, &terms(2, &[(1, 0), (1, 2)]));
    must_hold("f(t) = t + 1", next, &terms(1, &[(1, 5)]));
}

/// Why: the midpoint of 0 and 2 is enough to see that the square is not affine.
#[test]
fn the_square_is_not_affine() {
    must_be_violated("f(t) = t²", square, &terms(2, &[(1, 0), (1, 2)]));
}

/// Why: the weights 1/4 and 3/4 of 0 and 4 lead to 3, and only there the function is wrong.
#[test]
fn the_weights_count() {
    let f = wrong_only_at(3);
    must_be_violated("f(t) = t with f(3) = 4", f, &terms(4, &[(1, 0), (3, 4)]));
}

/// Why: a weight may be negative: the absolute value is affine on either side of 0, and the terms look across.
#[test]
fn negative_weights_count() {
    let terms = terms(1, &[(2, 1), (-1, 3)]);
    must_be_violated("f(t) = |t|", cagd::scalar::OrderedScalar::abs, &terms);
}

/// Why: every term counts, the last one too.
#[test]
fn every_term_counts() {
    for wrong in [0, 3, 6, 9] {
        let name = format!("f(t) = t with f({wrong}) = {}", wrong + 1);
        let terms = terms(4, &[(1, 0), (1, 3), (1, 6), (1, 9)]);
        must_be_violated(&name, wrong_only_at(wrong), &terms);
    }
}

/// A list of up to five terms: the last weight makes the sum 1.
fn any_terms() -> impl Strategy<Value = Terms> {
    let others = proptest::collection::vec((-6..=6_i64, -8..=8_i64), 0..5);
    (others, -8..=8_i64).prop_map(|(mut others, last)| {
        let rest = 3 - others.iter().map(|(weight, _)| weight).sum::<i64>();
        others.push((rest, last));
        terms(3, &others)
    })
}

proptest! {
    /// Why: no affine map may be rejected, whatever the terms are.
    #[test]
    fn affine_maps_pass(a in -6..=6_i64, b in -6..=6_i64, terms in any_terms()) {
        let f = |t: &BigRational| t * fraction(a, 2) + fraction(b, 2);
        must_hold(&format!("f(t) = {}·t + {}", fraction(a, 2), fraction(b, 2)), f, &terms);
    }

    /// Why: the square is rejected exactly for the terms that show it.
    #[test]
    fn squares_are_judged(terms in any_terms()) {
        let sum = |power: usize| {
            let values = terms.iter().map(|(weight, t)| weight * num_power(t, power));
            values.fold(fraction(0, 1), |sum, value| sum + value)
        };
        let is_seen = &sum(1) * &sum(1) != sum(2);
        let judged = answer::keeps_affine_combinations(square, &terms);
        claim("the law for f(t) = t²").equal(says(&judged), if is_seen { "violated" } else { "holds" });
    }
}

fn num_power(t: &BigRational, power: usize) -> BigRational {
    (0..power).fold(fraction(1, 1), |product, _| product * t)
}
