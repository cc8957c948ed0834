//! Statements, directives, evidence and the mdBook preprocessor.
//!
//! | module | is |
//! |---|---|
//! | [`catalogue`] | every statement by id: kind, title, sources, needed evidence |
//! | [`directive`] | how one directive is written |
//! | [`page`] | a page taken apart: directives, statements, code blocks, formulas |
//! | [`error`] | what can be wrong, with file, line and remedy |

pub mod catalogue;
pub mod data;
pub mod directive;
pub mod error;
pub mod manuscript;
pub mod page;
