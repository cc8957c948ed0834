//! The book in a real browser: each program for Node beside this file is one test.
//!
//! Where Chromium, Node or the driver of the browser is missing, the tests are listed as ignored and the reason is
//! printed; `.ci/run install build browser` installs all three. `--include-ignored` makes a missing tool a failure.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::OnceLock;

use libtest_mimic::{Arguments, Failed, Trial};

/// The programs, each called with the browser, the workbook and the built site.
const PROGRAMS: [&str; 4] = ["pages", "live", "exercises", "run"];

/// What the site is built to: the programs find the snapshots from there.
const SITE: &str = "target/book";

/// Where the driver is installed; the programs are copied beside it, since Node looks for it from there.
const DRIVER: &str = "target/browser";

fn main() -> ExitCode {
    let mut arguments = Arguments::from_args();
    // They measure how long a page takes, so that one must not disturb the other.
    arguments.test_threads.get_or_insert(1);
    let tools = Tools::find();
    if let Err(missing) = &tools {
        println!("the browser tests are skipped: {missing}");
        println!(
            "next step: `.ci/run install build browser` installs what is missing, and runs them"
        );
    }
    let trials = PROGRAMS.map(|program| {
        let tools = tools.clone();
        let skipped = tools.is_err();
        Trial::test(program, move || tools?.run(program)).with_ignored_flag(skipped)
    });
    libtest_mimic::run(&arguments, trials.into()).exit_code()
}

/// What a program needs besides the workbook.
#[derive(Clone)]
struct Tools {
    node: PathBuf,
    browser: PathBuf,
}

impl Tools {
    /// Finds the tools, or says which one is missing.
    fn find() -> Result<Self, String> {
        let node = on_path(&["node"]).ok_or("Node is not installed")?;
        let browser = on_path(&["chromium", "chromium-browser", "google-chrome"])
            .ok_or("Chromium is not installed")?;
        let driver = folder(DRIVER).join("node_modules/playwright-core");
        match driver.is_dir() {
            true => Ok(Self { node, browser }),
            false => Err(format!("there is no {}", driver.display())),
        }
    }

    /// Runs a program to its end; what it finds wrong stands in its output.
    fn run(&self, program: &str) -> Result<(), Failed> {
        let site = site()?;
        let script = Path::new("tests/browser")
            .join(program)
            .with_extension("mjs");
        let beside_the_driver = folder(DRIVER).join(program).with_extension("mjs");
        std::fs::copy(folder(script), &beside_the_driver)?;
        let status = Command::new(&self.node)
            .arg(beside_the_driver)
            .arg(&self.browser)
            .arg(env!("CARGO_BIN_EXE_workbook"))
            .arg(site)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .stdin(Stdio::null())
            .status()?;
        match status.success() {
            true => Ok(()),
            false => Err(format!("{program}.mjs ended with {status}; see above").into()),
        }
    }
}

/// The site with its live figures, built once, so that no older state of the sources is tested.
///
/// `WORKBOOK_SITE=built` says that it has just been built; the gate does that with a compiler of its own where needed.
fn site() -> Result<PathBuf, String> {
    static BUILT: OnceLock<Result<(), String>> = OnceLock::new();
    let build = || {
        let status = Command::new(env!("CARGO_BIN_EXE_workbook"))
            .arg("build")
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .status()
            .map_err(|e| e.to_string())?;
        match status.success() {
            true => Ok(()),
            false => Err(format!("`workbook build` ended with {status}")),
        }
    };
    if std::env::var_os("WORKBOOK_SITE").is_none() {
        BUILT.get_or_init(build).clone()?;
    }
    Ok(folder(SITE))
}

fn folder(inside: impl AsRef<Path>) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(inside)
}

/// The first of these programs that the search path has.
fn on_path(names: &[&str]) -> Option<PathBuf> {
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    names
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)))
        .find(|file| file.is_file())
}
