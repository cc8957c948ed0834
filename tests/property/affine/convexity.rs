//! Properties of convexity.
