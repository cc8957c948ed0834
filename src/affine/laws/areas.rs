//! Laws of areas.
