//! `cargo run -- new …`: scaffolds.

use std::io::Write;
use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Args, Subcommand};

use crate::book::catalogue::Catalogue;
use crate::book::exercise::{ExerciseKind, ExerciseName, Exercises};
use crate::workbook::command_line::{Failure, Outcome};
use crate::workbook::{house, scaffold};

/// What `new` is asked.
#[derive(Debug, Args)]
pub struct New {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Scaffold an exercise that works, with a to-do for everything that you have to say
    Exercise {
        /// Its name, `chapter/name`; it is for ever
        #[arg(value_name = "CHAPTER/NAME")]
        name: ExerciseName,
        /// What it asks for
        #[arg(long, default_value = "implement", value_parser = kinds())]
        kind: String,
        /// Write it into this pack
        #[arg(long, value_name = "DIR")]
        pack: Option<PathBuf>,
    },
}

fn kinds() -> PossibleValuesParser {
    PossibleValuesParser::new(ExerciseKind::ALL.map(ExerciseKind::name))
}

impl New {
    /// Writes the scaffold.
    ///
    /// # Errors
    ///
    /// The workbook is not found, or the scaffold cannot be written.
    pub(crate) fn run(&self) -> Result<Outcome, Failure> {
        let What::Exercise { name, kind, pack } = &self.what;
        let kind = ExerciseKind::ALL
            .into_iter()
            .find(|known| known.name() == kind)
            .unwrap_or(ExerciseKind::Implement);
        let root = house::find()?;
        let catalogue = Catalogue::load(&root)?;
        let packs: Vec<PathBuf> = pack
            .iter()
            .map(std::path::absolute)
            .collect::<Result<_, _>>()?;
        let exercises = Exercises::load(&root, &packs, &catalogue)?;
        let pack = packs.first().map(PathBuf::as_path);
        let folder = scaffold::exercise(&root, pack, name, kind, &catalogue, &exercises)?;
        let option = pack.map_or_else(String::new, |pack| format!("--pack {} ", pack.display()));
        writeln!(
            std::io::stdout(),
            "The exercise is in {}.\nnext step: `cargo run -- verify {option}{name}` lists what is to do",
            folder.display()
        )?;
        Ok(Outcome::Fine)
    }
}
