//! Mistakes with affine maps.
