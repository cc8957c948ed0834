//! The laws of the chapter on subdivision, in its sections.

mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod kobbelt;
mod loop_scheme;
mod polygons;
mod uniform_splines;
