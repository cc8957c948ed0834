//! What a reader sees in the terminal.
//!
//! | module | is |
//! |---|---|
//! | [`paint`] | colours and lines of text |
//! | [`markdown`] | tasks and hints as text |
//! | [`formula`] | formulas as text |
//! | [`report`] | a verdict in words |
//! | [`picture`] | the wrong curve beside the right one, as SVG |
//! | [`braille`] | the same in the terminal |
//! | [`terminal`] | what the terminal can show |
//! | [`patience`] | a sign of life while something takes long |
//!
//! Everything here makes text with colours; printed with `anstream`, the colours are left out where they do not belong.

pub mod braille;
pub mod formula;
pub mod markdown;
pub mod paint;
pub mod patience;
pub mod picture;
pub mod report;
pub mod terminal;
