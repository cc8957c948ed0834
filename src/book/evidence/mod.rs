//! The evidence for each statement, found in the sources.
//!
//! Nobody writes down that a statement is tested: the tests are looked up. One rule finds them.
//! `bezier-convex-hull` has the law `bezier::laws::convex_hull`, and in each test binary a test of that name below
//! the folder of its chapter:
//!
//! | evidence | is |
//! |---|---|
//! | example | a Rust block in the statement's section that runs and asserts something |
//! | property, exact | the test of that name in `tests/property`, `tests/exact`; it calls the law and rejects a mutant |
//! | figure | each figure in the section has its snapshot, and a test of its name that calls it and rejects a wrong one |
//! | proof | a proof in the section |
//! | compile_fail | a block in the section that must fail with the error code it names |
//! | errata | for a statement that the notes have wrong: an erratum whose block runs and asserts |
//!
//! Where a statement has no law or test of its own name, its directive names others
//! ([`Options`](super::directive::Options)).
//! A test that comes close but does not count is reported with the reason, as a [`Doubt`].
//!
//! An exercise is evidence for each statement that it names, unless it is an explanation; whether it passes `verify`
//! is asked by `coverage` ([`AllEvidence::find`] only looks).
//!
//! A figure is *interactive* as well if it has handles or sliders: the page draws it again, by the same function.

mod test_functions;
mod tokens;

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use super::catalogue::{CHAPTERS, Catalogue, Kind, Need, Statement};
use super::error::{BookErrors, Place};
use super::exercise::{Exercise, Exercises};
use super::manuscript::Manuscript;
use super::page::{CodeBlock, InnerBlock, Page, StatementBlock};
use super::registry::Registry;

pub use test_functions::{TestFunction, tests_of_binary};

/// What a statement can lack.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Gap {
    /// It is not written in the book, or its section holds no text.
    Statement,
    /// Evidence that the catalogue says it needs.
    Need(Need),
    /// The notes have it wrong, and no erratum with a running counterexample says so.
    Errata,
}

impl Gap {
    /// The name as `coverage` prints it: `property`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Statement => "statement",
            Self::Need(need) => need.name(),
            Self::Errata => "errata",
        }
    }

    /// Everything that can be missing, in the order in which it is shown.
    pub fn all() -> impl Iterator<Item = Self> {
        let needs = Need::ALL.into_iter().map(Self::Need);
        std::iter::once(Self::Statement)
            .chain(needs)
            .chain([Self::Errata])
    }
}

impl fmt::Display for Gap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Something that looks like evidence and does not count.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Doubt {
    /// The evidence that it would be.
    pub gap: Gap,
    /// Where it stands.
    pub place: Place,
    /// Why it does not count, and what to do.
    pub reason: String,
}

/// The evidence for one statement.
#[derive(Debug, Clone, Default)]
pub struct Evidence {
    /// Where the book states it.
    pub stated: Option<Place>,
    /// What was found of each kind.
    pub found: BTreeMap<Need, Vec<Place>>,
    /// The errata whose counterexample runs.
    pub errata: Vec<Place>,
    /// What does not count, and why.
    pub doubts: Vec<Doubt>,
}

impl Evidence {
    /// What was found of one kind.
    pub fn of(&self, need: Need) -> &[Place] {
        self.found.get(&need).map_or(&[], Vec::as_slice)
    }

    /// What the statement lacks, in the order of [`Gap::all`].
    ///
    /// Evidence that only partly counts, for instance one of two named tests, is lacking as well.
    pub fn gaps(&self, statement: &Statement) -> Vec<Gap> {
        let doubtful = |gap| self.doubts.iter().any(|doubt| doubt.gap == gap);
        Gap::all()
            .filter(|&gap| match gap {
                Gap::Statement => self.stated.is_none() || doubtful(gap),
                Gap::Need(need) => {
                    statement.needs.contains(&need) && (self.of(need).is_empty() || doubtful(gap))
                }
                Gap::Errata => statement.errata && (self.errata.is_empty() || doubtful(gap)),
            })
            .collect()
    }

    fn add(&mut self, need: Need, place: Place) {
        self.found.entry(need).or_default().push(place);
    }

    fn doubt(&mut self, gap: Gap, place: Place, reason: impl Into<String>) {
        let reason = reason.into();
        self.doubts.push(Doubt { gap, place, reason });
    }
}

/// The evidence for all statements.
#[derive(Debug, Clone, Default)]
pub struct AllEvidence {
    by_id: BTreeMap<String, Evidence>,
}

impl AllEvidence {
    /// Looks up the evidence for every statement of the catalogue.
    ///
    /// # Errors
    ///
    /// A test source that cannot be read or is no Rust.
    pub fn find(
        root: &Path,
        catalogue: &Catalogue,
        manuscript: &Manuscript,
        exercises: &Exercises,
        registry: &Registry,
    ) -> Result<Self, BookErrors> {
        let sources = Sources {
            root,
            manuscript,
            exercises,
            registry,
            property: tests_of_binary(root, "property")?,
            exact: tests_of_binary(root, "exact")?,
            figures: tests_of_binary(root, "figures")?,
        };
        let evidence = |statement: &Statement| (statement.id.clone(), sources.evidence(statement));
        Ok(Self {
            by_id: catalogue.statements().iter().map(evidence).collect(),
        })
    }

    /// Takes an exercise that is not sound out of the evidence, and says why.
    pub(crate) fn refuse(&mut self, exercise: &Exercise, reason: &str) {
        for id in &exercise.front.statements {
            let Some(evidence) = self.by_id.get_mut(id) else {
                continue;
            };
            let place = Place::new(exercise.file(), 1);
            if let Some(places) = evidence.found.get_mut(&Need::Exercise) {
                places.retain(|other| *other != place);
            }
            evidence.doubt(Gap::Need(Need::Exercise), place, reason);
        }
    }

    /// The evidence for the statement with this id; `None` for an id that no catalogue lists.
    pub fn get(&self, id: &str) -> Option<&Evidence> {
        self.by_id.get(id)
    }
}

/// Where evidence is looked for.
struct Sources<'a> {
    root: &'a Path,
    manuscript: &'a Manuscript,
    exercises: &'a Exercises,
    registry: &'a Registry,
    property: Vec<TestFunction>,
    exact: Vec<TestFunction>,
    figures: Vec<TestFunction>,
}

impl Sources<'_> {
    fn evidence(&self, statement: &Statement) -> Evidence {
        let mut evidence = Evidence::default();
        let written = self.section(&statement.id);
        if let Some((page, section)) = written {
            read_section(statement.kind, page, section, &mut evidence);
        }
        let section = written.map(|(_, section)| section);
        self.laws(statement, section, Need::Property, &mut evidence);
        self.laws(statement, section, Need::Exact, &mut evidence);
        if let Some((page, section)) = written {
            self.figures(statement, page, section, &mut evidence);
        }
        for exercise in self.exercises.iter().filter(|e| trains(e, &statement.id)) {
            evidence.add(Need::Exercise, Place::new(exercise.file(), 1));
        }
        evidence
    }

    /// The section that states it, and its page.
    fn section(&self, id: &str) -> Option<(&Page, &StatementBlock)> {
        let page = &self.manuscript.pages[self.manuscript.statements.get(id)?.page];
        let section = page.statements.iter().find(|section| section.id == id)?;
        Some((page, section))
    }

    /// The property or exact tests.
    fn laws(
        &self,
        statement: &Statement,
        section: Option<&StatementBlock>,
        need: Need,
        evidence: &mut Evidence,
    ) {
        let named = |key: &str| {
            section
                .and_then(|section| section.options.get(key))
                .cloned()
        };
        let own = statement.code_name();
        let laws = named("law").unwrap_or_else(|| vec![own.clone()]);
        let tests = named(need.name()).unwrap_or_else(|| vec![own.clone()]);
        let candidates = match need {
            Need::Property => &self.property,
            _ => &self.exact,
        };
        for name in &tests {
            let is_named =
                |test: &&TestFunction| test.name() == name && test.is_in_chapter(statement.chapter);
            let mut found = candidates.iter().filter(is_named).peekable();
            if let (None, Some(section)) = (found.peek(), section)
                && section.options.contains_key(need.name())
            {
                let place = self.place_of(statement, section);
                let folder = format!("tests/{need}/{}", statement.chapter);
                let reason = format!("no test `{name}` below `{folder}`; write it or name another");
                evidence.doubt(Gap::Need(need), place, reason);
            }
            for test in found {
                let calls_law = laws
                    .iter()
                    .chain([name])
                    .any(|law| test.calls(statement.chapter, "laws", law));
                if !calls_law {
                    let reason = format!("the test does not call `laws::{}`", laws[0]);
                    evidence.doubt(Gap::Need(need), test.place.clone(), reason);
                } else if !test.rejects_a_mutant() {
                    let reason = "the test rejects no mutant; add `rejects(…)`";
                    evidence.doubt(Gap::Need(need), test.place.clone(), reason);
                } else {
                    evidence.add(need, test.place.clone());
                }
            }
        }
    }

    /// The figures in the section, and those that the directive names.
    fn figures(
        &self,
        statement: &Statement,
        page: &Page,
        section: &StatementBlock,
        evidence: &mut Evidence,
    ) {
        let inside = section
            .figures
            .iter()
            .map(|(id, line)| (id.clone(), Place::new(&page.file, *line)));
        let elsewhere = section.options.get("figure").into_iter().flatten();
        let elsewhere = elsewhere.map(|name| {
            let id = format!("{}-{}", statement.chapter, name.replace('_', "-"));
            (id, Place::new(&page.file, section.line))
        });
        for (id, mention) in inside.chain(elsewhere) {
            match self.figure(&id) {
                Ok(place) => {
                    if self
                        .registry
                        .figure(&id)
                        .is_ok_and(|figure| figure.live.is_some())
                    {
                        evidence.add(Need::Interactive, place.clone());
                    }
                    evidence.add(Need::Figure, place);
                }
                Err(reason) => evidence.doubt(Gap::Need(Need::Figure), mention, reason),
            }
        }
    }

    /// The test of a figure, or why the figure does not count.
    fn figure(&self, id: &str) -> Result<Place, String> {
        let (chapter, name) = CHAPTERS
            .into_iter()
            .find_map(|chapter| Some((chapter, id.strip_prefix(chapter)?.strip_prefix('-')?)))
            .ok_or_else(|| format!("the figure id `{id}` does not begin with its chapter"))?;
        let function = name.replace('-', "_");
        if !self.manuscript.figures.contains_key(id) {
            return Err(format!("no page shows the figure `{id}`"));
        }
        let snapshot = PathBuf::from(format!("snapshots/{chapter}/{id}.snap.svg"));
        if !self.root.join(&snapshot).is_file() {
            let snapshot = snapshot.display();
            return Err(format!("the figure `{id}` has no snapshot `{snapshot}`"));
        }
        let test = self
            .figures
            .iter()
            .find(|test| test.name() == function && test.is_in_chapter(chapter))
            .ok_or_else(|| {
                format!(
                    "the figure `{id}` has no test `{function}` below `tests/figures/{chapter}`"
                )
            })?;
        if !test.calls(chapter, "figures", &function) {
            return Err(format!(
                "{} does not call `figures::{function}`",
                test.place
            ));
        }
        if !test.rejects_a_mutant() {
            let place = &test.place;
            return Err(format!("{place} refuses no wrong figure; add `rejects(…)`"));
        }
        Ok(test.place.clone())
    }

    fn place_of(&self, statement: &Statement, section: &StatementBlock) -> Place {
        let page = self.manuscript.statements[&statement.id].page;
        Place::new(&self.manuscript.pages[page].file, section.line)
    }
}

/// Whether solving an exercise shows that a statement was understood; an explanation shows it to nobody.
fn trains(exercise: &Exercise, id: &str) -> bool {
    exercise.front.kind.is_tested() && exercise.front.statements.iter().any(|s| s == id)
}

/// What stands in the section itself: text, examples, proofs, errata.
fn read_section(kind: Kind, page: &Page, section: &StatementBlock, evidence: &mut Evidence) {
    let opening = Place::new(&page.file, section.line);
    evidence.stated = Some(opening.clone());
    // A figure speaks by its picture, which has a title and a description of its own.
    let speaks = kind == Kind::Figure && !section.figures.is_empty();
    if !speaks && !has_words(&page.text[own_text(page, section)]) {
        let reason = "the section says nothing; write the statement below its directive";
        evidence.doubt(Gap::Statement, opening, reason);
    }
    let is_inside = |blocks: &[InnerBlock], code: &CodeBlock| {
        blocks
            .iter()
            .any(|block| block.body.contains(&code.span.start))
    };
    for code in section.code.iter().map(|&index| &page.code[index]) {
        let place = Place::new(&page.file, code.line);
        if code.compile_fail().is_some() {
            evidence.add(Need::CompileFail, place);
        } else if code.tags().any(|tag| tag == "compile_fail") {
            let reason = "the block names no error code; write `compile_fail,E0277` or the like";
            evidence.doubt(Gap::Need(Need::CompileFail), place, reason);
        } else if runs(code) && asserts(&code.code) {
            // An erratum's block shows what the notes say to be wrong; it is no example of the statement.
            if is_inside(&section.errata, code) {
                evidence.errata.push(place);
            } else {
                evidence.add(Need::Example, place);
            }
        }
    }
    for proof in &section.proofs {
        let place = Place::new(&page.file, proof.line);
        if has_words(&page.text[proof.body.clone()]) {
            evidence.add(Need::Proof, place);
        } else {
            let reason = "the proof is empty; write it or take the directives out";
            evidence.doubt(Gap::Need(Need::Proof), place, reason);
        }
    }
}

/// The bytes from the opening directive to the first proof or erratum, or to the end.
fn own_text(page: &Page, section: &StatementBlock) -> std::ops::Range<usize> {
    let opening = &page.text[section.span.clone()];
    let start = section.span.start + opening.find("}}").map_or(0, |at| at + 2);
    let end = section
        .proofs
        .iter()
        .chain(&section.errata)
        .map(|block| block.span.start)
        .min()
        .unwrap_or(section.span.end);
    start..end
}

/// Whether there is a word besides the directives.
fn has_words(text: &str) -> bool {
    let mut rest = text;
    loop {
        let (before, after) = rest.split_once("{{").unwrap_or((rest, ""));
        if before.chars().any(char::is_alphanumeric) {
            return true;
        }
        match after.split_once("}}") {
            Some((_, behind)) => rest = behind,
            None => return false,
        }
    }
}

/// Whether `cargo test` compiles the block and runs it.
fn runs(code: &CodeBlock) -> bool {
    let unrun = |tag: &str| {
        tag.starts_with("ignore") || ["no_run", "compile_fail", "should_panic"].contains(&tag)
    };
    code.is_rust() && !code.tags().any(unrun)
}

/// Whether the code calls `assert!`, `assert_eq!` or another macro of the family.
fn asserts(code: &str) -> bool {
    // Rustdoc hides lines that begin with `#`, and runs them.
    let visible: Vec<&str> = code
        .lines()
        .map(|line| line.trim_start().strip_prefix("# ").unwrap_or(line))
        .collect();
    visible
        .join("\n")
        .parse()
        .map(tokens::mentions)
        .is_ok_and(|mentions| {
            mentions
                .iter()
                .any(|mention| mention.macro_call && mention.last().starts_with("assert"))
        })
}
