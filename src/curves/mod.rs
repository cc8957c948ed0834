//! What holds for any parametric curve.
