//! The commands that need more than a few lines: their arguments and what they do.

pub mod coverage;
#[cfg(unix)]
pub mod verify;
