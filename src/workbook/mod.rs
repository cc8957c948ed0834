//! The server and the command line.
//!
//! | module | is |
//! |---|---|
//! | [`command_line`] | the commands, their arguments and exit statuses |
//! | [`house`] | where the sources of the workbook stand |

pub mod command_line;
pub mod house;
