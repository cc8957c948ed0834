//! The server and the command line.
//!
//! | module | is |
//! |---|---|
//! | [`answers`] | the reader's own answers, a small package |
//! | [`practice`] | what a reader does with exercises, in the terminal and on the page |
//! | [`progress`] | how far the reader is |
//! | [`feedback`] | what a reader sees in the terminal |
//! | [`checking`] | an answer is compiled, run and judged |
//! | [`command_line`] | the commands, their arguments and exit statuses |
//! | `commands` | the commands that need more than a few lines |
//! | [`verify`] | the proof that an exercise is sound |
//! | [`scaffold`] | what `new` writes |
//! | [`grade`] | a folder of submissions is checked |
//! | [`live_figures`] | the figures as wasm, for a site without a server |
//! | [`mesh_files`] | meshes in the formats OBJ, OFF and PLY |
//! | `parallel` | work on several threads |
//! | [`house`] | where the sources of the workbook stand |
//! | [`sandbox`] | other people's programs, run with limits and out of reach |
//! | [`server`] | the book on a loopback address, with live reload |
//! | [`watch`] | what to do when a source changes |

#[cfg(unix)]
pub mod answers;
#[cfg(unix)]
pub mod checking;
pub mod command_line;
mod commands;
#[cfg(unix)]
mod durable;
#[cfg(unix)]
pub mod feedback;
#[cfg(unix)]
pub mod grade;
pub mod house;
pub mod live_figures;
pub mod mesh_files;
#[cfg(unix)]
mod parallel;
#[cfg(unix)]
pub mod practice;
#[cfg(unix)]
pub mod progress;
pub mod sandbox;
pub mod scaffold;
pub mod server;
#[cfg(unix)]
pub mod verify;
pub mod watch;
