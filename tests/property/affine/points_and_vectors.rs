//! Properties of points and vectors.
