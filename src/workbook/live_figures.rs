//! The figures as wasm, for a site without a server.
//!
//! A page opened from disk may not fetch a file, but it may run a script. So the wasm code travels in one: compressed,
//! and written in letters. Each part of the gallery is a script of its own.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use thiserror::Error;

use crate::gallery;

const TARGET: &str = "wasm32-unknown-unknown";

/// The name of the part that judges tableaux instead of drawing.
const TABLEAUX: &str = "tableaux";

/// What a page calls.
const EXPORTS: [&str; 4] = ["memory", "question", "ask", "reply"];

/// There is no wasm build of the figures.
#[derive(Debug, Error)]
pub enum LiveFiguresError {
    /// The compiler has no wasm target.
    #[error(
        "the figures stay still, since the compiler cannot build for the web\n\
         next step: `rustup target add {TARGET}`, then build again"
    )]
    NoTarget,
    /// Cargo could not build them.
    #[error(
        "the figures could not be compiled for the web:\n{0}\nnext step: mend what the compiler says"
    )]
    Compile(String),
    /// The built file cannot be read.
    #[error("`{}` is no wasm build of the figures ({reason})\nnext step: delete it and build again", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        reason: String,
    },
}

/// The scripts with the figures of the workbook at `root`: for each part of the gallery a name and its bytes.
///
/// # Errors
///
/// The target is not installed, or the library does not compile.
pub fn scripts(root: &Path) -> Result<Vec<(String, Vec<u8>)>, LiveFiguresError> {
    let library = Library::of_the_compiler(root)?;
    let figures = gallery::PARTS.iter().map(|(part, _)| *part);
    figures
        .chain([TABLEAUX])
        .map(|part| {
            let file = compile(root, part, library)?;
            let unreadable = |reason: String| LiveFiguresError::Unreadable {
                file: file.clone(),
                reason,
            };
            let bytes = std::fs::read(&file).map_err(|e| unreadable(e.to_string()))?;
            let script = script(part, &bytes).map_err(unreadable)?;
            Ok((format!("figures-{part}.js"), script))
        })
        .collect()
}

/// The script that hands the wasm code of a part to the pages.
fn script(part: &str, wasm: &[u8]) -> Result<Vec<u8>, String> {
    let small = shrink(wasm)?;
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    let packed = packed
        .write_all(&small)
        .and_then(|()| packed.finish())
        .map_err(|e| e.to_string())?;
    let letters = BASE64_STANDARD.encode(packed);
    Ok(format!("(window.cagdFigures ??= {{}})[\"{part}\"] = \"{letters}\";\n").into_bytes())
}

/// Where the standard library for wasm comes from.
#[derive(Debug, Clone, Copy)]
enum Library {
    /// It is installed as the target.
    Installed,
    /// It is compiled from its sources, which only a compiler with `RUSTC_BOOTSTRAP` allows.
    FromSources,
}

impl Library {
    fn of_the_compiler(root: &Path) -> Result<Self, LiveFiguresError> {
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let sysroot = Command::new(rustc)
            .args(["--print", "sysroot"])
            .current_dir(root)
            .output()
            .map_err(|e| LiveFiguresError::Compile(e.to_string()))?;
        let sysroot = PathBuf::from(String::from_utf8_lossy(&sysroot.stdout).trim());
        let libraries = sysroot.join("lib/rustlib");
        if libraries.join(TARGET).is_dir() {
            Ok(Self::Installed)
        } else if std::env::var_os("RUSTC_BOOTSTRAP").is_some()
            && libraries.join("src/rust/library").is_dir()
        {
            Ok(Self::FromSources)
        } else {
            Err(LiveFiguresError::NoTarget)
        }
    }
}

/// Compiles a part of the figures and returns the wasm file.
fn compile(root: &Path, part: &str, library: Library) -> Result<PathBuf, LiveFiguresError> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let exports = EXPORTS[1..]
        .iter()
        .map(|name| OsString::from(format!("-Clink-arg=--export={name}")));
    let mut command = Command::new(cargo);
    command
        .args(["rustc", "--quiet", "--locked", "--bin", "figures"])
        .args(["--no-default-features", "--features", "figures"])
        .args(["--profile", "wasm", "--target", TARGET, "--target-dir"])
        .arg(root.join("target"));
    match part {
        TABLEAUX => command.env("WORKBOOK_TABLEAUX", "yes"),
        part => command.env("WORKBOOK_PART", part),
    };
    if let Library::FromSources = library {
        command.arg("-Zbuild-std=std,panic_abort");
    }
    let output = command
        .arg("--")
        .args(exports)
        // With an argument of its own Cargo remembers each part, and compiles none of them twice.
        .arg(format!("-Cmetadata={part}"))
        .current_dir(root)
        .output()
        .map_err(|e| LiveFiguresError::Compile(e.to_string()))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(LiveFiguresError::Compile(said));
    }
    Ok(root.join("target").join(TARGET).join("wasm/figures.wasm"))
}

/// The same program without what no page calls.
///
/// One of the crates behind the drawing exports functions for a browser that are never used here; what only they need
/// goes with them.
fn shrink(bytes: &[u8]) -> Result<Vec<u8>, String> {
    let mut config = walrus::ModuleConfig::new();
    config
        .generate_name_section(false)
        .generate_producers_section(false);
    let mut module = config.parse(bytes).map_err(|e| format!("{e:#}"))?;
    let idle: Vec<_> = module
        .exports
        .iter()
        .filter(|export| !EXPORTS.contains(&export.name.as_str()))
        .map(walrus::Export::id)
        .collect();
    for export in idle {
        module.exports.delete(export);
    }
    let notes: Vec<_> = module.customs.iter().map(|(id, _)| id).collect();
    for note in notes {
        module.customs.delete(note);
    }
    walrus::passes::gc::run(&mut module);
    Ok(module.emit_wasm())
}
