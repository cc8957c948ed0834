//! What every figure is drawn with.
//!
//! A [`Figure`] is a function of named parameters that draws on a [`Canvas`]; what it has drawn is a [`Plot`], in
//! which a test finds everything by name; a plot becomes SVG. The same function draws the reviewed picture, with
//! the default values, and the live one, with the reader's.
//!
//! ```text
//! Figure ── plot(values) ─▶ Plot ── svg() ─▶ SVG
//!    │                        └── polyline("curve"), point("b(t)"), … ─▶ a check
//!    └─ parameters: handles to drag, sliders, steppers, choices
//! ```
//!
//! # The visual language
//!
//! A line is styled by what it means: [`Style::Curve`], [`Style::ControlPolygon`], [`Style::Level`], …; a point by
//! [`PointStyle`]. Colours are CSS variables (`--fig-curve`, `--fig-polygon`, `--fig-accent`, `--fig-level-1` to
//! `--fig-level-4`, `--fig-guide`, `--fig-region`, `--fig-paper`), text has the page's colour (`currentColor`) and the font
//! `--fig-font`. Inside every SVG they have fallbacks for light and dark; [`PAGE_CSS`] sets them for a page.
//!
//! # The same bytes everywhere
//!
//! Coordinates are written in hundredths of a unit; roots, logarithms and trigonometry come from `libm`; nothing
//! depends on fonts that are installed. So native and wasm builds, optimised or not, give the same SVG.

mod backend;
mod canvas;
mod clip;
mod error;
#[expect(
    clippy::module_inception,
    reason = "the type Figure lives in the file of its name"
)]
mod figure;
mod glyph;
mod label;
mod layout;
mod palette;
mod parameter;
mod pen;
mod place;
mod placement;
mod plot;
mod reading;
mod render;
mod scheme;
mod shape;
mod space;
mod stroke;
mod style;
mod ticks;

pub use canvas::Canvas;
pub use error::{BoxError, FigureError, PlotError};
pub use figure::Figure;
pub use palette::PAGE_CSS;
pub use parameter::{Parameter, ParameterKind, Value, Values};
pub use place::{Place, Position, midpoint};
pub use plot::{Frame, HandlePlace, Plot};
pub use reading::LawReading;
pub(crate) use reading::{power_of_ten, readable};
pub use render::Picture;
pub use scheme::Scheme;
pub use shape::{Axes, Side, Window};
pub use space::{Cover, PaintedFace, Surface, SurfacePlot, View};
pub use style::{PointStyle, Style};

/// A number with at most `digits` decimals, without trailing zeros and without a negative zero.
///
/// ```
/// use cagd::figure::decimal;
/// assert_eq!(decimal(0.25, 3), "0.25");
/// assert_eq!(decimal(-0.0001, 3), "0");
/// assert_eq!(decimal(2.0, 1), "2");
/// ```
#[must_use]
pub fn decimal(x: f64, digits: usize) -> String {
    let text = format!("{x:.digits$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    match text {
        "-0" => "0".into(),
        text => text.into(),
    }
}
