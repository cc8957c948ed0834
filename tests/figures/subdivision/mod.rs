//! The figures of the chapter on subdivision, one module per section.

mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod four_point;
mod kobbelt;
mod limit_points;
mod meshes;
mod symbols;
mod uniform_splines;
