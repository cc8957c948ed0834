//! The commands that need more than a few lines: their arguments and what they do.
//!
//! | command | does |
//! |---|---|
//! | `list` | shows the exercises and how far the reader is |
//! | `next` | names what to do next |
//! | `start` | begins an exercise |
//! | `check` | compiles and tests the answer |
//! | `verify` | proves exercises sound |

pub mod coverage;
#[cfg(unix)]
pub mod check;
#[cfg(unix)]
mod desk;
#[cfg(unix)]
mod error;
#[cfg(unix)]
mod explain;
#[cfg(unix)]
pub mod list;
#[cfg(unix)]
pub mod next;
#[cfg(unix)]
mod output;
#[cfg(unix)]
pub mod start;
#[cfg(unix)]
pub mod verify;

#[cfg(unix)]
use desk::{Desk, Place};
#[cfg(unix)]
pub use error::CommandError;
#[cfg(unix)]
use output::{print, print_json};
