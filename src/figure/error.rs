//! What can be wrong with a figure, its values, or a question about its plot.

use std::error::Error;

/// Any error: what a drawing function and a check may return, so that `?` works on all of them.
pub type BoxError = Box<dyn Error + Send + Sync>;

/// Why a figure could not be drawn.
///
/// ```
/// use cagd::figure::{Figure, FigureError};
///
/// let figure = Figure::new("demo", "A demonstration", "Nothing but a slider.")
///     .slider("t", 0.0..=1.0, 0.5)
///     .draw(|values, canvas| {
///         canvas.point("p", [values.number("t")?, 0.0], cagd::figure::PointStyle::Result);
///         Ok(())
///     });
/// let outside = figure.defaults().with_number("t", 2.0);
/// assert!(matches!(figure.plot(&outside), Err(FigureError::OutOfRange { .. })));
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// A parameter is asked for, or set, that the figure does not have.
    #[error("figure {figure} has no parameter {name}; it has: {known}")]
    UnknownParameter {
        /// The figure's id.
        figure: String,
        /// The name that is not known.
        name: String,
        /// The names that are.
        known: String,
    },
    /// Two parameters of a figure have the same name.
    #[error("figure {figure} declares the parameter {name} twice; rename one of them")]
    DuplicateParameter {
        /// The figure's id.
        figure: String,
        /// The name that occurs twice.
        name: String,
    },
    /// A value has another kind than its parameter: a point for a slider, say.
    #[error("parameter {name} of figure {figure} is {expected}, not {found}")]
    WrongKind {
        /// The figure's id.
        figure: String,
        /// The parameter.
        name: String,
        /// What the parameter is.
        expected: &'static str,
        /// What was given or asked for.
        found: &'static str,
    },
    /// A value lies outside the range of its parameter.
    #[error("parameter {name} of figure {figure} must lie in [{low}, {high}], not at {value}")]
    OutOfRange {
        /// The figure's id.
        figure: String,
        /// The parameter.
        name: String,
        /// The value that was given.
        value: f64,
        /// The least value allowed.
        low: f64,
        /// The greatest value allowed.
        high: f64,
    },
    /// A list of points has the wrong length.
    #[error("parameter {name} of figure {figure} has {expected} points, not {found}")]
    WrongCount {
        /// The figure's id.
        figure: String,
        /// The parameter.
        name: String,
        /// The number of points declared.
        expected: usize,
        /// The number of points given.
        found: usize,
    },
    /// A value is NaN or infinite.
    #[error("parameter {name} of figure {figure} is not a finite number; give a finite one")]
    NotFinite {
        /// The figure's id.
        figure: String,
        /// The parameter.
        name: String,
    },
    /// A parameter's value could not be read from text.
    #[error(
        "cannot read `{text}` as values of figure {figure}: {reason}; write for instance t=0.5&p=1,2"
    )]
    Unreadable {
        /// The figure's id.
        figure: String,
        /// The text that was given.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A handle belongs to a panel that is not drawn.
    #[error(
        "figure {figure} shows the handle {name} in the panel `{panel}`, but draws only: {known}"
    )]
    UnknownPanel {
        /// The figure's id.
        figure: String,
        /// The parameter.
        name: String,
        /// The panel it asks for.
        panel: String,
        /// The panels that are drawn.
        known: String,
    },
    /// The figure has no drawing function.
    #[error("figure {figure} draws nothing; give it a drawing function with Figure::draw")]
    NothingDrawn {
        /// The figure's id.
        figure: String,
    },
    /// Something was drawn at a place that is no place: NaN, infinite, or not positive on a logarithmic axis.
    #[error("figure {figure} draws `{item}` at ({x}, {y}), which has no place in the picture")]
    NoPlace {
        /// The figure's id.
        figure: String,
        /// The name of what was drawn.
        item: String,
        /// Its abscissa.
        x: f64,
        /// Its ordinate.
        y: f64,
    },
    /// Two things in one panel have the same name.
    #[error(
        "figure {figure} draws two things named `{item}` in the panel `{panel}`; give each a name of its own"
    )]
    NameTaken {
        /// The figure's id.
        figure: String,
        /// The panel.
        panel: String,
        /// The name that occurs twice.
        item: String,
    },
    /// A polyline or polygon has too few points.
    #[error("figure {figure}: `{item}` needs at least {expected} points, not {found}")]
    TooFewPoints {
        /// The figure's id.
        figure: String,
        /// The name of what was drawn.
        item: String,
        /// The least number of points.
        expected: usize,
        /// The number of points given.
        found: usize,
    },
    /// A label could not be typeset.
    #[error("figure {figure}: cannot typeset the label `{text}`: {reason}")]
    Label {
        /// The figure's id.
        figure: String,
        /// The label's source.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// The drawing function failed: an error of the geometry, for instance.
    #[error("figure {figure} cannot be drawn with these values: {source}")]
    Drawing {
        /// The figure's id.
        figure: String,
        /// The error of the drawing function.
        source: BoxError,
    },
}

/// Why a question about a plot has no answer.
///
/// ```
/// use cagd::figure::{Figure, PlotError, PointStyle};
///
/// let figure = Figure::new("demo", "A point", "One point at the origin.").draw(|_, canvas| {
///     canvas.point("origin", [0.0, 0.0], PointStyle::Result);
///     Ok(())
/// });
/// let plot = figure.plot(&figure.defaults())?;
/// assert!(matches!(plot.point("centre"), Err(PlotError::UnknownItem { .. })));
/// assert!(matches!(plot.polyline("origin"), Err(PlotError::WrongShape { .. })));
/// # Ok::<(), cagd::figure::BoxError>(())
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// Nothing of that name was drawn.
    #[error("the plot of {figure} has no item `{name}`; it has: {known}")]
    UnknownItem {
        /// The figure's id.
        figure: String,
        /// The name asked for.
        name: String,
        /// The names that were drawn.
        known: String,
    },
    /// Several panels have something of that name.
    #[error(
        "the plot of {figure} has `{name}` in several panels; ask for `panel/{name}` with one of: {panels}"
    )]
    Ambiguous {
        /// The figure's id.
        figure: String,
        /// The name asked for.
        name: String,
        /// The panels that have it.
        panels: String,
    },
    /// The item has another shape.
    #[error("`{name}` in the plot of {figure} is {found}, not {expected}")]
    WrongShape {
        /// The figure's id.
        figure: String,
        /// The name asked for.
        name: String,
        /// The shape asked for.
        expected: &'static str,
        /// The shape that was drawn.
        found: &'static str,
    },
}
