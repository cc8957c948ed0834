//! Mistakes with affine combinations.
