//! A tableau to fill on a page: a table of fields, and what each of them is worth.
//!
//! [`described`] tells it in the words that [`tableaux::answer`](crate::tableaux::answer) hands to the page, and the
//! fields go into the reader's file and come from there ([`Deal::with_fields`], [`Deal::fields`]).

use std::fmt::Write;

use super::judging::Judgement;
use super::reading::{self, OPEN, ReadingError};
use super::{Cell, Deal, Entry, Place, Tableau, Verdict};

/// The fields of a table, row by row; row i has i + 1 of them, and an open one is empty.
pub type Fields = Vec<Vec<String>>;

/// The facts about a table with these fields; what is missing is open.
///
/// | line | fields |
/// |---|---|
/// | `task` | what is to be computed |
/// | `round` | the round that dealt the numbers |
/// | `cell` | row, column, what the entry is called, `given`, `open`, `right`, `wrong`, `waiting` or `unreadable`, its text, what is to be told about it |
/// | `say` | `right`, `wrong` or `open`, and how it stands in a sentence |
///
/// # Examples
///
/// ```
/// use cagd::check::tableau::sheet;
///
/// let deal = cagd::bezier::tableaux::cubic(0);
/// let facts = sheet::described(&deal, &vec![vec![], vec![String::new(), "(6, 12)".to_owned()]]);
/// assert!(facts.contains("cell\t1\t1\tb₀¹\tright\t(6, 12)\t\n"), "{facts}");
/// ```
#[must_use]
pub fn described(deal: &Deal, fields: &Fields) -> String {
    let tableau = &deal.tableau;
    let mut facts = String::new();
    let mut fact = |name: &str, parts: &[&str]| {
        facts.push_str(name);
        for part in parts {
            // Tabs and line ends part the fields and the facts.
            let _ = write!(facts, "\t{}", part.replace(['\t', '\n', '\r'], " "));
        }
        facts.push('\n');
    };
    fact("task", &[&deal.task]);
    fact("round", &[&deal.round.to_string()]);
    let (filled, unreadable) = tableau.filled(fields);
    let judgement = tableau.judgement(&filled);
    let all: Vec<&Cell> = judgement.cells().collect();
    let first_wrong = Judgement::first(&all).filter(|cell| is_wrong(cell));
    for cell in judgement.rows().iter().flatten() {
        let Place { row, column } = cell.place;
        let place = cell.place;
        let error = unreadable.iter().find(|error| error.place() == Some(place));
        let words = match error {
            Some(error) => error.short(),
            None if first_wrong == Some(cell) => tableau.correction(&judgement, cell),
            None if is_wrong(cell) => "does not follow from the two before it".to_owned(),
            None if cell.verdict == Verdict::Waiting => {
                "cannot be judged before the two before it are there".to_owned()
            }
            None => String::new(),
        };
        let state = match &cell.verdict {
            _ if error.is_some() => "unreadable",
            Verdict::Given | Verdict::Changed { .. } => "given",
            Verdict::Open => "open",
            Verdict::Right => "right",
            Verdict::Wrong { .. } => "wrong",
            Verdict::Waiting => "waiting",
        };
        let text = match (column, field(fields, place)) {
            (0, _) => tableau.rows()[row][0].to_string(),
            (_, text) => text.to_owned(),
        };
        let (row, column) = (row.to_string(), column.to_string());
        fact("cell", &[&row, &column, &cell.label, state, &text, &words]);
    }
    let open = all
        .iter()
        .filter(|cell| matches!(cell.verdict, Verdict::Open | Verdict::Waiting))
        .count();
    let (state, words) = if let Some(error) = unreadable.first() {
        ("wrong", error.short())
    } else if let Some(cell) = first_wrong {
        ("wrong", tableau.correction(&judgement, cell))
    } else if open > 0 {
        let entries = if open == 1 { "entry is" } else { "entries are" };
        ("open", format!("{open} {entries} still open."))
    } else {
        let words = "Right: every entry follows from the two before it.";
        ("right", words.to_owned())
    };
    fact("say", &[state, &words]);
    facts
}

fn is_wrong(cell: &Cell) -> bool {
    matches!(cell.verdict, Verdict::Wrong { .. })
}

/// The text of a field; empty where there is none.
fn field(fields: &Fields, place: Place) -> &str {
    let row = fields.get(place.row);
    let text = row.and_then(|row| row.get(place.column));
    match text.map_or("", |text| text.trim()) {
        OPEN => "",
        text => text,
    }
}

impl Tableau {
    /// The entries in these fields; those that cannot be read are open, and the errors say why.
    fn filled(&self, fields: &Fields) -> (Vec<Vec<Option<Entry>>>, Vec<ReadingError>) {
        let mut errors = Vec::new();
        let mut entry = |place: Place| {
            if place.column == 0 {
                return Some(self.rows()[place.row][0].clone());
            }
            let text = field(fields, place);
            if text.is_empty() {
                return None;
            }
            reading::read_entry(self, place, text)
                .map_err(|error| errors.push(error))
                .ok()
        };
        let filled = (0..self.size())
            .map(|row| {
                let places = (0..=row).map(|column| Place { row, column });
                places.map(&mut entry).collect()
            })
            .collect();
        (filled, errors)
    }
}

impl Deal {
    /// The fields that an answer file holds; `None` if it is no answer file with the numbers of this deal.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::tableaux;
    ///
    /// let deal = tableaux::cubic(4);
    /// let fields = deal.fields(&deal.answer_file()).expect("it is its own file");
    /// assert_eq!((fields.len(), fields[1][1].as_str()), (4, ""));
    /// assert!(deal.fields(&tableaux::cubic(5).answer_file()).is_none());
    /// ```
    #[must_use]
    pub fn fields(&self, file: &str) -> Option<Fields> {
        let (_, table, _) = parts(file)?;
        let is_own = round(file) == Some(self.round) && !table.contains('\\');
        let lines = table.lines().filter(|line| !line.trim().is_empty());
        let fields: Fields = lines
            .map(|line| {
                let words = reading::words(line).into_iter();
                words
                    .map(|word| if word == OPEN { String::new() } else { word })
                    .collect()
            })
            .collect();
        let has_shape = fields.len() == self.tableau.size()
            && fields.iter().enumerate().all(|(row, cells)| {
                let place = Place { row, column: 0 };
                cells.len() == row + 1
                    && reading::read_entry(&self.tableau, place, &cells[0]).as_ref()
                        == Ok(&self.tableau.rows()[row][0])
            });
        (is_own && has_shape).then_some(fields)
    }

    /// The answer file with these fields in the place of those it has.
    ///
    /// # Errors
    ///
    /// A field that cannot be read: it would not find its place in the file. `None` if the file is not one of this
    /// deal.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::tableaux;
    ///
    /// let deal = tableaux::cubic(0);
    /// let file = deal.answer_file();
    /// let mut fields = deal.fields(&file).expect("it is its own file");
    /// fields[1][1] = "(6,12)".to_owned();
    /// let filled = deal.with_fields(&file, &fields)?.expect("it is its own file");
    /// assert!(filled.contains("(8, 16)  (6, 12)\n"), "{filled}");
    /// fields[1][1] = "six".to_owned();
    /// assert!(deal.with_fields(&file, &fields).is_err());
    /// # Ok::<(), cagd::check::tableau::ReadingError>(())
    /// ```
    pub fn with_fields(&self, file: &str, fields: &Fields) -> Result<Option<String>, ReadingError> {
        let (_, errors) = self.tableau.filled(fields);
        if let Some(error) = errors.into_iter().next() {
            return Err(error);
        }
        let (Some((before, _, after)), Some(_)) = (parts(file), self.fields(file)) else {
            return Ok(None);
        };
        let table = self.tableau.text(|place, given| match place.column {
            0 => given.to_string(),
            _ => match field(fields, place) {
                "" => OPEN.to_owned(),
                text => in_one_word(text),
            },
        });
        Ok(Some(format!("{before}\n{table}{after}")))
    }
}

/// An entry as it was written, without the spaces that would part it in a file.
fn in_one_word(text: &str) -> String {
    let letters = text.chars().filter(|letter| !letter.is_whitespace());
    letters.collect::<String>().replace(',', ", ")
}

/// The round that an answer file names.
fn round(file: &str) -> Option<u64> {
    let (_, rest) = file.split_once("pub const ROUND: u64 = ")?;
    rest.split_once(';')?.0.trim().parse().ok()
}

/// The round of the answer file of a tableau; `None` if the text is no such file.
///
/// ```
/// use cagd::check::tableau::sheet;
///
/// assert_eq!(sheet::round_of(&cagd::bezier::tableaux::cubic(7).answer_file()), Some(7));
/// assert_eq!(sheet::round_of("pub fn f() {}"), None);
/// ```
#[must_use]
pub fn round_of(file: &str) -> Option<u64> {
    parts(file).and_then(|_| round(file))
}

/// What stands before the table of an answer file, the table, and what stands behind it.
fn parts(file: &str) -> Option<(&str, &str, &str)> {
    const OPENING: &str = "pub const TABLEAU: &str = \"";
    let start = file.find(OPENING)? + OPENING.len();
    let end = start + file[start..].find('"')?;
    Some((&file[..start], &file[start..end], &file[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{BigRational, Scalar};

    /// A cubic with the numbers of an exercise; another round has another first point.
    fn cubic(round: u64) -> Deal {
        let x = i64::try_from(round).expect("a small number");
        let given =
            [(x, 0), (8, 16), (12, 8), (16, 16)].map(|(x, y)| Entry::point([(x, 1), (y, 1)]));
        let tableau = Tableau::de_casteljau(given.to_vec(), BigRational::from_ratio(3, 4));
        Deal {
            round,
            task: "the point at t = 3/4".to_owned(),
            tableau: tableau.expect("four points"),
        }
    }

    fn filled(changes: &[(usize, usize, &str)]) -> (Deal, Fields) {
        let deal = cubic(0);
        let mut fields = deal.fields(&deal.answer_file()).expect("its own file");
        for &(row, column, text) in changes {
            fields[row][column] = text.to_owned();
        }
        (deal, fields)
    }

    /// The state and the words of a cell.
    fn cell(answer: &str, row: usize, column: usize) -> (String, String) {
        let head = format!("cell\t{row}\t{column}\t");
        let line = answer.lines().find_map(|line| line.strip_prefix(&head));
        let parts: Vec<&str> = line.expect("the cell is there").split('\t').collect();
        (parts[1].to_owned(), parts[3].to_owned())
    }

    #[test]
    fn the_first_wrong_entry_is_corrected_and_the_others_are_only_marked() {
        let (deal, fields) = filled(&[(1, 1, "(6, 12)"), (2, 1, "(1, 1)"), (2, 2, "(0, 0)")]);
        let told = described(&deal, &fields);
        assert_eq!(cell(&told, 1, 1).0, "right");
        let (state, words) = cell(&told, 2, 1);
        assert_eq!(state, "wrong");
        let right = &deal.tableau.rows()[2][1].to_string();
        assert!(words.contains(right), "{words}");
        let (state, words) = cell(&told, 2, 2);
        assert_eq!(state, "wrong");
        assert!(!words.contains('='), "only one is told: {words}");
        assert!(told.contains("\nsay\twrong\t"), "{told}");
    }

    #[test]
    fn an_unreadable_field_leaves_the_others_judged() {
        let (deal, fields) = filled(&[(1, 1, "(6, 12)"), (2, 1, "0.5"), (3, 1, "7")]);
        let told = described(&deal, &fields);
        assert_eq!(cell(&told, 1, 1).0, "right");
        for row in [2, 3] {
            let (state, words) = cell(&told, row, 1);
            assert_eq!(state, "unreadable");
            assert!(!words.is_empty());
        }
        assert!(deal.with_fields(&deal.answer_file(), &fields).is_err());
    }

    #[test]
    fn a_filled_table_goes_into_the_file_and_comes_back() {
        let deal = cubic(3);
        let solved = deal.fields(&deal.solved_file()).expect("its own file");
        let file = deal.with_fields(&deal.answer_file(), &solved);
        assert_eq!(file, Ok(Some(deal.solved_file())));
        let told = described(&deal, &solved);
        assert!(told.contains("\nsay\tright\t"), "{told}");
        // Comments of the reader stay.
        let own = format!("// mine\n{}// and mine\n", deal.answer_file());
        let file = deal.with_fields(&own, &solved).expect("readable");
        assert_eq!(
            file,
            Some(format!("// mine\n{}// and mine\n", deal.solved_file()))
        );
    }

    #[test]
    fn spaces_do_not_part_an_entry() {
        let (deal, fields) = filled(&[(1, 1, " ( 12 / 2,12 ) ")]);
        let file = deal.with_fields(&deal.answer_file(), &fields);
        let file = file.expect("readable").expect("its own file");
        let again = deal.fields(&file).expect("its own file");
        assert_eq!(again[1][1], "(12/2, 12)");
    }

    #[test]
    fn another_file_is_no_sheet() {
        let deal = cubic(0);
        let file = deal.answer_file();
        let first = deal.tableau.rows()[1][0].to_string();
        for other in [
            "pub fn f() {}".to_owned(),
            file.replace("ROUND: u64 = 0", "ROUND: u64 = 1"),
            file.replace(&first, "(9, 9)"),
            file.replacen("?\n", "? ?\n", 1),
        ] {
            assert_eq!(deal.fields(&other), None, "{other}");
        }
    }
}
