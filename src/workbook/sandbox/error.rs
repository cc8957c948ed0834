//! Why a run could not begin or be judged.

use std::path::PathBuf;

use thiserror::Error;

use super::Isolation;

/// A run could not begin or be judged; the program under test has no part in it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SandboxError {
    /// The system has no processes as a sandbox needs them.
    #[error(
        "programs of other people can be run on Linux and, without isolation, on other Unix systems, not on this one\n\
         next step: run the workbook on Linux; on Windows, inside WSL"
    )]
    Unsupported,
    /// A run is supervised by the workbook's own program, and this process is not the workbook.
    #[error(
        "`{}` is not the workbook and does not stand beside it\n\
         next step: run `cargo build` first, and do not rename the program `workbook`",
        program.display()
    )]
    NoSupervisor {
        /// The program of this process.
        program: PathBuf,
    },
    /// The program is not there, or a folder.
    #[error(
        "there is no program `{}`\n\
         next step: build it, and name it by an absolute path",
        program.display()
    )]
    NoProgram {
        /// The missing program.
        program: PathBuf,
    },
    /// Something that the program should read is not there.
    #[error(
        "`{}`, which the program should be able to read, cannot be found: {source}\n\
         next step: build what is missing, or take it out of the list",
        path.display()
    )]
    Unreadable {
        /// The missing file or folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The scratch folder cannot be used.
    #[error(
        "the scratch folder `{}` cannot be written: {source}\n\
         next step: name an existing folder of your own, by an absolute path",
        path.display()
    )]
    Scratch {
        /// The folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Less memory than the sandbox needs itself.
    #[error(
        "a memory limit of {asked} bytes is not enough to start a program; at least {least} are\n\
         next step: raise the limit"
    )]
    TooLittleMemory {
        /// The limit asked for.
        asked: u64,
        /// The smallest limit that works.
        least: u64,
    },
    /// The tool behind an isolation is not installed.
    #[error(
        "`{tool}`, which {isolation} needs, is not on the PATH\n\
         next step: install it (Debian's package is `{package}`)"
    )]
    NoTool {
        /// The isolation that needs it.
        isolation: Isolation,
        /// The program.
        tool: &'static str,
        /// The package of Debian that holds it.
        package: &'static str,
    },
    /// The first process of the sandbox could not be started.
    #[error(
        "`{}` cannot be started: {source}\n\
         next step: check that the file exists and may be executed",
        program.display()
    )]
    Start {
        /// The program that was to be started.
        program: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The isolation, or the system, does not let the program start.
    #[error(
        "{isolation} does not start the program: {said}\n\
         next step: see `describe` for what it needs, or choose another isolation"
    )]
    Refused {
        /// The isolation.
        isolation: Isolation,
        /// What it printed.
        said: String,
    },
    /// The processes of a run cannot be seen.
    #[error(
        "the children of a process cannot be read from `/proc`: {0}\n\
         next step: mount `/proc`; the kernel needs the option CONFIG_PROC_CHILDREN"
    )]
    Unwatchable(#[source] std::io::Error),
    /// Waiting for the program failed.
    #[error("the run cannot be watched: {0}\nnext step: run it again")]
    Watch(#[source] std::io::Error),
    /// A process does not end although it was killed.
    #[error(
        "processes of the run do not end, the first is {process}\n\
         next step: see what they wait for, for instance a network drive"
    )]
    Stuck {
        /// The number of the process that was started first.
        process: u32,
    },
}
