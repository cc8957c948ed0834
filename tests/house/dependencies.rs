//! Heavy crates stay out of the core, and every crate builds with the stated Rust.

use std::collections::BTreeSet;
use std::process::Command;

use serde_json::Value;

use super::{assert_none, root};

/// What `cargo` prints for these arguments, asked without a network.
#[track_caller]
fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(["--offline", "--locked"])
        .current_dir(root())
        .output()
        .expect("cargo starts");
    assert!(
        output.status.success(),
        "cargo {arguments:?} failed:\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("cargo prints UTF-8")
}

fn metadata() -> Value {
    // Only this platform: the crates of others need not be on this machine.
    let host = cargo_host();
    let printed = cargo(&["metadata", "--format-version=1", "--filter-platform", &host]);
    serde_json::from_str(&printed).expect("cargo metadata prints JSON")
}

fn cargo_host() -> String {
    let output = Command::new(env!("CARGO"))
        .args(["--version", "--verbose"])
        .output()
        .expect("cargo starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines()
        .find_map(|line| line.strip_prefix("host: "))
        .expect("cargo names its host")
        .to_owned()
}

/// The crates that the core is built from, without those that only run inside the compiler.
fn core_crates() -> BTreeSet<String> {
    let edges = "normal,no-proc-macro";
    let tree = [
        "tree",
        "--no-default-features",
        "--edges",
        edges,
        "--prefix",
        "none",
    ];
    cargo(&tree)
        .lines()
        .filter_map(|line| line.split(' ').next())
        .map(str::to_owned)
        .collect()
}

#[test]
fn heavy_crates_are_absent_from_the_core() {
    let core = core_crates();
    assert!(core.contains("nalgebra"), "{core:?}");
    let metadata = metadata();
    let package = metadata["packages"]
        .as_array()
        .expect("a list of packages")
        .iter()
        .find(|package| package["name"] == "cagd")
        .expect("the package itself");
    let optional: BTreeSet<&str> = package["dependencies"]
        .as_array()
        .expect("a list of dependencies")
        .iter()
        .filter(|dependency| dependency["optional"] == true)
        .filter_map(|dependency| dependency["name"].as_str())
        .collect();
    for heavy in ["plotters", "mdbook-driver", "axum", "tokio", "clap"] {
        assert!(optional.contains(heavy), "{heavy} should be optional");
    }
    let violations: Vec<String> = optional
        .iter()
        .filter(|name| core.contains(**name))
        .map(|name| format!("the core depends on `{name}`"))
        .collect();
    assert_none(&violations, "keep it behind its feature");
}

/// `1.95` or `1.95.0` as numbers that compare.
fn version(text: &str) -> Vec<u32> {
    text.split('.')
        .filter_map(|part| part.parse().ok())
        .collect()
}

#[test]
fn no_dependency_needs_a_newer_rust_than_we_state() {
    let metadata = metadata();
    let ours = version(env!("CARGO_PKG_RUST_VERSION"));
    assert!(ours >= vec![1, 85], "the manifest states a version");
    let used: BTreeSet<&str> = metadata["resolve"]["nodes"]
        .as_array()
        .expect("a list of nodes")
        .iter()
        .filter_map(|node| node["id"].as_str())
        .collect();
    let violations: Vec<String> = metadata["packages"]
        .as_array()
        .expect("a list of packages")
        .iter()
        .filter(|package| package["id"].as_str().is_some_and(|id| used.contains(id)))
        .filter_map(|package| Some((package, package["rust_version"].as_str()?)))
        .filter(|(_, needed)| version(needed)[..2] > ours[..2])
        .map(|(package, needed)| format!("{} needs Rust {needed}", package["name"]))
        .collect();
    assert_none(&violations, "pin an older version of it");
}
