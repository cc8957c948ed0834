//! Tableaux with fresh numbers, and the answer file that asks for one.

use super::Tableau;

/// A tableau whose numbers were dealt.
///
/// The numbers depend on the round alone. So the tests deal them again, and a reader who changes them is found out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deal {
    /// The round; round 0 is the one that the exercise shows.
    pub round: u64,
    /// What is to be computed, with the numbers that stand in no cell: `de Casteljau for a cubic at t = 1/3`.
    pub task: String,
    /// The tableau.
    pub tableau: Tableau,
}

impl Deal {
    /// The complete text of the answer file in which the reader fills the tableau.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::tableaux;
    ///
    /// let deal = tableaux::cubic(7);
    /// let file = deal.answer_file();
    /// assert!(file.contains("pub const ROUND: u64 = 7;"));
    /// assert!(file.contains(&deal.tableau.blank()));
    /// assert_eq!(file, tableaux::cubic(7).answer_file(), "the same round deals the same numbers");
    /// assert_ne!(file, tableaux::cubic(8).answer_file());
    /// ```
    #[must_use]
    pub fn answer_file(&self) -> String {
        self.file(&self.tableau.blank())
    }

    /// The answer file with the tableau filled.
    #[must_use]
    pub fn solved_file(&self) -> String {
        self.file(&self.tableau.solved())
    }

    fn file(&self, tableau: &str) -> String {
        let Self { round, task, .. } = self;
        format!(
            "//! To compute: {task}.\n\
             \n\
             /// The round that dealt the numbers; leave it as it is.\n\
             pub const ROUND: u64 = {round};\n\
             \n\
             /// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.\n\
             pub const TABLEAU: &str = \"\n{tableau}\";\n"
        )
    }
}

/// Who deals a tableau of one kind.
#[derive(Debug, Clone, Copy)]
pub struct Dealer {
    /// The name that the front matter of an exercise gives: `cubic`.
    pub name: &'static str,
    /// The tableau of a round.
    pub deal: fn(u64) -> Deal,
}
