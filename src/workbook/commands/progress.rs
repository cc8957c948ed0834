//! `progress`: takes the progress to another computer.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use serde::Serialize;

use super::{Place, PracticeError, print, print_json};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{CODE, paint, wrapped};

/// The arguments of `progress`.
#[derive(Debug, Args)]
pub struct Progress {
    #[command(subcommand)]
    direction: Direction,
}

#[derive(Debug, Subcommand)]
enum Direction {
    /// Write the progress to a new file
    Export(Transfer),
    /// Take over what a file knows; nothing that is known here is forgotten
    Import(Transfer),
}

#[derive(Debug, Args)]
struct Transfer {
    /// The file
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `progress … --json` prints.
#[derive(Debug, Serialize)]
struct Known {
    exercises: usize,
    solved: usize,
}

impl Progress {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let (transfer, progress, what) = match self.direction {
            Direction::Export(transfer) => {
                let progress = transfer.place.open()?.store.export(&transfer.file)?;
                (transfer, progress, "holds")
            }
            Direction::Import(transfer) => {
                let progress = transfer.place.open()?.store.import(&transfer.file)?;
                (transfer, progress, "was taken over; the progress now has")
            }
        };
        let known = Known {
            exercises: progress.exercises.len(),
            solved: progress
                .exercises
                .values()
                .filter(|entry| entry.solved.is_some())
                .count(),
        };
        if transfer.json {
            print_json(&known)?;
        } else {
            let sentence = format!(
                "{} {what} {} exercises begun, {} of them solved. The answers themselves are files; copy the folder to take them along.",
                paint(CODE, transfer.file.display()),
                known.exercises,
                known.solved,
            );
            print(&wrapped(&sentence, "", ""))?;
        }
        Ok(Outcome::Fine)
    }
}
