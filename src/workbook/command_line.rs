//! The commands, their arguments and exit statuses.
//!
//! | status | means |
//! |---|---|
//! | 0 | fine |
//! | 1 | what was checked falls short |
//! | 2 | it could not run |

use std::io::{Write, stdin, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::{Args, Parser, Subcommand};
use indicatif::ProgressBar;
use thiserror::Error;

#[cfg(unix)]
use super::checking;
use super::live_figures::{self, LiveFiguresError};
#[cfg(unix)]
use super::practice;
#[cfg(unix)]
use super::sandbox::supervisor;
use super::{commands, house, scaffold, watch};
use crate::book::build::build_with;
use crate::book::error::{BookError, BookErrors, Problem};
use crate::book::preprocessor::{self, Workbook};

/// The CAGD workbook: without a command it builds the book, serves it and follows your edits.
#[derive(Debug, Parser)]
#[command(name = "workbook", bin_name = "cargo run --", version)]
#[command(args_conflicts_with_subcommands = true)]
#[command(after_help = "Exit status: 0 fine, 1 what was checked falls short, 2 it could not run.")]
struct CommandLine {
    #[command(flatten)]
    serve: Serve,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Args)]
struct Serve {
    /// The port on 127.0.0.1; 0 takes any free one
    #[arg(long, default_value_t = 3000)]
    port: u16,
    /// Open the book in the browser
    #[arg(long)]
    open: bool,
    /// The folder of the answers, instead of `answers`
    #[arg(long, value_name = "DIR", hide = true)]
    answers: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Write the static site
    Build {
        /// The folder to write
        #[arg(long, value_name = "DIR", default_value = "target/book")]
        out: PathBuf,
        /// Leave out the solutions of the exercises, to hand the site out
        #[arg(long)]
        without_solutions: bool,
    },
    /// Show the evidence for every statement and what is missing
    Coverage(commands::coverage::AskedCoverage),
    /// Prove exercises sound: the starter fails, the solution passes, every wrong answer is rejected
    #[cfg(unix)]
    Verify(commands::verify::Verify),
    /// Scaffold an exercise
    New(commands::new::New),
    /// Check what students have handed in
    #[cfg(unix)]
    Grade(commands::grade::Grade),
    /// Show the exercises and how far you are
    #[cfg(unix)]
    List(commands::list::List),
    /// Begin an exercise: shows the task and makes the file of your answer
    #[cfg(unix)]
    Start(commands::start::Start),
    /// Compile and test your answer
    #[cfg(unix)]
    Check(commands::check::Check),
    /// Check your answer whenever you save it
    #[cfg(unix)]
    Watch(commands::watch::Watch),
    /// Show one more hint
    #[cfg(unix)]
    Hint(commands::hint::Hint),
    /// Show the solution: once you have solved it, or when you ask twice
    #[cfg(unix)]
    Solution(commands::solution::Solution),
    /// Begin an exercise anew; your answer is kept as a backup
    #[cfg(unix)]
    Reset(commands::reset::Reset),
    /// Take your progress to another computer
    #[cfg(unix)]
    Progress(commands::progress::Progress),
    /// Name what to do next
    #[cfg(unix)]
    Next(commands::next::Next),
    /// Refine a mesh of your own: reads and writes OBJ, OFF and PLY
    #[cfg(unix)]
    Subdivide(commands::subdivide::Subdivide),
    /// Speak mdBook's preprocessor protocol; `mdbook` calls this
    #[command(hide = true)]
    Preprocessor {
        #[command(subcommand)]
        question: Option<Question>,
    },
    /// Stand between the workbook and somebody's program; the sandbox calls this
    #[cfg(unix)]
    #[command(hide = true)]
    Supervise(supervisor::Order),
}

#[derive(Debug, Subcommand)]
enum Question {
    /// Whether the preprocessor is made for this renderer
    Supports {
        /// The name of the renderer
        renderer: String,
    },
}

/// What ends a command with status 2.
#[derive(Debug, Error)]
pub(crate) enum Failure {
    #[error(transparent)]
    House(#[from] house::NoHouse),
    #[error("{0}")]
    Book(#[from] BookErrors),
    #[error(transparent)]
    Serve(#[from] watch::ServeError),
    #[error(transparent)]
    Scaffold(#[from] scaffold::ScaffoldError),
    #[cfg(unix)]
    #[error(transparent)]
    Checking(#[from] checking::CheckingError),
    #[error("there is no exercise `{name}`{}\nnext step: `cargo run -- list` shows all of them", did_you_mean(similar.as_deref()))]
    NoExercise {
        name: String,
        similar: Option<String>,
    },
    #[error(
        "the pack `{}` cannot be read ({reason})\n\
         next step: name the folder that holds `<chapter>/<name>/exercise.md`",
        pack.display()
    )]
    Pack { pack: PathBuf, reason: String },
    #[cfg(unix)]
    #[error(transparent)]
    Grade(#[from] super::grade::GradeError),
    #[cfg(unix)]
    #[error(transparent)]
    Command(#[from] practice::PracticeError),
    #[cfg(unix)]
    #[error(transparent)]
    Subdivide(#[from] commands::subdivide::SubdivideError),
    #[error(transparent)]
    LiveFigures(#[from] LiveFiguresError),
    #[error("{0}")]
    Preprocessor(String),
    #[error(
        "`{}` holds files that are not a built book, and building would remove them\n\
         next step: name a new or an empty folder with `--out`",
        .0.display()
    )]
    Precious(PathBuf),
    #[error("cannot write the answer: {0}")]
    Output(#[from] std::io::Error),
}

/// The suggestion behind a name that is not there.
fn did_you_mean(similar: Option<&str>) -> String {
    similar.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

impl Failure {
    fn is_broken_pipe(&self) -> bool {
        let error = match self {
            Self::Output(error) => error,
            #[cfg(unix)]
            Self::Command(practice::PracticeError::Output(error)) => error,
            #[cfg(unix)]
            Self::Subdivide(commands::subdivide::SubdivideError::Answer(error)) => error,
            _ => return false,
        };
        error.kind() == std::io::ErrorKind::BrokenPipe
    }
}

/// How a command that ran ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    Fine,
    FallsShort,
    /// Part of it could not run; what is known has been printed.
    CouldNotRun,
}

/// Runs the command that the process was started with and returns its exit status.
#[must_use]
pub fn run() -> ExitCode {
    match execute(CommandLine::parse()) {
        Ok(Outcome::Fine) => ExitCode::SUCCESS,
        Ok(Outcome::FallsShort) => ExitCode::from(1),
        Ok(Outcome::CouldNotRun) => ExitCode::from(2),
        // A reader that closes the pipe early, such as `head`, has what it wanted.
        Err(failure) if failure.is_broken_pipe() => ExitCode::SUCCESS,
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
        None => {
            let Serve {
                port,
                open,
                answers,
            } = line.serve;
            let answers = answers.map(std::path::absolute).transpose()?;
            watch::serve(&house::find()?, port, open, answers.as_deref())?;
            Ok(Outcome::Fine)
        }
        Some(Command::Build {
            out,
            without_solutions,
        }) => {
            // A folder given on the command line is meant from where the reader stands, the default from the root.
            let root = house::find()?;
            let out = if out.as_os_str() == "target/book" {
                root.join(out)
            } else {
                out
            };
            build(&root, &out, without_solutions)
        }
        Some(Command::Coverage(asked)) => asked.run(),
        #[cfg(unix)]
        Some(Command::Verify(verify)) => verify.run(),
        Some(Command::New(new)) => new.run(),
        #[cfg(unix)]
        Some(Command::Grade(grade)) => grade.run(),
        #[cfg(unix)]
        Some(Command::List(list)) => Ok(list.run()?),
        #[cfg(unix)]
        Some(Command::Start(start)) => Ok(start.run()?),
        #[cfg(unix)]
        Some(Command::Check(check)) => Ok(check.run()?),
        #[cfg(unix)]
        Some(Command::Watch(watch)) => Ok(watch.run()?),
        #[cfg(unix)]
        Some(Command::Hint(hint)) => Ok(hint.run()?),
        #[cfg(unix)]
        Some(Command::Solution(solution)) => Ok(solution.run()?),
        #[cfg(unix)]
        Some(Command::Reset(reset)) => Ok(reset.run()?),
        #[cfg(unix)]
        Some(Command::Progress(progress)) => Ok(progress.run()?),
        #[cfg(unix)]
        Some(Command::Next(next)) => Ok(next.run()?),
        #[cfg(unix)]
        Some(Command::Subdivide(subdivide)) => Ok(subdivide.run()?),
        Some(Command::Preprocessor { question }) => preprocessor(question),
        #[cfg(unix)]
        Some(Command::Supervise(order)) => {
            supervisor::supervise(&order);
            Ok(Outcome::Fine)
        }
    }
}

/// A book with errors falls short; a folder that cannot be written keeps the command from running.
fn build(root: &Path, out: &Path, without_solutions: bool) -> Result<Outcome, Failure> {
    if is_precious(out) {
        return Err(Failure::Precious(out.to_path_buf()));
    }
    let workbook = match without_solutions {
        true => Workbook::default().without_solutions(),
        false => Workbook::default(),
    };
    let waiting = ProgressBar::new_spinner().with_message("compiling the live figures");
    waiting.enable_steady_tick(Duration::from_millis(100));
    let scripts = live_figures::scripts(root);
    waiting.finish_and_clear();
    let more = scripts.unwrap_or_else(|error| {
        // The site is whole without them: its figures are pictures.
        eprintln!("{error}");
        Vec::new()
    });
    match build_with(root, out, workbook, &more) {
        Ok(_) => {
            writeln!(
                stdout(),
                "The book is in {}.",
                out.join("index.html").display()
            )?;
            Ok(Outcome::Fine)
        }
        Err(errors) if errors.iter().any(is_about_the_output) => Err(errors.into()),
        Err(errors) => {
            eprintln!("{errors}");
            Ok(Outcome::FallsShort)
        }
    }
}

/// Whether a build would remove something that no build has put there.
fn is_precious(out: &Path) -> bool {
    let holds_something = std::fs::read_dir(out).is_ok_and(|mut entries| entries.next().is_some());
    let is_book = out.join("index.html").is_file() && out.join("toc.html").is_file();
    holds_something && !is_book
}

fn is_about_the_output(error: &BookError) -> bool {
    matches!(error.problem, Problem::Output { .. })
}

/// mdBook asks first whether the renderer is supported, then hands over the book.
fn preprocessor(question: Option<Question>) -> Result<Outcome, Failure> {
    match question {
        Some(Question::Supports { renderer }) if preprocessor::supports(&renderer) => {
            Ok(Outcome::Fine)
        }
        Some(Question::Supports { .. }) => Ok(Outcome::FallsShort),
        None => {
            preprocessor::run_as_command(stdin().lock(), stdout().lock())
                .map_err(|error| Failure::Preprocessor(format!("{error:#}")))?;
            Ok(Outcome::Fine)
        }
    }
}
