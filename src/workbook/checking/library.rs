//! The mathematics, compiled once for all answers.
//!
//! A small package below `target/exercises` depends on this one without its features, and on proptest for the tests.
//! Cargo builds it and says where the parts are; an answer is then compiled against them by `rustc` alone.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::CheckingError;
use crate::workbook::durable;

/// The parts that an answer and its tests are compiled against.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Library {
    /// A digest of everything that the parts are made of: sources, lock file, compiler.
    pub fingerprint: String,
    /// The compiled library.
    pub cagd: PathBuf,
    /// The compiled crate proptest, for tests.
    pub proptest: PathBuf,
    /// What the tests of exercises have in common, compiled; see `INSTANCES`.
    pub instances: PathBuf,
    /// The folder with the crates that these two need.
    pub dependencies: PathBuf,
    /// The compiler.
    pub rustc: PathBuf,
    /// The folder of the compiler's own libraries.
    pub sysroot: PathBuf,
    /// The folder in which answers are compiled and run, each in a folder of its own.
    pub work: PathBuf,
}

/// The source of the package's library: it calls what many tests call, so that it is compiled once.
///
/// A test program takes about half as long to compile with it.
const INSTANCES: &str = include_str!("instances.rs");

/// Where the package and everything that checking makes stand, relative to the root of the workbook.
pub const FOLDER: &str = "target/exercises";

impl Library {
    /// The library of the workbook at `root`, built if its sources, the lock file or the compiler have changed.
    ///
    /// # Errors
    ///
    /// Cargo or the compiler do not start, or the library does not compile.
    pub fn build(root: &Path) -> Result<Self, CheckingError> {
        // The compiler starts while the sources are read.
        let (rustc, sources) = thread::scope(|scope| {
            let rustc = scope.spawn(|| compiler(root));
            let sources = digest_of_sources(root);
            (rustc.join().unwrap_or_else(|_| compiler(root)), sources)
        });
        let (rustc, mut digest) = (rustc?, sources?);
        digest.update(&rustc.version);
        let fingerprint = hex(&digest.finalize());
        let folder = root.join(FOLDER);
        let record = folder.join("library.json");
        let known: Option<Self> = fs::read(&record)
            .ok()
            .and_then(|bytes| serde_json::from_slice(&bytes).ok());
        if let Some(known) = known
            && known.fingerprint == fingerprint
            // A copied or moved folder still names the old place.
            && known.work == folder.join("work")
            && known.cagd.is_file()
            && known.proptest.is_file()
            && known.instances.is_file()
        {
            return Ok(known);
        }
        write_package(root, &folder.join("package"))?;
        let [cagd, proptest, instances] = cargo_build(&folder)?;
        let library = Self {
            fingerprint,
            dependencies: folder.join("build/debug/deps"),
            cagd,
            proptest,
            instances,
            rustc: rustc.path,
            sysroot: rustc.sysroot,
            work: folder.join("work"),
        };
        let text = serde_json::to_vec_pretty(&library)
            .map_err(|e| CheckingError::file(&record, &e.into()))?;
        replace(&record, &text)?;
        Ok(library)
    }
}

/// The compiler that Cargo would take.
struct Compiler {
    path: PathBuf,
    sysroot: PathBuf,
    version: String,
}

fn compiler(root: &Path) -> Result<Compiler, CheckingError> {
    let asked = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let ask = |arguments: &[&str]| {
        let output = Command::new(&asked)
            .args(arguments)
            .current_dir(root)
            .output()
            .map_err(|e| CheckingError::Program {
                program: asked.to_string_lossy().into_owned(),
                reason: e.to_string(),
                remedy: "install Rust, or see that it is in the search path".into(),
            })?;
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    };
    // Each question starts the compiler anew, so both are asked at once.
    let (version, sysroot) = thread::scope(|scope| {
        let version = scope.spawn(|| ask(&["-vV"]));
        let sysroot = ask(&["--print", "sysroot"]);
        let version = version.join().unwrap_or_else(|_| ask(&["-vV"]));
        (version, sysroot)
    });
    let (version, sysroot) = (version?, PathBuf::from(sysroot?.trim()));
    // Behind the name may stand a chooser of toolchains, which a sandbox does not have.
    let inside = sysroot.join("bin/rustc");
    let path = if inside.is_file() {
        inside
    } else {
        PathBuf::from(asked)
    };
    Ok(Compiler {
        path,
        sysroot,
        version,
    })
}

/// A digest of the sources and the lock file that the library is made of, to be continued with the compiler.
fn digest_of_sources(root: &Path) -> Result<Sha256, CheckingError> {
    let mut files = vec![root.join("Cargo.toml"), root.join("Cargo.lock")];
    // What an answer is compiled against; the book, the figures and the command line are behind features.
    let elsewhere = ["book", "workbook", "figure", "gallery.rs", "live", "bin"];
    let mut folders = vec![root.join("src")];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).map_err(|e| CheckingError::file(&folder, &e))?;
        for entry in entries.flatten() {
            let path = entry.path();
            let name = entry.file_name();
            if folder == root.join("src") && elsewhere.iter().any(|other| name == *other) {
                continue;
            }
            if path.is_dir() {
                if name != "figures" && name != "computed" {
                    folders.push(path);
                }
            } else {
                files.push(path);
            }
        }
    }
    files.sort();
    let mut digest = Sha256::new();
    digest.update(INSTANCES);
    for file in files {
        let text = fs::read(&file).map_err(|e| CheckingError::file(&file, &e))?;
        digest.update(
            file.strip_prefix(root)
                .unwrap_or(&file)
                .to_string_lossy()
                .as_bytes(),
        );
        digest.update([0]);
        digest.update((text.len() as u64).to_le_bytes());
        digest.update(&text);
    }
    Ok(digest)
}

/// The digits of a digest.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Writes the package that has the library and proptest as its dependencies.
fn write_package(root: &Path, package: &Path) -> Result<(), CheckingError> {
    let lock = root.join("Cargo.lock");
    let manifest = manifest(root)?;
    fs::create_dir_all(package).map_err(|e| CheckingError::file(package, &e))?;
    replace(&package.join("Cargo.toml"), manifest.as_bytes())?;
    replace(&package.join("lib.rs"), INSTANCES.as_bytes())?;
    let lock_text = fs::read(&lock).map_err(|e| CheckingError::file(&lock, &e))?;
    replace(&package.join("Cargo.lock"), &lock_text)
}

/// The manifest of a package that depends on the mathematics as answers do.
fn manifest(root: &Path) -> Result<String, CheckingError> {
    let file = root.join("Cargo.toml");
    let text = fs::read_to_string(&file).map_err(|e| CheckingError::file(&file, &e))?;
    let own: toml::Table =
        toml::from_str(&text).map_err(|e| CheckingError::Library(e.to_string()))?;
    let proptest = own
        .get("dev-dependencies")
        .and_then(|table| table.get("proptest"))
        .cloned()
        .ok_or_else(|| CheckingError::Library("`Cargo.toml` does not name proptest".into()))?;
    let mut cagd = toml::Table::new();
    cagd.insert("path".into(), root.to_string_lossy().into_owned().into());
    cagd.insert("default-features".into(), false.into());
    let mut dependencies = toml::Table::new();
    dependencies.insert("cagd".into(), cagd.into());
    dependencies.insert("proptest".into(), proptest);
    let mut dev = toml::Table::new();
    dev.insert("debug".into(), 0.into());
    dev.insert("package".into(), core_profile(&own).into());
    let mut profiles = toml::Table::new();
    profiles.insert("dev".into(), dev.into());
    let mut library = toml::Table::new();
    library.insert("path".into(), "lib.rs".into());
    let mut package = toml::Table::new();
    package.insert("name".into(), "instances".into());
    package.insert("edition".into(), "2024".into());
    package.insert("publish".into(), false.into());
    let mut whole = toml::Table::new();
    whole.insert("package".into(), package.into());
    whole.insert("lib".into(), library.into());
    whole.insert("workspace".into(), toml::Table::new().into());
    whole.insert("dependencies".into(), dependencies.into());
    whole.insert("profile".into(), profiles.into());
    toml::to_string(&whole).map_err(|e| CheckingError::Library(e.to_string()))
}

/// How the crates that compute are optimised; it is worth it for answers too.
pub(crate) fn core_profile(manifest: &toml::Table) -> toml::Table {
    let core = [
        "cagd",
        "libm",
        "num-bigint",
        "num-integer",
        "num-rational",
        "num-traits",
    ];
    manifest
        .get("profile")
        .and_then(|table| table.get("dev"))
        .and_then(|table| table.get("package"))
        .and_then(toml::Value::as_table)
        .into_iter()
        .flatten()
        .filter(|(name, _)| core.contains(&name.as_str()))
        .map(|(name, value)| (name.clone(), value.clone()))
        .collect()
}

/// Builds the package and returns where the libraries `cagd`, `proptest` and `instances` are.
fn cargo_build(folder: &Path) -> Result<[PathBuf; 3], CheckingError> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let build = |offline: bool| {
        let mut command = Command::new(&cargo);
        command
            .args([
                "build",
                "--message-format=json-render-diagnostics",
                "--quiet",
            ])
            .arg("--target-dir")
            .arg(folder.join("build"))
            .current_dir(folder.join("package"))
            // What a surrounding `cargo` has set for its own package is not meant for this one.
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("CARGO_TARGET_DIR");
        if offline {
            command.arg("--offline");
        }
        command.output().map_err(|e| CheckingError::Program {
            program: cargo.to_string_lossy().into_owned(),
            reason: e.to_string(),
            remedy: "install Rust, or see that it is in the search path".into(),
        })
    };
    // The crates are usually there already; only if not, the network is asked.
    let mut output = build(true)?;
    if !output.status.success() {
        let again = build(false)?;
        if again.status.success() {
            output = again;
        }
    }
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(CheckingError::Library(said));
    }
    let printed = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<Value> = printed
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect();
    let part = |name: &str| {
        messages
            .iter()
            .filter(|message| message["reason"] == "compiler-artifact")
            .filter(|message| message["target"]["name"] == name)
            .flat_map(|message| message["filenames"].as_array().into_iter().flatten())
            .filter_map(Value::as_str)
            .find(|file| file.ends_with(".rlib"))
            .map(PathBuf::from)
            .ok_or_else(|| CheckingError::Library(format!("cargo has built no library `{name}`")))
    };
    Ok([part("cagd")?, part("proptest")?, part("instances")?])
}

/// Writes a file whole or not at all, if it is not there already.
pub(crate) fn replace(file: &Path, bytes: &[u8]) -> Result<(), CheckingError> {
    if fs::read(file).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    durable::replace(file, bytes).map_err(|e| CheckingError::file(file, &e))
}
