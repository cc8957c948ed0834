//! B-splines: piecewise polynomials over a knot vector.
