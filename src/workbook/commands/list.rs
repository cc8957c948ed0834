//! `list`: the exercises and how far the reader is.

use clap::Args;
use clap::builder::PossibleValuesParser;
use serde::Serialize;

use super::{Desk, Place, PracticeError, print, print_json};
use crate::book::catalogue::CHAPTERS;
use crate::book::exercise::{Exercise, ExerciseKind, ExerciseName};
use crate::workbook::command_line::Outcome;
use crate::workbook::feedback::paint::{
    ATTENTION, FAINT, GOOD, STRONG, columns, cut, padded, paint, width, wrapped,
};
use crate::workbook::feedback::report::command;
use crate::workbook::practice::typed;
use crate::workbook::progress::Progress;

/// The arguments of `list`.
#[derive(Debug, Args)]
pub struct List {
    /// Only this chapter; may be given again
    #[arg(long, value_name = "C", value_parser = PossibleValuesParser::new(CHAPTERS))]
    chapter: Vec<String>,
    /// Only what trains this statement
    #[arg(long, value_name = "ID")]
    statement: Option<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    place: Place,
}

/// How far the reader is with one exercise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
enum State {
    Open,
    Begun,
    Solved,
}

/// How many columns a title needs to say something; with fewer it stands below the name.
const TITLE: usize = 20;

/// A line of the list.
#[derive(Debug, Serialize)]
struct Item<'a> {
    exercise: &'a ExerciseName,
    title: &'a str,
    kind: ExerciseKind,
    difficulty: u8,
    minutes: u32,
    statements: &'a [String],
    prerequisites: &'a [ExerciseName],
    state: State,
    hints_shown: usize,
    hints: usize,
    checks: u32,
    /// The starter is another than the one with which the reader began.
    starter_changed: bool,
    /// The command that gives the new one.
    #[serde(skip)]
    reset: String,
}

impl List {
    /// Runs the command.
    ///
    /// # Errors
    ///
    /// It could not run.
    pub(crate) fn run(self) -> Result<Outcome, PracticeError> {
        let desk = self.place.open()?;
        if let Some(id) = &self.statement
            && let Err(problem) = desk.catalogue.require(id)
        {
            return Err(PracticeError::Unfit(problem.to_string()));
        }
        let progress = desk.progress()?;
        let items: Vec<Item<'_>> = desk
            .exercises
            .iter()
            .filter(|exercise| {
                let chapter = exercise.name.chapter();
                self.chapter.is_empty() || self.chapter.iter().any(|c| c == chapter)
            })
            .filter(|exercise| {
                let statements = &exercise.front.statements;
                self.statement
                    .as_ref()
                    .is_none_or(|id| statements.contains(id))
            })
            .map(|exercise| item(&desk, &progress, exercise))
            .collect();
        if self.json {
            print_json(&items)?;
            return Ok(Outcome::Fine);
        }
        let mut text = shown(&items);
        let is_whole = self.chapter.is_empty() && self.statement.is_none();
        if is_whole {
            text.push_str(&vanished(&desk, &progress));
        }
        print(&text)?;
        Ok(Outcome::Fine)
    }
}

fn item<'a>(desk: &Desk, progress: &Progress, exercise: &'a Exercise) -> Item<'a> {
    let entry = progress.of(&exercise.name);
    let state = if entry.solved.is_some() {
        State::Solved
    } else if entry.begun.is_some() || desk.is_begun(exercise) {
        State::Begun
    } else {
        State::Open
    };
    Item {
        exercise: &exercise.name,
        title: &exercise.front.title,
        kind: exercise.front.kind,
        difficulty: exercise.front.difficulty,
        minutes: exercise.front.minutes,
        statements: &exercise.front.statements,
        prerequisites: &exercise.front.prerequisites,
        state,
        hints_shown: entry.hints.min(exercise.document.hints.len()),
        hints: exercise.document.hints.len(),
        checks: entry.checks,
        starter_changed: state == State::Begun && desk.starter_changed(exercise, &entry),
        reset: typed(&format!("reset {}", exercise.name), exercise),
    }
}

fn shown(items: &[Item<'_>]) -> String {
    if items.is_empty() {
        return format!(
            "No exercise fits.\nnext step: {} shows all of them\n",
            command("list")
        );
    }
    // The chapter stands above, so the name alone will do, unless it leaves open which exercise is meant.
    let name = |item: &Item<'_>| {
        let own = item.exercise.name();
        let same = items.iter().filter(|other| other.exercise.name() == own);
        if same.count() == 1 {
            own.to_owned()
        } else {
            item.exercise.to_string()
        }
    };
    let widest = items.iter().map(|item| columns(&name(item))).max();
    let widest = widest.unwrap_or_default();
    // The sign, the dots, the minutes and the blanks between take 21 columns.
    let room = width().saturating_sub(widest + 21);
    let mut text = String::new();
    let mut chapter = "";
    for item in items {
        if item.exercise.chapter() != chapter {
            chapter = item.exercise.chapter();
            let of_chapter = || items.iter().filter(|i| i.exercise.chapter() == chapter);
            let solved = of_chapter().filter(|i| i.state == State::Solved).count();
            if !text.is_empty() {
                text.push('\n');
            }
            let count = format!("{solved} of {} solved", of_chapter().count());
            text.push_str(&format!("{} · {count}\n", paint(STRONG, chapter)));
        }
        let sign = match item.state {
            State::Open => " ".to_owned(),
            State::Begun => paint(ATTENTION, "›"),
            State::Solved => paint(GOOD, "✓"),
        };
        let difficulty = usize::from(item.difficulty.min(5));
        let dots = format!("{}{}", "●".repeat(difficulty), "○".repeat(5 - difficulty));
        let minutes = item.minutes;
        if room >= TITLE {
            text.push_str(&format!(
                " {sign} {}  {}  {dots} {minutes:>3} min\n",
                padded(&name(item), widest),
                padded(&cut(item.title, room), room),
            ));
        } else {
            text.push_str(&format!(" {sign} {}\n", name(item)));
            let facts = format!("   {dots} {minutes:>3} min  ");
            text.push_str(&wrapped(item.title, &facts, &" ".repeat(columns(&facts))));
        }
        if item.starter_changed {
            let note = format!(
                "the starter has changed since you began; {} gives you the new one and keeps your answer",
                command(&item.reset)
            );
            text.push_str(&wrapped(&note, "     ", "     "));
        }
    }
    // Blanks that do not break, so that a sign stays with its word.
    let legend = "✓\u{a0}solved\u{a0}\u{a0} ›\u{a0}begun\u{a0}\u{a0} ●○○○○\u{a0}first\u{a0}steps … ●●●●●\u{a0}exam";
    let legend = wrapped(legend, "", "");
    text.push_str(&format!("\n{}\n", paint(FAINT, legend.trim_end())));
    let sentence = format!(
        "{} begins one; {} names the next.",
        command("start NAME"),
        command("next")
    );
    text.push_str(&wrapped(&sentence, "", ""));
    text
}

/// What the progress knows and the book does not.
fn vanished(desk: &Desk, progress: &Progress) -> String {
    let names: Vec<String> = progress
        .exercises
        .keys()
        .filter(|name| desk.exercises.get(name).is_none())
        .map(ToString::to_string)
        .collect();
    if names.is_empty() {
        return String::new();
    }
    let sentence = format!(
        "Not in the book (any more): {}. Your answers and your progress are kept. \
         If they belong to a pack, name it with `--pack`.",
        names.join(", ")
    );
    format!("\n{}", wrapped(&sentence, "", ""))
}
