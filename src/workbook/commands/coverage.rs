//! `cargo run -- coverage`: the evidence for every statement, and what is missing.

use std::io::Write;
use std::path::Path;

use clap::Args;
use clap::builder::PossibleValuesParser;

use crate::book::catalogue::CHAPTERS;
use crate::book::coverage::Coverage;
use crate::book::evidence::Gap;
use crate::book::exercise::Exercise;
use crate::workbook::command_line::{Failure, Outcome};
use crate::workbook::house;

/// What `coverage` is asked.
#[derive(Debug, Args)]
pub struct AskedCoverage {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Only this chapter; without it, the chapters that have begun
    #[arg(long, value_name = "C", value_parser = PossibleValuesParser::new(CHAPTERS))]
    chapter: Vec<String>,
    /// What may be missing
    #[arg(long, value_name = "NEED,…", value_delimiter = ',', value_parser = gap_parser())]
    except: Vec<String>,
}

fn gap_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(Gap::all().map(Gap::name).collect::<Vec<_>>())
}

impl AskedCoverage {
    /// Looks the evidence up; exercises that changed since they were last verified are verified now.
    ///
    /// # Errors
    ///
    /// The workbook is not found, or the book has errors.
    pub(crate) fn run(&self) -> Result<Outcome, Failure> {
        let except: Vec<Gap> = Gap::all()
            .filter(|gap| self.except.iter().any(|name| name == gap.name()))
            .collect();
        let root = house::find()?;
        let verify = |asked: &[&Exercise]| are_sound(&root, asked);
        let coverage = Coverage::find(&root, &self.chapter, &except, verify)?;
        let mut out = std::io::stdout();
        if self.json {
            let text =
                serde_json::to_string_pretty(&coverage.entries).map_err(std::io::Error::from)?;
            writeln!(out, "{text}")?;
        } else {
            write!(out, "{coverage}")?;
        }
        Ok(if coverage.is_complete() {
            Outcome::Fine
        } else {
            Outcome::FallsShort
        })
    }
}

/// Whether each exercise is sound, or why not.
#[cfg(unix)]
fn are_sound(root: &Path, asked: &[&Exercise]) -> Vec<Result<(), String>> {
    use super::verify::progress_bar;
    use crate::workbook::checking::Checker;
    use crate::workbook::sandbox::Isolation;
    use crate::workbook::verify::verify;

    let bar = progress_bar();
    let verified = Checker::new(root, Isolation::best()).and_then(|checker| {
        verify(&checker, asked, true, &|progress| {
            bar.set_length(progress.all as u64);
            bar.set_message(progress.exercise.name.to_string());
            bar.inc(1);
        })
    });
    bar.finish_and_clear();
    match verified {
        Ok(verified) => verified
            .iter()
            .map(|verified| match verified.report.is_sound() {
                true => Ok(()),
                false => Err(format!(
                    "it is not sound; `cargo run -- verify {}` says why",
                    verified.report.exercise
                )),
            })
            .collect(),
        Err(error) => vec![Err(format!("it could not be verified: {error}")); asked.len()],
    }
}

/// Whether each exercise is sound, or why not.
#[cfg(not(unix))]
fn are_sound(_root: &Path, asked: &[&Exercise]) -> Vec<Result<(), String>> {
    vec![Err("exercises can be verified on Unix systems only".to_owned()); asked.len()]
}
