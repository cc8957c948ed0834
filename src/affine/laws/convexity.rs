//! Laws of convexity.
