//! Laws of convexity, with equality.
