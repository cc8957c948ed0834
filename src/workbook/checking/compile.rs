//! An answer and the tests of its exercise become a program.
//!
//! The answer is a crate of its own, so that it cannot see the tests, and the compiler refuses `unsafe` in it: without
//! it no code of the answer runs before the tests begin, and none reaches into their memory.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use proc_macro2::{TokenStream, TokenTree};
use serde_json::Value;
use tempfile::TempDir;

use super::CheckingError;
use super::library::Library;
use super::runner::Runner;
use super::verdict::Diagnostic;
use crate::book::exercise::{TestsSource, Variant};
use crate::workbook::sandbox::{Ending, Job};

/// A source with the name by which messages call it.
#[derive(Debug, Clone)]
pub struct Source {
    /// The name in messages: the path of the reader's file.
    pub shown_as: String,
    /// The source itself.
    pub text: String,
}

impl From<&Variant> for Source {
    fn from(variant: &Variant) -> Self {
        Self {
            shown_as: variant.file.display().to_string(),
            text: variant.text.clone(),
        }
    }
}

/// A compiled answer, in a folder of its own that ends with it and its program.
#[derive(Debug)]
pub struct CompiledAnswer {
    folder: Arc<TempDir>,
    library: PathBuf,
    shown_as: String,
    /// The warnings.
    pub diagnostics: Vec<Diagnostic>,
}

/// A program that runs the tests of an exercise against one answer.
#[derive(Debug, Clone)]
pub struct Program {
    /// The folder with everything; removed with the last program in it.
    pub folder: Arc<TempDir>,
    /// The program.
    pub path: PathBuf,
    /// Which of the answers of the program is meant; `None` if it has this one alone.
    pub answer: Option<usize>,
}

/// Compiles an answer; the inner error is what the compiler says.
///
/// # Errors
///
/// The compiler does not start, or a file cannot be written.
pub fn compile_answer(
    library: &Library,
    source: &Source,
    runner: &Runner,
) -> Result<Result<CompiledAnswer, Vec<Diagnostic>>, CheckingError> {
    if let Some(diagnostic) = refused_unseen(source) {
        return Ok(Err(vec![diagnostic]));
    }
    let folder = new_folder(library)?;
    let file = folder.path().join("answer.rs");
    fs::write(&file, &source.text).map_err(|e| CheckingError::file(&file, &e))?;
    let mut arguments = common(library, "answer", folder.path());
    // Several answers may come into one program; by this the linker tells them apart.
    let mut distinct = OsString::from("-Cmetadata=");
    distinct.push(folder.path().file_name().unwrap_or_default());
    arguments.push(distinct);
    arguments.extend(
        [
            "--crate-type=rlib",
            "-Funsafe_code",
            // A constant that never ends is then an error after a moment, which no `allow` of the answer takes back.
            "-Flong_running_const_eval",
            "answer.rs",
            "-o",
            "libanswer.rlib",
        ]
        .map(OsString::from),
    );
    let said = rustc(library, folder.path(), arguments, Vec::new(), runner)?;
    let diagnostics = said.diagnostics("answer.rs", &source.shown_as);
    let compiled = folder.path().join("libanswer.rlib");
    Ok(if said.succeeded && compiled.is_file() {
        Ok(CompiledAnswer {
            folder: Arc::new(folder),
            library: compiled,
            shown_as: source.shown_as.clone(),
            diagnostics,
        })
    } else {
        Err(if diagnostics.iter().any(|d| d.level == "error") {
            diagnostics
        } else {
            vec![said.ended()]
        })
    })
}

/// Compiles the tests against a compiled answer; the inner error is what the compiler says.
///
/// # Errors
///
/// The compiler does not start, or a file cannot be written.
pub fn compile_tests(
    library: &Library,
    answer: &CompiledAnswer,
    tests: &Source,
    runner: &Runner,
) -> Result<Result<Program, Vec<Diagnostic>>, CheckingError> {
    let folder = Arc::clone(&answer.folder);
    let file = folder.path().join("tests.rs");
    // Behind the last line, so that the others keep their numbers: only a crate that is named is looked into.
    let text = format!("{}\nextern crate instances as _;\n", tests.text);
    fs::write(&file, text).map_err(|e| CheckingError::file(&file, &e))?;
    let answers = [("answer".to_owned(), answer)];
    let said = build(library, folder.path(), "tests.rs", &answers, runner)?;
    let path = folder.path().join("tests");
    Ok(if said.succeeded && path.is_file() {
        Ok(Program {
            folder,
            path,
            answer: None,
        })
    } else {
        let mut diagnostics = said.diagnostics("tests.rs", &tests.shown_as);
        // They also point to what they call.
        let own = format!("--> {}:", answer.shown_as);
        for diagnostic in &mut diagnostics {
            diagnostic.rendered = diagnostic.rendered.replace("--> answer.rs:", &own);
        }
        Err(if diagnostics.is_empty() {
            vec![said.ended()]
        } else {
            diagnostics
        })
    })
}

/// Compiles the tests against several answers, into one program; each run of it tests one of them.
///
/// This takes much less time than a program for each: the compiler starts and links once, and most of what the tests
/// call has nothing to do with the answers. `None` if the tests do not compile with all of them; which one is to blame,
/// [`compile_tests`] tells.
///
/// # Errors
///
/// The compiler does not start, or a file cannot be written.
pub fn compile_together(
    library: &Library,
    answers: &[&CompiledAnswer],
    tests: &TestsSource,
    runner: &Runner,
) -> Result<Option<Vec<Program>>, CheckingError> {
    let folder = new_folder(library)?;
    let write = |file: &Path, text: &str| {
        let file = folder.path().join(file);
        file.parent()
            .map_or(Ok(()), fs::create_dir_all)
            .and_then(|()| fs::write(&file, text))
            .map_err(|e| CheckingError::file(&file, &e))
    };
    let mut main = String::new();
    let mut entries = String::new();
    let mut named = Vec::new();
    for (number, &answer) in answers.iter().enumerate() {
        let name = format!("answer_{number}");
        // A file of the usual name: where an assertion stands says what a panic means.
        let file = format!("{number}/tests.rs");
        write(Path::new(&file), &tests.module(&name))?;
        main.push_str(&format!("#[path = \"{file}\"]\nmod tests_{number};\n"));
        entries.push_str(&format!("tests_{number}::workbook_entry(), "));
        named.push((name, answer));
    }
    main.push_str(&format!(
        "fn main() -> ::std::process::ExitCode {{ ::cagd::check::harness::main_of(&[{entries}]) }}\n\
         extern crate instances as _;\n"
    ));
    write(Path::new("main.rs"), &main)?;
    let said = build(library, folder.path(), "main.rs", &named, runner)?;
    let path = folder.path().join("tests");
    if !said.succeeded || !path.is_file() {
        return Ok(None);
    }
    let folder = Arc::new(folder);
    let programs = (0..answers.len()).map(|number| Program {
        folder: Arc::clone(&folder),
        path: path.clone(),
        answer: Some(number),
    });
    Ok(Some(programs.collect()))
}

/// Compiles the program `tests` from a file in this folder and these answers, each with its name there.
fn build(
    library: &Library,
    folder: &Path,
    file: &str,
    answers: &[(String, &CompiledAnswer)],
    runner: &Runner,
) -> Result<Said, CheckingError> {
    let mut arguments = common(library, "tests", folder);
    let mut named = |name: &str, path: &Path| {
        let mut argument = OsString::from(format!("--extern={name}="));
        argument.push(path);
        arguments.push(argument);
    };
    for (name, answer) in answers {
        named(name, &answer.library);
    }
    named("proptest", &library.proptest);
    named("instances", &library.instances);
    arguments.extend(["--crate-type=bin", "-Adead_code", file, "-o", "tests"].map(OsString::from));
    arguments.extend(linker(library, folder)?);
    let readable = answers.iter().map(|(_, answer)| answer.library.clone());
    rustc(library, folder, arguments, readable.collect(), runner)
}

/// The words that no answer may use.
const FORBIDDEN: [&str; 2] = ["unsafe", "extern"];

/// What is wrong with an answer before it is compiled: there is nothing in it, or a word that no answer may use,
/// wherever it stands, so that no macro can smuggle it in.
fn refused_unseen(source: &Source) -> Option<Diagnostic> {
    let refused = |word: &str, line: usize| {
        let message = format!("`{word}` is not allowed in an answer");
        Diagnostic {
            level: "error".into(),
            rendered: format!("error: {message}\n --> {}:{line}\n", source.shown_as),
            message,
            line: Some(line),
        }
    };
    let Ok(tokens) = source.text.parse::<TokenStream>() else {
        // The compiler may still make sense of it, so here the word may not even stand in a comment.
        let mut lines = source.text.lines().enumerate();
        return lines.find_map(|(index, line)| {
            let word = FORBIDDEN.into_iter().find(|word| line.contains(word))?;
            Some(refused(word, index + 1))
        });
    };
    // Every test would miss its function, each with an error of its own.
    if tokens.is_empty() {
        let message = "the answer is empty".to_owned();
        return Some(Diagnostic {
            level: "error".into(),
            rendered: format!(
                "error: {message}\n --> {}\n = help: `cargo run -- reset` gives you the starter again\n",
                source.shown_as
            ),
            message,
            line: None,
        });
    }
    let mut streams = vec![tokens];
    while let Some(stream) = streams.pop() {
        for token in stream {
            match token {
                TokenTree::Group(group) => streams.push(group.stream()),
                TokenTree::Ident(word) => {
                    if let Some(found) = FORBIDDEN.into_iter().find(|forbidden| word == forbidden) {
                        return Some(refused(found, word.span().start().line));
                    }
                }
                _ => {}
            }
        }
    }
    None
}

/// A new folder below the work folder.
pub(super) fn new_folder(library: &Library) -> Result<tempfile::TempDir, CheckingError> {
    fs::create_dir_all(&library.work)
        .and_then(|()| {
            tempfile::Builder::new()
                .prefix("answer-")
                .tempdir_in(&library.work)
        })
        .map_err(|e| CheckingError::file(&library.work, &e))
}

/// The arguments of every compilation.
pub(super) fn common(library: &Library, name: &str, folder: &Path) -> Vec<OsString> {
    let mut arguments: Vec<OsString> = [
        "--edition=2024",
        "--error-format=json",
        "-Cdebuginfo=0",
        "-Cembed-bitcode=no",
        "-Ccodegen-units=1",
    ]
    .map(OsString::from)
    .into();
    arguments.push(format!("--crate-name={name}").into());
    let mut dependencies = OsString::from("-Ldependency=");
    dependencies.push(&library.dependencies);
    arguments.push(dependencies);
    let mut own = OsString::from("-Ldependency=");
    own.push(folder);
    arguments.push(own);
    let mut cagd = OsString::from("--extern=cagd=");
    cagd.push(&library.cagd);
    arguments.push(cagd);
    arguments
}

/// The arguments by which the compiler takes its own linker.
///
/// On this platform it would do so anyway, but through a wrapper that looks for itself in `/proc`, which a sandbox does
/// not have. The linker itself knows by the name of a link what it is asked to be.
pub(super) fn linker(library: &Library, folder: &Path) -> Result<Vec<OsString>, CheckingError> {
    let own = library
        .sysroot
        .join("lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld");
    let is_default = cfg!(all(
        target_os = "linux",
        target_arch = "x86_64",
        target_env = "gnu"
    ));
    if !is_default || !own.is_file() {
        return Ok(Vec::new());
    }
    let link = folder.join("ld.lld");
    std::os::unix::fs::symlink(own, &link).map_err(|e| CheckingError::file(&link, &e))?;
    let mut search = OsString::from("-Clink-arg=-B");
    search.push(folder);
    Ok(vec![
        "-Clinker-features=-lld".into(),
        "-Clink-arg=-fuse-ld=lld".into(),
        search,
    ])
}

/// What a compiler run gave.
pub(super) struct Said {
    pub(super) succeeded: bool,
    ending: Ending,
    stderr: String,
}

impl Said {
    /// The diagnostics, with the file called as the reader knows it.
    pub(super) fn diagnostics(&self, file: &str, shown_as: &str) -> Vec<Diagnostic> {
        self.stderr
            .lines()
            .filter_map(|line| serde_json::from_str::<Value>(line).ok())
            .filter(|message| message["$message_type"] == "diagnostic")
            // The last lines only count the errors.
            .filter(|message| {
                let text = message["message"].as_str().unwrap_or_default();
                !text.starts_with("aborting due to")
                    && !text.contains("warning emitted")
                    && !text.contains("warnings emitted")
            })
            .filter(|message| {
                ["error", "warning"]
                    .iter()
                    .any(|level| message["level"] == *level)
            })
            .map(|message| {
                let primary = message["spans"]
                    .as_array()
                    .into_iter()
                    .flatten()
                    .find(|span| span["is_primary"] == true && span["file_name"] == file);
                let text = |field: &str| message[field].as_str().unwrap_or_default().to_owned();
                Diagnostic {
                    level: text("level"),
                    message: text("message"),
                    line: primary
                        .and_then(|span| span["line_start"].as_u64())
                        .and_then(|line| usize::try_from(line).ok()),
                    rendered: text("rendered")
                        .replace(&format!("--> {file}:"), &format!("--> {shown_as}:")),
                }
            })
            .collect()
    }

    /// The diagnostic of a compiler that ended without a word about the source.
    pub(super) fn ended(&self) -> Diagnostic {
        let message = format!("the compiler {}", self.ending);
        Diagnostic {
            level: "error".into(),
            rendered: format!("error: {message}\n{}", self.stderr),
            message,
            line: None,
        }
    }
}

/// Runs the compiler in a folder; it sees the library and what is `readable` besides.
pub(super) fn rustc(
    library: &Library,
    folder: &Path,
    arguments: Vec<OsString>,
    mut readable: Vec<PathBuf>,
    runner: &Runner,
) -> Result<Said, CheckingError> {
    // What is in the folder can be read anyway.
    readable.retain(|path| !path.starts_with(folder));
    // Cargo puts the package's own library beside the folder of its dependencies.
    readable.extend([
        library.sysroot.clone(),
        library.dependencies.clone(),
        library.instances.clone(),
    ]);
    let job = Job {
        program: library.rustc.clone(),
        arguments,
        // The linker and the compiler's own helpers are found by it.
        environment: vec![("PATH".into(), "/usr/local/bin:/usr/bin:/bin".into())],
        scratch: folder.to_path_buf(),
        readable,
        needs_system: true,
        limits: runner.for_the_compiler(),
    };
    let run = runner.run(&job)?;
    Ok(Said {
        succeeded: run.ending == Ending::Exited(0),
        ending: run.ending,
        stderr: String::from_utf8_lossy(&run.stderr).into_owned(),
    })
}
