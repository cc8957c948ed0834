//! Subdivision: curves and surfaces as limits of refined polygons and meshes.
//!
//! - [`polygon`] — open and closed polygons, doubling and averaging,
//! - [`corner_cutting`] — the schemes of Chaikin, of Lane and Riesenfeld, and the cubic one,
//! - [`scheme_kind`] — approximating or interpolating,
//! - [`laurent`], [`mask`] — schemes for curves, and their algebra,
//! - [`contractivity`] — smoothness by norms of difference schemes,
//! - [`four_point`] — the four-point scheme,
//! - [`local_matrix`], [`limit_stencil`] — points of the limit by eigenvectors,
//! - [`cosine`] — the irrational weights of schemes,
//! - [`loop_scheme`], [`loop_limit`], [`butterfly`] — schemes for triangle meshes,
//! - [`lattice_mask`], [`mod@box_spline`] — schemes on regular triangle meshes, and the limit of Loop's,
//! - [`mod@catmull_clark`], [`mod@doo_sabin`], [`mod@kobbelt`] — schemes for quadrilaterals; [`creases`] — sharp edges,
//! - [`fan`], [`subdivision_matrix`], [`spectrum`], [`characteristic_map`] — what happens around an extraordinary point,
//! - [`Refiner`], [`StencilCascade`] — the same schemes for large meshes,
//! - [`files`] — meshes from texts and to texts;
//!
//! the theorems are in [`laws`].

pub mod box_spline;
pub mod butterfly;
pub mod catmull_clark;
pub mod characteristic_map;
pub mod contractivity;
pub mod corner_cutting;
pub mod cosine;
pub mod creases;
pub mod doo_sabin;
pub mod fan;
pub mod four_point;
pub mod kobbelt;
pub mod lattice_mask;
pub mod laurent;
pub mod limit_stencil;
pub mod local_matrix;
pub mod loop_limit;
pub mod loop_scheme;
pub mod mask;
pub mod polygon;
pub mod scheme_kind;
pub mod spectrum;
pub mod subdivision_matrix;

mod mesh;
mod refiner;
mod scheme;
mod stencil;
mod stencil_table;

pub mod laws;

pub use mesh::{
    EdgeId, FaceId, HalfEdgeId, HalfEdgeMesh, HalfEdgeTables, Mesh, MeshError, Refinement,
    VertexId, VertexRing, files, solids,
};
pub use refiner::{FastScheme, Refiner};
pub use scheme::{SchemeError, SurfaceScheme};
pub use stencil_table::StencilCascade;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use box_spline::box_spline_222;
pub use butterfly::{
    Butterfly, butterfly_centre_weight, butterfly_cosine_formula, butterfly_star_weights,
    butterfly_weights,
};
pub use catmull_clark::{
    CatmullClark, QuadrilateralStar, catmull_clark_limit_weights, catmull_clark_tangent_factor,
    catmull_clark_vertex_weights,
};
pub use characteristic_map::{CharacteristicMap, CharacteristicMapTest, CharacteristicRing};
pub use contractivity::{Contraction, Smoothness, norm_between};
pub use cosine::{CosineError, CosineOfTurn};
pub use creases::{CreaseError, Creases, VertexRule};
pub use doo_sabin::{DooSabin, doo_sabin_face, doo_sabin_weights};
pub use fan::{Fan, FanNet};
pub use four_point::{critical_tension, four_point_differences, four_point_rule};
pub use kobbelt::{Kobbelt, kobbelt_virtual_point, kobbelt_virtual_weights, kobbelt_weights};
pub use lattice_mask::{LatticeIndex, LatticeMask};
pub use laurent::LaurentPolynomial;
pub use limit_stencil::{LimitStencil, LimitStencilError};
pub use local_matrix::LocalMatrix;
pub use loop_limit::{loop_boundary_tangent_weights, loop_tangent_weights};
pub use loop_scheme::{
    Loop, loop_beta, loop_boundary_weights, loop_edge_weights, loop_lattice_mask,
    loop_limit_weight, loop_subdominant_eigenvalue,
};
pub use mask::{Mask, MaskError};
pub use polygon::{Closing, ControlPolygon, ControlPolygonError};
pub use scheme_kind::SchemeKind;
pub use spectrum::{Eigenvalue, Spectrum, eigenvector};
pub use subdivision_matrix::{SubdivisionMatrix, SubdivisionMatrixError};

/// The chapter's pages, so that `cargo test` runs each of their Rust blocks.
#[cfg(doctest)]
mod chapter {
    #[doc = include_str!("../../book/src/subdivision/corner-cutting.md")]
    mod corner_cutting {}
    #[doc = include_str!("../../book/src/subdivision/uniform-splines.md")]
    mod uniform_splines {}
    #[doc = include_str!("../../book/src/subdivision/symbols.md")]
    mod symbols {}
    #[doc = include_str!("../../book/src/subdivision/four-point.md")]
    mod four_point {}
    #[doc = include_str!("../../book/src/subdivision/limit-points.md")]
    mod limit_points {}
    #[doc = include_str!("../../book/src/subdivision/meshes.md")]
    mod meshes {}
    #[doc = include_str!("../../book/src/subdivision/loop.md")]
    mod loop_scheme {}
    #[doc = include_str!("../../book/src/subdivision/butterfly.md")]
    mod butterfly {}
    #[doc = include_str!("../../book/src/subdivision/catmull-clark.md")]
    mod catmull_clark {}
    #[doc = include_str!("../../book/src/subdivision/doo-sabin.md")]
    mod doo_sabin {}
    #[doc = include_str!("../../book/src/subdivision/kobbelt.md")]
    mod kobbelt {}
    #[doc = include_str!("../../book/src/subdivision/eigenstructure.md")]
    mod eigenstructure {}
}
