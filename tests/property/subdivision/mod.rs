//! The laws of the chapter on subdivision, in its sections.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod creases;
mod doo_sabin;
mod eigenstructure;
mod four_point;
mod invariants;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod masks;
mod mesh_files;
mod meshes;
mod polygons;
mod refiner;
mod symbols;
mod uniform_splines;
