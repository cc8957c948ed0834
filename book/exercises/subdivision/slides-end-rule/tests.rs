use cagd::affine::Interval;
use cagd::bezier::BezierCurve;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};

fn number(n: i64) -> BigRational {
    BigRational::from_ratio(n, 1)
}

fn probes() -> Vec<String> {
    cagd::probes![answer::counterexample()]
}

/// The answer, if it is of the form that is asked for.
fn read() -> Vec<BigRational> {
    let values = answer::counterexample();
    claim("the form of the answer")
        .input(format!("{values:?}"))
        .holds(
            (3..=8).contains(&values.len()) && values.iter().all(|v| (-100..=100).contains(v)),
            "3 to 8 numbers from -100 to 100",
            format!("{values:?}"),
        );
    values.into_iter().map(number).collect()
}

/// The cuts at 1/4 and 3/4 of each leg.
fn chaikin(values: &[BigRational]) -> Vec<BigRational> {
    let cut = |leg: &[BigRational], quarters: i64| {
        let t = BigRational::from_ratio(quarters, 4);
        leg[0].clone() + (leg[1].clone() - leg[0].clone()) * t
    };
    values
        .windows(2)
        .flat_map(|leg| [cut(leg, 1), cut(leg, 3)])
        .collect()
}

/// The control values after a knot has been inserted into the middle of each interval of the domain.
///
/// Each is a value of the blossom of a segment, at neighbouring new knots.
fn inserted(values: &[BigRational]) -> Vec<BigRational> {
    let m = values.len() as i64 - 1;
    // Twice the knots: 2, 4, 5, 6, 7, …, 2m + 2, 2m + 4.
    let knots: Vec<i64> = std::iter::once(2)
        .chain(4..=2 * m + 2)
        .chain([2 * m + 4])
        .collect();
    knots
        .windows(2)
        .map(|pair| {
            // The segment over [k, k + 1] has the Bézier points: middle of a leg, vertex, middle of a leg.
            let k = (pair[0] / 2).clamp(2, m) as usize;
            let half = BigRational::from_ratio(1, 2);
            let middle = |i: usize| (values[i].clone() + values[i + 1].clone()) * half.clone();
            let bezier_points = [middle(k - 2), values[k - 1].clone(), middle(k - 1)];
            let domain = Interval::new(number(k as i64), number(k as i64 + 1)).expect("two ends");
            let segment = BezierCurve::on(domain, bezier_points).expect("three points");
            let arguments = [pair[0], pair[1]].map(|twice| BigRational::from_ratio(twice, 2));
            segment.blossom().at(&arguments).expect("two arguments")
        })
        .collect()
}

#[test]
fn the_first_value_differs() {
    let values = read();
    let (left, right) = (inserted(&values), chaikin(&values));
    claim("the first new control value")
        .input(format!("p = {values:?}"))
        .holds(
            left[0] != right[0],
            "another one than Chaikin's",
            format!("{} in both polygons", left[0]),
        );
}

#[test]
fn the_others_agree() {
    let values = read();
    let (left, right) = (inserted(&values), chaikin(&values));
    claim("the other new control values")
        .input(format!("p = {values:?}"))
        .equal(left[1..].to_vec(), right[1..].to_vec());
}
