//! `cargo run -- verify`: the instructor's proof that exercises are sound.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use super::grade::{must_be_writable, to_file};
use crate::book::catalogue::Catalogue;
use crate::book::exercise::{Exercise, ExerciseName, Exercises, HiddenTests, Mistakes};
use crate::workbook::checking::Checker;
use crate::workbook::command_line::{Failure, Outcome};
use crate::workbook::house;
use crate::workbook::sandbox::Isolation;
use crate::workbook::verify::judge::unreadable;
use crate::workbook::verify::report::Report;
use crate::workbook::verify::session::Progress;
use crate::workbook::verify::text::Text;
use crate::workbook::verify::{Verified, hidden, junit, verify};

/// What `verify` is asked.
#[derive(Debug, Args)]
pub struct Verify {
    /// Only this exercise, `chapter/name`, or all of this chapter; with the tests that reject each answer
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Write JUnit XML to this file as well
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Try every answer again, also where nothing has changed
    #[arg(long)]
    no_cache: bool,
    /// Read the exercises and hidden tests of this pack as well
    #[arg(long, value_name = "DIR")]
    pack: Vec<PathBuf>,
    /// Show which test rejects which answer
    #[arg(long, short)]
    verbose: bool,
}

impl Verify {
    /// Verifies the exercises that were asked for.
    ///
    /// # Errors
    ///
    /// The workbook is not found, an exercise does not follow the schema or is not there, or an answer cannot be run.
    pub(crate) fn run(&self) -> Result<Outcome, Failure> {
        if let Some(file) = &self.junit {
            must_be_writable(file)?;
        }
        let root = house::find()?;
        let catalogue = Catalogue::load(&root)?;
        let packs = absolute_packs(&self.pack)?;
        let (exercises, mistakes) = Exercises::load_sound(&root, &packs, &catalogue);
        if let Some(errors) = &mistakes.all {
            eprintln!("{errors}\n");
        }
        let unreadable = self.unreadable(&mistakes);
        let chosen = self.chosen(&exercises, &unreadable)?;
        let hidden = HiddenTests::load(&root, &packs, &exercises);
        if let Err(errors) = &hidden {
            eprintln!("{errors}\n");
        }
        let can_read_all = hidden.is_ok();
        let checker = Checker::new(&root, Isolation::best())?.patient();
        let bar = progress_bar();
        let mut verified = verify(&checker, &chosen, !self.no_cache, &|progress: Progress| {
            bar.set_length(progress.all as u64);
            bar.set_message(progress.exercise.name.to_string());
            bar.inc(1);
        })?;
        for hidden in hidden.into_iter().flatten() {
            let exercise = chosen.iter().find(|e| e.name == hidden.exercise);
            let report = verified
                .iter_mut()
                .map(|v| &mut v.report)
                .find(|report| report.exercise == hidden.exercise);
            if let (Some(exercise), Some(report)) = (exercise, report)
                && let Some(tested) = &exercise.tested
            {
                bar.set_message(format!("hidden tests of {}", exercise.name));
                hidden::add(&checker, exercise, tested, &hidden, report)?;
            }
        }
        bar.finish_and_clear();
        verified.extend(unreadable);

        if let Some(file) = &self.junit {
            let xml = junit::xml(&verified);
            to_file(file, |out| {
                xml.serialize(out).map_err(std::io::Error::other)
            })?;
        }
        if self.json {
            let reports: Vec<&Report> = verified.iter().map(|v| &v.report).collect();
            let text = serde_json::to_string_pretty(&reports).map_err(std::io::Error::from)?;
            writeln!(std::io::stdout(), "{text}")?;
        } else {
            let text = Text {
                verified: &verified,
                matrix: self.verbose || self.names.iter().any(|name| name.contains('/')),
            };
            write!(anstream::stdout(), "{text}")?;
        }
        let is_sound = verified.iter().all(|v| v.report.is_sound());
        Ok(if is_sound && can_read_all {
            Outcome::Fine
        } else {
            Outcome::FallsShort
        })
    }

    /// What is to be said about the exercises of the names that do not follow the schema.
    fn unreadable(&self, mistakes: &Mistakes) -> Vec<Verified> {
        let is_chosen = |name: &ExerciseName| {
            self.names.is_empty() || self.names.iter().any(|chosen| is_name_of(chosen, name))
        };
        let chosen = mistakes
            .exercises
            .iter()
            .filter(|(name, _)| is_chosen(name));
        chosen
            .map(|(name, errors)| Verified {
                report: unreadable(name, errors),
                before: None,
                from_cache: false,
            })
            .collect()
    }

    /// The exercises of the names, in the order of the list; all without names.
    fn chosen<'a>(
        &self,
        exercises: &'a Exercises,
        unreadable: &[Verified],
    ) -> Result<Vec<&'a Exercise>, Failure> {
        let of_unreadable = |name: &&String| {
            unreadable
                .iter()
                .any(|verified| is_name_of(name, &verified.report.exercise))
        };
        let known: Vec<String> = self
            .names
            .iter()
            .filter(|name| !of_unreadable(name))
            .cloned()
            .collect();
        require_names(&known, exercises)?;
        let is_chosen =
            |exercise: &&Exercise| self.names.is_empty() || is_named(&self.names, exercise);
        Ok(exercises.iter().filter(is_chosen).collect())
    }
}

/// The folders of the packs, which are named from where the instructor stands.
pub(super) fn absolute_packs(packs: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let absolute = |pack: &PathBuf| {
        pack.canonicalize().map_err(|e| Failure::Pack {
            pack: pack.clone(),
            reason: e.to_string(),
        })
    };
    packs.iter().map(absolute).collect()
}

/// Whether one of the names is that of the exercise or of its chapter.
pub(super) fn is_named(names: &[String], exercise: &Exercise) -> bool {
    names.iter().any(|name| is_name_of(name, &exercise.name))
}

/// Whether a name is that of an exercise or of its chapter.
fn is_name_of(name: &str, exercise: &ExerciseName) -> bool {
    exercise.to_string() == name || exercise.chapter() == name
}

/// Each name is that of an exercise or of a chapter with exercises.
pub(super) fn require_names(names: &[String], exercises: &Exercises) -> Result<(), Failure> {
    for name in names {
        let one = std::slice::from_ref(name);
        if !exercises.iter().any(|exercise| is_named(one, exercise)) {
            let of_this_name = exercises.iter().find(|e| e.name.name() == name);
            return Err(Failure::NoExercise {
                name: name.clone(),
                similar: match of_this_name {
                    Some(exercise) => Some(exercise.name.to_string()),
                    None => exercises.similar(name),
                },
            });
        }
    }
    Ok(())
}

/// A bar on the terminal; nothing where standard error is none.
pub(super) fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::no_length();
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos} of {len} answers  {msg}") {
        bar.set_style(style);
    }
    bar
}
