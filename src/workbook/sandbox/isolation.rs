//! What keeps a run apart from the rest of the machine, and how far that goes.

use std::fmt;
use std::sync::OnceLock;

use super::Sandbox;

/// What keeps a run apart from the rest of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Isolation {
    /// Linux with `bwrap`: own files, own network, own processes.
    Bubblewrap,
    /// Linux with user namespaces, through `unshare`: own network, own processes.
    Namespaces,
    /// Linux without either: the supervisor ends every descendant.
    ProcessTree,
    /// Another Unix system: the supervisor ends the process group.
    ProcessGroup,
}

impl Isolation {
    /// What this kind of system may offer, the best first.
    #[must_use]
    pub fn all() -> &'static [Isolation] {
        if cfg!(target_os = "linux") {
            &[
                Isolation::Bubblewrap,
                Isolation::Namespaces,
                Isolation::ProcessTree,
            ]
        } else if cfg!(unix) {
            &[Isolation::ProcessGroup]
        } else {
            &[]
        }
    }

    /// The best isolation that works here, found once by trying.
    ///
    /// If none works, it is the weakest; a run then says what is missing.
    #[must_use]
    pub fn best() -> Self {
        static BEST: OnceLock<Isolation> = OnceLock::new();
        *BEST.get_or_init(|| {
            let works = |&isolation: &Isolation| {
                Sandbox::of_the_workbook(isolation)
                    .and_then(|sandbox| sandbox.try_out())
                    .is_ok()
            };
            let all = Isolation::all();
            let found = all.iter().copied().find(works).or(all.last().copied());
            found.unwrap_or(Isolation::ProcessGroup)
        })
    }

    /// Whether the program cannot reach other people's files and the network.
    #[must_use]
    pub fn is_complete(self) -> bool {
        self == Isolation::Bubblewrap
    }

    /// How far the guarantee goes, in a few sentences.
    #[must_use]
    pub fn describe(self) -> &'static str {
        match self {
            Isolation::Bubblewrap => {
                "The program runs under bubblewrap. \
                 It sees its scratch folder and what it was given to read, and no other file, process or network. \
                 Time, memory, output, files and processes are limited, and all its processes end with it. \
                 It shares the kernel with you: a fault of the kernel is not guarded against."
            }
            Isolation::Namespaces => {
                "The program runs in namespaces of its own. \
                 It has no network and cannot touch other processes. \
                 It can read and write every file that you can. \
                 Time, memory, output and processes are limited, files each by size, \
                 and all its processes end with it. \
                 To hide your files, install bubblewrap."
            }
            Isolation::ProcessTree => {
                "The program runs as you do: it can read and write your files and use the network. \
                 Time, memory, output and processes are limited, files each by size, \
                 and all its descendants end with it, unless it attacks the process that watches it. \
                 This guards against mistakes, not against malice. \
                 To guard against malice, install bubblewrap."
            }
            Isolation::ProcessGroup => {
                "The program runs as you do: it can read and write your files and use the network. \
                 Time, output and the size of each file are limited, memory where the system does it. \
                 A process that leaves its group outlives the run. \
                 This guards against mistakes, not against malice; Linux with bubblewrap guards against both."
            }
        }
    }
}

impl fmt::Display for Isolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Isolation::Bubblewrap => "bubblewrap",
            Isolation::Namespaces => "isolation by namespaces",
            Isolation::ProcessTree => "the supervised process tree",
            Isolation::ProcessGroup => "the process group",
        })
    }
}
