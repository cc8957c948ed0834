//! Figures of convexity.
