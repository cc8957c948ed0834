//! Laws of affine maps, with equality.
