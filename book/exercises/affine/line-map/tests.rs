use cagd::affine::Point;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn whole(numbers: [i64; 2]) -> [BigRational; 2] {
    numbers.map(|n| fraction(n, 1))
}

fn probes() -> Vec<String> {
    let map = |t, y| answer::line_map(&whole(t), &whole(y));
    cagd::probes![
        map([0, 2], [3, 7]),
        map([1, 4], [5, 3]),
        map([2, 2], [5, 5]),
        map([2, 2], [1, 5]),
        map([1, 3], [5, 5]),
        map([3, 1], [2, 9]),
    ]
}

/// The claim that the map is f(t) = at + b.
fn compare(t: [i64; 2], y: [BigRational; 2], expected: Option<[BigRational; 2]>) {
    let t = whole(t);
    let graph = |t: BigRational, y: BigRational| Point::new([t, y]);
    let input = format!("f({}) = {} and f({}) = {}", t[0], y[0], t[1], y[1]);
    let found = answer::line_map(&t, &y);
    claim("slope and offset [a, b]")
        .input(input)
        .picture(|| {
            let given = [0, 1].map(|k| graph(t[k].clone(), y[k].clone()));
            let picture = Picture::new().given(given.clone());
            let picture = if expected.is_some() {
                picture.expected(given)
            } else {
                picture
            };
            match &found {
                Some([a, b]) => picture.found(t.clone().map(|t| graph(t.clone(), a * &t + b))),
                None => picture,
            }
        })
        .equal(found.clone(), expected.clone());
}

/// Why: the first value is b itself, and the growth can be counted on the fingers.
#[test]
fn from_zero() {
    compare([0, 2], whole([3, 7]), Some(whole([2, 3])));
}

/// Why: the slider of the task, both ways; neither parameter is 0.
#[test]
fn a_slider() {
    let twentieth = fraction(1, 20);
    let up = [twentieth.clone(), fraction(-3, 2)];
    compare([30, 50], whole([0, 1]), Some(up));
    compare([50, 30], whole([0, 1]), Some([-twentieth, fraction(5, 2)]));
}

/// Why: a constant function is affine.
#[test]
fn equal_values() {
    compare([1, 3], whole([5, 5]), Some(whole([0, 5])));
}

/// Why: one parameter determines no map, even if both values agree.
#[test]
fn equal_parameters() {
    compare([2, 2], whole([1, 5]), None);
    compare([2, 2], whole([5, 5]), None);
    compare([0, 0], whole([0, 0]), None);
}

proptest! {
    /// Why: any map is found again from two of its values.
    #[test]
    fn a_planted_map(a in -12..=12_i64, b in any::<i8>(), t in any::<[i8; 2]>()) {
        prop_assume!(t[0] != t[1]);
        let (a, b) = (fraction(a, 4), fraction(b.into(), 3));
        let t = t.map(i64::from);
        let values = t.map(|t| &a * fraction(t, 1) + &b);
        compare(t, values, Some([a, b]));
    }
}
