//! The figures of the chapter on subdivision, one module per section.

mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod kobbelt;
mod uniform_splines;
