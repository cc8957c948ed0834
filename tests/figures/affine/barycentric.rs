//! Figures of barycentric coordinates.
