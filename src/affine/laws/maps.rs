//! Laws of affine maps.
