//! A Rust block of a page, as the reader has edited it, becomes a program and runs.
//!
//! As `rustdoc` does for the tests of the book, a block without `fn main` is the body of one, and one that ends in
//! `Ok::<(), E>(())` may use `?`.

use std::ffi::OsString;
use std::fs;
use std::time::Instant;

use proc_macro2::{TokenStream, TokenTree};
use serde::Serialize;

use super::CheckingError;
use super::check::Checker;
use super::compile::{common, linker, new_folder, rustc};
use super::library::Library;
use super::runner::Runner;
use super::verdict::Diagnostic;
use crate::workbook::sandbox::{Ending, Job};

/// The file that messages name.
const FILE: &str = "example.rs";

/// How a block ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ExampleOutcome {
    /// It ran to its end.
    Ran,
    /// It panicked, returned an error or was ended by a limit.
    Failed,
    /// It does not compile.
    DoesNotCompile,
}

/// What a block gave.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExampleRun {
    /// How it ended.
    pub outcome: ExampleOutcome,
    /// What ended it, if it did not run to its end: “the program took longer than 10 s”.
    pub reason: Option<String>,
    /// What it printed, without the picture.
    pub output: String,
    /// What it said about an error, such as the words of a panic.
    pub errors: String,
    /// What the compiler says.
    pub diagnostics: Vec<Diagnostic>,
    /// The drawing that it printed, as SVG.
    pub picture: Option<String>,
    /// How long compiling and running took.
    pub seconds: f64,
}

impl Checker {
    /// Compiles a block against the library and runs it.
    ///
    /// # Errors
    ///
    /// The compiler or the program does not start, or was stopped.
    pub fn run_example(&self, code: &str) -> Result<ExampleRun, CheckingError> {
        let start = Instant::now();
        let wrapped = Wrapped::of(code);
        let mut run = ExampleRun {
            outcome: ExampleOutcome::DoesNotCompile,
            reason: None,
            output: String::new(),
            errors: String::new(),
            diagnostics: Vec::new(),
            picture: None,
            seconds: 0.0,
        };
        let compiled = compile(self.library(), &wrapped, self.runner())?;
        run.diagnostics = compiled.diagnostics;
        if let Some(folder) = compiled.folder {
            self.run_compiled(&folder, &wrapped, &mut run)?;
        }
        run.seconds = start.elapsed().as_secs_f64();
        Ok(run)
    }

    fn run_compiled(
        &self,
        folder: &tempfile::TempDir,
        wrapped: &Wrapped,
        run: &mut ExampleRun,
    ) -> Result<(), CheckingError> {
        let work = &self.library().work;
        let scratch = tempfile::Builder::new()
            .prefix("run-")
            .tempdir_in(work)
            .map_err(|e| CheckingError::file(work, &e))?;
        let ended = self.runner().run(&Job {
            program: folder.path().join("example"),
            arguments: Vec::new(),
            environment: vec![("RUST_BACKTRACE".into(), "0".into())],
            scratch: scratch.path().to_path_buf(),
            readable: Vec::new(),
            needs_system: false,
            limits: self.limits().clone(),
        })?;
        let (picture, output) = without_picture(&String::from_utf8_lossy(&ended.stdout));
        run.picture = picture;
        run.output = output;
        run.errors = wrapped.said(&String::from_utf8_lossy(&ended.stderr));
        run.reason = match ended.ending {
            Ending::Exited(0) => None,
            // The number by which the standard library ends after a panic.
            Ending::Exited(101) => Some("the program panicked".into()),
            Ending::Exited(RETURNED_AN_ERROR) => Some("the program returned an error".into()),
            Ending::TooLong => Some(format!(
                "the program took longer than {} s; look for a loop or a recursion without end",
                self.limits().time.as_secs()
            )),
            ending => Some(format!("the program {ending}")),
        };
        run.outcome = match run.reason {
            None => ExampleOutcome::Ran,
            Some(_) => ExampleOutcome::Failed,
        };
        Ok(())
    }
}

/// The status of a block that ends with an error by `?`.
const RETURNED_AN_ERROR: i32 = 1;

/// A block as a whole program.
struct Wrapped {
    text: String,
    /// How many lines stand before those of the block.
    before: usize,
}

impl Wrapped {
    fn of(code: &str) -> Self {
        if has_main(code) {
            return Self {
                text: code.to_owned(),
                before: 0,
            };
        }
        let (before, after) = match code.trim_end().ends_with("(())") {
            true => (
                "fn main() { fn example() -> Result<(), impl ::core::fmt::Debug> {",
                format!(
                    "}} if let Err(error) = example() {{ eprintln!(\"Error: {{error:?}}\"); \
                     ::std::process::exit({RETURNED_AN_ERROR}) }} }}"
                ),
            ),
            false => ("fn main() {", "}".to_owned()),
        };
        Self {
            text: format!("{before}\n{code}\n{after}"),
            before: 1,
        }
    }

    /// What the program said, with the lines as the reader counts them.
    fn said(&self, said: &str) -> String {
        let hint = "note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace";
        let lines = said.lines().filter(|line| *line != hint);
        lines.map(|line| self.place(line) + "\n").collect()
    }

    /// A message of the compiler, with the lines as the reader counts them.
    fn message(&self, rendered: &str) -> String {
        let mut is_own = true;
        let lines = rendered.lines().map(|line| {
            let start = line.trim_start();
            if start.starts_with("--> ") || start.starts_with("::: ") {
                is_own = start[4..].starts_with(FILE);
            } else if line.starts_with(|c: char| c.is_alphabetic()) {
                // Where a new part of the message names no file, it is about the block.
                is_own = true;
            }
            match is_own {
                true => self.margin(line).unwrap_or_else(|| self.place(line)),
                false => line.to_owned(),
            }
        });
        lines.map(|line| line + "\n").collect()
    }

    /// A line with a number in the margin before the source: `12 |     let x = 1;`.
    fn margin(&self, line: &str) -> Option<String> {
        let width = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let (digits, rest) = line.split_at(width);
        rest.trim_start()
            .starts_with(['|', '+', '-', '~', '/'])
            .then_some(())?;
        let number = self.earlier(digits)?;
        Some(format!("{number:<width$}{rest}"))
    }

    /// A line that may name a place: `example.rs:12:5`.
    fn place(&self, line: &str) -> String {
        let mark = format!("{FILE}:");
        let place = line.split_once(&mark).and_then(|(head, tail)| {
            let end = tail.find(|c: char| !c.is_ascii_digit())?;
            let number = self.earlier(&tail[..end])?;
            Some(format!("{head}{mark}{number}{}", &tail[end..]))
        });
        place.unwrap_or_else(|| line.to_owned())
    }

    /// The number of a line within the block.
    fn earlier(&self, digits: &str) -> Option<usize> {
        Some(digits.parse::<usize>().ok()?.saturating_sub(self.before))
    }
}

/// Whether the block is a whole program already.
fn has_main(code: &str) -> bool {
    let Ok(tokens) = code.parse::<TokenStream>() else {
        // The compiler will say what is wrong with it.
        return code.contains("fn main(");
    };
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.windows(2).any(|pair| {
        matches!(pair, [TokenTree::Ident(word), TokenTree::Ident(name)] if word == "fn" && name == "main")
    })
}

/// The drawing in an output, and the rest.
fn without_picture(output: &str) -> (Option<String>, String) {
    let end_mark = "</svg>";
    let (Some(start), Some(end)) = (output.find("<svg"), output.rfind(end_mark)) else {
        return (None, output.to_owned());
    };
    if end < start {
        return (None, output.to_owned());
    }
    let end = end + end_mark.len();
    let rest = format!("{}{}", &output[..start], &output[end..]);
    (
        Some(output[start..end].to_owned()),
        rest.trim_matches('\n').to_owned(),
    )
}

struct Compiled {
    /// With the program, if there is one.
    folder: Option<tempfile::TempDir>,
    diagnostics: Vec<Diagnostic>,
}

fn compile(
    library: &Library,
    wrapped: &Wrapped,
    runner: &Runner,
) -> Result<Compiled, CheckingError> {
    let folder = new_folder(library)?;
    let file = folder.path().join(FILE);
    fs::write(&file, &wrapped.text).map_err(|e| CheckingError::file(&file, &e))?;
    let mut arguments = common(library, "example", folder.path());
    // As in the tests of the book, an example may leave things unused.
    arguments.extend(["--crate-type=bin", "-Aunused", FILE, "-o", "example"].map(OsString::from));
    arguments.extend(linker(library, folder.path())?);
    let said = rustc(library, folder.path(), arguments, Vec::new(), runner)?;
    let mut diagnostics = said.diagnostics(FILE, FILE);
    for diagnostic in &mut diagnostics {
        diagnostic.line = diagnostic
            .line
            .and_then(|line| line.checked_sub(wrapped.before));
        diagnostic.rendered = wrapped.message(&diagnostic.rendered);
    }
    let is_compiled = said.succeeded && folder.path().join("example").is_file();
    if !is_compiled && !diagnostics.iter().any(|d| d.level == "error") {
        diagnostics.push(said.ended());
    }
    Ok(Compiled {
        folder: is_compiled.then_some(folder),
        diagnostics,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_the_body_of_main_unless_it_has_one() {
        assert!(has_main("use std::fmt;\npub fn main() {}"));
        assert!(!has_main("// fn main() is not here\nlet main = 1;"));
        assert!(!has_main("mod a { fn main() {} }"));
        assert_eq!(Wrapped::of("fn main() {}").before, 0);
        let wrapped = Wrapped::of("let x = 1;");
        assert_eq!(wrapped.text.lines().nth(wrapped.before), Some("let x = 1;"));
    }

    #[test]
    fn messages_count_the_lines_of_the_block_and_those_of_other_files_as_they_are() {
        let wrapped = Wrapped::of("let x = 1;");
        let said = "error[E0308]: mismatched types\n  --> example.rs:10:5\n   |\n9  | a\n10 |     b\n   |     ^ no\n   ::: /src/lib.rs:7:1\n   |\n7  | fn\nhelp: try\n   |\n10 ~     c\n";
        let expected = "error[E0308]: mismatched types\n  --> example.rs:9:5\n   |\n8  | a\n9  |     b\n   |     ^ no\n   ::: /src/lib.rs:7:1\n   |\n7  | fn\nhelp: try\n   |\n9  ~     c\n";
        assert_eq!(wrapped.message(said), expected);
        let panic = "thread 'main' panicked at example.rs:3:1:\n2 | 3 apples\n";
        let told = "thread 'main' panicked at example.rs:2:1:\n2 | 3 apples\n";
        assert_eq!(wrapped.said(panic), told);
    }

    #[test]
    fn a_drawing_is_taken_out_of_what_was_printed() {
        let (picture, rest) = without_picture("before\n<svg a><g/></svg>\nafter\n");
        assert_eq!(picture.as_deref(), Some("<svg a><g/></svg>"));
        assert_eq!(rest, "before\n\nafter");
        assert_eq!(without_picture("</svg><svg"), (None, "</svg><svg".into()));
    }
}
