//! Laws of barycentric coordinates, with equality.
