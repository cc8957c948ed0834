//! The figures as wasm, for a site without a server.
//!
//! A page opened from disk may not fetch a file, but it may run a script. So the wasm code travels in one: compressed,
//! and written in letters.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use thiserror::Error;

/// The name of the script, beside the pages.
pub const SCRIPT: &str = "figures.js";

const TARGET: &str = "wasm32-unknown-unknown";

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
    #[error("`{}` is no wasm build of the figures ({reason})\nnext step: build it anew", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        reason: String,
    },
}

/// The script with the figures of the workbook at `root`; `built` is a wasm build that is there already.
///
/// # Errors
///
/// The target is not installed, the library does not compile, or `built` is no wasm.
pub fn script(root: &Path, built: Option<&Path>) -> Result<Vec<u8>, LiveFiguresError> {
    let file = match built {
        Some(file) => file.to_path_buf(),
        None => compile(root)?,
    };
    let unreadable = |reason: String| LiveFiguresError::Unreadable {
        file: file.clone(),
        reason,
    };
    let bytes = std::fs::read(&file).map_err(|e| unreadable(e.to_string()))?;
    let small = shrink(&bytes).map_err(unreadable)?;
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    let packed = packed
        .write_all(&small)
        .and_then(|()| packed.finish())
        .map_err(|e| unreadable(e.to_string()))?;
    let letters = BASE64_STANDARD.encode(packed);
    Ok(format!("window.cagdFigures = \"{letters}\";\n").into_bytes())
}

/// Compiles the figures and returns the wasm file.
fn compile(root: &Path) -> Result<PathBuf, LiveFiguresError> {
    let failed = |e: std::io::Error| LiveFiguresError::Compile(e.to_string());
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let sysroot = Command::new(rustc)
        .args(["--print", "sysroot"])
        .current_dir(root)
        .output()
        .map_err(failed)?;
    let sysroot = PathBuf::from(String::from_utf8_lossy(&sysroot.stdout).trim());
    if !sysroot.join("lib/rustlib").join(TARGET).is_dir() {
        return Err(LiveFiguresError::NoTarget);
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let exports = EXPORTS[1..]
        .iter()
        .map(|name| OsString::from(format!("-Clink-arg=--export={name}")));
    let output = Command::new(cargo)
        .args(["rustc", "--quiet", "--locked", "--bin", "figures"])
        .args(["--no-default-features", "--features", "figures"])
        .args(["--profile", "wasm", "--target", TARGET, "--target-dir"])
        .arg(root.join("target"))
        .arg("--")
        .args(exports)
        .current_dir(root)
        .output()
        .map_err(failed)?;
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
