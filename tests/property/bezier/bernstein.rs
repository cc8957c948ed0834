//! Properties of the Bernstein polynomials.

use cagd::affine::Interval;
use cagd::bezier::{
    BernsteinMaximum, bernstein, bernstein_basis, bernstein_maximum, bernstein_on, laws,
};
use proptest::prelude::*;

use crate::generators::{domain, for_all, for_all_of, inner_parameter, local_parameter};
use crate::support::mutants::bezier::bernstein as mutants;
use crate::support::{holds, rejects};

type Basis = fn(usize, i64, f64) -> f64;
type OnInterval = fn(usize, i64, &Interval<f64>, f64) -> f64;
type AllValues = fn(usize, f64) -> Vec<f64>;
type Maximum = fn(usize, usize, &Interval<f64>) -> BernsteinMaximum<f64>;

/// Degrees from 0 on, mostly low.
fn degree() -> impl Strategy<Value = usize> {
    prop_oneof![4 => 0_usize..=6, 2 => 7_usize..=30]
}

/// A degree and an index in and around 0 … n.
fn degree_and_index() -> impl Strategy<Value = (usize, i64)> {
    degree().prop_flat_map(|n| (Just(n), -1..=n as i64 + 1))
}

/// A degree so high that C(n, i) is infinite, with any index, and a parameter in [0, 1].
fn high_degree() -> impl Strategy<Value = (usize, i64, f64)> {
    (1500_usize..3000)
        .prop_flat_map(|n| (Just(n), 0..=n as i64, 0.0..=1.0))
        // Half of the indices close to n·t, where the polynomial is largest.
        .prop_flat_map(|(n, i, t)| {
            let middle = (n as f64 * t) as i64;
            (Just(n), prop_oneof![Just(i), Just(middle)], Just(t))
        })
}

/// The implementation that takes all values from the recursion.
fn from_basis(n: usize, i: i64, t: f64) -> f64 {
    usize::try_from(i)
        .ok()
        .and_then(|i| bernstein_basis(n, t).get(i).copied())
        .unwrap_or(0.0)
}

fn one_by_one(n: usize, t: f64) -> Vec<f64> {
    (0..=n).map(|i| bernstein(n, i as i64, t)).collect()
}

fn maximum(m: usize, i: usize, interval: &Interval<f64>) -> BernsteinMaximum<f64> {
    bernstein_maximum(m, i, interval).expect("degree and index are given so")
}

#[test]
fn bernstein_recursion() {
    let law = |implementation: Basis| {
        for_all((degree_and_index(), local_parameter()), |&((j, l), t)| {
            laws::bernstein_recursion(implementation, j, l, t)
        })
    };
    holds(law(bernstein));
    holds(law(from_basis));
    rejects("no binomial coefficient", law(mutants::no_binomial));
    rejects("the index is clamped", law(mutants::index_clamped));
    rejects("B₀ⁿ = 1", law(mutants::first_is_one));

    let law = |implementation: Basis| {
        for_all_of(60, high_degree(), |&(j, l, t)| {
            laws::bernstein_recursion(implementation, j, l, t)
        })
    };
    holds(law(bernstein));
    rejects("C(n, i) overflows", law(mutants::coefficient_first));
}

#[test]
fn partition_of_unity() {
    let law = |implementation: AllValues| {
        for_all((degree(), local_parameter()), |&(n, t)| {
            laws::partition_of_unity(implementation, n, t)
        })
    };
    holds(law(bernstein_basis));
    holds(law(one_by_one));
    rejects("the last is missing", law(mutants::last_missing));
    rejects(
        "no binomial coefficients",
        law(mutants::all_without_binomial),
    );
}

#[test]
fn nonnegativity() {
    let law = |implementation: Basis| {
        for_all((degree(), local_parameter()), |&(n, t)| {
            laws::nonnegativity(implementation, n, t)
        })
    };
    holds(law(bernstein));
    holds(law(from_basis));
    rejects("signs alternate", law(mutants::alternating));
    rejects("not negative outside [0, 1]", law(mutants::absolute));
}

#[test]
fn bernstein_symmetry() {
    let law = |implementation: OnInterval| {
        for_all(
            (degree_and_index(), domain(), local_parameter()),
            |&((m, i), interval, t)| {
                laws::bernstein_symmetry(implementation, m, i, &interval, interval.length() * t)
            },
        )
    };
    holds(law(bernstein_on));
    rejects(
        "the interval is forgotten",
        law(mutants::interval_forgotten),
    );
    rejects("not normalised", law(mutants::not_normalised));
    rejects(
        "the binomial coefficient of the next degree",
        law(|m, i, interval, u| mutants::wrong_binomial(m, i, interval.local(u))),
    );
}

/// A degree of at least 1, an index, an interval and parameters.
fn unimodal_inputs() -> impl Strategy<Value = ((usize, usize), Interval<f64>, Vec<f64>)> {
    (
        (1_usize..=20).prop_flat_map(|m| (Just(m), 0..=m)),
        domain(),
        prop::collection::vec(inner_parameter(), 0..12),
    )
}

#[test]
fn unimodal() {
    let law = |implementation: Maximum| {
        for_all(unimodal_inputs(), |((m, i), interval, locals)| {
            let parameters: Vec<f64> = locals.iter().map(|&t| interval.global(t)).collect();
            laws::unimodal(implementation, *m, *i, interval, &parameters)
        })
    };
    holds(law(maximum));
    rejects("the place as the value", law(mutants::place_as_value));
    rejects("place off by one", law(mutants::place_off_by_one));
    rejects("interval forgotten", law(mutants::place_on_unit_interval));
}

#[test]
fn bernstein_properties() {
    let law = |implementation: AllValues| {
        for_all((degree(), local_parameter()), |&(n, t)| {
            laws::bernstein_properties(implementation, n, t)
        })
    };
    holds(law(bernstein_basis));
    holds(law(one_by_one));
    rejects("in reverse order", law(mutants::all_reversed));
    rejects("forced to a sum of 1", law(mutants::normalised));
    rejects(
        "no binomial coefficients",
        law(mutants::all_without_binomial),
    );
    rejects("the last is missing", law(mutants::last_missing));
}
