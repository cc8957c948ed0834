//! What a drawing function draws on.

use std::ops::RangeInclusive;

use super::error::FigureError;
use super::label::{Label, SIZE};
use super::place::{Place, Position};
use super::reading::LawReading;
use super::scheme::Scheme;
use super::shape::{Aspect, Axes, Item, Looks, Panel, Shape, Side, Window};
use super::style::{PointStyle, Style};
use crate::law::Sides;
use crate::scalar::Scalar;

/// A curve is sampled at this many equal steps.
///
/// 240 chords of a curve that fills the picture, 480 units wide, are two units long;
/// with radius of curvature 10 units they miss it by 2²/(8·10) = 0.05 units.
const STEPS: usize = 240;

/// Records what is drawn, by name, in world coordinates.
///
/// Everything goes into the current panel; [`panel`](Canvas::panel) makes another one current.
/// Names identify things in checks, so each is used once a panel; labels need none.
/// A mistake (a name taken twice, a position that is not finite, a label that cannot be typeset)
/// is remembered and reported by [`Figure::plot`](super::Figure::plot), so that drawing needs no `?`.
#[derive(Debug)]
pub struct Canvas {
    figure: String,
    panels: Vec<Panel>,
    current: usize,
    readings: Vec<LawReading>,
    remarks: Vec<String>,
    mistake: Option<FigureError>,
}

/// What was drawn without a mistake.
pub(super) struct Drawn {
    pub(super) panels: Vec<Panel>,
    pub(super) readings: Vec<LawReading>,
    pub(super) remarks: Vec<String>,
}

impl Canvas {
    pub(super) fn new(figure: &str) -> Self {
        Canvas {
            figure: figure.into(),
            panels: vec![],
            current: 0,
            readings: vec![],
            remarks: vec![],
            mistake: None,
        }
    }

    /// What was drawn, or the first mistake.
    pub(super) fn finish(self) -> Result<Drawn, FigureError> {
        match self.mistake {
            Some(mistake) => Err(mistake),
            None => Ok(Drawn {
                panels: self.panels,
                readings: self.readings,
                remarks: self.remarks,
            }),
        }
    }

    // ── laws ──

    /// Shows both sides of the law of a statement beside the live figure, for the very values that the reader chose.
    ///
    /// `statement` is the id of what the law says. The picture itself does not change.
    pub fn law<T: Scalar>(&mut self, statement: &str, sides: &Sides<T>) {
        let panel = self.current().name.clone();
        let readings = sides
            .readings()
            // Of some inputs a claim has nothing to say.
            .filter(|reading| !(reading.left.is_empty() && reading.right.is_empty()))
            .map(|reading| LawReading::of(statement, &panel, reading));
        self.readings.extend(readings);
    }

    /// Says beside the live figure what is special about these values: which hypothesis fails, and what it was for.
    ///
    /// The picture itself does not change.
    pub fn remark(&mut self, sentence: &str) {
        self.remarks.push(sentence.into());
    }

    // ── panels ──

    /// Makes the panel of this name current; it is created when it is first named.
    pub fn panel(&mut self, name: &str) {
        self.current = match self.panels.iter().position(|panel| panel.name == name) {
            Some(i) => i,
            None => {
                self.panels.push(Panel::new(name));
                self.panels.len() - 1
            }
        };
    }

    /// A line of text above the panel, in the language of labels.
    pub fn caption(&mut self, text: &str) {
        self.readable(text);
        self.current().caption = Some(text.into());
    }

    /// Shows exactly this part of the plane, instead of what the default values need.
    pub fn window(&mut self, low: impl Position, high: impl Position) {
        let (low, high) = (low.position(), high.position());
        self.placed("window", &Place::from(low));
        self.placed("window", &Place::from(high));
        self.current().window = Some(Window { low, high });
    }

    /// Makes the window large enough to show this place too.
    pub fn include(&mut self, place: impl Position) {
        let place = place.position();
        self.placed("include", &Place::from(place));
        self.current().included.push(place);
    }

    /// Gives the panel this height relative to its width, with different units on the axes.
    pub fn free_aspect(&mut self, height: f64) {
        self.current().aspect = Aspect::Free(height.clamp(0.2, 2.0));
    }

    /// Draws axes with ticks; the panel then has free units, 0.62 times as high as wide unless set otherwise.
    pub fn axes(&mut self, axes: Axes) {
        axes.labels.iter().for_each(|label| self.readable(label));
        let panel = self.current();
        if panel.aspect == Aspect::Equal {
            panel.aspect = Aspect::Free(0.62);
        }
        panel.axes = Some(axes);
    }

    /// An entry of the legend below the panel; a label at the thing itself is better where there is room.
    pub fn legend(&mut self, text: &str, style: Style) {
        self.readable(text);
        self.current()
            .legend
            .push((text.into(), Looks::Line(style)));
    }

    /// As [`legend`](Canvas::legend), for a point style.
    pub fn legend_point(&mut self, text: &str, style: PointStyle) {
        self.readable(text);
        self.current().legend.push((text.into(), Looks::Dot(style)));
    }

    // ── lines ──

    /// A polyline through the points; some styles show its vertices too.
    pub fn polyline<P: Position>(
        &mut self,
        name: &str,
        points: impl IntoIterator<Item = P>,
        style: Style,
    ) {
        let points = places(points);
        self.at_least(1, name, points.len());
        self.draw(name, Shape::Polyline { points }, Looks::Line(style));
    }

    /// The curve `at` over an interval, sampled at 241 parameters.
    pub fn curve<P: Position>(
        &mut self,
        name: &str,
        range: RangeInclusive<f64>,
        at: impl Fn(f64) -> P,
        style: Style,
    ) {
        let (a, b) = (*range.start(), *range.end());
        let parameters: Vec<f64> = (0..=STEPS)
            .map(|k| {
                if k == STEPS {
                    b
                } else {
                    a + (b - a) * (k as f64 / STEPS as f64)
                }
            })
            .collect();
        let points = parameters
            .iter()
            .map(|&t| Place::from(at(t).position()))
            .collect();
        self.draw(
            name,
            Shape::Curve { parameters, points },
            Looks::Line(style),
        );
    }

    /// The graph of a function.
    pub fn graph(
        &mut self,
        name: &str,
        range: RangeInclusive<f64>,
        f: impl Fn(f64) -> f64,
        style: Style,
    ) {
        self.curve(name, range, |x| [x, f(x)], style);
    }

    /// The segment between two points.
    pub fn segment(&mut self, name: &str, from: impl Position, to: impl Position, style: Style) {
        let (from, to) = (place(from), place(to));
        self.draw(name, Shape::Segment { from, to }, Looks::Line(style));
    }

    /// The whole line through two points, as far as the panel reaches.
    pub fn line(&mut self, name: &str, through: impl Position, and: impl Position, style: Style) {
        let (through, and) = (place(through), place(and));
        self.draw(name, Shape::Line { through, and }, Looks::Line(style));
    }

    /// An arrow: a vector, drawn where it belongs.
    pub fn arrow(&mut self, name: &str, from: impl Position, to: impl Position, style: Style) {
        let (from, to) = (place(from), place(to));
        self.draw(name, Shape::Arrow { from, to }, Looks::Line(style));
    }

    /// A circle.
    pub fn circle(&mut self, name: &str, centre: impl Position, radius: f64, style: Style) {
        let centre = place(centre);
        self.placed(name, &Place::new([radius, 0.0]));
        self.draw(
            name,
            Shape::Circle {
                centre,
                radius: radius.max(0.0),
            },
            Looks::Line(style),
        );
    }

    // ── areas ──

    /// A polygon, closed; filled in the styles that fill.
    pub fn polygon<P: Position>(
        &mut self,
        name: &str,
        vertices: impl IntoIterator<Item = P>,
        style: Style,
    ) {
        let points = places(vertices);
        self.at_least(1, name, points.len());
        self.draw(name, Shape::Polygon { points }, Looks::Line(style));
    }

    /// The rectangle with sides parallel to the axes and these two opposite corners.
    pub fn rectangle(&mut self, name: &str, low: impl Position, high: impl Position, style: Style) {
        let ([a, b], [c, d]) = (low.position(), high.position());
        self.polygon(name, [[a, b], [c, b], [c, d], [a, d]], style);
    }

    /// All points at most `distance` away from the segment, measured across it: a strip, as a polygon.
    ///
    /// A segment of length 0 gives a square.
    pub fn strip(
        &mut self,
        name: &str,
        from: impl Position,
        to: impl Position,
        distance: f64,
        style: Style,
    ) {
        let ([ax, ay], [bx, by]) = (from.position(), to.position());
        let length = libm::hypot(bx - ax, by - ay);
        if length == 0.0 {
            let d = distance;
            return self.rectangle(name, [ax - d, ay - d], [ax + d, ay + d], style);
        }
        let (nx, ny) = (
            -(by - ay) / length * distance,
            (bx - ax) / length * distance,
        );
        let corners = [
            [ax + nx, ay + ny],
            [bx + nx, by + ny],
            [bx - nx, by - ny],
            [ax - nx, ay - ny],
        ];
        self.polygon(name, corners, style);
    }

    // ── points and text ──

    /// A point.
    pub fn point(&mut self, name: &str, at: impl Position, style: PointStyle) {
        let at = place(at);
        self.draw(name, Shape::Point { at }, Looks::Dot(style));
    }

    /// Several points that belong together.
    pub fn points<P: Position>(
        &mut self,
        name: &str,
        at: impl IntoIterator<Item = P>,
        style: PointStyle,
    ) {
        let points = places(at);
        self.draw(name, Shape::Points { points }, Looks::Dot(style));
    }

    /// A label near a place; it looks for room around it.
    ///
    /// The text is in the language of labels: `b_0^1(t)`, `\Delta`, `the point $b(t)$`.
    pub fn label(&mut self, text: &str, at: impl Position) {
        self.labelled(text, at, None);
    }

    /// A label on a given side of a place.
    pub fn label_on(&mut self, side: Side, text: &str, at: impl Position) {
        self.labelled(text, at, Some(side));
    }

    /// Labels `stem_0, stem_1, …` at the points.
    pub fn labels<P: Position>(&mut self, stem: &str, points: impl IntoIterator<Item = P>) {
        for (i, point) in points.into_iter().enumerate() {
            self.label(&format!("{stem}_{{{i}}}"), point);
        }
    }

    /// Text that stays exactly where it is put; `\n` begins a new line.
    pub fn text(&mut self, name: &str, text: &str, at: impl Position, side: Side) {
        text.split('\n').for_each(|line| self.readable(line));
        let (text, at) = (text.into(), place(at));
        self.draw(name, Shape::Text { text, at, side }, Looks::Text);
    }

    /// A triangular scheme or a table; the panel then has no other coordinates.
    pub fn scheme(&mut self, name: &str, scheme: &Scheme) {
        self.current().aspect = Aspect::Picture;
        scheme.draw(name, self);
    }

    // ── inside ──

    fn current(&mut self) -> &mut Panel {
        if self.panels.is_empty() {
            self.panels.push(Panel::new("main"));
        }
        &mut self.panels[self.current]
    }

    fn labelled(&mut self, text: &str, at: impl Position, side: Option<Side>) {
        self.record_label(text, at, side, Looks::Text);
    }

    pub(super) fn small_label(&mut self, text: &str, at: impl Position, side: Side) {
        self.record_label(text, at, Some(side), Looks::SmallText);
    }

    fn record_label(&mut self, text: &str, at: impl Position, side: Option<Side>, look: Looks) {
        self.readable(text);
        let at = place(at);
        self.placed(text, &at);
        let shape = Shape::Label {
            text: text.into(),
            at,
            side,
        };
        self.current().items.push(Item {
            name: text.into(),
            shape,
            look,
        });
    }

    pub(super) fn draw(&mut self, name: &str, mut shape: Shape, look: Looks) {
        for place in shape.places_mut() {
            self.placed(name, place);
        }
        let panel = self.current();
        let taken = panel
            .items
            .iter()
            .any(|item| item.name == name && !matches!(item.shape, Shape::Label { .. }));
        if taken {
            let panel = panel.name.clone();
            let mistake = FigureError::NameTaken {
                figure: self.figure.clone(),
                panel,
                item: name.into(),
            };
            self.wrong(mistake);
        } else {
            panel.items.push(Item {
                name: name.into(),
                shape,
                look,
            });
        }
    }

    fn wrong(&mut self, mistake: FigureError) {
        self.mistake.get_or_insert(mistake);
    }

    fn at_least(&mut self, expected: usize, name: &str, found: usize) {
        if found < expected {
            self.wrong(FigureError::TooFewPoints {
                figure: self.figure.clone(),
                item: name.into(),
                expected,
                found,
            });
        }
    }

    fn placed(&mut self, item: &str, place: &Place) {
        let [x, y] = place.position();
        if !(x.is_finite() && y.is_finite()) {
            self.wrong(FigureError::NoPlace {
                figure: self.figure.clone(),
                item: item.into(),
                x,
                y,
            });
        }
    }

    fn readable(&mut self, text: &str) {
        if let Err(reason) = Label::read(text, SIZE) {
            self.wrong(FigureError::Label {
                figure: self.figure.clone(),
                text: text.into(),
                reason,
            });
        }
    }
}

fn place(at: impl Position) -> Place {
    Place::from(at.position())
}

fn places<P: Position>(points: impl IntoIterator<Item = P>) -> Vec<Place> {
    points.into_iter().map(place).collect()
}
