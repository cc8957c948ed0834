//! Laws of affine combinations.
