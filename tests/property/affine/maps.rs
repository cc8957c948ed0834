//! Properties of affine maps.
