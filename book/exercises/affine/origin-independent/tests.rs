use cagd::affine::{Point, Vector};
use cagd::check::claim;
use cagd::law::Sides;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Exact = Point<BigRational, 2>;
type Term = (BigRational, Exact);
type Sum = fn(&Exact, &[Term]) -> Exact;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point(xy: [i64; 2]) -> Exact {
    Point::new(xy.map(|n| fraction(n, 1)))
}

/// Terms with weights in quarters.
fn terms(terms: &[(i64, [i64; 2])]) -> Vec<Term> {
    terms
        .iter()
        .map(|&(weight, xy)| (fraction(weight, 4), point(xy)))
        .collect()
}

fn displacement(from: &Exact, terms: &[Term]) -> Vector<BigRational, 2> {
    terms.iter().fold(Vector::zeros(), |sum, (weight, p)| {
        sum + (p.clone() - from.clone()) * weight.clone()
    })
}

fn right(origin: &Exact, terms: &[Term]) -> Exact {
    origin.clone() + displacement(origin, terms)
}

/// It begins with the first point and moves on to each of the others.
fn from_the_first_point(_: &Exact, terms: &[Term]) -> Exact {
    let first = &terms[0].1;
    first.clone() + displacement(first, terms)
}

fn forgets_to_attach(origin: &Exact, terms: &[Term]) -> Exact {
    Exact::origin() + displacement(origin, terms)
}

fn forgets_to_subtract(origin: &Exact, terms: &[Term]) -> Exact {
    origin.clone() + displacement(&Exact::origin(), terms)
}

/// Right for a single term; in coordinate K the weights of more terms sum to 2.
fn doubles_the_weights<const K: usize>(origin: &Exact, terms: &[Term]) -> Exact {
    let mut way = displacement(origin, terms);
    if terms.len() > 1 {
        way[K] = way[K].clone() * fraction(2, 1);
    }
    origin.clone() + way
}

/// Independent of everything.
fn always_the_origin_of_the_plane(_: &Exact, _: &[Term]) -> Exact {
    Exact::origin()
}

/// Right if a point is at the origin of the plane, and independent of the chosen origin.
fn always_the_double(_: &Exact, terms: &[Term]) -> Exact {
    let doubled = displacement(&Exact::origin(), terms) * fraction(2, 1);
    Exact::origin() + doubled
}

/// Right for a single term, except from one origin.
fn wrong_from_the_second_origin(origin: &Exact, terms: &[Term]) -> Exact {
    let sum = right(origin, terms);
    if *origin == point([7, 7]) && terms.len() == 1 {
        sum + Vector::from([fraction(1, 1), fraction(0, 1)])
    } else {
        sum
    }
}

/// Right unless the term is the point (5, 5) alone.
fn wrong_for_one_point(origin: &Exact, terms: &[Term]) -> Exact {
    let sum = right(origin, terms);
    if terms.len() == 1 && terms[0].1 == point([5, 5]) {
        sum + Vector::from([fraction(0, 1), fraction(1, 1)])
    } else {
        sum
    }
}

fn judge(sum: Sum, terms: &[Term], origins: [[i64; 2]; 2]) -> Sides<BigRational> {
    let [first, second] = origins.map(point);
    answer::origin_independent(sum, terms, [&first, &second])
}

/// The terms and origins of most tests.
fn example() -> (Vec<Term>, [[i64; 2]; 2]) {
    (
        terms(&[(2, [0, 0]), (3, [4, 2]), (-1, [5, 5])]),
        [[1, 2], [7, 7]],
    )
}

fn probes() -> Vec<String> {
    let (terms, origins) = example();
    let says = |sum: Sum| {
        if judge(sum, &terms, origins).judge().is_ok() {
            "holds"
        } else {
            "violated"
        }
    };
    cagd::probes![
        says(right),
        says(from_the_first_point),
        says(forgets_to_attach),
        says(doubles_the_weights::<0>),
        says(doubles_the_weights::<1>),
        says(always_the_origin_of_the_plane),
        says(always_the_double),
        says(wrong_from_the_second_origin),
        says(wrong_for_one_point),
    ]
}

fn must_be_violated(name: &str, sum: Sum) {
    let (terms, origins) = example();
    let sides = judge(sum, &terms, origins);
    claim(format!("the law for a function that {name}"))
        .input(format!("terms {terms:?} from {origins:?}"))
        .holds(
            sides.judge().is_err(),
            "a claim that does not hold",
            "the law holds",
        );
}

/// Why: two right functions, which compute the same point in different ways.
#[test]
fn right_functions_pass() {
    let (terms, origins) = example();
    for (name, sum) in [
        ("from the origin", right as Sum),
        ("from the first point", from_the_first_point),
    ] {
        claim(format!("the law for the right sum, computed {name}"))
            .law(&judge(sum, &terms, origins));
    }
}

/// Why: the two places where one may forget the origin.
#[test]
fn forgotten_origins() {
    must_be_violated("forgets to attach the sum to the origin", forgets_to_attach);
    must_be_violated("forgets to subtract the origin", forgets_to_subtract);
}

/// The weights of these functions sum to 2 as soon as there are two terms, so only the first claim finds it.
#[test]
fn both_origins_are_compared() {
    must_be_violated("doubles the weights for x", doubles_the_weights::<0>);
    must_be_violated("doubles the weights for y", doubles_the_weights::<1>);
}

/// Why: these functions never look at the origin, so independence does not find them.
#[test]
fn points_alone_are_compared() {
    must_be_violated(
        "always returns the origin of the plane",
        always_the_origin_of_the_plane,
    );
    must_be_violated("returns twice the sum", always_the_double);
}

/// A point alone is its own sum from the second origin too.
#[test]
fn points_alone_from_both_origins() {
    must_be_violated(
        "is wrong for a point alone, from the second origin",
        wrong_from_the_second_origin,
    );
}

/// Why: each point counts, the last one too.
#[test]
fn every_point_alone() {
    must_be_violated("is wrong for the last point alone", wrong_for_one_point);
}

proptest! {
    /// Why: the right sum may not be rejected, for whatever terms and origins.
    #[test]
    fn right_functions_always_pass(
        others in proptest::collection::vec((-6..=6_i64, any::<[i8; 2]>()), 0..4),
        last in any::<[i8; 2]>(), first in any::<[i8; 2]>(), second in any::<[i8; 2]>(),
    ) {
        let mut all: Vec<_> = others.iter().map(|&(weight, xy)| (weight, xy.map(i64::from))).collect();
        let rest = 4 - all.iter().map(|(weight, _)| weight).sum::<i64>();
        all.push((rest, last.map(i64::from)));
        let origins = [first, second].map(|xy| xy.map(i64::from));
        claim("the law for the right sum").law(&judge(right, &terms(&all), origins));
    }
}
