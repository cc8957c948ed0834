use cagd::bezier::{bernstein, bernstein_basis, binomial};
use cagd::check::claim;
use cagd::scalar::{BigRational, OrderedScalar, Scalar};

type Basis = fn(usize, BigRational) -> Vec<BigRational>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn power(x: &BigRational, k: usize) -> BigRational {
    (0..k).fold(fraction(1, 1), |product, _| product * x)
}

/// All that the law is tried on: degrees up to 5, and for each more parameters than a polynomial needs.
fn inputs() -> impl Iterator<Item = (usize, BigRational)> {
    let parameters = [
        (-2, 1),
        (-1, 3),
        (0, 1),
        (1, 4),
        (1, 2),
        (2, 3),
        (1, 1),
        (5, 2),
    ];
    (0..=5).flat_map(move |n| parameters.map(|(p, q)| (n, fraction(p, q))))
}

fn probes() -> Vec<String> {
    let judged = |basis: Basis, n, t| answer::law(basis, n, t).judge().is_ok();
    cagd::probes![
        judged(bernstein_basis, 3, fraction(1, 3)),
        judged(bernstein_basis, 3, fraction(5, 2)),
        judged(lagrange, 3, fraction(1, 3)),
        judged(one_more, 3, fraction(1, 3)),
        judged(no_binomials, 3, fraction(1, 3)),
        judged(squared_bumps, 3, fraction(1, 3)),
        judged(last_missing, 3, fraction(1, 3)),
        judged(absolute_values, 2, fraction(5, 2)),
        judged(no_degree_0, 0, fraction(1, 3)),
        judged(one_fewer, 3, fraction(1, 3)),
        judged(second_missing, 3, fraction(1, 3)),
    ]
}

/// Claims that the law holds for a right implementation.
fn accepts(name: &str, basis: Basis) {
    for (n, t) in inputs() {
        claim(format!("the law holds for {name}"))
            .input(format!("n = {n}, t = {t}"))
            .law(&answer::law(basis, n, t.clone()));
    }
}

/// Claims that some input makes a wrong implementation violate the law.
fn refuses(name: &str, basis: Basis) {
    let is_violated = inputs().any(|(n, t)| answer::law(basis, n, t).judge().is_err());
    claim(format!("the law is violated by {name}"))
        .input("n ≤ 5, t between -2 and 5/2")
        .holds(is_violated, "a violation", "the law holds for every input");
}

/// The Lagrange polynomials of the nodes 0, 1, …, n, which sum to one as well.
fn lagrange(n: usize, t: BigRational) -> Vec<BigRational> {
    let factor = |i: usize, j: usize| {
        let (i, j) = (i as i64, j as i64);
        (t.clone() - fraction(j, 1)) / fraction(i - j, 1)
    };
    let one = |i: usize| {
        let others = (0..=n).filter(|&j| j != i);
        others.fold(fraction(1, 1), |product, j| product * factor(i, j))
    };
    (0..=n).map(one).collect()
}

fn one_more(n: usize, t: BigRational) -> Vec<BigRational> {
    (0..=n + 1)
        .map(|i| bernstein(n, i as i64, t.clone()))
        .collect()
}

fn one_fewer(n: usize, t: BigRational) -> Vec<BigRational> {
    bernstein_basis(n.saturating_sub(1), t)
}

/// Right on [0, 1].
fn absolute_values(n: usize, t: BigRational) -> Vec<BigRational> {
    let values = bernstein_basis(n, t);
    values.iter().map(OrderedScalar::abs).collect()
}

/// Right for every degree but 0.
fn no_degree_0(n: usize, t: BigRational) -> Vec<BigRational> {
    match n {
        0 => vec![fraction(0, 1)],
        _ => bernstein_basis(n, t),
    }
}

fn last_missing(n: usize, t: BigRational) -> Vec<BigRational> {
    let mut values = bernstein_basis(n, t);
    values[n] = fraction(0, 1);
    values
}

/// Right at both ends for n ≥ 2, and not symmetric.
fn second_missing(n: usize, t: BigRational) -> Vec<BigRational> {
    let mut values = bernstein_basis(n, t);
    if let Some(second) = values.get_mut(1) {
        *second = fraction(0, 1);
    }
    values
}

/// Right at both ends.
fn no_binomials(n: usize, t: BigRational) -> Vec<BigRational> {
    let s = fraction(1, 1) - &t;
    (0..=n).map(|i| power(&t, i) * power(&s, n - i)).collect()
}

/// Right at both ends, and symmetric.
fn squared_bumps(n: usize, t: BigRational) -> Vec<BigRational> {
    let s = fraction(1, 1) - &t;
    let term = |i: usize| {
        let count = binomial::<BigRational>(n, i as i64);
        count.clone() * count * power(&t, i) * power(&s, n - i)
    };
    (0..=n).map(term).collect()
}

/// Why: the law must hold for what the theorem is about.
#[test]
fn it_holds_for_the_bernstein_polynomials() {
    accepts("the Bernstein polynomials", bernstein_basis);
}

/// Why: the law must not claim more than the theorem.
#[test]
fn it_holds_for_the_lagrange_polynomials() {
    accepts("the Lagrange polynomials of the nodes 0, 1, …, n", lagrange);
}

#[test]
fn it_counts_the_values() {
    refuses("a list with one more value, 0", one_more);
    refuses("the values of one degree less", one_fewer);
}

#[test]
fn it_looks_outside_of_the_interval() {
    refuses(
        "the absolute values of Bernstein polynomials",
        absolute_values,
    );
}

#[test]
fn it_looks_at_degree_0() {
    refuses("Bernstein polynomials with B₀⁰ = 0", no_degree_0);
}

/// Why: the first wrong implementation that one thinks of.
#[test]
fn it_misses_the_last_value() {
    refuses("Bernstein polynomials with the last one 0", last_missing);
}

/// Why: what is right at both ends, and symmetric, need not be right between them.
#[test]
fn it_notices_wrong_factors() {
    refuses(
        "the products tⁱ(1 − t)ⁿ⁻ⁱ without binomial coefficients",
        no_binomials,
    );
    refuses(
        "Bernstein polynomials with squared binomial coefficients",
        squared_bumps,
    );
}
