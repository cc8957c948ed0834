//! The laws of the affine chapter, in its sections.

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod inputs;
mod maps;
mod points_and_vectors;
