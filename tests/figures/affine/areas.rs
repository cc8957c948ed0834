//! Figures of areas.
