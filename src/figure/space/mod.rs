//! Figures in space: a view that the reader turns, and surfaces of polygons, shaded, the nearer hiding the farther.
//!
//! A figure has a handle for the view; all that stands in space is put into the plane by [`View::place`], and then
//! everything that a canvas can draw may be drawn there:
//!
//! ```
//! use cagd::affine::Point;
//! use cagd::figure::{Figure, PointStyle, Surface, View};
//!
//! let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]].map(Point::new);
//! let faces = vec![vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
//! let figure = Figure::new("demo", "A corner", "A tetrahedron with three right angles at one corner.")
//!     .handle("view", View::degrees(30.0, 25.0).knob(2.0))
//!     .draw(move |values, canvas| {
//!         let view = View::of_knob(values.point("view")?, 2.0);
//!         canvas.surface("tetrahedron", &view, &Surface::new(corners, faces.clone()).closed());
//!         canvas.point("tip", view.place(&corners[3]), PointStyle::Result);
//!         Ok(())
//!     });
//! let plot = figure.plot(&figure.defaults())?;
//! assert_eq!(plot.surface("tetrahedron")?.places.len(), 4);
//! # Ok::<(), cagd::figure::BoxError>(())
//! ```

mod surface;
mod view;

pub use surface::{Cover, PaintedFace, Surface};
pub(super) use surface::{SHADES, groups};
pub use view::View;

use super::canvas::Canvas;
use super::place::{Place, Position};
use super::shape::{Looks, Shape};
use super::style::PointStyle;

/// A surface as it was painted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePlot<'a> {
    /// Where each vertex stands in the picture.
    pub places: &'a [Place],
    /// The faces that are seen, the farthest first.
    pub faces: &'a [PaintedFace],
}

impl Canvas {
    /// A surface in space, with room to turn it.
    pub fn surface(&mut self, name: &str, view: &View, surface: &Surface) {
        for place in surface.room(view) {
            self.include(place);
        }
        let shape = Shape::Surface {
            places: surface.places(view),
            faces: surface.painted(view),
        };
        let edges = surface.has_edges();
        self.draw(name, shape, Looks::Surface { edges });
    }

    /// A stencil: points with their weights, and the point that is their weighted mean.
    ///
    /// The points are named `name 0`, `name 1`, …, the mean `name`; a weight is in the language of labels, such as `3/8`.
    pub fn stencil<P: Position, W: AsRef<str>>(
        &mut self,
        name: &str,
        weights: impl IntoIterator<Item = (P, W)>,
        mean: impl Position,
    ) {
        for (i, (at, weight)) in weights.into_iter().enumerate() {
            self.point(&format!("{name} {i}"), &at, PointStyle::OnCurve);
            self.label(weight.as_ref(), &at);
        }
        self.point(name, mean, PointStyle::Result);
    }
}
