use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::laws;
use proptest::prelude::*;

fn whole(numbers: &[i64]) -> Vec<BigRational> {
    numbers
        .iter()
        .map(|&n| BigRational::from_ratio(n, 1))
        .collect()
}

/// `n` numbers, of which only one is not 0.
fn one(n: usize, at: usize, value: i64) -> Vec<BigRational> {
    whole(
        &(0..n)
            .map(|j| if j == at { value } else { 0 })
            .collect::<Vec<_>>(),
    )
}

fn probes() -> Vec<String> {
    let zero = |n: usize| one(n, 0, 0);
    cagd::probes![
        answer::virtual_point(&one(3, 0, 45), &zero(3)),
        answer::virtual_point(&zero(3), &one(3, 0, 135)),
        answer::virtual_point(&one(5, 2, 45), &zero(5)),
        answer::virtual_point(&zero(5), &one(5, 2, 225)),
        answer::virtual_point(&zero(5), &one(5, 3, 225)),
    ]
}

fn compare(neighbours: &[BigRational], opposite: &[BigRational], expected: i64) {
    let list = |numbers: &[BigRational]| {
        let shown: Vec<String> = numbers.iter().map(ToString::to_string).collect();
        shown.join(", ")
    };
    claim("the virtual point v₀")
        .input(format!("l = {}; q = {}", list(neighbours), list(opposite)))
        .equal(
            answer::virtual_point(neighbours, opposite),
            BigRational::from_ratio(expected, 1),
        );
}

/// Why: on a grid it is the vertex straight beyond.
#[test]
fn four_neighbours() {
    compare(&whole(&[1, 5, -1, -5]), &whole(&[6, 4, -6, -4]), -1);
    compare(&whole(&[3, 1, 4, 1]), &whole(&[5, 9, 2, 6]), 4);
}

/// Why: the weights must sum to 1.
#[test]
fn equal_points() {
    for n in 3..9 {
        compare(&whole(&vec![7; n]), &whole(&vec![7; n]), 7);
    }
}

/// Why: three neighbours without the opposite points: 4/3 of the sum minus the sum.
#[test]
fn three_neighbours() {
    compare(&whole(&[3, 6, 12]), &whole(&[0, 0, 0]), 7);
}

/// Why: one weight of an opposite point at a time.
#[test]
fn one_opposite_point() {
    // 1/9 − 4/45 near l₀, and −4/45 for q₂, which is not near.
    for (at, expected) in [(0, 1), (1, 1), (2, -4), (3, 1), (4, 1)] {
        compare(&one(5, 0, 0), &one(5, at, 45), expected);
    }
}

proptest! {
    /// Why: this is what the virtual point is for.
    #[test]
    fn both_ways_agree(
        n in 3_usize..9,
        neighbours in prop::array::uniform8(any::<i8>()),
        opposite in prop::array::uniform8(any::<i8>()),
    ) {
        let list = |numbers: [i8; 8]| whole(&numbers[..n].iter().map(|&x| x.into()).collect::<Vec<_>>());
        let sides = laws::kobbelt(
            |l: &[BigRational], q: &[BigRational]| answer::virtual_point(l, q),
            &list(neighbours),
            &list(opposite),
        );
        claim("the parts of the face point in which the two ways differ").law(&sides);
    }
}
