//! The figures of the chapter on subdivision, one module per section.

mod corner_cutting;
mod uniform_splines;
