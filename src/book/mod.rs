//! Statements, directives, evidence and the mdBook preprocessor.
//!
//! | module | is |
//! |---|---|
//! | [`catalogue`] | every statement by id: kind, title, sources, needed evidence |
//! | [`directive`] | how one directive is written |
//! | [`page`] | a page taken apart: directives, statements, code blocks, formulas |
//! | [`evidence`] | what shows that a statement holds, found in the sources |
//! | [`coverage`] | what is shown for each statement, and what is missing |
//! | [`error`] | what can be wrong, with file, line and remedy |
//! | [`tex`] | numbers and points as LaTeX |

pub mod catalogue;
pub mod coverage;
pub mod data;
pub mod directive;
pub mod error;
pub mod evidence;
pub mod manuscript;
pub mod page;
pub mod tex;
