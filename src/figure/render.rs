//! From a plot to SVG, by way of plotters.

use std::rc::Rc;

use plotters::drawing::IntoDrawingArea;
use plotters::element::{PathElement, Polygon};
use plotters::style::text_anchor::HPos;

use super::backend::{PIXELS, SvgBackend};
use super::clip::Rect;
use super::label::{CAPTION_SIZE, LEADING, Label, SIZE, block, escape};
use super::layout::{self, Laid, WIDTH};
use super::pen::{Drawn, Ground, Pen, World, pixel};
use super::placement::{self, Placed, Request};
use super::plot::{Frame, HandlePlace, Plot};
use super::shape::{Item, Looks, Shape, Side};
use super::style::{Look, base_rules};
use super::ticks;

/// A drawn figure, with what a page needs to lay handles over it.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The SVG document.
    pub svg: String,
    /// Width and height of its view box.
    pub size: [f64; 2],
    /// The coordinate systems of the panels.
    pub frames: Vec<Frame>,
    /// Where in the picture the handles are, in the order of [`Plot::handles`].
    pub handles: Vec<[f64; 2]>,
    /// The estimated boxes of all text: left, top, right, bottom, with the source of each.
    pub labels: Vec<(String, [f64; 4])>,
}

/// Draws everything, and puts the document around it.
pub(super) fn picture(plot: &Plot) -> Picture {
    let (panels, height) = layout::layout(plot);
    let height = height.ceil();
    let backend = SvgBackend {
        sheet: Rc::default(),
        size: ((WIDTH * PIXELS) as u32, (height * PIXELS) as u32),
    };
    let sheet = Rc::clone(&backend.sheet);
    let mut pen = Pen {
        root: backend.into_drawing_area(),
        sheet: Rc::clone(&sheet),
        texts: vec![],
        requests: vec![],
    };
    // The backend cannot fail: it writes to a string.
    let drawn = pen.panels(&panels).and_then(|()| pen.place_labels());
    debug_assert!(drawn.is_ok(), "writing to a string failed");
    let Pen { texts, .. } = pen;
    let (light, dark, body) = sheet.take().into_parts();
    let mut svg = String::with_capacity(body.len() + 2000);
    svg.push_str(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cagd\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
         aria-labelledby=\"{id}-title {id}-description\">\n<title id=\"{id}-title\">",
        id = plot.id
    ));
    escape(&plot.title, &mut svg);
    svg.push_str(&format!("</title>\n<desc id=\"{}-description\">", plot.id));
    escape(&plot.description, &mut svg);
    svg.push_str("</desc>\n<style>");
    svg.push_str(&base_rules());
    svg.push_str(&light);
    svg.push_str(&format!("@media(prefers-color-scheme:dark){{{dark}}}"));
    svg.push_str("</style>\n");
    // One element a line: the diff of two snapshots shows what changed.
    svg.push_str(
        &body
            .replace("/><", "/>\n<")
            .replace("</text><", "</text>\n<"),
    );
    svg.push_str("\n</svg>\n");
    let shown = |handle: &HandlePlace| {
        let own = |laid: &&Laid<'_>| {
            handle
                .panel
                .as_ref()
                .is_none_or(|name| laid.panel.name == *name)
        };
        let laid = panels.iter().find(own)?;
        Some(laid.frame.to_picture(laid.panel.on_axes(&handle.place)))
    };
    Picture {
        svg,
        size: [WIDTH, height],
        handles: plot.handles.iter().filter_map(shown).collect(),
        frames: panels.into_iter().map(|laid| laid.frame).collect(),
        labels: texts
            .into_iter()
            .map(|(text, r)| (text, [r.low[0], r.low[1], r.high[0], r.high[1]]))
            .collect(),
    }
}

/// How much smaller the markers of a polyline are, so that many vertices do not hide it.
///
/// Full size for up to 7 vertices, or while they are on average five radii apart; never below 0.4 of it.
fn crowding(vertices: &[[f64; 2]], radius: f64) -> f64 {
    let lengths = vertices
        .windows(2)
        .map(|pair| libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]));
    let average = lengths.sum::<f64>() / vertices.len().saturating_sub(1).max(1) as f64;
    if vertices.len() < 8 {
        return 1.0;
    }
    (average / (5.0 * radius)).clamp(0.4, 1.0)
}

impl Pen {
    fn panels(&mut self, panels: &[Laid<'_>]) -> Drawn {
        for laid in panels {
            let [left, top, width, height] =
                laid.frame.rectangle.map(|c| (c * PIXELS).round() as i32);
            let window = laid.frame.window;
            let world = World::new(
                window.low[0]..window.high[0],
                window.low[1]..window.high[1],
                (left..left + width, top + height..top),
            );
            let ground = Ground {
                laid,
                area: self.root.apply_coord_spec(world),
                clip: laid.clip(),
            };
            self.axes(&ground)?;
            for layer in 0..=3 {
                for item in &laid.panel.items {
                    self.item(&ground, item, layer)?;
                }
            }
            self.legend(laid)?;
            if let Some(caption) = &laid.panel.caption {
                self.text(caption, CAPTION_SIZE, laid.caption, HPos::Center)?;
            }
            for item in &laid.panel.items {
                self.writing(&ground, item)?;
            }
        }
        Ok(())
    }

    fn item(&mut self, ground: &Ground<'_>, item: &Item, layer: u8) -> Drawn {
        match item.look {
            Looks::Line(style) => {
                let look = style.look();
                if look.layer == layer {
                    self.line(ground, &item.shape, look)?;
                }
                if let (Shape::Polyline { points }, Some(dots), 3) =
                    (&item.shape, style.vertices(), layer)
                {
                    let vertices: Vec<[f64; 2]> = points
                        .iter()
                        .map(|p| ground.units(ground.axes(p)))
                        .collect();
                    let size = crowding(&vertices, dots.radius());
                    for (point, vertex) in points.iter().zip(vertices) {
                        if ground.clip.contains(ground.axes(point)) {
                            self.mark(vertex, dots, size)?;
                        }
                    }
                }
                Ok(())
            }
            Looks::Dot(style) if layer == 3 => match &item.shape {
                Shape::Point { at } => self.marker(ground, ground.axes(at), style),
                Shape::Points { points } => points
                    .iter()
                    .try_for_each(|p| self.marker(ground, ground.axes(p), style)),
                _ => Ok(()),
            },
            Looks::Surface { edges } if layer == 0 => {
                if let Shape::Surface { places, faces } = &item.shape {
                    self.surface(ground, places, faces, edges);
                }
                Ok(())
            }
            Looks::Dot(_) | Looks::Text | Looks::SmallText | Looks::Surface { .. } => Ok(()),
        }
    }

    fn line(&mut self, ground: &Ground<'_>, shape: &Shape, look: Look) -> Drawn {
        match shape {
            Shape::Polyline { points } | Shape::Curve { points, .. } => {
                let points: Vec<[f64; 2]> = points.iter().map(|p| ground.axes(p)).collect();
                self.path(ground, &points, look)
            }
            Shape::Segment { from, to } => {
                self.path(ground, &[ground.axes(from), ground.axes(to)], look)
            }
            Shape::Line { through, and } => {
                match ground.clip.line(ground.axes(through), ground.axes(and)) {
                    Some(ends) => self.path(ground, &ends, look),
                    None => Ok(()),
                }
            }
            Shape::Arrow { from, to } => {
                self.arrow(ground, ground.axes(from), ground.axes(to), look)
            }
            Shape::Polygon { points } => {
                let points: Vec<[f64; 2]> = points.iter().map(|p| ground.axes(p)).collect();
                self.polygon(ground, &points, look)
            }
            Shape::Circle { centre, radius } => {
                self.circle(ground, centre.coordinates(), *radius, look)
            }
            Shape::Point { .. }
            | Shape::Points { .. }
            | Shape::Surface { .. }
            | Shape::Label { .. }
            | Shape::Text { .. } => Ok(()),
        }
    }

    fn axes(&mut self, ground: &Ground<'_>) -> Drawn {
        let Laid { panel, data, .. } = ground.laid;
        let Some(axes) = &panel.axes else {
            return Ok(());
        };
        let ([x0, y0], [x1, y1]) = (ground.units(data.low), ground.units(data.high));
        let (grid, ink) = {
            let mut sheet = self.sheet.borrow_mut();
            (sheet.ink(Look::grid()), sheet.ink(Look::axis()))
        };
        // A tick every 60 units leaves room for its number.
        let most = |length: f64| (length.abs() / 60.0).floor().max(2.0) as usize + 1;
        let across = ticks::linear(data.low[0], data.high[0], most(x1 - x0), axes.whole);
        let up = if axes.logarithmic {
            ticks::logarithmic(data.low[1], data.high[1], most(y1 - y0))
        } else {
            ticks::linear(data.low[1], data.high[1], most(y1 - y0), false)
        };
        if data.low[1] < 0.0 && 0.0 < data.high[1] && !axes.logarithmic {
            let zero = ground.units([0.0, 0.0])[1];
            self.root.draw(&PathElement::new(
                vec![pixel([x0, zero]), pixel([x1, zero])],
                grid,
            ))?;
        }
        self.root.draw(&PathElement::new(
            vec![pixel([x0, y1]), pixel([x0, y0]), pixel([x1, y0])],
            ink,
        ))?;
        for (value, label) in across {
            let x = ground.units([value, data.low[1]])[0];
            self.root.draw(&PathElement::new(
                vec![pixel([x, y0]), pixel([x, y0 + 5.0])],
                ink,
            ))?;
            self.text(&label, CAPTION_SIZE, [x, y0 + 18.0], HPos::Center)?;
        }
        for (value, label) in up {
            let y = ground.units([data.low[0], value])[1];
            self.root.draw(&PathElement::new(
                vec![pixel([x0, y]), pixel([x0 - 5.0, y])],
                ink,
            ))?;
            self.text(&label, CAPTION_SIZE, [x0 - 8.0, y + 4.5], HPos::Right)?;
        }
        let [x_label, y_label] = &axes.labels;
        self.text(x_label, SIZE, [0.5 * (x0 + x1), y0 + 36.0], HPos::Center)?;
        self.text(y_label, SIZE, [x0 - 4.0, y1 - 12.0], HPos::Left)
    }

    fn legend(&mut self, laid: &Laid<'_>) -> Drawn {
        for &(i, [x, y]) in &laid.legend {
            let (text, looks) = &laid.panel.legend[i];
            match looks {
                Looks::Line(style) => {
                    let look = style.look();
                    let filled = look.layer == 0;
                    let ink = self.sheet.borrow_mut().ink(look);
                    if filled {
                        let corners = [
                            [x, y - 11.0],
                            [x + 26.0, y - 11.0],
                            [x + 26.0, y + 1.0],
                            [x, y + 1.0],
                        ];
                        self.root
                            .draw(&Polygon::new(corners.map(pixel).to_vec(), ink))?;
                    } else {
                        let ends = [[x, y - 5.0], [x + 26.0, y - 5.0]];
                        self.root
                            .draw(&PathElement::new(ends.map(pixel).to_vec(), ink))?;
                    }
                    if let Some(dots) = style.vertices() {
                        self.mark([x + 13.0, y - 5.0], dots, 1.0)?;
                    }
                }
                Looks::Dot(style) => self.mark([x + 13.0, y - 5.0], *style, 1.0)?,
                Looks::Text | Looks::SmallText | Looks::Surface { .. } => {}
            }
            self.text(text, SIZE, [x + 34.0, y], HPos::Left)?;
        }
        Ok(())
    }

    /// Writes texts that have their place, and notes labels that need one.
    fn writing(&mut self, ground: &Ground<'_>, item: &Item) -> Drawn {
        let size = if item.look == Looks::SmallText {
            CAPTION_SIZE
        } else {
            SIZE
        };
        match &item.shape {
            Shape::Text { text, at, side } => {
                let at = ground.units(ground.axes(at));
                let lines: Vec<&str> = text.split('\n').collect();
                let [width, height] = block(text, size);
                let extent = super::label::Extent {
                    width,
                    ascent: height,
                    descent: 0.0,
                };
                let Placed { rect, .. } = placement::beside(at, 3.0, extent, *side);
                let (x, anchor) = match side {
                    Side::Right | Side::AboveRight | Side::BelowRight => (rect.low[0], HPos::Left),
                    Side::Left | Side::AboveLeft | Side::BelowLeft => (rect.high[0], HPos::Right),
                    Side::Above | Side::Below | Side::Centre => (at[0], HPos::Center),
                };
                for (k, line) in lines.into_iter().enumerate() {
                    // A line's base line stands 0.85 of the leading below its top.
                    let y = rect.low[1] + (k as f64 + 0.78) * LEADING * size;
                    self.text(line, size, [x, y], anchor)?;
                }
                Ok(())
            }
            Shape::Label { text, at, side } if ground.clip.contains(ground.axes(at)) => {
                let anchor = ground.units(ground.axes(at));
                let markers = &self.sheet.borrow().markers;
                let here = Rect {
                    low: anchor,
                    high: anchor,
                };
                // A marker at the anchor itself must be cleared.
                let radius = |m: &Rect| 0.5 * (m.high[0] - m.low[0]);
                let centred = |m: &&Rect| m.inflated(0.5 - radius(m)).contains_rect(&here);
                let clear = 4.0
                    + markers
                        .iter()
                        .filter(centred)
                        .map(radius)
                        .fold(0.0, f64::max);
                let [left, top, width, height] = ground.laid.frame.rectangle;
                if let Ok(label) = Label::read(text, size) {
                    let mut bounds = Rect {
                        low: [left, top],
                        high: [left + width, top + height],
                    };
                    if ground.laid.panel.axes.is_some() {
                        // The numbers at the axes have their rooms to themselves.
                        let corner = ground.units(ground.laid.data.low);
                        (bounds.low[0], bounds.high[1]) = (corner[0] + 2.0, corner[1] - 1.0);
                    }
                    let request = Request {
                        anchor,
                        clear,
                        extent: label.extent(),
                        side: *side,
                        bounds,
                    };
                    self.requests.push((request, text.clone(), size));
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn place_labels(&mut self) -> Drawn {
        let requests: Vec<Request> = self
            .requests
            .iter()
            .map(|(request, ..)| request.clone())
            .collect();
        let taken: Vec<Rect> = self.texts.iter().map(|(_, rect)| *rect).collect();
        let places = {
            let sheet = self.sheet.borrow();
            placement::place(&requests, &sheet.strokes, &sheet.markers, &taken)
        };
        for (
            (_, text, size),
            Placed {
                rect,
                side,
                baseline,
            },
        ) in std::mem::take(&mut self.requests).iter().zip(places)
        {
            // Anchored at the side that faces the point, so that another font changes only the far end.
            let (x, anchor) = match side {
                Side::Right | Side::AboveRight | Side::BelowRight => (rect.low[0], HPos::Left),
                Side::Left | Side::AboveLeft | Side::BelowLeft => (rect.high[0], HPos::Right),
                Side::Above | Side::Below | Side::Centre => {
                    (0.5 * (rect.low[0] + rect.high[0]), HPos::Center)
                }
            };
            self.text(text, *size, [x, baseline], anchor)?;
        }
        Ok(())
    }
}
