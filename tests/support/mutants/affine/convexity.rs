//! Mistakes with convexity.
