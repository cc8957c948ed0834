//! Statements, directives, evidence and the mdBook preprocessor.
//!
//! | module | is |
//! |---|---|
//! | [`catalogue`] | every statement by id: kind, title, sources, needed evidence |
//! | [`data`] | bibliography, glossary, notation |
//! | [`directive`] | how one directive is written |
//! | [`page`] | a page taken apart: directives, statements, code blocks, formulas |
//! | [`manuscript`] | all pages in reading order, and the numbers of what they state and show |
//! | [`lint`] | what refuses code blocks that would pass unrun |
//! | [`evidence`] | what shows that a statement holds, found in the sources |
//! | [`exercise`] | exercises: their folders, and the schema that is checked |
//! | [`coverage`] | what is shown for each statement, and what is missing |
//! | [`laws`] | where the laws stand |
//! | [`formula`] | LaTeX in, MathML out |
//! | [`listing`] | items of the source code, found by name |
//! | [`registry`] | the figures that the chapters draw and the texts that they compute |
//! | [`preprocessor`] | the manuscript goes in, the pages of the site come out |
//! | [`mod@build`] | builds the site |
//! | [`error`] | what can be wrong, with file, line and remedy |
//! | [`tex`] | numbers and points as LaTeX |

pub mod build;
pub mod catalogue;
pub mod coverage;
pub mod data;
pub mod directive;
pub mod error;
pub mod evidence;
pub mod exercise;
mod expand;
pub mod formula;
pub mod laws;
pub mod lint;
pub mod listing;
pub mod manuscript;
pub mod page;
mod pages;
pub mod preprocessor;
pub mod registry;
pub(crate) mod site;
pub mod tex;

pub use build::{BuildReport, build};
