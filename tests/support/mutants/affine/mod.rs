//! Wrong affine geometry, in the sections of the chapter.

pub mod areas;
pub mod barycentric;
pub mod combinations;
pub mod convexity;
pub mod maps;
pub mod points_and_vectors;
