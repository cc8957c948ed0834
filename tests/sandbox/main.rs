//! The sandbox against programs that try to get out or to take too much.
//!
//! | file | tries |
//! |---|---|
//! | `endings.rs` | how a run ends, and what it is given |
//! | `limits.rs` | time, memory, output, processes, files |
//! | `isolation.rs` | files, network and processes of others |
//! | `leftovers.rs` | that nothing is left, whatever happens |
//! | `compiler.rs` | the compiler inside |
//! | `hostile.rs` | is the program that misbehaves; the tests compile it |
//!
//! What an isolation does not promise is done under it as well, and must succeed: that shows that the deed works.
#![cfg(target_os = "linux")]

mod compiler;
mod endings;
mod isolation;
mod leftovers;
mod limits;
mod support;
