//! What was drawn, by name: checked by tests, shown as SVG.

use super::error::{FigureError, PlotError};
use super::parameter::known;
use super::place::{Place, Position};
use super::reading::LawReading;
use super::render::{self, Picture};
use super::shape::{Item, Panel, Shape, Window};
use super::space::SurfacePlot;

/// A figure drawn with certain values: everything in it by name, in world coordinates.
///
/// Where several panels have something of one name, ask for `panel/name`.
/// The methods that change something return a changed copy: a test uses them to see that its check refuses
/// a picture that is wrong.
///
/// ```
/// use cagd::affine::Point;
/// use cagd::figure::{Figure, Style};
///
/// let figure = Figure::new("demo", "A segment", "The segment from (0, 0) to (2, 0).").draw(|_, canvas| {
///     canvas.segment("chord", [0.0, 0.0], [2.0, 0.0], Style::Tangent);
///     Ok(())
/// });
/// let plot = figure.plot(&figure.defaults())?;
/// assert_eq!(plot.segment("chord")?, [Point::new([0.0, 0.0]), Point::new([2.0, 0.0])]);
/// let wrong = plot.shifted("chord", [0.0, 0.5])?;
/// assert_eq!(wrong.segment("chord")?, [Point::new([0.0, 0.5]), Point::new([2.0, 0.5])]);
/// # Ok::<(), cagd::figure::BoxError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) description: String,
    pub(super) rows: Vec<Vec<String>>,
    pub(super) panels: Vec<Panel>,
    /// The windows of the default picture, so that nothing moves but what is dragged.
    pub(super) windows: Vec<(String, Window)>,
    pub(super) handles: Vec<HandlePlace>,
    pub(super) readings: Vec<LawReading>,
    pub(super) remarks: Vec<String>,
}

/// Where a handle is: in the world and in the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct HandlePlace {
    /// The name of its parameter.
    pub parameter: String,
    /// Which of several points of that parameter it is.
    pub index: Option<usize>,
    /// Where it is in the world.
    pub place: Place,
    /// The panel that shows it; the first one if `None`.
    pub panel: Option<String>,
}

/// The coordinate system of a panel: which rectangle of the picture shows which part of the world.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The panel.
    pub panel: String,
    /// Left, top, width and height of the rectangle in the picture.
    pub rectangle: [f64; 4],
    /// What it shows, in units of the axes (logarithms on a logarithmic axis).
    pub window: Window,
}

impl Frame {
    /// From the units of the axes to the picture, y downwards.
    #[must_use]
    pub fn to_picture(&self, at: [f64; 2]) -> [f64; 2] {
        let [left, top, width, height] = self.rectangle;
        let ([x, y], [w, h]) = (self.window.low, self.window.size());
        [
            left + (at[0] - x) / w * width,
            top + height - (at[1] - y) / h * height,
        ]
    }

    /// From the picture to the units of the axes.
    #[must_use]
    pub fn to_world(&self, at: [f64; 2]) -> [f64; 2] {
        let [left, top, width, height] = self.rectangle;
        let ([x, y], [w, h]) = (self.window.low, self.window.size());
        [
            x + (at[0] - left) / width * w,
            y + (top + height - at[1]) / height * h,
        ]
    }
}

impl Plot {
    // ── questions ──

    /// The id of the figure.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The names of everything that was drawn, with their panels.
    pub fn names(&self) -> impl Iterator<Item = (&str, &str)> {
        self.panels.iter().flat_map(|panel| {
            panel
                .items
                .iter()
                .map(|item| (panel.name.as_str(), item.name.as_str()))
        })
    }

    /// The points of a polyline, or the samples of a curve.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn polyline(&self, name: &str) -> Result<&[Place], PlotError> {
        match self.shape(name)? {
            Shape::Polyline { points } | Shape::Curve { points, .. } => Ok(points),
            other => Err(self.wrong_shape(name, "a polyline or a curve", other)),
        }
    }

    /// The samples of a curve, each with its parameter.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn samples(&self, name: &str) -> Result<impl Iterator<Item = (f64, Place)>, PlotError> {
        match self.shape(name)? {
            Shape::Curve { parameters, points } => {
                Ok(parameters.iter().copied().zip(points.iter().copied()))
            }
            other => Err(self.wrong_shape(name, "a curve", other)),
        }
    }

    /// The vertices of a polygon.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn polygon(&self, name: &str) -> Result<&[Place], PlotError> {
        match self.shape(name)? {
            Shape::Polygon { points } => Ok(points),
            other => Err(self.wrong_shape(name, "a polygon", other)),
        }
    }

    /// A set of points.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn points(&self, name: &str) -> Result<&[Place], PlotError> {
        match self.shape(name)? {
            Shape::Points { points } => Ok(points),
            other => Err(self.wrong_shape(name, "a set of points", other)),
        }
    }

    /// A surface as it was painted.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn surface(&self, name: &str) -> Result<SurfacePlot<'_>, PlotError> {
        match self.shape(name)? {
            Shape::Surface { places, faces } => Ok(SurfacePlot { places, faces }),
            other => Err(self.wrong_shape(name, "a surface", other)),
        }
    }

    /// A point.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn point(&self, name: &str) -> Result<Place, PlotError> {
        match self.shape(name)? {
            Shape::Point { at } => Ok(*at),
            other => Err(self.wrong_shape(name, "a point", other)),
        }
    }

    /// The ends of a segment or of an arrow, or the two points that define a line.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn segment(&self, name: &str) -> Result<[Place; 2], PlotError> {
        match self.shape(name)? {
            Shape::Segment { from, to } | Shape::Arrow { from, to } => Ok([*from, *to]),
            Shape::Line { through, and } => Ok([*through, *and]),
            other => Err(self.wrong_shape(name, "a segment, an arrow or a line", other)),
        }
    }

    /// The centre and the radius of a circle.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn circle(&self, name: &str) -> Result<(Place, f64), PlotError> {
        match self.shape(name)? {
            Shape::Circle { centre, radius } => Ok((*centre, *radius)),
            other => Err(self.wrong_shape(name, "a circle", other)),
        }
    }

    /// The source of a text.
    ///
    /// # Errors
    /// [`PlotError`] if nothing, several things or something else has this name.
    pub fn text(&self, name: &str) -> Result<&str, PlotError> {
        match self.shape(name)? {
            Shape::Text { text, .. } => Ok(text),
            other => Err(self.wrong_shape(name, "a text", other)),
        }
    }

    /// All labels with the places they belong to.
    pub fn labels(&self) -> impl Iterator<Item = (&str, Place)> {
        self.panels
            .iter()
            .flat_map(|panel| &panel.items)
            .filter_map(|item| match &item.shape {
                Shape::Label { text, at, .. } => Some((text.as_str(), *at)),
                _ => None,
            })
    }

    /// Where the handles are.
    #[must_use]
    pub fn handles(&self) -> &[HandlePlace] {
        &self.handles
    }

    /// What the laws say that the figure illustrates, for these values.
    #[must_use]
    pub fn readings(&self) -> &[LawReading] {
        &self.readings
    }

    /// What is special about these values: which hypothesis fails, and what it was for.
    #[must_use]
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    // ── the picture ──

    /// The figure as an SVG document that stands on its own.
    ///
    /// The same plot gives the same bytes on every platform and at every level of optimisation.
    #[must_use]
    pub fn svg(&self) -> String {
        self.picture().svg
    }

    /// The SVG together with the coordinate systems of its panels and the boxes of its labels.
    #[must_use]
    pub fn picture(&self) -> Picture {
        render::picture(self)
    }

    // ── wrong pictures ──

    /// A copy in which one item is moved.
    ///
    /// # Errors
    /// [`PlotError`] if nothing or several things have this name.
    pub fn shifted(&self, name: &str, by: impl Position) -> Result<Self, PlotError> {
        let [dx, dy] = by.position();
        self.changed(name, |shape| {
            for place in shape.places_mut() {
                *place = Place::new([place[0] + dx, place[1] + dy]);
            }
        })
    }

    /// A copy in which one item is stretched from the origin by a factor; a circle keeps its centre.
    ///
    /// # Errors
    /// [`PlotError`] if nothing or several things have this name.
    pub fn scaled(&self, name: &str, factor: f64) -> Result<Self, PlotError> {
        self.changed(name, |shape| match shape {
            Shape::Circle { radius, .. } => *radius *= factor,
            shape => {
                for place in shape.places_mut() {
                    *place = Place::new([place[0] * factor, place[1] * factor]);
                }
            }
        })
    }

    /// A copy in which the places of one item are others, as many as before.
    ///
    /// # Errors
    /// [`PlotError::WrongShape`] if there are not as many places; or nothing or several things have this name.
    pub fn replaced<P: Position>(
        &self,
        name: &str,
        places: impl IntoIterator<Item = P>,
    ) -> Result<Self, PlotError> {
        let places: Vec<Place> = places
            .into_iter()
            .map(|p| Place::from(p.position()))
            .collect();
        let mut fits = true;
        let changed = self.changed(name, |shape| {
            let old = shape.places_mut();
            fits = old.len() == places.len();
            for (old, new) in old.into_iter().zip(&places) {
                *old = *new;
            }
        })?;
        if fits {
            Ok(changed)
        } else {
            Err(self.wrong_shape(
                name,
                "an item with as many places as the new ones",
                self.shape(name)?,
            ))
        }
    }

    /// A copy in which one text reads differently.
    ///
    /// # Errors
    /// [`PlotError`] if no text, or several, have this name.
    pub fn rewritten(&self, name: &str, new: &str) -> Result<Self, PlotError> {
        self.text(name)?;
        self.changed(name, |shape| {
            if let Shape::Text { text, .. } = shape {
                *text = new.into();
            }
        })
    }

    /// A copy without one item.
    ///
    /// # Errors
    /// [`PlotError`] if nothing or several things have this name.
    pub fn without(&self, name: &str) -> Result<Self, PlotError> {
        let (panel, item) = self.find(name)?;
        let mut copy = self.clone();
        copy.panels[panel].items.remove(item);
        Ok(copy)
    }

    /// A copy in which two items have changed places: each has the shape of the other.
    ///
    /// # Errors
    /// [`PlotError`] if nothing or several things have one of these names.
    pub fn swapped(&self, one: &str, other: &str) -> Result<Self, PlotError> {
        let (first, second) = (self.shape(one)?.clone(), self.shape(other)?.clone());
        self.changed(one, |shape| *shape = second)?
            .changed(other, |shape| *shape = first)
    }

    // ── inside ──

    fn changed(&self, name: &str, change: impl FnOnce(&mut Shape)) -> Result<Self, PlotError> {
        let (panel, item) = self.find(name)?;
        let mut copy = self.clone();
        change(&mut copy.panels[panel].items[item].shape);
        Ok(copy)
    }

    fn shape(&self, name: &str) -> Result<&Shape, PlotError> {
        let (panel, item) = self.find(name)?;
        Ok(&self.panels[panel].items[item].shape)
    }

    fn find(&self, name: &str) -> Result<(usize, usize), PlotError> {
        let in_panel = |panel: &Panel, wanted: &str| {
            panel.items.iter().position(|Item { name, shape, .. }| {
                name == wanted && !matches!(shape, Shape::Label { .. })
            })
        };
        let found: Vec<(usize, usize)> = self
            .panels
            .iter()
            .enumerate()
            .filter_map(|(p, panel)| {
                let qualified = name
                    .strip_prefix(panel.name.as_str())
                    .and_then(|rest| rest.strip_prefix('/'));
                let item = in_panel(panel, name).or_else(|| in_panel(panel, qualified?))?;
                Some((p, item))
            })
            .collect();
        match found.as_slice() {
            [one] => Ok(*one),
            [] => Err(PlotError::UnknownItem {
                figure: self.id.clone(),
                name: name.into(),
                known: known(self.names().map(|(_, name)| name)),
            }),
            several => Err(PlotError::Ambiguous {
                figure: self.id.clone(),
                name: name.into(),
                panels: known(several.iter().map(|&(p, _)| self.panels[p].name.as_str())),
            }),
        }
    }

    fn wrong_shape(&self, name: &str, expected: &'static str, found: &Shape) -> PlotError {
        PlotError::WrongShape {
            figure: self.id.clone(),
            name: name.into(),
            expected,
            found: found.kind(),
        }
    }

    /// Checks what only the whole picture shows: panels of handles, and positions on logarithmic axes.
    pub(super) fn check(&self) -> Result<(), FigureError> {
        for handle in &self.handles {
            let Some(panel) = &handle.panel else { continue };
            if self.panels.iter().all(|known| known.name != *panel) {
                return Err(FigureError::UnknownPanel {
                    figure: self.id.clone(),
                    name: handle.parameter.clone(),
                    panel: panel.clone(),
                    known: known(self.panels.iter().map(|panel| panel.name.as_str())),
                });
            }
        }
        for panel in &self.panels {
            for item in &panel.items {
                for place in item.shape.extent() {
                    if !panel.on_axes(&place).iter().all(|c| c.is_finite()) {
                        return Err(FigureError::NoPlace {
                            figure: self.id.clone(),
                            item: item.name.clone(),
                            x: place[0],
                            y: place[1],
                        });
                    }
                }
            }
        }
        Ok(())
    }
}
