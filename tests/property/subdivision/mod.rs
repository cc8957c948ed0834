//! The laws of the chapter on subdivision, in its sections.

mod loop_scheme;
