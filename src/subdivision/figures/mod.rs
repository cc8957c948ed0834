//! The figures of this chapter, one module per section.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod eigenstructure;
mod four_point;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod meshes;
mod symbols;
mod uniform_splines;

pub use butterfly::*;
pub use catmull_clark::*;
pub use corner_cutting::*;
pub use doo_sabin::*;
pub use eigenstructure::*;
pub use four_point::*;
pub use kobbelt::*;
pub use limit_points::*;
pub use loop_scheme::*;
pub use meshes::*;
pub use symbols::*;
pub use uniform_splines::*;

use crate::figure::Figure;

/// The figures on polygons that are averaged, on uniform splines and on meshes.
#[must_use]
pub fn polygons_and_meshes() -> Vec<Figure> {
    joined([corner_cutting::all(), meshes::all(), uniform_splines::all()])
}

/// The figures on the curves of the four-point scheme.
#[must_use]
pub fn four_point_curves() -> Vec<Figure> {
    vec![
        figure_four_point(),
        four_point_convergence(),
        figure_precision(),
    ]
}

/// The figure on the tension of the four-point scheme.
#[must_use]
pub fn tension() -> Vec<Figure> {
    vec![four_point_tension()]
}

/// The figures on masks, their norms and their limits.
#[must_use]
pub fn masks() -> Vec<Figure> {
    joined([
        limit_points::all(),
        symbols::all(),
        vec![four_point_analysis()],
    ])
}

/// The figures on Loop's scheme.
#[must_use]
pub fn loop_surfaces() -> Vec<Figure> {
    loop_scheme::all()
}

/// The figures on the Butterfly scheme.
#[must_use]
pub fn butterfly_surfaces() -> Vec<Figure> {
    butterfly::all()
}

/// The figures on the schemes for quadrilaterals.
#[must_use]
pub fn quadrilaterals() -> Vec<Figure> {
    joined([catmull_clark::all(), doo_sabin::all(), kobbelt::all()])
}

/// The figures on eigenvalues.
#[must_use]
pub fn eigenvalues() -> Vec<Figure> {
    eigenstructure::all()
}

fn joined<const N: usize>(sections: [Vec<Figure>; N]) -> Vec<Figure> {
    sections.into_iter().flatten().collect()
}
