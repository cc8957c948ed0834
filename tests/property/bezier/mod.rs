//! The laws of the Bézier chapter, in its sections.

mod batch;
mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod flattening;
mod intersection;
mod measures;
mod representation;
mod shape;
mod subdivision;
