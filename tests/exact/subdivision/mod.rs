//! The laws of the chapter on subdivision, in its sections.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod four_point;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod meshes;
mod polygons;
mod symbols;
mod uniform_splines;
