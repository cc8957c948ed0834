//! The commands, their arguments and exit statuses.
//!
//! | status | means |
//! |---|---|
//! | 0 | fine |
//! | 1 | what was checked falls short |
//! | 2 | it could not run |

use std::io::{Write, stdout};
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand};
use thiserror::Error;

use super::house;
use crate::book::catalogue::CHAPTERS;
use crate::book::coverage::Coverage;
use crate::book::error::BookErrors;
use crate::book::evidence::Gap;

/// The CAGD workbook.
#[derive(Debug, Parser)]
#[command(name = "workbook", bin_name = "cargo run --", version)]
#[command(after_help = "Exit status: 0 fine, 1 what was checked falls short, 2 it could not run.")]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Show the evidence for every statement and what is missing
    Coverage {
        /// Print JSON
        #[arg(long)]
        json: bool,
        /// Only this chapter; without it, the chapters that have begun
        #[arg(long, value_name = "C", value_parser = PossibleValuesParser::new(CHAPTERS))]
        chapter: Vec<String>,
        /// What may be missing
        #[arg(long, value_name = "NEED,…", value_delimiter = ',', value_parser = gap_parser())]
        except: Vec<String>,
    },
}

fn gap_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(Gap::all().map(Gap::name).collect::<Vec<_>>())
}

/// What ends a command with status 2.
#[derive(Debug, Error)]
enum Failure {
    #[error(transparent)]
    House(#[from] house::NoHouse),
    #[error("{0}")]
    Book(#[from] BookErrors),
    #[error("cannot write the answer: {0}")]
    Output(#[from] std::io::Error),
}

/// How a command that ran ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Fine,
    FallsShort,
}

/// Runs the command that the process was started with and returns its exit status.
#[must_use]
pub fn run() -> ExitCode {
    match execute(CommandLine::parse()) {
        Ok(Outcome::Fine) => ExitCode::SUCCESS,
        Ok(Outcome::FallsShort) => ExitCode::from(1),
        // A reader that closes the pipe early, such as `head`, has what it wanted.
        Err(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(Failure::Book(errors)) => {
            eprintln!("{errors}");
            ExitCode::from(2)
        }
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::from(2)
        }
    }
}

fn execute(line: CommandLine) -> Result<Outcome, Failure> {
    match line.command {
        Command::Coverage {
            json,
            chapter,
            except,
        } => coverage(json, &chapter, &except),
    }
}

fn coverage(json: bool, chapters: &[String], except: &[String]) -> Result<Outcome, Failure> {
    let except: Vec<Gap> = Gap::all()
        .filter(|gap| except.iter().any(|name| name == gap.name()))
        .collect();
    let coverage = Coverage::find(&house::find()?, chapters, &except)?;
    if json {
        let text = serde_json::to_string_pretty(&coverage.entries).map_err(std::io::Error::from)?;
        writeln!(stdout(), "{text}")?;
    } else {
        write!(stdout(), "{coverage}")?;
    }
    Ok(if coverage.is_complete() {
        Outcome::Fine
    } else {
        Outcome::FallsShort
    })
}
