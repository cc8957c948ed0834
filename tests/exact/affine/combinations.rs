//! Laws of affine combinations, with equality.
