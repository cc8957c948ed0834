//! Mistakes with areas.
