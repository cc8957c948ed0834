//! `check`: compiles and tests the reader's answer.

use std::thread;

use clap::Args;

use super::start::starter_changed;
use super::{Desk, Place, PracticeError, print, print_json};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::checking::{Checker, Verdict};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{CODE, STRONG, paint};
use crate::workbook::feedback::patience::patiently;
use crate::workbook::feedback::report::{command, described};
use crate::workbook::feedback::{braille, markdown, picture, terminal};
use crate::workbook::practice::check::keep_picture;
use crate::workbook::practice::{self, shown, typed};
use crate::workbook::progress::Progress;
use crate::workbook::sandbox::Isolation;

/// The arguments of `check`.
#[derive(Debug, Args)]
pub struct Check {
    /// The exercise; without it, the one begun last
    name: Option<String>,
    /// Mark an explanation as done, after you have compared it with the model answer
    #[arg(long)]
    done: bool,
    /// Print the verdict as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

impl Check {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        // How programs are kept apart is found out by trying, while the exercises are read.
        let desk = thread::scope(|scope| {
            scope.spawn(Isolation::best);
            self.place.open()
        })?;
        let progress = desk.progress()?;
        let exercise = desk.exercise_or_last(self.name.as_deref(), &progress)?;
        let Some(tested) = &exercise.tested else {
            return super::explain::check(&desk, exercise, self.done, self.json);
        };
        if self.done {
            let name = &exercise.name;
            return Err(PracticeError::Unfit(format!(
                "`{name}` is judged by its tests; `--done` is for explanations\nnext step: `cargo run -- {}`",
                typed(&format!("check {name}"), exercise)
            )));
        }
        let verdict = check(&desk, exercise, tested, &checker(&desk)?)?;
        if self.json {
            print_json(&verdict)?;
        } else {
            print(&feedback(
                &desk,
                exercise,
                &verdict,
                &format!(", then {}", command(&typed("check", exercise))),
            )?)?;
        }
        Ok(if verdict.passed() {
            Outcome::Fine
        } else {
            Outcome::FallsShort
        })
    }
}

/// What checks answers; the library is compiled if that is needed.
pub(super) fn checker(desk: &Desk) -> Result<Checker, PracticeError> {
    let what = "The library is compiled for your answers; this happens once";
    Ok(patiently(what, || {
        Checker::new(&desk.root, Isolation::best())
    })?)
}

/// Checks the answer and remembers how it ended.
pub(super) fn check(
    desk: &Desk,
    exercise: &Exercise,
    tested: &Tested,
    checker: &Checker,
) -> Result<Verdict, PracticeError> {
    patiently("Your answer is compiled and tested", || {
        practice::check::check(desk, exercise, tested, checker)
    })
}

/// All that the reader is told about a verdict.
///
/// `afterwards` says how a mended answer is checked.
pub(super) fn feedback(
    desk: &Desk,
    exercise: &Exercise,
    verdict: &Verdict,
    afterwards: &str,
) -> Result<String, PracticeError> {
    let progress = desk.progress()?;
    let strokes = picture::strokes(verdict);
    let drawn = terminal::can_draw()
        .then(|| braille::drawn(strokes, terminal::has_colours()))
        .flatten();
    let mut text = described(verdict, &exercise.front.title, drawn.as_deref());
    if let Some(file) = keep_picture(desk, exercise, verdict) {
        let file = shown(&file).display().to_string();
        text.push_str(&format!("\n  picture  {}\n", paint(CODE, file)));
    }
    if verdict.passed() {
        text.push_str(&after_success(desk, exercise, &progress));
        return Ok(text);
    }
    let entry = progress.of(&exercise.name);
    if desk.starter_changed(exercise, &entry) {
        text.push('\n');
        text.push_str(&starter_changed(exercise));
    }
    let file = shown(&desk.answers.file(exercise));
    text.push_str(&format!(
        "\nnext step: mend {}{afterwards}\n",
        paint(CODE, file.display()),
    ));
    let left = exercise.document.hints.len().saturating_sub(entry.hints);
    if left > 0 {
        text.push_str(&format!(
            "           or take a hint: {}\n",
            command(&typed("hint", exercise))
        ));
    }
    Ok(text)
}

/// What is worth knowing once it is solved, and what comes next.
pub(super) fn after_success(desk: &Desk, exercise: &Exercise, progress: &Progress) -> String {
    let mut text = String::new();
    if let Some(afterwards) = &exercise.document.afterwards {
        text.push_str(&format!("\n{}\n\n", paint(STRONG, "Afterwards")));
        text.push_str(&markdown::rendered(&afterwards.text, &desk.catalogue));
    }
    text.push('\n');
    text.push_str(&super::next::sentence(desk, progress));
    text
}
