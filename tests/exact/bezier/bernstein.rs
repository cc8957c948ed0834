//! The Bernstein polynomials, proved for every degree up to 12.

use cagd::affine::Interval;
use cagd::bezier::{
    BernsteinMaximum, bernstein, bernstein_basis, bernstein_maximum, bernstein_on, binomial, laws,
};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, integer, interval, ratio};
use crate::support::mutants::bezier::bernstein as mutants;
use crate::support::{holds, rejects};

type Rational = BigRational;
type Basis = fn(usize, i64, Rational) -> Rational;
type OnInterval = fn(usize, i64, &Interval<Rational>, Rational) -> Rational;
type AllValues = fn(usize, Rational) -> Vec<Rational>;
type Maximum = fn(usize, usize, &Interval<Rational>) -> BernsteinMaximum<Rational>;

/// Every degree with the n + 1 parameters 0 … n, which prove an identity of degree n in t.
fn degrees_and_parameters() -> impl Iterator<Item = (usize, Rational)> {
    (0..=MAX_DEGREE).flat_map(|n| (0..=n as i64).map(move |t| (n, integer(t))))
}

/// As before, with every index from −1 to n + 1.
fn degrees_indices_and_parameters() -> impl Iterator<Item = (usize, i64, Rational)> {
    degrees_and_parameters().flat_map(|(n, t)| (-1..=n as i64 + 1).map(move |i| (n, i, t.clone())))
}

/// An interval away from 0 whose length is not 1, and the unit interval.
fn intervals() -> [Interval<Rational>; 2] {
    [interval(0, 1), interval(2, 5)]
}

fn from_basis(n: usize, i: i64, t: Rational) -> Rational {
    usize::try_from(i)
        .ok()
        .and_then(|i| bernstein_basis(n, t).get(i).cloned())
        .unwrap_or_else(|| integer(0))
}

fn maximum(m: usize, i: usize, interval: &Interval<Rational>) -> BernsteinMaximum<Rational> {
    bernstein_maximum(m, i, interval).expect("degree and index are given so")
}

#[test]
fn binomial_coefficients() {
    let law = |implementation: fn(usize, i64) -> Rational| {
        let rows = (0..=40_usize).flat_map(|n| (-2..=n as i64 + 2).map(move |k| (n, k)));
        for_each(rows, |&(n, k)| {
            laws::binomial_coefficients(implementation, n, k)
        })
    };
    holds(law(binomial));
    rejects("C(n, −k) = C(n, k)", law(mutants::binomial_even));
    rejects("without the division by k!", law(mutants::arrangements));
    rejects("the row of n + 1", law(mutants::binomial_of_next));
}

#[test]
fn bernstein_polynomials() {
    let law = |implementation: OnInterval| {
        let inputs = intervals().into_iter().flat_map(|interval| {
            degrees_indices_and_parameters().map(move |(n, i, u)| (n, i, interval.clone(), u))
        });
        for_each(inputs, |(n, i, interval, u)| {
            laws::bernstein_polynomials(implementation, *n, *i, interval, u.clone())
        })
    };
    holds(law(bernstein_on));
    rejects(
        "the interval is forgotten",
        law(mutants::interval_forgotten),
    );
    rejects("not normalised", law(mutants::not_normalised));
    rejects("measured from b", law(mutants::from_the_end));
}

#[test]
fn bernstein_special_values() {
    let law = |implementation: Basis| {
        for_each(degrees_and_parameters(), |(n, t)| {
            laws::bernstein_special_values(implementation, *n, t.clone())
        })
    };
    holds(law(bernstein));
    holds(law(from_basis));
    rejects("B₀ⁿ = 1", law(mutants::first_is_one));
    rejects("the index is clamped", law(mutants::index_clamped));
    rejects("t and 1 − t swapped", law(mutants::reversed));
}

#[test]
fn bernstein_recursion() {
    let law = |implementation: Basis| {
        for_each(degrees_indices_and_parameters(), |(j, l, t)| {
            laws::bernstein_recursion(implementation, *j, *l, t.clone())
        })
    };
    holds(law(bernstein));
    rejects("no binomial coefficient", law(mutants::no_binomial));
    rejects("the index is clamped", law(mutants::index_clamped));
    rejects("B₀ⁿ = 1", law(mutants::first_is_one));
}

#[test]
fn partition_of_unity() {
    let law = |implementation: AllValues| {
        for_each(degrees_and_parameters(), |(n, t)| {
            laws::partition_of_unity(implementation, *n, t.clone())
        })
    };
    holds(law(bernstein_basis));
    rejects("the last is missing", law(mutants::last_missing));
    rejects(
        "no binomial coefficients",
        law(mutants::all_without_binomial),
    );
}

/// Checked at the n + 1 parameters 0, 1/n, …, 1 and at −1/2 and 3/2.
#[test]
fn nonnegativity() {
    let law = |implementation: Basis| {
        let inputs = (0..=MAX_DEGREE).flat_map(|n| {
            let last = n.max(1) as i64;
            let inside = (0..=last).map(move |k| ratio(k, last));
            inside
                .chain([ratio(-1, 2), ratio(3, 2)])
                .map(move |t| (n, t))
        });
        for_each(inputs, |(n, t)| {
            laws::nonnegativity(implementation, *n, t.clone())
        })
    };
    holds(law(bernstein));
    rejects("signs alternate", law(mutants::alternating));
    rejects("not negative outside [0, 1]", law(mutants::absolute));
}

#[test]
fn bernstein_symmetry() {
    let law = |implementation: OnInterval| {
        let inputs = intervals().into_iter().flat_map(|interval| {
            degrees_indices_and_parameters().map(move |(m, i, h)| (m, i, interval.clone(), h))
        });
        for_each(inputs, |(m, i, interval, h)| {
            laws::bernstein_symmetry(implementation, *m, *i, interval, h.clone())
        })
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

/// Checked at twelfths of the interval; place and value are equations.
#[test]
fn unimodal() {
    let law = |implementation: Maximum| {
        let inputs = intervals().into_iter().flat_map(|interval| {
            (1..=MAX_DEGREE).flat_map(move |m| {
                let interval = interval.clone();
                (0..=m).map(move |i| (m, i, interval.clone()))
            })
        });
        for_each(inputs, |(m, i, interval)| {
            let parameters: Vec<Rational> =
                (0..=12).map(|k| interval.global(ratio(k, 12))).collect();
            laws::unimodal(implementation, *m, *i, interval, &parameters)
        })
    };
    holds(law(maximum));
    rejects("the place as the value", law(mutants::place_as_value));
    rejects("place off by one", law(mutants::place_off_by_one));
    rejects("interval forgotten", law(mutants::place_on_unit_interval));
}
