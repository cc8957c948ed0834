use cagd::bezier::{BezierCurve, Counted, recursive_at};
use cagd::check::claim;

fn probes() -> Vec<String> {
    cagd::probes![
        answer::interpolations(0),
        answer::interpolations(5),
        answer::calls(0),
        answer::calls(5),
    ]
}

fn curve(n: u32) -> BezierCurve<f64> {
    BezierCurve::new((0..=n).map(f64::from)).expect("at least one value")
}

/// The library's algorithm is run and counted.
#[test]
fn interpolations_are_those_that_are_made() {
    for n in 0..=20 {
        let cost = Counted::curve(&curve(n)).at(0.5).cost();
        claim("the number of interpolations")
            .input(format!("n = {n}"))
            .equal(answer::interpolations(n), cost.combinations as u64);
    }
}

/// The recursive program is run and counted.
#[test]
fn calls_are_those_that_are_made() {
    for n in 0..=12 {
        let (_, calls) = recursive_at(&curve(n), 0.5);
        claim("the number of calls")
            .input(format!("n = {n}"))
            .equal(answer::calls(n), calls);
    }
}
