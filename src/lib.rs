//! Curves and surfaces for design: a literate exercise workbook, as a library.
//!
//! This file is the map of the house. Read the modules in this order; each knows only those above it.
//!
//! | module | is |
//! |---|---|
//! | [`scalar`] | the number types every algorithm runs over: `f64`, exact rationals, dual and complex numbers |
//! | [`law`] | what a law is: a theorem as an executable function, and one judge for all of them |
//! | [`affine`] | points, vectors, affine combinations and maps, intervals, convex hulls |
//! | [`curves`] | what holds for any parametric curve: curvature, arc length, sampling |
//! | [`bezier`] | Bézier curves: de Casteljau, Bernstein polynomials, blossoms, subdivision, bounds |
//! | [`bspline`] | uniform B-splines, as far as subdivision needs them |
//! | [`subdivision`] | curves and surfaces as limits of refined polygons and meshes |
//! | [`check`] | what the tests of an exercise are written with |
//! | [`tableaux`] | every tableau that deals fresh numbers for computing by hand |
//! | `figure` | canvas, style, handles and sliders: what every figure is drawn with (feature `figures`) |
//! | `gallery` | every figure of every chapter, by id (feature `figures`) |
//! | `live` | figures drawn again with the reader's values, for pages (feature `figures`) |
//! | `book` | statements, directives, evidence and the mdBook preprocessor (feature `book`) |
//! | `workbook` | the server and the command line (feature `workbook`) |

pub mod scalar;

pub mod law;

pub mod affine;
pub mod curves;

pub mod bezier;
pub mod bspline;
pub mod subdivision;

pub mod check;
pub mod tableaux;

#[cfg(feature = "figures")]
pub mod figure;
#[cfg(feature = "figures")]
pub mod gallery;

#[cfg(feature = "figures")]
pub mod live;

#[cfg(feature = "book")]
pub mod book;

#[cfg(feature = "workbook")]
pub mod workbook;
