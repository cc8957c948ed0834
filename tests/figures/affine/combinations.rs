//! Figures of affine combinations.
