use cagd::bezier::{BezierCurve, Counted, recursive_at};
use cagd::check::claim;

fn probes() -> Vec<String> {
    cagd::probes![
        answer::interpolations(0),
        answer::interpolations(5),
        answer::calls(0),
        answer::calls(5),
        answer::calls(40),
    ]
}

fn curve(n: u32) -> BezierCurve<f64> {
    BezierCurve::new((0..=n).map(f64::from)).expect("at least one value")
}

/// Why: the library's algorithm is run and counted, so a wrong number is seen at the smallest degree.
#[test]
fn interpolations_are_those_that_are_made() {
    for n in 0..=20 {
        let cost = Counted::curve(&curve(n)).at(0.5).cost();
        claim("the number of interpolations")
            .input(format!("n = {n}"))
            .equal(answer::interpolations(n), cost.combinations as u64);
    }
}

/// Why: the recursive program is run and counted, as long as one can wait for it.
#[test]
fn calls_are_those_that_are_made() {
    for n in 0..=12 {
        let (_, calls) = recursive_at(&curve(n), 0.5);
        claim("the number of calls")
            .input(format!("n = {n}"))
            .equal(answer::calls(n), calls);
    }
}

/// Nobody can wait for the recursive program of degree 60, so the number is written out: 2⁶¹ − 1.
#[test]
fn the_largest_degree() {
    claim("the number of interpolations")
        .input("n = 60")
        .equal(answer::interpolations(60), 30 * 61);
    claim("the number of calls")
        .input("n = 60")
        .equal(answer::calls(60), 2_305_843_009_213_693_951);
}
