//! Tableaux to compute by hand, with fresh numbers for each round.
//!
//! The numbers are small, no two of them that are combined are equal, and no ratio is 1 : 1.
//! So every entry shows whether it was computed as it should be.

use crate::affine::monte_carlo::SplitMix64;
use crate::check::tableau::{Deal, Dealer, Entry, Tableau};
use crate::scalar::{BigRational, Scalar};

/// All tableaux of the chapter.
#[must_use]
pub fn all() -> Vec<Dealer> {
    vec![
        Dealer {
            name: "cubic",
            deal: cubic,
        },
        Dealer {
            name: "cubic-blossom",
            deal: cubic_blossom,
        },
    ]
}

/// The algorithm of de Casteljau for a plane cubic.
///
/// # Examples
///
/// ```
/// use cagd::bezier::tableaux;
///
/// let deal = tableaux::cubic(0);
/// assert_eq!((deal.tableau.size(), deal.tableau.rows()[3][3].dimension()), (4, 2));
/// ```
#[must_use]
pub fn cubic(round: u64) -> Deal {
    let mut random = SplitMix64::new(round);
    let (numerator, denominator) = chosen(&mut random, [(1, 3), (2, 3), (1, 4), (3, 4)]);
    // The coordinates are multiples of the denominator, so that the second column is whole.
    // The first ones increase, hence also in every column: neighbours are never equal.
    let mut x = 0;
    let given = [(); 4].map(|()| {
        let y = chosen(&mut random, [0, 1, 2, 3, 4]);
        let point = Entry::point([(x * denominator, 1), (y * denominator, 1)]);
        x += chosen(&mut random, [1, 2]);
        point
    });
    let t = BigRational::from_ratio(numerator, denominator);
    let task =
        format!("the point at t = {t} of the cubic with the control points in the first column");
    dealt(round, task, Tableau::de_casteljau(given.to_vec(), t))
}

/// A value of the blossom of a cubic polynomial over [0, 1], at three different arguments.
///
/// The first two arguments lie inside, the last one outside.
///
/// # Examples
///
/// ```
/// use cagd::bezier::tableaux;
///
/// let deal = tableaux::cubic_blossom(0);
/// assert_eq!((deal.tableau.size(), deal.tableau.rows()[3][3].dimension()), (4, 1));
/// ```
#[must_use]
pub fn cubic_blossom(round: u64) -> Deal {
    let mut random = SplitMix64::new(round);
    let first = chosen(&mut random, [(1, 3), (2, 3)]);
    let second = chosen(&mut random, [(1, 4), (3, 4)]);
    let third = chosen(&mut random, [(2, 1), (3, 1), (-1, 1), (-2, 1)]);
    // Increasing multiples of 3: the second column is whole, and neighbours are never equal.
    let mut value = chosen(&mut random, [-2, -1, 0, 1, 2]);
    let given = [(); 4].map(|()| {
        let entry = Entry::number(3 * value, 1);
        value += chosen(&mut random, [1, 2, 3]);
        entry
    });
    let arguments = [first, second, third].map(|(n, d)| BigRational::from_ratio(n, d));
    let [t1, t2, t3] = &arguments;
    let task = format!(
        "the value p({t1}, {t2}, {t3}) of the blossom with p(0,0,0), p(0,0,1), p(0,1,1), p(1,1,1) in the first column"
    );
    dealt(round, task, Tableau::blossom(given.to_vec(), &arguments))
}

fn dealt<E: std::fmt::Display>(round: u64, task: String, tableau: Result<Tableau, E>) -> Deal {
    let tableau = tableau.unwrap_or_else(|error| {
        unreachable!("four entries of one dimension, and three arguments: {error}")
    });
    Deal {
        round,
        task,
        tableau,
    }
}

fn chosen<T: Copy, const N: usize>(random: &mut SplitMix64, choices: [T; N]) -> T {
    const { assert!(N > 0, "there must be something to choose from") };
    random.choose(&choices).unwrap_or(choices[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Enough rounds for every combination of ratios to occur.
    const ROUNDS: u64 = 300;

    #[test]
    fn every_round_is_fit_for_computing_by_hand() {
        for dealer in all() {
            for round in 0..ROUNDS {
                let tableau = (dealer.deal)(round).tableau;
                let mut row_above: &[Entry] = &[];
                for row in tableau.rows() {
                    // An entry is made of the one to its left and the one above that.
                    for (upper, lower) in row_above.iter().zip(row) {
                        assert_ne!(upper, lower, "{} {round}", dealer.name);
                    }
                    // Three digits are enough: at most 24 over a denominator of 16 in the first tableau;
                    // in the second at most 33·(2 + 3), extrapolated once, over 4.
                    for number in row.iter().flat_map(Entry::coordinates) {
                        let (numerator, denominator) = (number.numer(), number.denom());
                        assert!(
                            *denominator <= 16.into() && numerator.magnitude() < &1000_u32.into(),
                            "{number}"
                        );
                    }
                    row_above = row;
                }
            }
        }
    }

    #[test]
    fn rounds_differ_and_repeat() {
        for dealer in all() {
            let files = (0..ROUNDS).map(|round| (dealer.deal)(round).answer_file());
            let different: BTreeSet<String> = files.collect();
            assert_eq!(different.len() as u64, ROUNDS);
            assert_eq!((dealer.deal)(5), (dealer.deal)(5));
        }
    }

    #[test]
    fn names_are_unique() {
        let names: BTreeSet<&str> = all().iter().map(|dealer| dealer.name).collect();
        assert_eq!(names.len(), all().len());
    }

    #[test]
    fn the_tip_is_the_point_of_the_curve() {
        use crate::affine::Point;
        use crate::bezier::BezierCurve;

        for round in 0..20 {
            let Deal { task, tableau, .. } = cubic(round);
            let t = task.split(' ').find_map(|word| word.parse().ok());
            let t: BigRational = t.expect("the task says t");
            let points = tableau.rows().iter().map(|row| match row[0].coordinates() {
                [x, y] => Point::new([x.clone(), y.clone()]),
                _ => panic!("not plane"),
            });
            let curve = BezierCurve::new(points.collect::<Vec<_>>()).expect("four points");
            assert_eq!(
                curve.at(t).coordinates(),
                tableau.rows()[3][3].coordinates()
            );
        }
    }

    #[test]
    fn the_tip_is_the_value_of_the_blossom() {
        use crate::bezier::BezierCurve;

        for round in 0..20 {
            let Deal { task, tableau, .. } = cubic_blossom(round);
            let (_, rest) = task.split_once("p(").expect("the task says the arguments");
            let (list, _) = rest.split_once(')').expect("a list");
            let arguments = list.split(", ").map(|t| t.parse().expect("a fraction"));
            let arguments: Vec<BigRational> = arguments.collect();
            let values = tableau
                .rows()
                .iter()
                .map(|row| row[0].coordinates()[0].clone());
            let curve = BezierCurve::new(values.collect::<Vec<_>>()).expect("four values");
            let value = curve.blossom().at(&arguments).expect("three arguments");
            assert_eq!(tableau.rows()[3][3].coordinates(), [value]);
        }
    }
}
