//! The server and the command line.
//!
//! | module | is |
//! |---|---|
//! | [`command_line`] | the commands, their arguments and exit statuses |
//! | [`house`] | where the sources of the workbook stand |
//! | [`server`] | the book on a loopback address, with live reload |
//! | [`watch`] | what to do when a source changes |

pub mod command_line;
pub mod house;
pub mod server;
pub mod watch;
