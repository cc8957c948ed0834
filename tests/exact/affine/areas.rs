//! Laws of areas, with equality.
