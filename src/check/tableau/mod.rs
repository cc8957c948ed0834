//! Tableaux to fill by hand: triangular tables of fractions or points, in which each entry follows from two others.
//!
//! Row i begins with the given entry number i. Each further entry is made of two entries of the column before: the
//! one in the row above, and the one in the same row, to its left.
//!
//! ```text
//! b₀
//! b₁   b₀¹            b₀¹ from b₀ and b₁
//! b₂   b₁¹   b₀²      b₁¹ from b₁ and b₂,  b₀² from b₀¹ and b₁¹
//! ```
//!
//! The weights may depend on column and row. So the schemes of de Casteljau, of the blossom, of Neville and of de Boor
//! are tableaux.
//!
//! | item | is |
//! |---|---|
//! | [`Tableau`] | given entries and weights, and what follows from them |
//! | [`Tableau::judged`] | what each cell of a reader's text is worth, as data |
//! | [`Tableau::judge`], [`Tableau::judge_column`] | the same as claims, for the tests of an exercise |
//! | [`sheet`] | a tableau to fill on a page |
//! | [`Deal`], [`Dealer`] | a tableau with fresh numbers, and the answer file that asks for it |
//!
//! # Examples
//!
//! ```
//! use cagd::check::tableau::{Entry, Tableau, Verdict};
//! use cagd::scalar::{BigRational, Scalar};
//!
//! let given = [0, 4, 8].map(|n| Entry::number(n, 1));
//! let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4))?;
//! assert_eq!(tableau.blank(), "0\n4  ?\n8  ?  ?\n");
//! assert_eq!(tableau.solved(), "0\n4  1\n8  5  2\n");
//!
//! // A wrong entry, and what follows from it: that is one error, not two.
//! let judgement = tableau.judged("0\n4  1\n8  7  5/2\n")?;
//! let verdicts: Vec<_> = judgement.cells().filter(|cell| cell.place.column > 0).map(|cell| &cell.verdict).collect();
//! assert_eq!(verdicts[0], &Verdict::Right);
//! assert!(matches!(verdicts[1], Verdict::Wrong { follows, .. } if *follows == Entry::number(5, 1)));
//! assert_eq!(verdicts[2], &Verdict::Right);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod deal;
mod entry;
mod judging;
mod reading;
pub mod sheet;

use std::fmt;

use num_traits::One;
use thiserror::Error;

pub use deal::{Deal, Dealer};
pub use entry::Entry;
pub use judging::{Cell, Judgement, Slip, Verdict};
pub use reading::ReadingError;

use crate::scalar::BigRational;

/// A cell, by its row and column, both counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The row, which begins with the given entry of the same number.
    pub row: usize,
    /// The column; column 0 holds the given entries.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "row {}, column {}", self.row, self.column)
    }
}

/// What the two entries count of which an entry is made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Weights {
    /// The weight of the entry in the row above.
    pub upper: BigRational,
    /// The weight of the entry in the same row.
    pub lower: BigRational,
}

impl Weights {
    /// The weights 1 − t and t of the ratio t : (1 − t).
    #[must_use]
    pub fn ratio(t: &BigRational) -> Self {
        Self {
            upper: BigRational::one() - t,
            lower: t.clone(),
        }
    }

    fn exchanged(&self) -> Self {
        Self {
            upper: self.lower.clone(),
            lower: self.upper.clone(),
        }
    }
}

/// Why there is no such tableau.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TableauError {
    /// No entry is given.
    #[error("the tableau has no first column; give at least one entry")]
    Empty,
    /// The given entries are not of one dimension.
    #[error(
        "the given entry number {index} has {found} coordinates and the first one has {expected}; give entries of one dimension"
    )]
    Dimension {
        /// Which entry, counted from 0.
        index: usize,
        /// How many coordinates the first one has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// The number of arguments of a blossom is not the degree.
    #[error(
        "a blossom tableau with {} given entries takes {expected} arguments, not {found}; give one for each column",
        expected + 1
    )]
    ArgumentCount {
        /// The degree.
        expected: usize,
        /// How many arguments are given.
        found: usize,
    },
}

/// A triangular tableau: given entries, weights, and what follows from them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tableau {
    /// The right entries, row by row.
    rows: Vec<Vec<Entry>>,
    /// The weights by which each entry is made; row i has i of them.
    weights: Vec<Vec<Weights>>,
    /// What the entries are called, row by row.
    labels: Vec<Vec<String>>,
}

impl Tableau {
    /// The tableau with this first column, these weights and these names of its entries.
    ///
    /// `weights` is asked for the places in the columns from 1 on, `label` for all.
    ///
    /// # Errors
    ///
    /// [`TableauError::Empty`] without an entry, [`TableauError::Dimension`] if the entries differ in dimension.
    ///
    /// # Examples
    ///
    /// The scheme of Neville for the values 1, 4, 9 at 1, 2, 3: it finds 0² = 0.
    ///
    /// ```
    /// use cagd::check::tableau::{Entry, Tableau, Weights};
    /// use cagd::scalar::{BigRational, Scalar};
    ///
    /// let values = [1, 4, 9].map(|n| Entry::number(n, 1));
    /// let neville = Tableau::new(
    ///     values.to_vec(),
    ///     |place| {
    ///         let [first, last] = [place.row - place.column, place.row].map(|i| i as i64 + 1);
    ///         Weights::ratio(&BigRational::from_ratio(-first, last - first))
    ///     },
    ///     |place| format!("p{},{}", place.row, place.column),
    /// )?;
    /// assert_eq!(neville.solved(), "1\n4  -2\n9  -6  0\n");
    /// # Ok::<(), cagd::check::tableau::TableauError>(())
    /// ```
    pub fn new(
        given: Vec<Entry>,
        weights: impl Fn(Place) -> Weights,
        label: impl Fn(Place) -> String,
    ) -> Result<Self, TableauError> {
        let expected = given.first().ok_or(TableauError::Empty)?.dimension();
        let mut tableau = Self {
            rows: Vec::new(),
            weights: Vec::new(),
            labels: Vec::new(),
        };
        for (row, entry) in given.into_iter().enumerate() {
            if entry.dimension() != expected {
                return Err(TableauError::Dimension {
                    index: row,
                    expected,
                    found: entry.dimension(),
                });
            }
            let places = (0..=row).map(|column| Place { row, column });
            tableau.labels.push(places.clone().map(&label).collect());
            let weights: Vec<Weights> = places.skip(1).map(&weights).collect();
            let mut entries = vec![entry];
            for (column, weights) in weights.iter().enumerate() {
                // A row above the first has as many columns as this one but one.
                let upper = &tableau.rows[row - 1][column];
                entries.push(Entry::combined(weights, upper, &entries[column]));
            }
            tableau.weights.push(weights);
            tableau.rows.push(entries);
        }
        Ok(tableau)
    }

    /// The tableau of de Casteljau at t, with the control points in the first column.
    ///
    /// ```text
    /// bᵢʲ = (1 − t)·bᵢʲ⁻¹ + t·bᵢ₊₁ʲ⁻¹   stands in row i + j and column j
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new).
    pub fn de_casteljau(given: Vec<Entry>, t: BigRational) -> Result<Self, TableauError> {
        let weights = Weights::ratio(&t);
        Self::new(
            given,
            |_| weights.clone(),
            |Place { row, column }| match column {
                0 => format!("b{}", subscript(row)),
                _ => format!("b{}{}", subscript(row - column), superscript(column)),
            },
        )
    }

    /// The tableau that evaluates a blossom p over [0, 1] at n arguments, one for each column.
    ///
    /// The given entries are p(0, …, 0, 1, …, 1), in the order of the control points.
    /// In column j one 0 above and one 1 to the left are replaced by `arguments[j - 1]`.
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new), and [`TableauError::ArgumentCount`] if n + 1 is not the number of given entries.
    ///
    /// # Examples
    ///
    /// p(x, y) = x·y belongs to the square: p(0, 0) = p(0, 1) = 0 and p(1, 1) = 1.
    ///
    /// ```
    /// use cagd::check::tableau::{Entry, Tableau};
    /// use cagd::scalar::{BigRational, Scalar};
    ///
    /// let given = [0, 0, 1].map(|n| Entry::number(n, 1));
    /// let arguments = [3, 5].map(|n| BigRational::from_ratio(n, 1));
    /// let tableau = Tableau::blossom(given.to_vec(), &arguments)?;
    /// assert_eq!(tableau.solved(), "0\n0  0\n1  3  15\n");
    /// # Ok::<(), cagd::check::tableau::TableauError>(())
    /// ```
    pub fn blossom(given: Vec<Entry>, arguments: &[BigRational]) -> Result<Self, TableauError> {
        let degree = given.len().checked_sub(1).ok_or(TableauError::Empty)?;
        if arguments.len() != degree {
            return Err(TableauError::ArgumentCount {
                expected: degree,
                found: arguments.len(),
            });
        }
        Self::new(
            given,
            |place| Weights::ratio(&arguments[place.column - 1]),
            |Place { row, column }| {
                let mut values = vec!["0".to_owned(); degree - row];
                values.extend(arguments[..column].iter().map(ToString::to_string));
                values.resize(degree, "1".to_owned());
                format!("p({})", values.join(", "))
            },
        )
    }

    /// How many rows, and columns, there are.
    #[must_use]
    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// The right entries, row by row; row i has i + 1 of them.
    #[must_use]
    pub fn rows(&self) -> &[Vec<Entry>] {
        &self.rows
    }

    /// What the entry at a place is called: `b₀²`.
    ///
    /// # Panics
    ///
    /// If there is no such place.
    #[must_use]
    pub fn label(&self, place: Place) -> &str {
        &self.labels[place.row][place.column]
    }

    /// The given entries, and a question mark for each of the others, as text that can be read again.
    #[must_use]
    pub fn blank(&self) -> String {
        self.text(|place, entry| match place.column {
            0 => entry.to_string(),
            _ => reading::OPEN.to_owned(),
        })
    }

    /// All entries, as text that can be read again.
    #[must_use]
    pub fn solved(&self) -> String {
        self.text(|_, entry| entry.to_string())
    }

    /// The text with `show` in the cells, the columns aligned.
    fn text(&self, show: impl Fn(Place, &Entry) -> String) -> String {
        let cells: Vec<Vec<String>> = (0..self.size())
            .map(|row| {
                let entries = self.rows[row].iter().enumerate();
                entries
                    .map(|(column, entry)| show(Place { row, column }, entry))
                    .collect()
            })
            .collect();
        let widths: Vec<usize> = (0..self.size())
            .map(|column| {
                let cells = cells[column..]
                    .iter()
                    .map(|row| row[column].chars().count());
                cells.max().unwrap_or(0)
            })
            .collect();
        let mut text = String::new();
        for row in cells {
            let padded = row.iter().zip(&widths);
            let padded: Vec<String> = padded
                .map(|(cell, &width)| format!("{cell:<width$}"))
                .collect();
            text += padded.join("  ").trim_end();
            text.push('\n');
        }
        text
    }
}

/// The number with small raised digits.
fn superscript(n: usize) -> String {
    digits(n, ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'])
}

/// The number with small lowered digits.
fn subscript(n: usize) -> String {
    digits(n, ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'])
}

fn digits(n: usize, signs: [char; 10]) -> String {
    let value = |digit: u8| usize::from(digit - b'0');
    n.to_string()
        .bytes()
        .map(|digit| signs[value(digit)])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    #[test]
    fn points_are_aligned_and_named() {
        let given = [(0, 0), (0, 4), (4, 4), (4, 0)];
        let given = given.map(|(x, y)| Entry::point([(x, 1), (y, 1)]));
        let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 2))
            .expect("four points of the plane");
        assert_eq!(
            tableau.solved(),
            "(0, 0)\n(0, 4)  (0, 2)\n(4, 4)  (2, 4)  (1, 3)\n(4, 0)  (4, 2)  (3, 3)  (2, 3)\n"
        );
        let label = |row, column| tableau.label(Place { row, column });
        assert_eq!(
            [label(2, 0), label(2, 1), label(3, 3)],
            ["b₂", "b₁¹", "b₀³"]
        );
    }

    #[test]
    fn blossom_values_are_named_by_their_arguments() {
        let given = [0, 1, 2, 3].map(|n| Entry::number(n, 1));
        let arguments = [(1, 2), (2, 3), (4, 1)].map(|(n, d)| BigRational::from_ratio(n, d));
        let tableau = Tableau::blossom(given.to_vec(), &arguments).expect("three arguments");
        let label = |row, column| tableau.label(Place { row, column });
        assert_eq!(label(0, 0), "p(0, 0, 0)");
        assert_eq!(label(2, 1), "p(0, 1/2, 1)");
        assert_eq!(label(3, 3), "p(1/2, 2/3, 4)");
        // The identity has the blossom (x + y + z)/3, here thrice that.
        assert_eq!(tableau.rows()[3][3], Entry::number(31, 6));
    }

    #[test]
    fn what_is_no_tableau_is_refused() {
        let half = BigRational::from_ratio(1, 2);
        assert_eq!(
            Tableau::de_casteljau(vec![], half.clone()),
            Err(TableauError::Empty)
        );
        assert_eq!(Tableau::blossom(vec![], &[]), Err(TableauError::Empty));
        let mixed = vec![Entry::number(1, 1), Entry::point([(1, 1), (1, 1)])];
        let error = Tableau::de_casteljau(mixed, half.clone()).expect_err("two dimensions");
        assert!(
            error
                .to_string()
                .contains("entry number 1 has 2 coordinates")
        );
        let error = Tableau::blossom(vec![Entry::number(1, 1); 3], &[half]).expect_err("one short");
        assert!(error.to_string().contains("takes 2 arguments, not 1"));
    }
}
