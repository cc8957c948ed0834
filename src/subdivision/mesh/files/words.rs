//! Lines, words and numbers of a text format.

use std::borrow::Cow;

use super::{MeshFileError, MeshFileProblem};

/// The lines of a text, counted from 1.
///
/// Letters that are not UTF-8 are replaced: they do no harm in comments and names, and elsewhere they are no number.
#[derive(Debug, Clone)]
pub(super) struct Lines<'a> {
    rest: Option<&'a [u8]>,
    /// The number of the line that was read last.
    pub(super) number: usize,
}

impl<'a> Lines<'a> {
    /// The lines, without the mark for the order of bytes that some editors put in front.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Self, MeshFileError> {
        if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
            return Err(MeshFileProblem::Utf16.anywhere());
        }
        Ok(Self {
            rest: Some(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)),
            number: 0,
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Cow<'a, str>;

    /// The next line without its end and without a comment behind `#`.
    fn next(&mut self) -> Option<Cow<'a, str>> {
        let rest = self.rest?;
        // Old Macs ended a line with a carriage return alone.
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let line = match end {
            Some(end) => {
                let behind = rest[end..].strip_prefix(b"\r\n");
                self.rest = Some(behind.unwrap_or(&rest[end + 1..]));
                &rest[..end]
            }
            None => {
                self.rest = None;
                rest
            }
        };
        self.number += 1;
        let comment = line.iter().position(|&byte| byte == b'#');
        let said = &line[..comment.unwrap_or(line.len())];
        Some(String::from_utf8_lossy(said.trim_ascii_end()))
    }
}

/// A word as a message shows it: not too long, and without what a terminal would obey.
pub(crate) fn written(word: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String = word.chars().take(LONGEST).collect();
    if word.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    shown.escape_debug().to_string()
}

/// The number that a word is; it may be infinite.
pub(crate) fn number(word: &str) -> Result<f64, MeshFileProblem> {
    word.parse().map_err(|_| MeshFileProblem::Word {
        expected: "a number",
        found: written(word),
    })
}

/// The finite number that a word is.
pub(crate) fn coordinate(word: &str) -> Result<f64, MeshFileProblem> {
    let value = number(word)?;
    if value.is_finite() {
        return Ok(value);
    }
    Err(MeshFileProblem::NotFinite {
        found: written(word),
    })
}

/// The integer that a word is.
pub(crate) fn integer<T: std::str::FromStr>(
    word: &str,
    expected: &'static str,
) -> Result<T, MeshFileProblem> {
    word.parse().map_err(|_| MeshFileProblem::Word {
        expected,
        found: written(word),
    })
}

/// A number in the shortest decimal that is read as the same number.
pub(super) fn shortest(x: f64) -> impl std::fmt::Display {
    std::fmt::from_fn(move |f| {
        // Without an exponent the largest numbers would have 300 digits.
        if x == 0.0 || (1e-5..1e16).contains(&x.abs()) {
            write!(f, "{x}")
        } else {
            write!(f, "{x:e}")
        }
    })
}
