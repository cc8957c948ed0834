//! Mistakes with barycentric coordinates.
