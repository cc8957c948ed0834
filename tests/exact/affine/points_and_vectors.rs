//! Laws of points and vectors, with equality.
