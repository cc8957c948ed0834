//! Figures of affine maps.
