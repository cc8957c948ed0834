//! The figures of the chapter on subdivision, one module per section.
