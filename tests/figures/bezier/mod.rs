//! The figures of the chapter on Bézier curves, one module per section.

mod blossom;
mod de_casteljau;
mod elevation;
mod shape;
