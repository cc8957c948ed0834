//! Wrong Bézier curves, in the sections of the chapter.

pub mod de_casteljau;
pub mod elevation;
pub mod representation;
