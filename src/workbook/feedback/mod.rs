//! What a reader is told, in the terminal and on the page.
//!
//! | module | is |
//! |---|---|
//! | [`paint`] | colours and lines of text |
//! | [`markdown`] | tasks and hints as text |
//! | [`formula`] | formulas as text |
//! | [`told`] | a verdict in words |
//! | [`report`] | these words for the terminal |
//! | [`page`] | the same words as HTML |
//! | [`picture`] | the wrong curve beside the right one, as SVG |
//! | [`braille`] | the same in the terminal |
//! | [`terminal`] | what the terminal can show |
//! | [`patience`] | a sign of life while something takes long |
//!
//! What is made for the terminal has colours; printed with `anstream`, the colours are left out where they do not belong.

pub mod braille;
pub mod formula;
pub mod markdown;
pub mod page;
pub mod paint;
pub mod patience;
pub mod picture;
pub mod report;
pub mod terminal;
pub mod told;
