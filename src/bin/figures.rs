//! The figures and tableaux for pages: compiled to wasm, it is what a page without a server asks.
//!
//! The page asks for room for its question, writes it there, and reads the answer where it is told. Both texts stay
//! until the next question. On other targets there is nothing to run.

#![expect(
    unsafe_code,
    reason = "names that a page calls are exported unmangled, which counts as unsafe; no memory is touched by hand"
)]

use std::sync::{Mutex, PoisonError};

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
    let text = match question.starts_with("tableau ") {
        true => cagd::tableaux::answer(&question),
        false => cagd::live::answer(&question),
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
