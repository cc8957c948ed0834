use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{CosineOfTurn, doo_sabin_weights};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn cosine(numerator: usize, k: usize) -> BigRational {
    BigRational::cosine_of_turn(numerator as i64, k).expect("rational for 3, 4 and 6")
}

fn cosines(k: usize) -> Vec<BigRational> {
    (0..k).map(|j| cosine(j, k)).collect()
}

fn eigenvalue(row: &[BigRational], frequency: usize) -> BigRational {
    answer::eigenvalue(row, &cosines(row.len()), frequency)
}

fn probes() -> Vec<String> {
    let row = [7, 1, 3, 2, 3, 1].map(|n| fraction(n, 1));
    cagd::probes![
        eigenvalue(&row, 0),
        eigenvalue(&row, 1),
        eigenvalue(&row, 2),
        eigenvalue(&row, 3),
        answer::loop_row::<BigRational>(3),
        answer::loop_row::<BigRational>(5),
    ]
}

fn compare(row: &[BigRational], frequency: usize, expected: BigRational) {
    let names: Vec<String> = row.iter().map(ToString::to_string).collect();
    claim("the eigenvalue")
        .input(format!("row {}, frequency {frequency}", names.join(", ")))
        .equal(eigenvalue(row, frequency), expected);
}

/// Why: equal points are multiplied by the sum of the row.
#[test]
fn frequency_zero() {
    compare(&[3, 1, 0, 1].map(|n| fraction(n, 8)), 0, fraction(5, 8));
}

/// Why: the alternating points 1, −1, 1, −1 can be checked by hand.
#[test]
fn alternating_points() {
    compare(&[3, 1, 0, 1].map(|n| fraction(n, 8)), 2, fraction(1, 8));
    compare(&[5, 1, 2, 1].map(|n| fraction(n, 9)), 2, fraction(5, 9));
}

/// Why: a face of Doo and Sabin has the eigenvalues 1, 1/2, 1/2 and else 1/4.
#[test]
fn doo_sabin() {
    for k in [3, 4, 6] {
        let row = doo_sabin_weights::<BigRational>(k).expect("rational for 3, 4 and 6");
        for frequency in 0..k {
            let expected = match frequency {
                0 => fraction(1, 1),
                f if f == 1 || f == k - 1 => fraction(1, 2),
                _ => fraction(1, 4),
            };
            compare(&row, frequency, expected);
        }
    }
}

#[test]
fn row_of_loop() {
    for (k, expected) in [
        (3, vec![3, 1, 1]),
        (4, vec![3, 1, 0, 1]),
        (7, vec![3, 1, 0, 0, 0, 0, 1]),
    ] {
        let expected: Vec<BigRational> = expected.into_iter().map(|n| fraction(n, 8)).collect();
        claim("the row of Loop's scheme")
            .input(format!("k = {k}"))
            .equal(answer::loop_row::<BigRational>(k), expected);
    }
}

proptest! {
    /// Why: it is what an eigenvalue is: the points are multiplied by it.
    #[test]
    fn the_ring_is_multiplied(
        k in prop::sample::select(vec![3_usize, 4, 6]),
        halves in prop::array::uniform4(any::<i8>()),
        frequency in 0_usize..6,
    ) {
        let frequency = frequency % k;
        let row: Vec<BigRational> =
            (0..k).map(|j| fraction(halves[j.min(k - j)].into(), 1)).collect();
        let ring: Vec<BigRational> = (0..k).map(|i| cosine(frequency * i, k)).collect();
        let refined: Vec<BigRational> = (0..k)
            .map(|i| {
                (0..k).fold(fraction(0, 1), |sum, j| {
                    sum + row[j].clone() * ring[(i + j) % k].clone()
                })
            })
            .collect();
        let lambda = eigenvalue(&row, frequency);
        let multiplied: Vec<BigRational> = ring.iter().map(|w| w.clone() * lambda.clone()).collect();
        claim("λ times the points cos(2πfi/k) are the points after the step").equal(multiplied, refined);
    }
}
