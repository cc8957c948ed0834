//! The laws of the Bézier chapter, in its sections.

mod bounds;
mod de_casteljau;
mod elevation;
mod representation;
mod subdivision;
