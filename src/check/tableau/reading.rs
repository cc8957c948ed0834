//! Reads the text that a reader has filled.

use thiserror::Error;

use super::entry::NoEntry;
use super::{Entry, Place, Tableau};

/// What stands in a cell that is still open.
pub(super) const OPEN: &str = "?";

/// Why a text is no filled tableau.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReadingError {
    /// There are too few or too many rows.
    #[error("there are {found} rows instead of {expected}; write each row on a line of its own")]
    RowCount {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A row has too few or too many entries.
    #[error(
        "row {row} has {found} entries instead of {expected}; separate entries by spaces, write no spaces inside a fraction, and `?` for what is still open (rows and columns count from 0)"
    )]
    EntryCount {
        /// The row.
        row: usize,
        /// How many entries it should have.
        expected: usize,
        /// How many it has.
        found: usize,
    },
    /// An entry cannot be read.
    #[error(
        "`{text}` in {place} cannot be read; write a fraction as `3/4` or `-2`, a point as `(1/2, 3)`, and `?` for what is still open (rows and columns count from 0)"
    )]
    Unreadable {
        /// Where it stands.
        place: Place,
        /// What stands there.
        text: String,
    },
    /// A denominator is 0.
    #[error(
        "`{text}` in {place} divides by zero; correct the denominator (rows and columns count from 0)"
    )]
    DivisionByZero {
        /// Where it stands.
        place: Place,
        /// What stands there.
        text: String,
    },
    /// A number stands for a point, or a point for a number.
    #[error(
        "`{text}` in {place} has {found} coordinates instead of {expected} (rows and columns count from 0)"
    )]
    Dimension {
        /// Where it stands.
        place: Place,
        /// What stands there.
        text: String,
        /// How many coordinates the given entries have.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
}

impl ReadingError {
    /// The cell that cannot be read; none if it is about a whole row or table.
    #[must_use]
    pub fn place(&self) -> Option<Place> {
        match self {
            Self::RowCount { .. } | Self::EntryCount { .. } => None,
            Self::Unreadable { place, .. }
            | Self::DivisionByZero { place, .. }
            | Self::Dimension { place, .. } => Some(*place),
        }
    }

    /// The same in few words, where the reader sees which cell it is about.
    pub(super) fn short(&self) -> String {
        match self {
            Self::Unreadable { text, .. } => {
                format!("`{text}` cannot be read; write 3/4, -2 or, for a point, (1/2, 3)")
            }
            Self::DivisionByZero { text, .. } => format!("`{text}` divides by zero"),
            Self::Dimension {
                text, expected: 1, ..
            } => {
                format!("`{text}` is a point; a number belongs here")
            }
            Self::Dimension { text, expected, .. } => {
                format!("`{text}` does not have {expected} coordinates")
            }
            Self::RowCount { .. } | Self::EntryCount { .. } => self.to_string(),
        }
    }
}

/// The cells of a text, row by row; `None` is an open one.
pub(super) fn read(tableau: &Tableau, text: &str) -> Result<Vec<Vec<Option<Entry>>>, ReadingError> {
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    if lines.len() != tableau.size() {
        return Err(ReadingError::RowCount {
            expected: tableau.size(),
            found: lines.len(),
        });
    }
    let rows = lines.into_iter().enumerate();
    rows.map(|(row, line)| read_row(tableau, row, line))
        .collect()
}

fn read_row(tableau: &Tableau, row: usize, line: &str) -> Result<Vec<Option<Entry>>, ReadingError> {
    let words = words(line);
    let entries = words.iter().enumerate().map(|(column, text)| {
        if text == OPEN {
            return Ok(None);
        }
        read_entry(tableau, Place { row, column }, text).map(Some)
    });
    // What cannot be read is told before a count that may be its consequence.
    let entries: Vec<Option<Entry>> = entries.collect::<Result<_, _>>()?;
    if entries.len() != row + 1 {
        return Err(ReadingError::EntryCount {
            row,
            expected: row + 1,
            found: entries.len(),
        });
    }
    Ok(entries)
}

/// One entry.
pub(super) fn read_entry(
    tableau: &Tableau,
    place: Place,
    text: &str,
) -> Result<Entry, ReadingError> {
    let text = text.to_owned();
    let entry = match Entry::parse(&text) {
        Ok(entry) => entry,
        Err(NoEntry::NoFraction) => return Err(ReadingError::Unreadable { place, text }),
        Err(NoEntry::DivisionByZero) => return Err(ReadingError::DivisionByZero { place, text }),
    };
    let expected = tableau.rows[0][0].dimension();
    if entry.dimension() != expected {
        return Err(ReadingError::Dimension {
            place,
            expected,
            found: entry.dimension(),
            text,
        });
    }
    Ok(entry)
}

/// The parts between spaces; those inside brackets separate nothing.
pub(super) fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut is_inside = false;
    for letter in line.chars() {
        match letter {
            '(' => is_inside = true,
            ')' => is_inside = false,
            _ => {}
        }
        if letter.is_whitespace() && !is_inside {
            words.extend((!word.is_empty()).then(|| std::mem::take(&mut word)));
        } else {
            word.push(letter);
        }
    }
    words.extend((!word.is_empty()).then_some(word));
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{BigRational, Scalar};

    fn numbers() -> Tableau {
        let given = [0, 4, 8].map(|n| Entry::number(n, 1));
        Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4)).expect("numbers")
    }

    #[test]
    fn what_is_written_is_read_again() {
        let tableau = numbers();
        let solved = read(&tableau, &tableau.solved()).expect("it is readable");
        let right: Vec<Vec<_>> = tableau
            .rows()
            .iter()
            .map(|row| row.iter().cloned().map(Some).collect())
            .collect();
        assert_eq!(solved, right);
        let blank = read(&tableau, "\n  0\n\n4 ?\r\n8\t?   ?\n").expect("spaces and blank lines");
        assert_eq!(blank, read(&tableau, &tableau.blank()).expect("blank"));
        assert_eq!(blank[2], [Some(Entry::number(8, 1)), None, None]);
    }

    #[test]
    fn points_have_spaces_inside() {
        assert_eq!(words("(1/2, 3)  ? ( 0 ,1 )"), ["(1/2, 3)", "?", "( 0 ,1 )"]);
        assert_eq!(words("(1, 2 ?"), ["(1, 2 ?"]);
    }

    #[test]
    fn each_mistake_says_where_it_is() {
        let error = |text: &str| read(&numbers(), text).expect_err(text);
        assert_eq!(
            error("0\n4 1\n"),
            ReadingError::RowCount {
                expected: 3,
                found: 2
            }
        );
        for (row, found) in [("8 ?", 2), ("8 ? ? ?", 4)] {
            let expected = ReadingError::EntryCount {
                row: 2,
                expected: 3,
                found,
            };
            assert_eq!(error(&format!("0\n4 1\n{row}")), expected);
        }
        let place = Place { row: 2, column: 1 };
        assert_eq!(
            error("0\n4 1\n8 1/0 ?"),
            ReadingError::DivisionByZero {
                place,
                text: "1/0".into()
            }
        );
        assert_eq!(
            error("0\n4 1\n8 0.5 ?"),
            ReadingError::Unreadable {
                place,
                text: "0.5".into()
            }
        );
        let dimension = error("0\n4 1\n8 (1, 2) ?");
        let words = "`(1, 2)` in row 2, column 1 has 2 coordinates instead of 1";
        assert!(dimension.to_string().starts_with(words), "{dimension}");
    }
}
