//! Wrong subdivision, in the sections of the chapter.

pub mod loop_scheme;
