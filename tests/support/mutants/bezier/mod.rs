//! Wrong Bézier curves, in the sections of the chapter.

pub mod bernstein;
pub mod blossom;
pub mod bounds;
pub mod de_casteljau;
pub mod derivatives;
pub mod elevation;
pub mod intersection;
pub mod representation;
pub mod shape;
pub mod subdivision;
