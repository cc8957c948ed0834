//! Wrong implementations, each with the misconception it stands for, generic like the right ones.

pub mod affine;
pub mod bezier;
pub mod subdivision;
