//! A figure: parameters and a function that draws.

use std::fmt;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

use super::canvas::Canvas;
use super::error::{BoxError, FigureError};
use super::parameter::{Parameter, ParameterKind, Value, Values};
use super::place::{Place, Position};
use super::plot::{HandlePlace, Plot};
use super::shape::Window;

type Drawing = Box<dyn Fn(&Values, &mut Canvas) -> Result<(), BoxError> + Send + Sync>;

/// A figure of the book: one function that draws it from named parameters.
///
/// With the default values it gives the picture that is reviewed and printed; with the reader's values the same
/// function draws it again.
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
/// use cagd::figure::{Figure, PointStyle, Style};
///
/// let figure = Figure::new("demo", "A parabola", "A quadratic Bézier curve with its control polygon.")
///     .handles("b", [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])
///     .slider("t", 0.0..=1.0, 0.5)
///     .draw(|values, canvas| {
///         let curve = BezierCurve::new(values.points("b")?)?;
///         canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
///         canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
///         canvas.point("b(t)", curve.at(values.number("t")?), PointStyle::Result);
///         Ok(())
///     });
/// let plot = figure.plot(&figure.defaults())?;
/// assert_eq!(plot.point("b(t)")?, Point::new([1.0, 1.0]));
/// assert!(plot.svg().starts_with("<svg"));
/// # Ok::<(), cagd::figure::BoxError>(())
/// ```
pub struct Figure {
    id: String,
    title: String,
    description: String,
    parameters: Vec<Parameter>,
    rows: Vec<Vec<String>>,
    drawing: Option<Drawing>,
    windows: OnceLock<Vec<(String, Window)>>,
}

impl fmt::Debug for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Figure")
            .field("id", &self.id)
            .field("parameters", &self.parameters)
            .finish_non_exhaustive()
    }
}

impl Figure {
    /// A figure with the id of its ledger item, a title, and a description for those who cannot see it.
    pub fn new(id: &str, title: &str, description: &str) -> Self {
        Figure {
            id: id.into(),
            title: title.into(),
            description: description.into(),
            parameters: vec![],
            rows: vec![],
            drawing: None,
            windows: OnceLock::new(),
        }
    }

    // ── parameters ──

    fn parameter(mut self, name: &str, kind: ParameterKind) -> Self {
        self.parameters.push(Parameter {
            name: name.into(),
            kind,
        });
        self
    }

    /// Points `name_0, name_1, …` that the reader may drag, in the first panel.
    #[must_use]
    pub fn handles<P: Position>(self, name: &str, defaults: impl IntoIterator<Item = P>) -> Self {
        let defaults = defaults
            .into_iter()
            .map(|p| Place::from(p.position()))
            .collect();
        self.parameter(
            name,
            ParameterKind::Handles {
                defaults,
                panel: None,
            },
        )
    }

    /// Points that the reader may drag in the panel named.
    #[must_use]
    pub fn handles_in<P: Position>(
        self,
        panel: &str,
        name: &str,
        defaults: impl IntoIterator<Item = P>,
    ) -> Self {
        let defaults = defaults
            .into_iter()
            .map(|p| Place::from(p.position()))
            .collect();
        self.parameter(
            name,
            ParameterKind::Handles {
                defaults,
                panel: Some(panel.into()),
            },
        )
    }

    /// One point that the reader may drag, in the first panel.
    #[must_use]
    pub fn handle(self, name: &str, default: impl Position) -> Self {
        let default = Place::from(default.position());
        self.parameter(
            name,
            ParameterKind::Handle {
                default,
                panel: None,
            },
        )
    }

    /// One point that the reader may drag in the panel named.
    #[must_use]
    pub fn handle_in(self, panel: &str, name: &str, default: impl Position) -> Self {
        let default = Place::from(default.position());
        self.parameter(
            name,
            ParameterKind::Handle {
                default,
                panel: Some(panel.into()),
            },
        )
    }

    /// A real number in a closed interval.
    #[must_use]
    pub fn slider(self, name: &str, range: RangeInclusive<f64>, default: f64) -> Self {
        let (low, high) = (*range.start(), *range.end());
        self.parameter(name, ParameterKind::Slider { low, high, default })
    }

    /// A whole number in a closed range.
    #[must_use]
    pub fn stepper(self, name: &str, range: RangeInclusive<usize>, default: usize) -> Self {
        let (low, high) = (*range.start(), *range.end());
        let names = &[];
        self.parameter(
            name,
            ParameterKind::Stepper {
                low,
                high,
                default,
                names,
            },
        )
    }

    /// One of several named things; its value is the index of the name, at first `default`.
    ///
    /// ```
    /// use cagd::figure::{Figure, Value};
    ///
    /// let figure = Figure::new("demo", "Title", "Description.").choice("edges", &["smooth", "sharp"], 0);
    /// assert_eq!(figure.parameters()[0].extremes(), vec![Value::Count(0), Value::Count(1)]);
    /// ```
    #[must_use]
    pub fn choice(self, name: &str, names: &'static [&'static str], default: usize) -> Self {
        let high = names.len().saturating_sub(1);
        self.parameter(
            name,
            ParameterKind::Stepper {
                low: 0,
                high,
                default,
                names,
            },
        )
    }

    /// How panels are arranged: rows of panel names, from above.
    ///
    /// Without it, two panels stand side by side and more stand below each other.
    #[must_use]
    pub fn rows(mut self, rows: &[&[&str]]) -> Self {
        self.rows = rows
            .iter()
            .map(|row| row.iter().map(|&name| name.into()).collect())
            .collect();
        self
    }

    /// The function that draws.
    ///
    /// It must depend on its values alone.
    #[must_use]
    pub fn draw(
        mut self,
        drawing: impl Fn(&Values, &mut Canvas) -> Result<(), BoxError> + Send + Sync + 'static,
    ) -> Self {
        self.drawing = Some(Box::new(drawing));
        self
    }

    // ── questions ──

    /// The id: that of the ledger item.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What is to be seen, in words.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.description
    }

    /// What the reader can change, in the order of declaration.
    #[must_use]
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// The default values.
    #[must_use]
    pub fn defaults(&self) -> Values {
        Values::defaults(&self.id, &self.parameters)
    }

    /// Reads values from a query string such as `t=0.25&b=0,0;1,2`; what it leaves out keeps its default.
    ///
    /// # Errors
    /// [`FigureError`] if the text cannot be read, or a value does not suit its parameter.
    pub fn values(&self, text: &str) -> Result<Values, FigureError> {
        Values::read(&self.id, &self.parameters, text)
    }

    // ── drawing ──

    /// Draws the figure with these values.
    ///
    /// # Errors
    /// [`FigureError`] if a value does not suit its parameter, or the figure cannot be drawn with them.
    pub fn plot(&self, values: &Values) -> Result<Plot, FigureError> {
        let mut plot = self.drawn(values)?;
        plot.windows = match self.windows.get() {
            Some(windows) => windows.clone(),
            None => {
                let defaults = self.defaults();
                let windows = if *values == defaults {
                    natural_windows(&plot)
                } else {
                    natural_windows(&self.drawn(&defaults)?)
                };
                self.windows.get_or_init(|| windows).clone()
            }
        };
        Ok(plot)
    }

    /// The figure with its default values, as SVG.
    ///
    /// # Errors
    /// [`FigureError`] if it cannot be drawn.
    pub fn svg(&self) -> Result<String, FigureError> {
        Ok(self.plot(&self.defaults())?.svg())
    }

    fn drawn(&self, values: &Values) -> Result<Plot, FigureError> {
        values.check(&self.parameters)?;
        let drawing = self
            .drawing
            .as_ref()
            .ok_or_else(|| FigureError::NothingDrawn {
                figure: self.id.clone(),
            })?;
        let mut canvas = Canvas::new(&self.id);
        drawing(values, &mut canvas).map_err(|source| match source.downcast::<FigureError>() {
            Ok(own) => *own,
            Err(source) => FigureError::Drawing {
                figure: self.id.clone(),
                source,
            },
        })?;
        let drawn = canvas.finish()?;
        let plot = Plot {
            id: self.id.clone(),
            title: self.title.clone(),
            description: self.description.clone(),
            rows: self.rows.clone(),
            panels: drawn.panels,
            readings: drawn.readings,
            remarks: drawn.remarks,
            windows: vec![],
            handles: self.handle_places(values)?,
        };
        plot.check()?;
        Ok(plot)
    }

    fn handle_places(&self, values: &Values) -> Result<Vec<HandlePlace>, FigureError> {
        let mut handles = vec![];
        for Parameter { name, kind } in &self.parameters {
            let (ParameterKind::Handles { panel, .. } | ParameterKind::Handle { panel, .. }) = kind
            else {
                continue;
            };
            let mut handle = |index, place| {
                handles.push(HandlePlace {
                    parameter: name.clone(),
                    index,
                    place,
                    panel: panel.clone(),
                });
            };
            match values.get(name)? {
                Value::Points(points) => points
                    .iter()
                    .enumerate()
                    .for_each(|(i, &p)| handle(Some(i), p)),
                Value::Point(point) => handle(None, *point),
                Value::Number(_) | Value::Count(_) => {}
            }
        }
        Ok(handles)
    }
}

fn natural_windows(plot: &Plot) -> Vec<(String, Window)> {
    plot.panels
        .iter()
        .filter_map(|panel| Some((panel.name.clone(), panel.natural_window()?)))
        .collect()
}
