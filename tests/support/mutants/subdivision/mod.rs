//! Wrong subdivision, in the sections of the chapter.

pub mod catmull_clark;
pub mod corner_cutting;
pub mod doo_sabin;
pub mod kobbelt;
pub mod loop_scheme;
pub mod uniform_splines;
