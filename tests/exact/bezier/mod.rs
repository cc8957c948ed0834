//! The laws of the Bézier chapter, in its sections.

mod de_casteljau;
mod elevation;
mod representation;
