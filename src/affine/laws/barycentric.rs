//! Laws of barycentric coordinates.
