//! Properties of areas.
