//! Laws of points and vectors.
