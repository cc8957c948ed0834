//! What each cell of a reader's tableau is worth.

use std::fmt;

use super::reading::{self, ReadingError};
use super::{Entry, Place, Tableau, Weights};
use crate::affine::Point;
use crate::check::{Picture, claim};
use crate::scalar::{BigRational, Scalar};

/// What a cell is worth.
///
/// An entry is judged by what follows from the reader's own entries before it. So what follows from a wrong entry
/// is right, and a slip is told once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// A given entry, as it was.
    Given,
    /// A given entry that the reader has changed.
    Changed {
        /// What was given.
        given: Entry,
    },
    /// Nothing stands here yet.
    Open,
    /// It follows from the two entries before it.
    Right,
    /// It does not.
    Wrong {
        /// What follows from the reader's own entries.
        follows: Entry,
        /// How one comes to what stands here, if that is known.
        slip: Option<Slip>,
    },
    /// It cannot be judged: an entry that it is made of is open, and it is not the right one.
    Waiting,
}

/// How one comes to a wrong entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slip {
    /// The two weights are exchanged.
    Exchanged,
    /// It is the mean of the two, whatever the weights are.
    Mean,
    /// It is the entry above, as it is.
    Upper,
    /// It is the entry to the left, as it is.
    Lower,
    /// The weights are those of another column.
    OtherColumn(usize),
}

/// Completes “this comes out if …”.
impl fmt::Display for Slip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exchanged => f.write_str("the two weights are exchanged"),
            Self::Mean => f.write_str("the mean is taken, whatever the weights are"),
            Self::Upper => f.write_str("the upper of the two entries is copied"),
            Self::Lower => f.write_str("the lower of the two entries is copied"),
            Self::OtherColumn(column) => write!(f, "the weights of column {column} are taken"),
        }
    }
}

/// A cell of a reader's tableau.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// Where it is.
    pub place: Place,
    /// What the entry is called.
    pub label: String,
    /// What the reader has written; `None` if it is open.
    pub entry: Option<Entry>,
    /// What it is worth.
    pub verdict: Verdict,
}

/// What every cell of a reader's tableau is worth.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judgement {
    rows: Vec<Vec<Cell>>,
}

impl Judgement {
    /// The cells, row by row.
    #[must_use]
    pub fn rows(&self) -> &[Vec<Cell>] {
        &self.rows
    }

    /// The cells in the order in which they are computed: column by column, each from top to bottom.
    pub fn cells(&self) -> impl Iterator<Item = &Cell> {
        (0..self.rows.len()).flat_map(|column| self.column(column))
    }

    /// The cells of one column, from top to bottom.
    pub fn column(&self, column: usize) -> impl Iterator<Item = &Cell> {
        self.rows.iter().filter_map(move |row| row.get(column))
    }

    /// Whether every cell is filled and follows from those before it.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.cells()
            .all(|cell| matches!(cell.verdict, Verdict::Given | Verdict::Right))
    }

    fn entry(&self, row: usize, column: usize) -> Option<&Entry> {
        self.rows.get(row)?.get(column)?.entry.as_ref()
    }

    /// The cell to tell first: what is wrong comes before what is open, and what is computed first before the rest.
    pub(super) fn first<'c>(cells: &[&'c Cell]) -> Option<&'c Cell> {
        let is_wrong = |cell: &&&Cell| {
            matches!(
                cell.verdict,
                Verdict::Changed { .. } | Verdict::Wrong { .. }
            )
        };
        let is_unfinished =
            |cell: &&&Cell| matches!(cell.verdict, Verdict::Open | Verdict::Waiting);
        let mut all = cells.iter();
        let found = all
            .find(is_wrong)
            .or_else(|| cells.iter().find(is_unfinished));
        found.copied()
    }
}

impl Tableau {
    /// Reads what a reader has filled and judges every cell.
    ///
    /// # Errors
    ///
    /// [`ReadingError`] if the text is no tableau of this size.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::check::tableau::{Entry, Slip, Tableau, Verdict};
    /// use cagd::scalar::{BigRational, Scalar};
    ///
    /// let given = [0, 4].map(|n| Entry::number(n, 1));
    /// let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4))?;
    /// let judgement = tableau.judged("0\n4  3")?;
    /// let cell = &judgement.rows()[1][1];
    /// assert_eq!(cell.verdict, Verdict::Wrong { follows: Entry::number(1, 1), slip: Some(Slip::Exchanged) });
    /// assert!(tableau.judged("0\n4  1")?.is_right());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn judged(&self, text: &str) -> Result<Judgement, ReadingError> {
        Ok(self.judgement(&reading::read(self, text)?))
    }

    /// Judges every cell of what was filled.
    pub(super) fn judgement(&self, filled: &[Vec<Option<Entry>>]) -> Judgement {
        let rows = filled.iter().enumerate().map(|(row, entries)| {
            let cells = entries.iter().enumerate().map(|(column, entry)| {
                let place = Place { row, column };
                Cell {
                    place,
                    label: self.label(place).to_owned(),
                    entry: entry.clone(),
                    verdict: self.verdict(filled, place),
                }
            });
            cells.collect()
        });
        Judgement {
            rows: rows.collect(),
        }
    }

    fn verdict(&self, filled: &[Vec<Option<Entry>>], place: Place) -> Verdict {
        let Place { row, column } = place;
        let right = &self.rows[row][column];
        let entry = match &filled[row][column] {
            entry if column == 0 => {
                return if entry.as_ref() == Some(right) {
                    Verdict::Given
                } else {
                    let given = right.clone();
                    Verdict::Changed { given }
                };
            }
            None => return Verdict::Open,
            Some(entry) => entry,
        };
        let before = (&filled[row - 1][column - 1], &filled[row][column - 1]);
        let (Some(upper), Some(lower)) = before else {
            return if entry == right {
                Verdict::Right
            } else {
                Verdict::Waiting
            };
        };
        let follows = Entry::combined(self.weights_at(place), upper, lower);
        if *entry == follows {
            Verdict::Right
        } else {
            let slip = self.slip(place, entry, upper, lower);
            Verdict::Wrong { follows, slip }
        }
    }

    /// The weights by which an entry right of the first column is made.
    fn weights_at(&self, place: Place) -> &Weights {
        &self.weights[place.row][place.column - 1]
    }

    fn slip(&self, place: Place, entry: &Entry, upper: &Entry, lower: &Entry) -> Option<Slip> {
        let ratio = |n, d| Weights::ratio(&BigRational::from_ratio(n, d));
        let weights = [
            (Slip::Exchanged, self.weights_at(place).exchanged()),
            (Slip::Upper, ratio(0, 1)),
            (Slip::Lower, ratio(1, 1)),
        ];
        // In a short row the weights of a later column are taken from the first row that has some.
        let others = (1..self.size()).map(|column| {
            let row = place.row.max(column);
            let weights = self.weights_at(Place { row, column });
            (Slip::OtherColumn(column), weights.clone())
        });
        let mut candidates = weights
            .into_iter()
            .chain(others)
            .chain([(Slip::Mean, ratio(1, 2))]);
        let found =
            candidates.find(|(_, weights)| Entry::combined(weights, upper, lower) == *entry);
        found.map(|(slip, _)| slip)
    }

    /// Claims that the text is this tableau, completely filled.
    ///
    /// The first wrong entry is told, in the order of computing, with what follows from the reader's own entries;
    /// if none is wrong, the first that is open.
    ///
    /// # Panics
    ///
    /// If it is not, like every [`claim`](fn@claim).
    #[track_caller]
    pub fn judge(&self, text: &str) {
        let judgement = self.readable(text);
        self.tell(&judgement, &judgement.cells().collect::<Vec<_>>());
    }

    /// Claims that one column of the text is filled with what follows from the column before it.
    ///
    /// Column 0 must hold what was given.
    ///
    /// # Panics
    ///
    /// If it is not so, like every [`claim`](fn@claim).
    #[track_caller]
    pub fn judge_column(&self, text: &str, column: usize) {
        let judgement = self.readable(text);
        self.tell(&judgement, &judgement.column(column).collect::<Vec<_>>());
    }

    /// What each cell is worth, in a word, column by column: by this a misconception is recognised.
    ///
    /// It does not depend on the numbers that were dealt.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::check::tableau::{Entry, Tableau};
    /// use cagd::scalar::{BigRational, Scalar};
    ///
    /// let given = [0, 4].map(|n| Entry::number(n, 1));
    /// let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4))?;
    /// assert_eq!(tableau.trace("0\n4  3"), ["Given", "Given", "Exchanged"]);
    /// # Ok::<(), cagd::check::tableau::TableauError>(())
    /// ```
    #[must_use]
    pub fn trace(&self, text: &str) -> Vec<String> {
        let Ok(judgement) = self.judged(text) else {
            return vec!["unreadable".to_owned()];
        };
        let word = |cell: &Cell| match &cell.verdict {
            Verdict::Changed { .. } => "Changed".to_owned(),
            Verdict::Wrong {
                slip: Some(slip), ..
            } => format!("{slip:?}"),
            Verdict::Wrong { slip: None, .. } => "Wrong".to_owned(),
            verdict => format!("{verdict:?}"),
        };
        judgement.cells().map(word).collect()
    }

    #[track_caller]
    fn readable(&self, text: &str) -> Judgement {
        match self.judged(text) {
            Ok(judgement) => judgement,
            Err(error) => {
                claim("the tableau can be read").input(text.trim()).holds(
                    false,
                    format!("{} rows; row i has i + 1 entries", self.size()),
                    error,
                );
                unreachable!("a claim that does not hold panics")
            }
        }
    }

    /// Claims that nothing is to be told of these cells.
    #[track_caller]
    fn tell(&self, judgement: &Judgement, cells: &[&Cell]) {
        let Some(cell) = Judgement::first(cells) else {
            return;
        };
        let place = cell.place;
        let found = match &cell.entry {
            Some(entry) => entry.to_string(),
            None => format!("{}, still open", reading::OPEN),
        };
        let what = format!("{} ({place})", cell.label);
        let (expected, found) = match &cell.verdict {
            Verdict::Changed { given } => (format!("{given}, as given"), found),
            Verdict::Wrong { follows, slip } => {
                let expected = format!("{} = {follows}", self.sum(judgement, place));
                let found = match slip {
                    Some(slip) => format!("{found}; this comes out if {slip}"),
                    None => found,
                };
                (expected, found)
            }
            _ => (self.sum(judgement, place), found),
        };
        let made_of = self.made_of(judgement, place);
        let mut told = claim(what).input(made_of);
        if matches!(cell.verdict, Verdict::Wrong { .. }) && self.is_plane() {
            told = told.picture(|| self.picture(judgement, place.column));
        }
        told.holds(false, expected, found);
    }

    /// What is wrong with an entry: `b₀¹ = 3/4·4 + 1/4·8 = 5; 6 comes out if the two weights are exchanged`.
    pub(super) fn correction(&self, judgement: &Judgement, cell: &Cell) -> String {
        let Verdict::Wrong { follows, slip } = &cell.verdict else {
            return String::new();
        };
        let entry = cell.entry.as_ref().map(ToString::to_string);
        let found = match (entry, slip) {
            (Some(entry), Some(slip)) => format!("; {entry} comes out if {slip}"),
            (Some(entry), None) => format!(", not {entry}"),
            (None, _) => String::new(),
        };
        let sum = self.sum(judgement, cell.place);
        format!("{} = {sum} = {follows}{found}", cell.label)
    }

    /// `b₀¹ = 1, b₁¹ = 5`
    fn made_of(&self, judgement: &Judgement, place: Place) -> String {
        let [upper, lower] = match before(place) {
            Some(places) => places,
            None => return "the given entries".to_owned(),
        };
        let named = |place: Place| {
            let entry = judgement.entry(place.row, place.column);
            let entry = entry.map_or_else(|| reading::OPEN.to_owned(), ToString::to_string);
            format!("{} = {entry}", self.label(place))
        };
        format!("{}, {}", named(upper), named(lower))
    }

    /// `3/4·b₀¹ + 1/4·b₁¹`
    fn sum(&self, judgement: &Judgement, place: Place) -> String {
        let Some([upper, lower]) = before(place) else {
            return "the given entry".to_owned();
        };
        let weights = self.weights_at(place);
        let factor = |weight: &BigRational| {
            if weight < &BigRational::from_ratio(0, 1) {
                format!("({weight})")
            } else {
                weight.to_string()
            }
        };
        let term = |weight: &BigRational, place: Place| {
            let name = self.label(place);
            let entry = judgement.entry(place.row, place.column);
            let entry = entry.map_or_else(|| name.to_owned(), ToString::to_string);
            format!("{}·{entry}", factor(weight))
        };
        format!(
            "{} + {}",
            term(&weights.upper, upper),
            term(&weights.lower, lower)
        )
    }

    fn is_plane(&self) -> bool {
        self.rows[0][0].dimension() == 2
    }

    /// The given polygon, the reader's column, and what should stand there.
    fn picture(&self, judgement: &Judgement, column: usize) -> Picture {
        let point = |entry: &Entry| match entry.coordinates() {
            [x, y] => Some(Point::new([x.clone(), y.clone()])),
            _ => None,
        };
        let given = self.rows.iter().filter_map(|row| point(&row[0]));
        let expected = judgement
            .column(column)
            .filter_map(|cell| match &cell.verdict {
                Verdict::Wrong { follows, .. } => point(follows),
                _ => cell.entry.as_ref().and_then(point),
            });
        let found = judgement
            .column(column)
            .filter_map(|cell| cell.entry.as_ref().and_then(point));
        Picture::new().given(given).expected(expected).found(found)
    }
}

/// The two places that an entry is made of, the upper one first; `None` for a given one.
fn before(Place { row, column }: Place) -> Option<[Place; 2]> {
    let column = column.checked_sub(1)?;
    let upper = Place {
        row: row.checked_sub(1)?,
        column,
    };
    Some([upper, Place { row, column }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    fn tableau() -> Tableau {
        let given = [0, 4, 8, 16].map(|n| Entry::number(n, 1));
        Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4)).expect("numbers")
    }

    const RIGHT: &str = "0\n4 1\n8 5 2\n16 10 25/4 49/16";

    fn verdict(text: &str, row: usize, column: usize) -> Verdict {
        let judgement = tableau().judged(text).expect(text);
        judgement.rows()[row][column].verdict.clone()
    }

    /// The words of the panic.
    fn words(judge: impl FnOnce(&Tableau) + std::panic::UnwindSafe) -> Option<String> {
        let payload = catch_unwind(|| judge(&tableau())).err()?;
        payload.downcast_ref::<String>().cloned()
    }

    #[test]
    fn the_right_tableau_is_right() {
        assert!(tableau().judged(RIGHT).expect("readable").is_right());
        assert_eq!(
            tableau().judged(&tableau().solved()),
            tableau().judged(RIGHT)
        );
        assert_eq!(words(|tableau| tableau.judge(RIGHT)), None);
        for column in 0..4 {
            assert_eq!(
                words(move |tableau| tableau.judge_column(RIGHT, column)),
                None
            );
        }
    }

    #[test]
    fn an_error_is_told_once_and_what_follows_from_it_is_right() {
        let text = "0\n4 1\n8 6 9/4\n16 10 7 55/16";
        let judgement = tableau().judged(text).expect("readable");
        let wrong: Vec<Place> = judgement
            .cells()
            .filter(|cell| !matches!(cell.verdict, Verdict::Given | Verdict::Right))
            .map(|cell| cell.place)
            .collect();
        assert_eq!(wrong, [Place { row: 2, column: 1 }]);
        let told = words(move |tableau| tableau.judge(text)).expect("it is wrong");
        let expected = "tested: b₁¹ (row 2, column 1)\ninput: b₁ = 4, b₂ = 8\nexpected: 3/4·4 + 1/4·8 = 5\nfound: 6; this comes out if the mean is taken, whatever the weights are";
        assert_eq!(told, expected);
        for (column, is_told) in [(0, false), (1, true), (2, false), (3, false)] {
            let told = words(move |tableau| tableau.judge_column(text, column));
            assert_eq!(told.is_some(), is_told, "column {column}");
        }
    }

    #[test]
    fn the_first_wrong_entry_is_the_one_that_is_computed_first() {
        // Row 2 holds a wrong entry in column 2, row 3 one in column 1.
        let text = "0\n4 1\n8 5 3\n16 11 25/4 ?";
        let told = words(move |tableau| tableau.judge(text)).expect("it is wrong");
        assert!(told.starts_with("tested: b₂¹ (row 3, column 1)"), "{told}");
    }

    #[test]
    fn what_is_open_is_told_after_what_is_wrong() {
        let text = "0\n4 ?\n8 5 ?\n16 10 25/4 ?";
        let told = words(move |tableau| tableau.judge(text)).expect("it is open");
        let expected = "tested: b₀¹ (row 1, column 1)\ninput: b₀ = 0, b₁ = 4\nexpected: 3/4·0 + 1/4·4\nfound: ?, still open";
        assert_eq!(told, expected);
        let text = "0\n4 ?\n8 5 ?\n16 10 7 ?";
        let told = words(move |tableau| tableau.judge(text)).expect("one is wrong");
        assert!(told.starts_with("tested: b₁² (row 3, column 2)"), "{told}");
    }

    #[test]
    fn without_the_entries_before_it_only_the_right_one_can_be_judged() {
        assert_eq!(verdict("0\n4 ?\n8 5 2\n16 ? ? ?", 2, 2), Verdict::Right);
        assert_eq!(verdict("0\n4 ?\n8 5 3\n16 ? ? ?", 2, 2), Verdict::Waiting);
        let told = words(|tableau| tableau.judge_column("0\n4 ?\n8 5 3\n16 10 25/4 ?", 2));
        let told = told.expect("it is not judged");
        assert!(
            told.contains("input: b₀¹ = ?, b₁¹ = 5\nexpected: 3/4·b₀¹ + 1/4·5\nfound: 3"),
            "{told}"
        );
    }

    #[test]
    fn a_given_entry_that_was_changed_is_told_and_counted_on() {
        let text = "0\n8 2\n8 8 7/2\n16 10 17/2 19/4";
        let given = Entry::number(4, 1);
        assert_eq!(verdict(text, 1, 0), Verdict::Changed { given });
        assert_eq!(
            verdict(text, 1, 1),
            Verdict::Right,
            "of the reader's own entries"
        );
        let told = words(move |tableau| tableau.judge(text)).expect("it was changed");
        assert!(told.ends_with("expected: 4, as given\nfound: 8"), "{told}");
        assert_eq!(words(move |tableau| tableau.judge_column(text, 1)), None);
        assert!(matches!(
            verdict("0\n? ?\n8 ? ?\n16 ? ? ?", 1, 0),
            Verdict::Changed { .. }
        ));
    }

    #[test]
    fn known_slips_are_recognised() {
        let slip = |entry: &str| match verdict(&format!("0\n4 {entry}\n8 ? ?\n16 ? ? ?"), 1, 1) {
            Verdict::Wrong { slip, .. } => slip,
            other => panic!("{entry}: {other:?}"),
        };
        assert_eq!(slip("3"), Some(Slip::Exchanged));
        assert_eq!(slip("2"), Some(Slip::Mean));
        assert_eq!(slip("0"), Some(Slip::Upper));
        assert_eq!(slip("4"), Some(Slip::Lower));
        assert_eq!(slip("17"), None);

        let given = [0, 0, 12].map(|n| Entry::number(n, 1));
        let arguments = [(1, 3), (1, 4)].map(|(n, d)| BigRational::from_ratio(n, d));
        let blossom = Tableau::blossom(given.to_vec(), &arguments).expect("two arguments");
        let judgement = blossom.judged("0\n0 0\n12 3 1").expect("readable");
        let verdicts: Vec<&Verdict> = judgement.cells().map(|cell| &cell.verdict).collect();
        let follows = Entry::number(4, 1);
        let slip = Some(Slip::OtherColumn(2));
        assert_eq!(verdicts[4], &Verdict::Wrong { follows, slip });
        let slip = Some(Slip::OtherColumn(1));
        let follows = Entry::number(3, 4);
        assert_eq!(verdicts[5], &Verdict::Wrong { follows, slip });
    }

    #[test]
    fn what_cannot_be_read_is_told_by_every_claim() {
        let told = words(|tableau| tableau.judge_column("0\n4 x\n8 ? ?\n16 ? ? ?", 3));
        let told = told.expect("it is unreadable");
        assert!(
            told.contains("found: `x` in row 1, column 1 cannot be read"),
            "{told}"
        );
        assert_eq!(tableau().trace("0"), ["unreadable"]);
    }

    #[test]
    fn a_wrong_point_of_the_plane_is_drawn() {
        let given = [(0, 0), (4, 8)].map(|(x, y)| Entry::point([(x, 1), (y, 1)]));
        let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(1, 4));
        let tableau = tableau.expect("points");
        let judgement = tableau.judged("(0, 0)\n(4, 8) (1, 6)").expect("readable");
        let picture = tableau.picture(&judgement, 1);
        let points: Vec<_> = picture.strokes.into_iter().map(|s| s.points).collect();
        assert_eq!(
            points,
            [
                vec![[0.0, 0.0], [4.0, 8.0]],
                vec![[1.0, 2.0]],
                vec![[1.0, 6.0]]
            ]
        );
    }
}
