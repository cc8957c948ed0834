//! Wrong subdivision, in the sections of the chapter.

pub mod butterfly;
pub mod catmull_clark;
pub mod corner_cutting;
pub mod creases;
pub mod doo_sabin;
pub mod eigenstructure;
pub mod four_point;
pub mod invariants;
pub mod kobbelt;
pub mod limit_points;
pub mod loop_scheme;
pub mod meshes;
pub mod symbols;
pub mod uniform_splines;
