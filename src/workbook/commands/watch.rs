//! `watch`: checks the answer whenever it is saved.

use std::io::{self, Write};
use std::sync::mpsc;
use std::time::Duration;

use clap::Args;
use notify_debouncer_full::notify::RecursiveMode;
use notify_debouncer_full::{DebounceEventResult, new_debouncer};

use super::check::{check, checker, feedback};
use super::{Desk, Place, PracticeError, print};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::Checker;
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{CODE, FAINT, paint, width};
use crate::workbook::practice::{shown, typed};

/// How long a file must be quiet before it is read.
///
/// Editors save in several steps within a few milliseconds, and the verdict should be there soon.
const QUIET: Duration = Duration::from_millis(40);

/// The arguments of `watch`.
#[derive(Debug, Args)]
pub struct Watch {
    /// The exercise; without it, the one begun last
    name: Option<String>,
    /// Print a verdict as JSON, one a line
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

impl Watch {
    /// Runs the command until Ctrl-C.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        let progress = desk.progress()?;
        let exercise = desk.exercise_or_last(self.name.as_deref(), &progress)?;
        let name = &exercise.name;
        let Some(tested) = &exercise.tested else {
            return Err(PracticeError::Unfit(format!(
                "`{name}` is an explanation, which no test can judge\nnext step: `cargo run -- {}` shows what a good answer says",
                typed(&format!("check {name}"), exercise)
            )));
        };
        let file = desk.answers.file(exercise);
        let Some(mut last) = desk.answers.read(exercise)? else {
            return Err(PracticeError::not_begun(exercise));
        };
        let (sender, changes) = mpsc::channel();
        let unwatchable = |error| {
            PracticeError::Unfit(format!(
                "`{}` cannot be watched: {error}\nnext step: run `cargo run -- check` after each change",
                shown(&file).display()
            ))
        };
        let mut debouncer = new_debouncer(QUIET, None, move |result: DebounceEventResult| {
            // The receiver is gone only when the process ends.
            let _ = sender.send(result);
        })
        .map_err(unwatchable)?;
        // Not the file itself: many editors put a new file in its place.
        if let Some(folder) = file.parent() {
            debouncer
                .watch(folder, RecursiveMode::NonRecursive)
                .map_err(unwatchable)?;
        }
        // The library is asked for once; it takes a tenth of a second to see that it is up to date.
        let checker = checker(&desk)?;
        self.tell(&desk, exercise, tested, &checker)?;
        for _ in changes {
            // While an editor saves, there may be no file; what is saved twice is checked once.
            match desk.answers.read(exercise)? {
                Some(text) if text != last => last = text,
                _ => continue,
            }
            self.tell(&desk, exercise, tested, &checker)?;
        }
        Ok(Outcome::Fine)
    }

    /// Checks once and prints what there is to say.
    fn tell(
        &self,
        desk: &Desk,
        exercise: &Exercise,
        tested: &Tested,
        checker: &Checker,
    ) -> Result<(), PracticeError> {
        let verdict = check(desk, exercise, tested, checker)?;
        if self.json {
            let line = serde_json::to_string(&verdict).map_err(io::Error::from)?;
            let mut out = io::stdout();
            writeln!(out, "{line}")?;
            out.flush()?;
            return Ok(());
        }
        let rule = "─".repeat(width());
        let file = shown(&desk.answers.file(exercise));
        print(&format!(
            "{}\n{}\n{} {} {}\n",
            paint(FAINT, rule),
            feedback(desk, exercise, &verdict, " and save it")?.trim_end(),
            paint(FAINT, "Waiting until"),
            paint(CODE, file.display()),
            paint(FAINT, "is saved; Ctrl-C stops."),
        ))
    }
}
