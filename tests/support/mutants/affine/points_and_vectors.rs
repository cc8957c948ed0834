//! Mistakes with points and vectors.
