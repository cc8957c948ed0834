//! Printing what a command found.

use std::io::{self, Write};

use super::PracticeError;
use crate::workbook::feedback::paint::printable;

/// Prints a text, without its colours where they do not belong.
pub(super) fn print(text: &str) -> Result<(), PracticeError> {
    let mut out = anstream::stdout();
    out.write_all(printable(text).as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Prints a value as JSON.
pub(super) fn print_json(value: &impl serde::Serialize) -> Result<(), PracticeError> {
    let text = serde_json::to_string_pretty(value).map_err(io::Error::from)?;
    writeln!(io::stdout(), "{text}")?;
    Ok(())
}
