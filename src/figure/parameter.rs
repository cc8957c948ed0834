//! What a reader can change in a figure, and the values it has.

use std::fmt;

use super::error::FigureError;
use super::place::{Place, Position};

/// How far a handle may be dragged from the origin: far beyond any picture, and far from overflow.
const FARTHEST: f64 = 1e6;

/// Something in a figure that the reader can change.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The name, which is also its mathematical label: `t`, `b`, `\alpha`.
    pub name: String,
    /// What can be changed, and the default.
    pub kind: ParameterKind,
}

/// The kinds of parameters.
#[derive(Debug, Clone, PartialEq)]
pub enum ParameterKind {
    /// Draggable points `b_0, b_1, …`, in the panel named (or the first one).
    Handles {
        /// Where the points are at first.
        defaults: Vec<Place>,
        /// The panel that shows them.
        panel: Option<String>,
    },
    /// One draggable point.
    Handle {
        /// Where the point is at first.
        default: Place,
        /// The panel that shows it.
        panel: Option<String>,
    },
    /// A real number in a closed interval.
    Slider {
        /// The least value.
        low: f64,
        /// The greatest value.
        high: f64,
        /// The value at first.
        default: f64,
    },
    /// A whole number in a closed range.
    Stepper {
        /// The least value.
        low: usize,
        /// The greatest value.
        high: usize,
        /// The value at first.
        default: usize,
        /// What the values stand for, from the least one on; empty if they are numbers.
        names: &'static [&'static str],
    },
}

impl Parameter {
    pub(super) fn default_value(&self) -> Value {
        match &self.kind {
            ParameterKind::Handles { defaults, .. } => Value::Points(defaults.clone()),
            ParameterKind::Handle { default, .. } => Value::Point(*default),
            ParameterKind::Slider { default, .. } => Value::Number(*default),
            ParameterKind::Stepper { default, .. } => Value::Count(*default),
        }
    }

    /// The values at the ends of its range: what the tests of all figures try.
    ///
    /// ```
    /// use cagd::figure::{Figure, Value};
    ///
    /// let figure = Figure::new("demo", "Title", "Description.").stepper("n", 1..=9, 4);
    /// assert_eq!(figure.parameters()[0].extremes(), vec![Value::Count(1), Value::Count(9)]);
    /// ```
    pub fn extremes(&self) -> Vec<Value> {
        match self.kind {
            ParameterKind::Slider { low, high, .. } => {
                vec![Value::Number(low), Value::Number(high)]
            }
            ParameterKind::Stepper { low, high, .. } => vec![Value::Count(low), Value::Count(high)],
            ParameterKind::Handles { .. } | ParameterKind::Handle { .. } => vec![],
        }
    }

    fn check(&self, figure: &str, value: &Value) -> Result<(), FigureError> {
        let within = |value: f64, low: f64, high: f64| {
            if !value.is_finite() {
                return Err(FigureError::NotFinite {
                    figure: figure.into(),
                    name: self.name.clone(),
                });
            }
            if value < low || value > high {
                return Err(FigureError::OutOfRange {
                    figure: figure.into(),
                    name: self.name.clone(),
                    value,
                    low,
                    high,
                });
            }
            Ok(())
        };
        let place = |place: &Place| {
            place
                .position()
                .iter()
                .try_for_each(|&coordinate| within(coordinate, -FARTHEST, FARTHEST))
        };
        match (&self.kind, value) {
            (ParameterKind::Handles { defaults, .. }, Value::Points(points)) => {
                if points.len() != defaults.len() {
                    return Err(FigureError::WrongCount {
                        figure: figure.into(),
                        name: self.name.clone(),
                        expected: defaults.len(),
                        found: points.len(),
                    });
                }
                points.iter().try_for_each(place)
            }
            (ParameterKind::Handle { .. }, Value::Point(point)) => place(point),
            (ParameterKind::Slider { low, high, .. }, Value::Number(number)) => {
                within(*number, *low, *high)
            }
            (ParameterKind::Stepper { low, high, .. }, Value::Count(count)) => {
                within(*count as f64, *low as f64, *high as f64)
            }
            (_, value) => Err(FigureError::WrongKind {
                figure: figure.into(),
                name: self.name.clone(),
                expected: self.default_value().kind(),
                found: value.kind(),
            }),
        }
    }
}

/// The value of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Of a slider.
    Number(f64),
    /// Of a stepper.
    Count(usize),
    /// Of a handle.
    Point(Place),
    /// Of several handles.
    Points(Vec<Place>),
}

impl Value {
    fn kind(&self) -> &'static str {
        match self {
            Value::Number(_) => "a number",
            Value::Count(_) => "a whole number",
            Value::Point(_) => "a point",
            Value::Points(_) => "a list of points",
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = |f: &mut fmt::Formatter<'_>, place: &Place| {
            let [x, y] = place.position();
            write!(f, "{x},{y}")
        };
        match self {
            Value::Number(number) => write!(f, "{number}"),
            Value::Count(count) => write!(f, "{count}"),
            Value::Point(point) => place(f, point),
            Value::Points(points) => points.iter().enumerate().try_for_each(|(i, point)| {
                if i > 0 {
                    f.write_str(";")?;
                }
                place(f, point)
            }),
        }
    }
}

/// A value for every parameter of one figure, looked up by name.
///
/// [`Display`](fmt::Display) writes them as a query string, which [`Figure::values`](super::Figure::values) reads back:
///
/// ```
/// use cagd::figure::Figure;
///
/// let figure = Figure::new("demo", "Title", "Description.")
///     .handles("b", [[0.0, 0.0], [1.0, 2.5]])
///     .slider("t", 0.0..=1.0, 0.25);
/// let text = figure.defaults().to_string();
/// assert_eq!(text, "b=0,0;1,2.5&t=0.25");
/// assert_eq!(figure.values(&text)?, figure.defaults());
/// # Ok::<(), cagd::figure::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Values {
    figure: String,
    entries: Vec<(String, Value)>,
}

impl Values {
    pub(super) fn defaults(figure: &str, parameters: &[Parameter]) -> Self {
        Values {
            figure: figure.into(),
            entries: parameters
                .iter()
                .map(|p| (p.name.clone(), p.default_value()))
                .collect(),
        }
    }

    /// These values, but another one for the parameter named.
    ///
    /// Whether the figure has that parameter, and whether the value suits it, is checked when the figure is drawn.
    #[must_use]
    pub fn with(mut self, name: &str, value: Value) -> Self {
        match self.entries.iter_mut().find(|(known, _)| known == name) {
            Some(entry) => entry.1 = value,
            None => self.entries.push((name.into(), value)),
        }
        self
    }

    /// These values, with another number for a slider.
    #[must_use]
    pub fn with_number(self, name: &str, number: f64) -> Self {
        self.with(name, Value::Number(number))
    }

    /// These values, with another whole number for a stepper.
    #[must_use]
    pub fn with_count(self, name: &str, count: usize) -> Self {
        self.with(name, Value::Count(count))
    }

    /// These values, with another place for a handle.
    #[must_use]
    pub fn with_point(self, name: &str, at: impl Position) -> Self {
        self.with(name, Value::Point(Place::from(at.position())))
    }

    /// These values, with other places for a list of handles.
    #[must_use]
    pub fn with_points<P: Position>(self, name: &str, points: impl IntoIterator<Item = P>) -> Self {
        let points = points
            .into_iter()
            .map(|p| Place::from(p.position()))
            .collect();
        self.with(name, Value::Points(points))
    }

    /// The value of a parameter.
    ///
    /// # Errors
    /// [`FigureError::UnknownParameter`] if the figure has none of that name.
    pub fn get(&self, name: &str) -> Result<&Value, FigureError> {
        self.entries
            .iter()
            .find(|(known, _)| known == name)
            .map(|(_, value)| value)
            .ok_or_else(|| FigureError::UnknownParameter {
                figure: self.figure.clone(),
                name: name.into(),
                known: known(self.entries.iter().map(|(name, _)| name.as_str())),
            })
    }

    /// The number at which a slider stands.
    ///
    /// # Errors
    /// [`FigureError::UnknownParameter`], or [`FigureError::WrongKind`] if `name` is no slider.
    pub fn number(&self, name: &str) -> Result<f64, FigureError> {
        match self.get(name)? {
            Value::Number(number) => Ok(*number),
            value => Err(self.wrong_kind(name, value, "a number")),
        }
    }

    /// The whole number at which a stepper stands.
    ///
    /// # Errors
    /// [`FigureError::UnknownParameter`], or [`FigureError::WrongKind`] if `name` is no stepper.
    pub fn count(&self, name: &str) -> Result<usize, FigureError> {
        match self.get(name)? {
            Value::Count(count) => Ok(*count),
            value => Err(self.wrong_kind(name, value, "a whole number")),
        }
    }

    /// The place of a single handle.
    ///
    /// # Errors
    /// [`FigureError::UnknownParameter`], or [`FigureError::WrongKind`] if `name` is no single handle.
    pub fn point(&self, name: &str) -> Result<Place, FigureError> {
        match self.get(name)? {
            Value::Point(point) => Ok(*point),
            value => Err(self.wrong_kind(name, value, "a point")),
        }
    }

    /// The places of a list of handles.
    ///
    /// # Errors
    /// [`FigureError::UnknownParameter`], or [`FigureError::WrongKind`] if `name` is no list of handles.
    pub fn points(&self, name: &str) -> Result<Vec<Place>, FigureError> {
        match self.get(name)? {
            Value::Points(points) => Ok(points.clone()),
            value => Err(self.wrong_kind(name, value, "a list of points")),
        }
    }

    fn wrong_kind(&self, name: &str, value: &Value, asked: &'static str) -> FigureError {
        FigureError::WrongKind {
            figure: self.figure.clone(),
            name: name.into(),
            expected: value.kind(),
            found: asked,
        }
    }

    /// Checks every value against its parameter.
    pub(super) fn check(&self, parameters: &[Parameter]) -> Result<(), FigureError> {
        for (i, parameter) in parameters.iter().enumerate() {
            if parameters[..i]
                .iter()
                .any(|earlier| earlier.name == parameter.name)
            {
                return Err(FigureError::DuplicateParameter {
                    figure: self.figure.clone(),
                    name: parameter.name.clone(),
                });
            }
            parameter.check(&self.figure, self.get(&parameter.name)?)?;
        }
        match self
            .entries
            .iter()
            .find(|(name, _)| parameters.iter().all(|p| &p.name != name))
        {
            None => Ok(()),
            Some((name, _)) => Err(FigureError::UnknownParameter {
                figure: self.figure.clone(),
                name: name.clone(),
                known: known(parameters.iter().map(|p| p.name.as_str())),
            }),
        }
    }

    /// Reads values from a query string; what it does not mention keeps its default.
    pub(super) fn read(
        figure: &str,
        parameters: &[Parameter],
        text: &str,
    ) -> Result<Self, FigureError> {
        let unreadable = |reason: String| FigureError::Unreadable {
            figure: figure.into(),
            text: text.into(),
            reason,
        };
        let number = |text: &str| {
            text.trim()
                .parse::<f64>()
                .map_err(|_| unreadable(format!("`{text}` is no number")))
        };
        let place = |text: &str| {
            let (x, y) = text
                .split_once(',')
                .ok_or_else(|| unreadable(format!("`{text}` is no point x,y")))?;
            Ok(Place::from([number(x)?, number(y)?]))
        };
        let mut values = Values::defaults(figure, parameters);
        for pair in text.split('&').filter(|pair| !pair.trim().is_empty()) {
            let (name, value) = pair
                .split_once('=')
                .ok_or_else(|| unreadable(format!("`{pair}` has no `=`")))?;
            let parsed = match values.get(name)? {
                Value::Number(_) => Value::Number(number(value)?),
                Value::Count(_) => Value::Count(
                    value
                        .trim()
                        .parse()
                        .map_err(|_| unreadable(format!("`{value}` is no whole number")))?,
                ),
                Value::Point(_) => Value::Point(place(value)?),
                Value::Points(_) => Value::Points(value.split(';').map(place).collect::<Result<
                    _,
                    FigureError,
                >>(
                )?),
            };
            values = values.with(name, parsed);
        }
        values.check(parameters)?;
        Ok(values)
    }
}

impl fmt::Display for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.entries
            .iter()
            .enumerate()
            .try_for_each(|(i, (name, value))| {
                if i > 0 {
                    f.write_str("&")?;
                }
                write!(f, "{name}={value}")
            })
    }
}

/// A list of names for an error message.
pub(super) fn known<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    if names.is_empty() {
        "none".into()
    } else {
        names.join(", ")
    }
}
