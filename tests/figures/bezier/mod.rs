//! The figures of the chapter on Bézier curves, one module per section.

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod representation;
mod shape;
mod subdivision;
