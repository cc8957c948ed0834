use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Numbers = [BigRational; 4];

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn numbers(n: [i64; 4]) -> Numbers {
    n.map(|n| fraction(n, 1))
}

/// The three functions of the answer, by name.
fn blossoms() -> [(&'static str, fn(&Numbers) -> BigRational); 3] {
    [
        ("the blossom of X", answer::blossom_of_x),
        ("the blossom of X²", answer::blossom_of_x2),
        ("the blossom of X⁴", answer::blossom_of_x4),
    ]
}

fn probes() -> Vec<String> {
    let x = numbers([1, 2, 3, 5]);
    cagd::probes![
        answer::blossom_of_x(&x),
        answer::blossom_of_x2(&x),
        answer::blossom_of_x4(&x),
    ]
}

fn list(x: &Numbers) -> String {
    x.each_ref().map(ToString::to_string).join(", ")
}

/// Why: the sums 11, 41 and the product 30 can be computed by hand.
#[test]
fn by_hand() {
    let x = numbers([1, 2, 3, 5]);
    let right = [fraction(11, 4), fraction(41, 6), fraction(30, 1)];
    for ((name, blossom), right) in blossoms().into_iter().zip(right) {
        claim(name).input(list(&x)).equal(blossom(&x), right);
    }
}

proptest! {
    /// Why: the first of the three properties.
    #[test]
    fn on_the_diagonal(t in -20..=20_i64) {
        let t = fraction(t, 2);
        let square = t.clone() * t.clone();
        let powers = [t.clone(), square.clone(), square.clone() * square];
        for ((name, blossom), power) in blossoms().into_iter().zip(powers) {
            let x = [t.clone(), t.clone(), t.clone(), t.clone()];
            claim(format!("{name} on the diagonal")).input(list(&x)).equal(blossom(&x), power);
        }
    }

    /// Why: the second property, for any two arguments.
    #[test]
    fn symmetric(x in prop::array::uniform4(-9..=9_i64), i in 0..4_usize, k in 0..4_usize) {
        let mut swapped = x;
        swapped.swap(i, k);
        let (x, swapped) = (numbers(x), numbers(swapped));
        for (name, blossom) in blossoms() {
            claim(format!("{name} with two arguments swapped"))
                .input(format!("{} and {}", list(&x), list(&swapped)))
                .equal(blossom(&swapped), blossom(&x));
        }
    }

    /// Why: the third property, for every argument.
    #[test]
    fn affine_in_each_argument(
        x in prop::array::uniform4(-9..=9_i64),
        place in 0..4_usize,
        v in -9..=9_i64,
        lambda in -3..=7_i64,
    ) {
        let with = |number: BigRational| {
            let mut arguments = numbers(x);
            arguments[place] = number;
            arguments
        };
        let (u, v, lambda) = (fraction(x[place], 1), fraction(v, 1), fraction(lambda, 4));
        let rest = fraction(1, 1) - lambda.clone();
        let between = with(u.clone() * rest.clone() + v.clone() * lambda.clone());
        for (name, blossom) in blossoms() {
            let right = blossom(&with(u.clone())) * rest.clone() + blossom(&with(v.clone())) * lambda.clone();
            claim(format!("{name} between {u} and {v}, in argument {}", place + 1))
                .input(list(&between))
                .equal(blossom(&between), right);
        }
    }
}
