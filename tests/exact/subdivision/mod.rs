//! The laws of the chapter on subdivision, in its sections.

mod corner_cutting;
mod loop_scheme;
mod polygons;
mod uniform_splines;
