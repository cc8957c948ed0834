//! Which files a run under bubblewrap sees, and the other arguments of `bwrap`.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::Job;

/// What a compiler with its linker needs of the system, where it exists.
///
/// Of `/etc` it is only what leads to libraries and tools; `/nix/store` is where NixOS has them all.
const SYSTEM: [&str; 9] = [
    "/bin",
    "/etc/alternatives",
    "/etc/ld.so.cache",
    "/lib",
    "/lib32",
    "/lib64",
    "/nix/store",
    "/sbin",
    "/usr",
];

/// The folders in which every dynamic linker looks, and in one of which it stands itself.
const LIBRARY_FOLDERS: [&str; 2] = ["/lib", "/lib64"];

/// The arguments of `bwrap` for a job, its program included.
pub(super) fn arguments(job: &Job) -> Vec<OsString> {
    let mut arguments: Vec<OsString> = [
        // Nothing of the outside but files: no network, no process, no shared memory, no host name.
        "--unshare-user",
        "--unshare-pid",
        "--unshare-net",
        "--unshare-ipc",
        "--unshare-uts",
        // Neither root nor any part of root's power, inside as well.
        "--uid",
        "65534",
        "--gid",
        "65534",
        "--cap-drop",
        "ALL",
        "--die-with-parent",
        // A terminal cannot be made to read what the program writes.
        "--new-session",
        // It tells there when the program has started and ended; the program finds the descriptor closed.
        "--json-status-fd",
        "0",
        "--dev-bind",
        "/dev/null",
        "/dev/null",
    ]
    .map(OsString::from)
    .into();
    let mut add = |option: &str, from: &Path, to: &Path| {
        arguments.extend([option.into(), from.into(), to.into()]);
    };
    let mut visible: Vec<(&str, PathBuf)> = Vec::new();
    if job.needs_system {
        for path in SYSTEM.map(PathBuf::from) {
            match fs::read_link(&path) {
                Ok(target) => add("--symlink", &target, &path),
                Err(_) if path.exists() => visible.push(("--ro-bind", path)),
                Err(_) => {}
            }
        }
    } else {
        for library in shared_libraries() {
            if let Some(name) = library.file_name() {
                for folder in LIBRARY_FOLDERS.map(Path::new) {
                    if folder.join(name) != library {
                        add("--symlink", &library, &folder.join(name));
                    }
                }
            }
            visible.push(("--ro-bind", library));
        }
    }
    visible.push(("--bind", job.scratch.clone()));
    visible.push(("--ro-bind", job.program.clone()));
    visible.extend(job.readable.iter().map(|path| ("--ro-bind", path.clone())));
    // What lies below another comes after it, or it would be covered.
    visible.sort_by_key(|(_, path)| path.components().count());
    visible.dedup();
    for (option, path) in &visible {
        add(option, path, path);
    }
    // The root is kept in memory, where writing would not be counted.
    arguments.extend(["--remount-ro".into(), "/".into()]);
    arguments.extend(["--chdir".into(), job.scratch.clone().into()]);
    if let Some(libraries) = libraries_of_the_compiler(job) {
        arguments.extend([
            "--setenv".into(),
            "LD_LIBRARY_PATH".into(),
            libraries.into(),
        ]);
    }
    arguments.push("--".into());
    arguments.push(job.program.clone().into());
    arguments.extend(job.arguments.iter().cloned());
    arguments
}

/// The libraries that a Rust program may be linked to, all parts of the C library but one.
const LIBRARIES: [&str; 7] = [
    "libc.so.6",
    "libdl.so.2",
    "libgcc_s.so.1",
    "libm.so.6",
    "libpthread.so.0",
    "librt.so.1",
    "libutil.so.1",
];

/// The shared libraries of a Rust program, the dynamic linker among them.
///
/// They are those of this process, which was built as the test programs are, and what else stands beside them.
/// To ask a test program would mean to trust it.
fn shared_libraries() -> BTreeSet<PathBuf> {
    let maps = fs::read_to_string("/proc/self/maps").unwrap_or_default();
    let own: BTreeSet<PathBuf> = maps
        .lines()
        .filter_map(|line| line.find('/').map(|start| PathBuf::from(&line[start..])))
        .filter(|path| is_shared_library(path) && path.is_file())
        .collect();
    let folders: BTreeSet<&Path> = own.iter().filter_map(|path| path.parent()).collect();
    let others = folders
        .into_iter()
        .flat_map(|folder| LIBRARIES.map(|name| folder.join(name)))
        .filter(|path| path.is_file());
    others.chain(own.iter().cloned()).collect()
}

/// Whether a file is called `name.so` or `name.so.1`.
fn is_shared_library(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.ends_with(".so") || name.contains(".so.")
}

/// The folder of the libraries that the compiler looks for beside itself.
///
/// It names them by where it stands, and without `/proc` the dynamic linker does not know where that is.
fn libraries_of_the_compiler(job: &Job) -> Option<PathBuf> {
    let is_named = job
        .environment
        .iter()
        .any(|(name, _)| name == "LD_LIBRARY_PATH");
    let folder = job.program.parent()?.parent()?.join("lib");
    (job.needs_system && !is_named && folder.is_dir()).then_some(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rust_program_needs_the_c_library_and_a_linker() {
        let names: Vec<String> = shared_libraries()
            .iter()
            .filter_map(|path| Some(path.file_name()?.to_string_lossy().into_owned()))
            .collect();
        // A program that is linked statically needs none.
        if cfg!(target_env = "gnu") {
            assert!(
                names.iter().any(|name| name.starts_with("libc.")),
                "{names:?}"
            );
            assert!(
                names.iter().any(|name| name.starts_with("ld-")),
                "{names:?}"
            );
        }
    }

    #[test]
    fn libraries_are_known_by_their_names() {
        for library in [
            "/lib/libc.so.6",
            "/lib/libm.so",
            "/lib64/ld-linux-x86-64.so.2",
        ] {
            assert!(is_shared_library(Path::new(library)), "{library}");
        }
        for other in ["/usr/bin/also", "/lib/libc.a", "/home/a.so/notes"] {
            assert!(!is_shared_library(Path::new(other)), "{other}");
        }
    }
}
