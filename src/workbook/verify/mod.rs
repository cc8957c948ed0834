//! The proof that an exercise is sound: its starter fails, its solution passes, every wrong answer is rejected.
//!
//! ```text
//! exercise ─▶ candidates ─▶ trials (in parallel) ─▶ judge ─▶ Report ─▶ text, JSON, JUnit
//!                                                     └───▶ cache
//! ```
//!
//! | module | is |
//! |---|---|
//! | [`candidate`] | the answers that an exercise brings: starter, solution, mutants, alternatives |
//! | [`trial`] | they are compiled and run |
//! | [`judge`] | the rules: what the trials must show |
//! | [`hidden`] | the same, with the hidden tests of a pack |
//! | [`to_do`] | what an author has left open |
//! | [`report`] | what `verify --json` prints |
//! | [`session`] | many exercises at once, on all cores, with the cache |
//! | [`cache`] | what was verified stays so until something changes |
//! | [`text`] | the report for people |
//! | [`junit`] | the report for a build server |

pub mod cache;
pub mod candidate;
pub mod hidden;
pub mod judge;
pub mod junit;
pub mod report;
pub mod session;
pub mod text;
pub mod to_do;
pub mod trial;

use std::path::Path;

use super::checking::{Checker, CheckingError};
use super::sandbox::Isolation;
use crate::book::exercise::Exercise;

pub use report::Report;
pub use session::{Verified, verify};

/// The report about one exercise, from the cache or by verifying it now.
///
/// # Errors
///
/// The library does not compile, or the compiler or a program does not start.
pub fn verified(root: &Path, exercise: &Exercise) -> Result<Report, CheckingError> {
    let checker = Checker::new(root, Isolation::best())?.patient();
    let mut all = verify(&checker, &[exercise], true, &|_| {})?;
    Ok(all.remove(0).report)
}
