//! Laws over rationals, with equality and no tolerance.

#[path = "../support/mod.rs"]
mod support;

mod affine;
mod bezier;
mod inputs;
mod subdivision;
