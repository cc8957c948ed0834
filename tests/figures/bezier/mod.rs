//! The figures of the chapter on Bézier curves, one module per section.

mod bernstein;
mod blossom;
mod de_casteljau;
mod elevation;
mod representation;
mod shape;
