//! The commands that need more than a few lines: their arguments and what they do.
//!
//! | command | does |
//! |---|---|
//! | `list` | shows the exercises and how far the reader is |
//! | `next` | names what to do next |
//! | `start` | begins an exercise |
//! | `check` | compiles and tests the answer |
//! | `watch` | checks the answer whenever it is saved |
//! | `hint` | shows one more hint |
//! | `solution` | shows the solution, once it may be seen |
//! | `reset` | begins an exercise anew and keeps the answer |
//! | `progress` | takes the progress to another computer |
//! | `verify` | proves exercises sound |
//! | `new` | scaffolds an exercise |
//! | `grade` | checks what students hand in |
//! | `subdivide` | refines a mesh from a file |

#[cfg(unix)]
pub mod check;
pub mod coverage;
#[cfg(unix)]
mod explain;
#[cfg(unix)]
pub mod grade;
#[cfg(unix)]
pub mod hint;
#[cfg(unix)]
pub mod list;
pub mod new;
#[cfg(unix)]
pub mod next;
#[cfg(unix)]
mod output;
#[cfg(unix)]
mod place;
#[cfg(unix)]
pub mod progress;
#[cfg(unix)]
pub mod reset;
#[cfg(unix)]
pub mod solution;
#[cfg(unix)]
pub mod start;
#[cfg(unix)]
pub mod subdivide;
#[cfg(unix)]
pub mod verify;
#[cfg(unix)]
pub mod watch;

#[cfg(unix)]
use output::{print, print_json};
#[cfg(unix)]
use place::Place;

#[cfg(unix)]
use super::practice::{Desk, PracticeError};
