//! Wrong subdivision, in the sections of the chapter.

pub mod corner_cutting;
pub mod loop_scheme;
pub mod uniform_splines;
