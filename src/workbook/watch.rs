//! What to do when a source changes.
//!
//! Pages, figures' snapshots, tests and the theme are read again at once.
//! A change of the Rust sources needs a new program: Cargo builds it while the old one goes on serving, then the
//! new program takes the old one's place.
//! If either fails, the last good book stays, and the page and the terminal show what is wrong.

use std::ffi::OsString;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::process::Command;
use std::sync::mpsc;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use notify_debouncer_full::notify::{self, RecursiveMode};
use notify_debouncer_full::{DebounceEventResult, new_debouncer};
use thiserror::Error;
use tokio::sync::watch;

use super::server::{self, Book, ServerError, State, Token, token};
use crate::book;

/// How long the sources must be quiet before a change is acted on.
///
/// Editors save in several steps within a few milliseconds; a reader does not notice 0.2 s.
const QUIET: Duration = Duration::from_millis(200);

/// The parts of the house that the book is made from.
const WATCHED: [&str; 4] = ["book", "snapshots", "src", "tests"];

/// Why the book could not be served.
#[derive(Debug, Error)]
pub enum ServeError {
    /// The address cannot be had, or the server broke down.
    #[error(transparent)]
    Server(#[from] ServerError),
    /// The operating system gives no threads or timers.
    #[error("the server cannot start: {0}")]
    Runtime(#[source] io::Error),
    /// Changes cannot be noticed.
    #[error(
        "the sources cannot be watched: {0}\n\
         next step: if the limit of watched files is reached, raise it (Linux: fs.inotify.max_user_watches)"
    )]
    Watch(#[from] notify::Error),
}

/// Builds the book, serves it on `127.0.0.1:port` and follows the edits until Ctrl-C.
///
/// `open` shows it in the browser; `answers` is another folder of answers than that of the workbook. A book with errors does not end the server.
///
/// # Errors
///
/// [`ServeError`] if the port cannot be had or the sources cannot be watched.
pub fn serve(root: &Path, port: u16, open: bool, answers: Option<&Path>) -> Result<(), ServeError> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .map_err(ServeError::Runtime)?;
    // The port is taken before the build, so that a port in use is told at once; early visitors wait in its queue.
    let listener = runtime.block_on(server::listen(port))?;
    let address = listener.local_addr().map_err(ServerError::from)?;
    let token = Token::for_this_start()?;
    let link = format!("http://{address}/?token={}", token.text());

    let (mut workshop, state) = Workshop::open(root, address.port(), token.clone());
    workshop.answers = answers.map(Path::to_path_buf);
    let served = Book {
        root: root.to_path_buf(),
        folder: workshop.out.clone(),
        answers: answers.map_or_else(|| root.join("answers"), Path::to_path_buf),
        state,
        token,
    };
    let (sender, changes) = mpsc::channel();
    let mut debouncer = new_debouncer(QUIET, None, move |result: DebounceEventResult| {
        // The receiver is gone only when the process ends.
        let _ = sender.send(result);
    })?;
    for part in WATCHED {
        if root.join(part).is_dir() {
            debouncer.watch(root.join(part), RecursiveMode::Recursive)?;
        }
    }
    // Not its subfolders: the build's own output lies there.
    debouncer.watch(root, RecursiveMode::NonRecursive)?;

    workshop.build_book();
    println!("The book is open, and follows your edits, at\n\n    {link}\n");
    println!(
        "Whoever has this link may run code here; without `?token=…` the book can be read. Ctrl-C stops it."
    );
    if open && webbrowser::open(&link).is_err() {
        eprintln!("No browser could be opened; visit the address above.");
    }
    std::thread::spawn(move || {
        for result in changes {
            workshop.follow(result);
        }
    });
    runtime.block_on(server::serve(listener, served, server::ctrl_c()))?;
    println!("Stopped.");
    Ok(())
}

/// Where the book is built again and again.
struct Workshop {
    root: PathBuf,
    out: PathBuf,
    port: u16,
    token: Token,
    /// The folder of answers that was asked for.
    answers: Option<PathBuf>,
    /// The program as it was started; the path stays right when Cargo replaces the file.
    program: Option<PathBuf>,
    /// Differs between runs of the server, so that a page notices a restart.
    run: u128,
    builds: u32,
    good_builds: u32,
    book_error: Option<String>,
    program_error: Option<String>,
    state: watch::Sender<State>,
}

impl Workshop {
    fn open(root: &Path, port: u16, token: Token) -> (Self, watch::Receiver<State>) {
        let started = SystemTime::now().duration_since(UNIX_EPOCH);
        let (sender, receiver) = watch::channel(State::default());
        let workshop = Self {
            root: root.to_path_buf(),
            out: root.join("target/served-book"),
            port,
            token,
            answers: None,
            program: std::env::current_exe().ok(),
            run: started.map_or(0, |time| time.as_millis()),
            builds: 0,
            good_builds: 0,
            book_error: None,
            program_error: None,
            state: sender,
        };
        (workshop, receiver)
    }

    /// Acts on what the debouncer collected.
    fn follow(&mut self, result: DebounceEventResult) {
        let events = match result {
            Ok(events) => events,
            Err(errors) => {
                for error in errors {
                    eprintln!("A change may have gone unnoticed: {error}");
                }
                return;
            }
        };
        let mut changed: Vec<PathBuf> = events
            .iter()
            .filter(|event| !event.kind.is_access())
            .flat_map(|event| &event.paths)
            .filter_map(|path| path.strip_prefix(&self.root).ok())
            .filter(|path| is_source(path))
            .map(Path::to_path_buf)
            .collect();
        changed.sort();
        changed.dedup();
        let Some(first) = changed.first() else {
            return;
        };
        match changed.len() {
            1 => println!("{} changed.", first.display()),
            count => println!("{} and {} more changed.", first.display(), count - 1),
        }
        let compiled_in = self.compiled_in();
        let needs_program =
            |path: &PathBuf| is_of_the_program(path) || compiled_in.contains(&self.root.join(path));
        if changed.iter().any(needs_program) && !self.replace_program() {
            self.tell();
            return;
        }
        self.build_book();
    }

    /// The files that the compiler read, by Cargo's list beside the program; among them is a style sheet of the book.
    fn compiled_in(&self) -> Vec<PathBuf> {
        let list = self
            .program
            .as_ref()
            .map(|program| program.with_extension("d"));
        let list = list.and_then(|list| std::fs::read_to_string(list).ok());
        // As in a makefile: `program: file file …`, with blanks inside a name escaped.
        let list = list.unwrap_or_default().replace("\\ ", "\0");
        list.split_whitespace()
            .map(|name| PathBuf::from(name.replace('\0', " ")))
            .collect()
    }

    /// Builds the book; if that fails, the last good one stays.
    fn build_book(&mut self) {
        match book::build(&self.root, &self.out) {
            Ok(report) => {
                self.good_builds += 1;
                self.book_error = None;
                println!(
                    "The book is built ({:.2} s).",
                    report.duration.as_secs_f64()
                );
            }
            Err(errors) => {
                eprintln!("{errors}");
                if self.has_book() {
                    eprintln!("The last good book is still served.");
                }
                self.book_error = Some(errors.to_string());
            }
        }
        self.tell();
    }

    fn has_book(&self) -> bool {
        self.out.join("index.html").is_file()
    }

    /// Tells the open pages how things stand.
    fn tell(&mut self) {
        self.builds += 1;
        let errors: Vec<&str> = [&self.program_error, &self.book_error]
            .into_iter()
            .filter_map(|error| error.as_deref())
            .collect();
        self.state.send_replace(State {
            version: format!("{}-{}", self.run, self.good_builds),
            news: format!("{}-{}", self.run, self.builds),
            ready: self.has_book(),
            error: (!errors.is_empty()).then(|| errors.join("\n")),
        });
    }

    /// Builds the program anew and, if that succeeds, lets it take the place of this one.
    ///
    /// Returns whether this process may go on to build the book: not if the new program does not compile.
    fn replace_program(&mut self) -> bool {
        println!("The sources of the program changed: it is built anew …");
        let Some(program) = self.program.clone() else {
            eprintln!("Where this program lies is not known; stop it and run `cargo run` again.");
            return true;
        };
        match compile(&self.root, &program) {
            Err(message) => {
                eprintln!("{message}\nThe last good book is still served.");
                self.program_error = Some(message);
                false
            }
            Ok(()) => {
                self.program_error = None;
                let port = OsString::from(self.port.to_string());
                let mut arguments = vec!["--port".into(), port];
                if let Some(answers) = &self.answers {
                    arguments.extend(["--answers".into(), answers.into()]);
                }
                let reason = become_program(&program, &arguments, &self.token);
                eprintln!("{reason}; stop this program and run `cargo run` again.");
                true
            }
        }
    }
}

/// Whether a change of this file, relative to the root, can change the book.
fn is_source(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    // What editors and `insta` put beside the file that is worked on.
    let is_passing = name.starts_with(['.', '#'])
        || name.ends_with('~')
        || [".swp", ".tmp", ".new", ".new.svg"]
            .iter()
            .any(|end| name.ends_with(end));
    let is_watched = match path.components().next() {
        Some(Component::Normal(part)) => {
            WATCHED.iter().any(|watched| part == *watched) || is_manifest(path)
        }
        _ => false,
    };
    is_watched && !is_passing
}

fn is_manifest(path: &Path) -> bool {
    path == Path::new("Cargo.toml") || path == Path::new("Cargo.lock")
}

/// Whether the program is made from this file, or may be: a new source is in no list of Cargo's yet.
fn is_of_the_program(path: &Path) -> bool {
    path.starts_with("src") || is_manifest(path)
}

/// Lets Cargo build the program in the profile in which it runs.
///
/// # Errors
///
/// The compiler's errors, each with file and line.
fn compile(root: &Path, program: &Path) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let folder = program.parent().and_then(Path::file_name);
    let profile = match folder.and_then(|name| name.to_str()) {
        // The only profile whose folder is not called as the profile itself.
        Some("debug") | None => "dev",
        Some(name) => name,
    };
    let output = Command::new(cargo)
        .args([
            "build",
            "--quiet",
            "--bin",
            "workbook",
            "--message-format",
            "short",
        ])
        .args(["--profile", profile])
        .current_dir(root)
        // Build scripts of other people's crates have no use for it.
        .env_remove(token::VARIABLE)
        .output()
        .map_err(|error| format!("cargo cannot be started: {error}"))?;
    if output.status.success() {
        Ok(())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).trim().to_owned())
    }
}

/// Replaces this process by the program; returns only if that is not possible.
#[cfg(unix)]
fn become_program(program: &Path, arguments: &[OsString], token: &Token) -> String {
    use std::os::unix::process::CommandExt;
    let error = Command::new(program)
        .args(arguments)
        // The open pages go on working.
        .env(token::VARIABLE, token.text())
        .exec();
    format!("the new program cannot be started ({error})")
}

/// Replaces this process by the program; returns only if that is not possible.
#[cfg(not(unix))]
fn become_program(_program: &Path, _arguments: &[OsString], _token: &Token) -> String {
    "the new program is built, but this system cannot put it in the place of the running one".into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_told_from_what_lies_beside_them() {
        for source in ["book/src/bezier/shape.md", "src/lib.rs", "Cargo.toml"] {
            assert!(is_source(Path::new(source)), "{source}");
        }
        for other in [
            "target/served-book/index.html",
            "book/src/.shape.md.swp",
            "book/src/shape.md~",
            "snapshots/bezier/a.snap.new",
            "README.md",
            "",
        ] {
            assert!(!is_source(Path::new(other)), "{other}");
        }
        assert!(is_of_the_program(Path::new(
            "src/workbook/server/reload.html"
        )));
        assert!(!is_of_the_program(Path::new("book/src/SUMMARY.md")));
    }
}
