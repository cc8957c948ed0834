//! What can be drawn: named items in world coordinates, in panels.

use super::label::{SIZE, block};
use super::place::Place;
use super::space::PaintedFace;
use super::style::{PointStyle, Style};

/// One thing that was drawn, with its name.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Item {
    pub(super) name: String,
    pub(super) shape: Shape,
    pub(super) look: Looks,
}

/// The style of an item.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Looks {
    Line(Style),
    Dot(PointStyle),
    Text,
    SmallText,
    Surface {
        /// Whether lines are drawn along the edges.
        edges: bool,
    },
}

/// Where a text stands relative to its anchor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the right of the anchor.
    Right,
    /// Above and to the right.
    AboveRight,
    /// Centred above.
    Above,
    /// Above and to the left.
    AboveLeft,
    /// To the left.
    Left,
    /// Below and to the left.
    BelowLeft,
    /// Centred below.
    Below,
    /// Below and to the right.
    BelowRight,
    /// Centred on the anchor itself.
    Centre,
}

/// The shapes.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Polyline {
        points: Vec<Place>,
    },
    Curve {
        parameters: Vec<f64>,
        points: Vec<Place>,
    },
    Polygon {
        points: Vec<Place>,
    },
    Segment {
        from: Place,
        to: Place,
    },
    Arrow {
        from: Place,
        to: Place,
    },
    Line {
        through: Place,
        and: Place,
    },
    Circle {
        centre: Place,
        radius: f64,
    },
    Point {
        at: Place,
    },
    Points {
        points: Vec<Place>,
    },
    /// A surface in space, put into the plane: all vertices, and the faces that are seen, the farthest first.
    Surface {
        places: Vec<Place>,
        faces: Vec<PaintedFace>,
    },
    /// A label that looks for a free place around its anchor, or keeps to the side it is told.
    Label {
        text: String,
        at: Place,
        side: Option<Side>,
    },
    /// Text that stands exactly where it is put; lines are separated by `\n`.
    Text {
        text: String,
        at: Place,
        side: Side,
    },
}

impl Shape {
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Shape::Polyline { .. } => "a polyline",
            Shape::Curve { .. } => "a curve",
            Shape::Polygon { .. } => "a polygon",
            Shape::Segment { .. } => "a segment",
            Shape::Arrow { .. } => "an arrow",
            Shape::Line { .. } => "a line",
            Shape::Circle { .. } => "a circle",
            Shape::Point { .. } => "a point",
            Shape::Points { .. } => "a set of points",
            Shape::Surface { .. } => "a surface",
            Shape::Label { .. } => "a label",
            Shape::Text { .. } => "a text",
        }
    }

    /// The positions that define it.
    pub(super) fn places_mut(&mut self) -> Vec<&mut Place> {
        match self {
            Shape::Polyline { points }
            | Shape::Curve { points, .. }
            | Shape::Polygon { points }
            | Shape::Points { points }
            | Shape::Surface { places: points, .. } => points.iter_mut().collect(),
            Shape::Segment { from, to } | Shape::Arrow { from, to } => vec![from, to],
            Shape::Line { through, and } => vec![through, and],
            Shape::Circle { centre: at, .. }
            | Shape::Point { at }
            | Shape::Label { at, .. }
            | Shape::Text { at, .. } => {
                vec![at]
            }
        }
    }

    /// The positions that the window must show: a line needs none of its own.
    pub(super) fn extent(&self) -> Vec<Place> {
        match self {
            Shape::Polyline { points }
            | Shape::Curve { points, .. }
            | Shape::Polygon { points }
            | Shape::Points { points }
            | Shape::Surface { places: points, .. } => points.clone(),
            Shape::Segment { from, to } | Shape::Arrow { from, to } => vec![*from, *to],
            Shape::Line { .. } => vec![],
            Shape::Circle { centre, radius } => vec![
                Place::new([centre[0] - radius, centre[1] - radius]),
                Place::new([centre[0] + radius, centre[1] + radius]),
            ],
            Shape::Point { at } | Shape::Label { at, .. } | Shape::Text { at, .. } => vec![*at],
        }
    }
}

/// The part of the plane that a panel shows: corners with the least and the greatest coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// The least abscissa and ordinate.
    pub low: [f64; 2],
    /// The greatest abscissa and ordinate.
    pub high: [f64; 2],
}

impl Window {
    pub(super) fn around<'a>(places: impl IntoIterator<Item = &'a [f64; 2]>) -> Option<Self> {
        places.into_iter().fold(None, |window: Option<Window>, p| {
            Some(match window {
                None => Window { low: *p, high: *p },
                Some(Window { low, high }) => Window {
                    low: [low[0].min(p[0]), low[1].min(p[1])],
                    high: [high[0].max(p[0]), high[1].max(p[1])],
                },
            })
        })
    }

    pub(super) fn size(&self) -> [f64; 2] {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }
}

/// How the units of the two axes compare.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Aspect {
    /// One unit is as long in both directions: geometry.
    Equal,
    /// The panel is this high, relative to its width: function graphs.
    Free(f64),
    /// One unit of the world is one unit of the picture: schemes and tables.
    Picture,
}

/// Axes with ticks, for panels whose coordinates mean something.
///
/// ```
/// use cagd::figure::Axes;
/// let axes = Axes::new("k", "\\text{distance}").logarithmic();
/// assert_eq!(axes, Axes::new("k", "\\text{distance}").logarithmic());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Axes {
    pub(super) labels: [String; 2],
    pub(super) logarithmic: bool,
    pub(super) whole: bool,
}

impl Axes {
    /// Axes with labels for the abscissa and the ordinate.
    pub fn new(x: impl Into<String>, y: impl Into<String>) -> Self {
        Axes {
            labels: [x.into(), y.into()],
            logarithmic: false,
            whole: false,
        }
    }

    /// The ordinate in powers of ten; what is drawn must then be positive.
    #[must_use]
    pub fn logarithmic(self) -> Self {
        Axes {
            logarithmic: true,
            ..self
        }
    }

    /// Ticks of the abscissa at whole numbers only: for degrees, steps and indices.
    #[must_use]
    pub fn whole(self) -> Self {
        Axes {
            whole: true,
            ..self
        }
    }
}

/// One coordinate system in a figure, with what is drawn in it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    pub(super) name: String,
    pub(super) caption: Option<String>,
    pub(super) window: Option<Window>,
    pub(super) included: Vec<[f64; 2]>,
    pub(super) aspect: Aspect,
    pub(super) axes: Option<Axes>,
    pub(super) legend: Vec<(String, Looks)>,
    pub(super) items: Vec<Item>,
}

impl Panel {
    pub(super) fn new(name: &str) -> Self {
        Panel {
            name: name.into(),
            caption: None,
            window: None,
            included: vec![],
            aspect: Aspect::Equal,
            axes: None,
            legend: vec![],
            items: vec![],
        }
    }

    /// A position in the units of the axes: logarithms where the axis is logarithmic.
    pub(super) fn on_axes(&self, place: &Place) -> [f64; 2] {
        let logarithmic = self.axes.as_ref().is_some_and(|axes| axes.logarithmic);
        [
            place[0],
            if logarithmic {
                libm::log10(place[1])
            } else {
                place[1]
            },
        ]
    }

    /// The corners of the texts, where one unit of the world is one of the picture.
    fn text_corners(&self) -> Vec<[f64; 2]> {
        let corners = |item: &Item| match &item.shape {
            Shape::Text { text, at, .. } if self.aspect == Aspect::Picture => {
                let [w, h] = block(text, SIZE);
                vec![
                    [at[0] - 0.5 * w, at[1] - 0.5 * h],
                    [at[0] + 0.5 * w, at[1] + 0.5 * h],
                ]
            }
            _ => vec![],
        };
        self.items.iter().flat_map(corners).collect()
    }

    /// The window asked for, or the smallest that shows everything.
    pub(super) fn natural_window(&self) -> Option<Window> {
        self.window.or_else(|| {
            let places: Vec<[f64; 2]> = self
                .items
                .iter()
                .flat_map(|item| item.shape.extent())
                .map(|place| self.on_axes(&place))
                .chain(self.text_corners())
                .chain(self.included.iter().copied())
                .collect();
            Window::around(&places)
        })
    }
}
