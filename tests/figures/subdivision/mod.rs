//! The figures of the chapter on subdivision, one module per section.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod eigenstructure;
mod four_point;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod meshes;
mod symbols;
mod uniform_splines;
