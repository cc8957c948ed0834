//! `start`: begins an exercise.

use clap::Args;
use serde::Serialize;

use super::{Desk, Place, PracticeError, print, print_json};
use crate::book::exercise::{Exercise, ExerciseKind};
use crate::workbook::answers::Begun;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::markdown;
use crate::workbook::feedback::paint::{ATTENTION, CODE, FAINT, STRONG, paint, wrapped};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::begin::{Fresh, any_seed, begin, begin_fresh};
use crate::workbook::practice::{shown, typed};
use crate::workbook::progress::Progress;

/// The arguments of `start`.
#[derive(Debug, Args)]
pub struct Start {
    /// The exercise: `chapter/name`, or the name alone
    name: String,
    /// Deal fresh numbers for a tableau, the same ones for the same seed; your answer so far is kept as a backup
    #[arg(long, value_name = "SEED", num_args = 0..=1)]
    fresh: Option<Option<u64>>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// What `start --json` prints.
#[derive(Debug, Serialize)]
struct Started {
    exercise: String,
    file: String,
    /// Whether the file is new; an answer that was there is left alone.
    new: bool,
    /// With which seed fresh numbers were dealt.
    seed: Option<u64>,
    /// Where the answer with the former numbers is kept.
    backup: Option<String>,
    task: String,
}

impl Start {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        let exercise = desk.exercise(&self.name)?;
        let fresh = self
            .fresh
            .map(|seed| Fresh::deal(exercise, seed.unwrap_or_else(any_seed)))
            .transpose()?;
        // The package is new with its first answer; then the reader is told how an editor completes in it.
        let is_first = !desk.answers.folder().join("Cargo.toml").is_file();
        let (begun, backup) = match &fresh {
            Some(fresh) => begin_fresh(&desk, exercise, fresh)?,
            None => (begin(&desk, exercise, None)?, None),
        };
        let file = shown(&desk.answers.file(exercise)).display().to_string();
        if self.json {
            print_json(&Started {
                exercise: exercise.name.to_string(),
                file,
                new: begun == Begun::New,
                seed: fresh.map(|fresh| fresh.seed),
                backup: backup.map(|file| shown(&file).display().to_string()),
                task: exercise.document.task.text.clone(),
            })?;
            return Ok(Outcome::Fine);
        }
        let progress = desk.progress()?;
        let mut text = task(&desk, exercise);
        text.push('\n');
        text.push_str(&builds_on(&desk, &progress, exercise));
        match begun {
            Begun::New => text.push_str(&format!("Your file: {}\n", paint(CODE, &file))),
            Begun::AlreadyThere => {
                text.push_str(&format!(
                    "Your file: {} (it was there already and is as you left it)\n",
                    paint(CODE, &file)
                ));
                if desk.starter_changed(exercise, &progress.of(&exercise.name)) {
                    text.push_str(&starter_changed(exercise));
                }
            }
        }
        if let Some(fresh) = &fresh {
            let same = format!("start {} --fresh {}", exercise.name, fresh.seed);
            let same = command(&typed(&same, exercise));
            let note = format!("It has fresh numbers; {same} deals the same ones again.");
            text.push_str(&wrapped(&note, "", ""));
        }
        if let Some(backup) = backup {
            let backup = shown(&backup).display().to_string();
            text.push_str(&format!("Your answer before: {}\n", paint(CODE, backup)));
        }
        if is_first {
            let folder = shown(desk.answers.folder()).display().to_string();
            let note = format!(
                "Open the folder {} in your editor: it is a small Cargo package, so that rust-analyzer completes.",
                paint(CODE, folder)
            );
            text.push_str(&wrapped(&note, "", ""));
        }
        text.push_str(&what_next(exercise));
        print(&text)?;
        Ok(Outcome::Fine)
    }
}

/// The task with its heading.
fn task(desk: &Desk, exercise: &Exercise) -> String {
    let front = &exercise.front;
    let facts = format!(
        "{} · {} · difficulty {} of 5 · about {} minutes",
        exercise.name,
        front.kind.title(),
        front.difficulty,
        front.minutes
    );
    format!(
        "{}\n{}\n\n{}",
        paint(STRONG, &front.title),
        paint(FAINT, wrapped(&facts, "", "").trim_end()),
        markdown::rendered(&exercise.document.task.text, &desk.catalogue)
    )
}

/// What should have been solved before, and is not.
fn builds_on(desk: &Desk, progress: &Progress, exercise: &Exercise) -> String {
    let open: Vec<String> = exercise
        .front
        .prerequisites
        .iter()
        .filter(|name| !progress.is_solved(name))
        .filter_map(|name| desk.exercises.get(name))
        .map(|before| format!("“{}” ({})", before.front.title, before.name))
        .collect();
    if open.is_empty() {
        return String::new();
    }
    let note = format!("It builds on {}, not solved yet.", open.join(" and "));
    wrapped(&note, &paint(ATTENTION, "» "), "  ") + "\n"
}

/// That the starter is another one now, and what to do about it.
pub(super) fn starter_changed(exercise: &Exercise) -> String {
    let note = format!(
        "The starter has changed since you began. Your answer is left alone. {} gives you the new starter and keeps your answer as a backup.",
        command(&typed(&format!("reset {}", exercise.name), exercise))
    );
    wrapped(&note, &paint(ATTENTION, "» "), "  ")
}

fn what_next(exercise: &Exercise) -> String {
    let of = |words| command(&typed(words, exercise));
    let (check, hint) = (of("check"), of("hint"));
    if exercise.front.kind == ExerciseKind::Explain {
        return format!("\n{check}  shows what a good answer says\n{hint}   helps a little\n");
    }
    let watch = of("watch");
    format!(
        "\n{check}  tests your answer\n{watch}  tests it whenever you save\n{hint}   helps a little\n"
    )
}
