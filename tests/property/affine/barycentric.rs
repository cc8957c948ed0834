//! Properties of barycentric coordinates.
