//! Figures of points and vectors.
