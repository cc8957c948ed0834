//! The figures and tableaux for pages: compiled to wasm, it is what a page without a server asks.
//!
//! `workbook build` compiles it once for each part of the gallery, named by the variable `WORKBOOK_PART`, and once
//! for the tableaux, with the variable `WORKBOOK_TABLEAUX`.
//!
//! The page asks for room for its question, writes it there, and reads the answer where it is told. Both texts stay
//! until the next question. On other targets there is nothing to run.

#![expect(
    unsafe_code,
    reason = "names that a page calls are exported unmangled, which counts as unsafe; no memory is touched by hand"
)]

use std::sync::{Mutex, PoisonError};

use cagd::gallery;
use cagd::live::LiveFigures;

/// Whether this program judges tableaux instead of drawing figures.
const TABLEAUX: bool = option_env!("WORKBOOK_TABLEAUX").is_some();

static FIGURES: LiveFigures = LiveFigures::new(match option_env!("WORKBOOK_PART") {
    Some(name) => gallery::part(name),
    None => gallery::all,
});
static QUESTION: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static ANSWER: Mutex<String> = Mutex::new(String::new());

/// Room for a question of `length` bytes.
#[unsafe(no_mangle)]
pub extern "C" fn question(length: usize) -> *const u8 {
    let mut question = QUESTION.lock().unwrap_or_else(PoisonError::into_inner);
    question.clear();
    question.resize(length, 0);
    question.as_ptr()
}

/// Answers the question that was written; returns the length of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    let question = QUESTION.lock().unwrap_or_else(PoisonError::into_inner);
    let question = String::from_utf8_lossy(&question);
    let text = if TABLEAUX {
        cagd::tableaux::answer(&question)
    } else {
        FIGURES.answer(&question)
    };
    let length = text.len();
    *ANSWER.lock().unwrap_or_else(PoisonError::into_inner) = text;
    length
}

/// Where the answer begins.
#[unsafe(no_mangle)]
pub extern "C" fn reply() -> *const u8 {
    let answer = ANSWER.lock().unwrap_or_else(PoisonError::into_inner);
    answer.as_ptr()
}

fn main() {}
