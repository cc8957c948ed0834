//! The laws of the Bézier chapter, in its sections.

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod representation;
mod shape;
mod subdivision;
