//! Laws on random input that likes degenerate cases.

#[path = "../support/mod.rs"]
mod support;

mod affine;
mod bezier;
mod curves;
mod generators;
mod subdivision;
