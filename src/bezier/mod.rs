//! Bézier curves.
