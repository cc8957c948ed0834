//! The figures of the chapter on affine geometry, one module per section.

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod maps;
mod points_and_vectors;
