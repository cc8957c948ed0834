//! Affine geometry: points are not vectors.
