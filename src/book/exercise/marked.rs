//! One source from which the starter and the solution come, so that they cannot drift apart.
//!
//! `answer.rs` is the solution, as it compiles. What the reader is not given stands between marks, and what stands
//! there instead in the starter is written behind `//|`:
//!
//! ```text
//! pub fn half(x: f64) -> f64 {
//!     //@ solution
//!     x / 2.0
//!     //@ starter
//!     //| x // this is not the half yet
//!     //@ end
//! }
//! ```

use std::path::Path;

use crate::book::error::{BookError, Problem};

/// The solution and the starter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkedSource {
    /// What passes.
    pub solution: String,
    /// What the reader begins with.
    pub starter: String,
}

/// The marks, in the order in which they must come.
const MARKS: [&str; 3] = ["//@ solution", "//@ starter", "//@ end"];

impl MarkedSource {
    /// Splits the source of `answer.rs`.
    ///
    /// # Errors
    ///
    /// Marks out of order, a line of the starter without `//|`, a source without marks.
    pub fn parse(file: &Path, text: &str) -> Result<Self, BookError> {
        let error = |line: usize, found: String, remedy: &str| {
            let remedy = remedy.to_owned();
            Err(BookError::new(
                file,
                line,
                Problem::Exercise { found, remedy },
            ))
        };
        let (mut solution, mut starter) = (String::new(), String::new());
        // How many of the three marks of this block have been seen.
        let mut seen = 0;
        let mut blocks = 0;
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            let trimmed = line.trim();
            if trimmed.starts_with("//@") {
                if trimmed != MARKS[seen] {
                    let found = format!("`{trimmed}` stands where `{}` should", MARKS[seen]);
                    return error(
                        number,
                        found,
                        "write `//@ solution`, `//@ starter`, `//@ end`, in this order",
                    );
                }
                seen = (seen + 1) % MARKS.len();
                blocks += usize::from(seen == 0);
                continue;
            }
            match (seen, line.trim_start().strip_prefix("//|")) {
                (0, None) => {
                    push(&mut solution, line);
                    push(&mut starter, line);
                }
                (1, None) => push(&mut solution, line),
                (2, Some(rest)) => {
                    let indent = &line[..line.len() - line.trim_start().len()];
                    let rest = rest.strip_prefix(' ').unwrap_or(rest);
                    push(&mut starter, format!("{indent}{rest}").trim_end());
                }
                (2, None) => {
                    let found = "a line of the starter does not begin with `//|`".to_owned();
                    return error(number, found, "write `//|` in front of it");
                }
                (_, Some(_)) => {
                    let found = "`//|` stands outside of a starter".to_owned();
                    return error(number, found, "move it between `//@ starter` and `//@ end`");
                }
                (_, None) => {}
            }
        }
        if seen != 0 {
            let found = format!("`{}` is missing", MARKS[seen]);
            return error(text.lines().count().max(1), found, "close the marked block");
        }
        if blocks == 0 {
            let found = "nothing is marked, so the starter would be the solution".to_owned();
            return error(
                1,
                found,
                "put what the reader writes between `//@ solution` and `//@ starter`",
            );
        }
        Ok(Self { solution, starter })
    }
}

fn push(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "fn f() -> i32 {\n    //@ solution\n    2\n    //@ starter\n    //| // two?\n    //|\n    //| 1\n    //@ end\n}\n";

    fn parse(text: &str) -> Result<MarkedSource, BookError> {
        MarkedSource::parse(Path::new("answer.rs"), text)
    }

    #[test]
    fn starter_and_solution_come_from_one_source() {
        let source = parse(SOURCE).expect("the marks are right");
        assert_eq!(source.solution, "fn f() -> i32 {\n    2\n}\n");
        assert_eq!(source.starter, "fn f() -> i32 {\n    // two?\n\n    1\n}\n");
    }

    #[test]
    fn wrong_marks_are_told_with_their_line() {
        for (text, line) in [
            (SOURCE.replace("    //@ end\n", ""), 8),
            (SOURCE.replace("//@ solution", "//@ starter"), 2),
            (SOURCE.replace("//| 1", "1"), 7),
            (SOURCE.replace("    2\n", "    //| 2\n"), 3),
            ("fn f() {}\n".to_owned(), 1),
            (SOURCE.replace("//@ end", "//@ ende"), 8),
        ] {
            assert_eq!(
                parse(&text).expect_err("a mistake").place.line,
                line,
                "{text}"
            );
        }
    }
}
