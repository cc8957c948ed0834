//! Where exercises and answers are, and how a command names them.

use std::path::{Path, PathBuf};

use clap::Args;

use super::PracticeError;
use crate::book::exercise::Exercise;
use crate::workbook::answers;
use crate::workbook::house;
use crate::workbook::practice::{Desk, typed};
use crate::workbook::progress::Progress;

/// Where exercises and answers are.
#[derive(Debug, Args)]
pub struct Place {
    /// A folder with more exercises, laid out like `book/exercises`; may be given again
    #[arg(long = "pack", value_name = "DIR")]
    packs: Vec<PathBuf>,
    /// The folder of the answers, instead of `answers`
    #[arg(long, value_name = "DIR", hide = true)]
    answers: Option<PathBuf>,
}

impl Place {
    /// Reads the exercises and finds the answers.
    ///
    /// # Errors
    ///
    /// There is no workbook here, or the exercises have errors.
    pub fn open(&self) -> Result<Desk, PracticeError> {
        let root = house::find()?;
        // A folder on the command line is meant from where the reader stands.
        let absolute = |path: &Path| std::path::absolute(path).map_err(PracticeError::Output);
        let pack = |pack: &PathBuf| match pack.canonicalize() {
            Ok(folder) if folder.is_dir() => Ok(folder),
            _ => Err(PracticeError::Unfit(format!(
                "there is no folder `{}`\nnext step: name the folder that holds the chapters of the pack",
                pack.display()
            ))),
        };
        let packs: Vec<PathBuf> = self.packs.iter().map(pack).collect::<Result<_, _>>()?;
        let folder = match &self.answers {
            Some(folder) => absolute(folder)?,
            None => root.join(answers::FOLDER),
        };
        let desk = Desk::open(&root, &packs, &folder)?;
        if let Some(mistakes) = &desk.mistakes.all {
            anstream::eprintln!("{mistakes}\n");
        }
        Ok(desk)
    }
}

/// The arguments of the next command, such as `hint`: with the name where without it another exercise would be meant.
pub fn about(command: &str, exercise: &Exercise, progress: &Progress) -> String {
    if progress.begun_last.as_ref() == Some(&exercise.name) {
        typed(command, exercise)
    } else {
        typed(&format!("{command} {}", exercise.name), exercise)
    }
}
