//! What is shown for each statement, and what is missing.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::Path;

use serde::Serialize;

use super::catalogue::{Catalogue, Kind, Need, Statement};
use super::error::{BookErrors, Place};
use super::evidence::{AllEvidence, Doubt, Evidence, Gap};
use super::exercise::{Exercise, Exercises};
use super::manuscript::Manuscript;
use super::registry::Registry;

/// One statement with its evidence; serialised, it is an entry of `coverage --json`.
#[derive(Debug, Clone, Serialize)]
pub struct Entry {
    /// The id.
    pub id: String,
    /// The chapter.
    pub chapter: &'static str,
    /// What it is.
    pub kind: Kind,
    /// What it is called.
    pub title: String,
    /// Where the lecture notes have it.
    pub sources: Vec<String>,
    /// The evidence it needs.
    pub needs: Vec<Need>,
    /// The evidence that was found, each kind with its places as `path:line`.
    pub evidence: BTreeMap<Need, Vec<String>>,
    /// What is missing and was not excepted.
    pub missing: Vec<&'static str>,
    /// What looks like the missing evidence and does not count.
    #[serde(skip)]
    pub doubts: Vec<Doubt>,
}

/// The coverage of the chosen chapters.
#[derive(Debug, Clone)]
pub struct Coverage {
    /// The statements, in the order of the catalogue.
    pub entries: Vec<Entry>,
}

impl Coverage {
    /// Looks up the evidence for the statements of `chapters`.
    ///
    /// No chapters stands for those that have begun: those of which the book states something.
    /// What is in `except` may be missing.
    ///
    /// `verify` says of each exercise whether it is sound, or why not; it is asked only about those that count.
    ///
    /// # Errors
    ///
    /// What is wrong with the catalogue, the pages, the exercises or the tests' sources, all at once.
    pub fn find(
        root: &Path,
        chapters: &[String],
        except: &[Gap],
        verify: impl Fn(&[&Exercise]) -> Vec<Result<(), String>>,
    ) -> Result<Self, BookErrors> {
        let catalogue = Catalogue::load(root)?;
        let mut errors = Vec::new();
        let manuscript = Manuscript::load(root, &catalogue, &mut errors);
        BookErrors::none_of(errors)?;
        let exercises = Exercises::load(root, &[], &catalogue)?;
        let mut all = AllEvidence::find(
            root,
            &catalogue,
            &manuscript,
            &exercises,
            &Registry::of_all_chapters(),
        )?;
        let begun: BTreeSet<&str> = manuscript
            .statements
            .keys()
            .filter_map(|id| Some(catalogue.get(id)?.chapter))
            .collect();
        let is_chosen = |statement: &&Statement| match chapters {
            [] => begun.contains(statement.chapter),
            chosen => chosen.iter().any(|chapter| chapter == statement.chapter),
        };
        if !except.contains(&Gap::Need(Need::Exercise)) {
            let trains_chosen = |exercise: &&Exercise| {
                let trained = exercise.front.statements.iter();
                trained
                    .filter_map(|id| catalogue.get(id))
                    .any(|s| is_chosen(&s))
            };
            let asked: Vec<&Exercise> = exercises
                .iter()
                .filter(|exercise| exercise.front.kind.is_tested())
                .filter(trains_chosen)
                .collect();
            for (exercise, judged) in asked.iter().zip(verify(&asked)) {
                if let Err(reason) = judged {
                    all.refuse(exercise, &reason);
                }
            }
        }
        let entries = catalogue
            .statements()
            .iter()
            .filter(is_chosen)
            .filter_map(|statement| Some(entry(statement, all.get(&statement.id)?, except)))
            .collect();
        Ok(Self { entries })
    }

    /// Whether nothing is missing but what was excepted.
    pub fn is_complete(&self) -> bool {
        self.entries.iter().all(|entry| entry.missing.is_empty())
    }
}

fn entry(statement: &Statement, evidence: &Evidence, except: &[Gap]) -> Entry {
    let places = |need| evidence.of(need).iter().map(Place::to_string).collect();
    let gaps: Vec<Gap> = evidence
        .gaps(statement)
        .into_iter()
        .filter(|gap| !except.contains(gap))
        .collect();
    let is_missing = |doubt: &&Doubt| gaps.contains(&doubt.gap);
    Entry {
        id: statement.id.clone(),
        chapter: statement.chapter,
        kind: statement.kind,
        title: statement.title.clone(),
        sources: statement.sources.clone(),
        needs: statement.needs.clone(),
        evidence: Need::ALL.map(|need| (need, places(need))).into(),
        missing: gaps.iter().map(|gap| gap.name()).collect(),
        doubts: evidence.doubts.iter().filter(is_missing).cloned().collect(),
    }
}

/// A table for people: a line for each statement, then the totals.
///
/// The columns stand for the kinds of evidence; `+` is found, `-` is missing, `.` is neither needed nor missing.
impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.entries.iter().map(|entry| entry.id.len()).max();
        let width = width.unwrap_or(0).max("statement".len());
        let heads = Need::ALL.map(Need::name);
        writeln!(
            f,
            "{:width$}  kind        {}",
            "statement",
            heads.join("  ")
        )?;
        for entry in &self.entries {
            write!(f, "{:width$}  {:10}", entry.id, entry.kind.name())?;
            for need in Need::ALL {
                let sign = sign(entry, need);
                write!(f, "  {sign:<column$}", column = need.name().len())?;
            }
            let elsewhere = ["statement", "errata"];
            let also = entry.missing.iter().filter(|gap| elsewhere.contains(gap));
            for gap in also {
                write!(f, "  no {gap}")?;
            }
            writeln!(f)?;
            for doubt in &entry.doubts {
                writeln!(f, "    {}: {}: {}", doubt.gap, doubt.place, doubt.reason)?;
            }
        }
        self.totals(f)
    }
}

impl Coverage {
    fn totals(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let incomplete = self
            .entries
            .iter()
            .filter(|entry| !entry.missing.is_empty());
        let incomplete = incomplete.count();
        let statements = self.entries.len();
        writeln!(f)?;
        if incomplete == 0 {
            return writeln!(f, "{statements} statements, nothing missing");
        }
        write!(
            f,
            "{statements} statements, {incomplete} with something missing:"
        )?;
        let mut separator = "";
        for gap in Gap::all().map(Gap::name) {
            let lacking = self
                .entries
                .iter()
                .filter(|entry| entry.missing.contains(&gap));
            let lacking = lacking.count();
            if lacking > 0 {
                write!(f, "{separator} {lacking} {gap}")?;
                separator = ",";
            }
        }
        writeln!(f)
    }
}

fn sign(entry: &Entry, need: Need) -> char {
    if entry.missing.contains(&need.name()) {
        '-'
    } else if entry
        .evidence
        .get(&need)
        .is_some_and(|places| !places.is_empty())
    {
        '+'
    } else {
        '.'
    }
}
