//! Properties of affine combinations.
