//! Drawing one thing: lines, markers and text, cut off at the panel.

use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, PathElement, Polygon, Text};
use plotters::prelude::{Cartesian2d, DrawingAreaErrorKind};
use plotters::style::text_anchor::HPos;

use super::backend::{PIXELS, Sheet, SvgBackend};
use super::clip::Rect;
use super::label::{Label, SIZE};
use super::layout::Laid;
use super::place::Place;
use super::placement::Request;
use super::space::{PaintedFace, groups};
use super::stroke::Stroke;
use super::style::{Look, Marker, PointStyle};

/// Lines of at least this weight get a halo where text crosses them: all but the outlines of regions.
const HALO_WEIGHT: f64 = 0.3;

pub(super) type Area<C> = DrawingArea<SvgBackend, C>;
pub(super) type World = Cartesian2d<RangedCoordf64, RangedCoordf64>;
pub(super) type Drawn = Result<(), DrawingAreaErrorKind<Infallible>>;

/// Draws on the sheet and remembers where text stands.
pub(super) struct Pen {
    pub(super) root: Area<Shift>,
    pub(super) sheet: Rc<RefCell<Sheet>>,
    pub(super) texts: Vec<(String, Rect)>,
    pub(super) requests: Vec<(Request, String, f64)>,
}

/// A panel with its coordinate system.
pub(super) struct Ground<'a> {
    pub(super) laid: &'a Laid<'a>,
    pub(super) area: Area<World>,
    pub(super) clip: Rect,
}

impl Ground<'_> {
    pub(super) fn axes(&self, place: &Place) -> [f64; 2] {
        self.laid.panel.on_axes(place)
    }

    /// From the units of the axes to those of the picture.
    pub(super) fn units(&self, at: [f64; 2]) -> [f64; 2] {
        let (x, y) = self.area.map_coordinate(&(at[0], at[1]));
        [f64::from(x) / PIXELS, f64::from(y) / PIXELS]
    }
}

pub(super) fn pixel(units: [f64; 2]) -> (i32, i32) {
    // A cast of a float saturates.
    (
        (units[0] * PIXELS).round() as i32,
        (units[1] * PIXELS).round() as i32,
    )
}

impl Pen {
    pub(super) fn path(&mut self, ground: &Ground<'_>, points: &[[f64; 2]], look: Look) -> Drawn {
        let ink = self.sheet.borrow_mut().ink(look);
        for piece in ground.clip.polyline(points) {
            let piece: Vec<(f64, f64)> = piece.into_iter().map(|[x, y]| (x, y)).collect();
            ground.area.draw(&PathElement::new(piece, ink))?;
        }
        Ok(())
    }

    pub(super) fn polygon(
        &mut self,
        ground: &Ground<'_>,
        vertices: &[[f64; 2]],
        look: Look,
    ) -> Drawn {
        let inside = ground.clip.polygon(vertices);
        if inside.len() < 2 {
            return Ok(());
        }
        let ink = self.sheet.borrow_mut().ink(look);
        let inside: Vec<(f64, f64)> = inside.into_iter().map(|[x, y]| (x, y)).collect();
        ground.area.draw(&Polygon::new(inside, ink))
    }

    /// Paints a surface, sets of faces that do not cover each other as one path.
    pub(super) fn surface(
        &mut self,
        ground: &Ground<'_>,
        places: &[Place],
        faces: &[PaintedFace],
        edges: bool,
    ) {
        let mut sheet = self.sheet.borrow_mut();
        for group in groups(faces, places) {
            let Some(head) = group.first() else { continue };
            let look = Look::face(head.cover, head.shade, edges);
            let polygons = group.iter().map(|face| {
                let corners = face
                    .corners
                    .iter()
                    .map(|&v| ground.axes(&places[v as usize]));
                let inside = ground.clip.polygon(&corners.collect::<Vec<_>>());
                inside
                    .into_iter()
                    .map(|at| pixel(ground.units(at)))
                    .collect()
            });
            let polygons: Vec<Vec<(i32, i32)>> = polygons.collect();
            sheet.faces(&polygons, look);
        }
    }

    pub(super) fn circle(
        &mut self,
        ground: &Ground<'_>,
        centre: &[f64],
        radius: f64,
        look: Look,
    ) -> Drawn {
        /// Chords of a circle that is cut off by its panel, or distorted by its axes; of radius 200 units
        /// it is missed by 200·(1 − cos(π/120)) = 0.07 units.
        const CHORDS: usize = 120;
        let (x, y) = (centre[0], centre[1]);
        let whole = Rect {
            low: [x - radius, y - radius],
            high: [x + radius, y + radius],
        };
        let around: Vec<[f64; 2]> = (0..=CHORDS)
            .map(|k| std::f64::consts::TAU * (k % CHORDS) as f64 / CHORDS as f64)
            .map(|angle| [x + radius * libm::cos(angle), y + radius * libm::sin(angle)])
            .collect();
        let across = ground.units([x + radius, y])[0] - ground.units([x, y])[0];
        let up = ground.units([x, y])[1] - ground.units([x, y + radius])[1];
        if ground.clip.contains_rect(&whole) && (across - up).abs() < 0.05 {
            let at = pixel(ground.units([x, y]));
            let mut sheet = self.sheet.borrow_mut();
            // Labels must know where it runs.
            for chord in around.windows(2) {
                let ends = (ground.units(chord[0]), ground.units(chord[1]));
                sheet.strokes.push(Stroke::new(ends.0, ends.1, look.weight));
            }
            let ink = sheet.ink(look);
            drop(sheet);
            return self
                .root
                .draw(&Circle::new(at, (across * PIXELS).round() as i32, ink));
        }
        if look.layer == 2 {
            self.path(ground, &around, look)
        } else {
            self.polygon(ground, &around, look)
        }
    }

    pub(super) fn arrow(
        &mut self,
        ground: &Ground<'_>,
        from: [f64; 2],
        to: [f64; 2],
        look: Look,
    ) -> Drawn {
        /// Length and half width of an arrow's head, in units of the picture.
        const HEAD: [f64; 2] = [9.0, 3.6];
        let (a, b) = (ground.units(from), ground.units(to));
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        if length == 0.0 {
            return Ok(());
        }
        let (dx, dy) = ((b[0] - a[0]) / length, (b[1] - a[1]) / length);
        // The head of a short arrow is smaller, so that the arrow keeps its length.
        let [long, half] = HEAD.map(|size| size * (length / (1.4 * HEAD[0])).min(1.0));
        let base = [b[0] - long * dx, b[1] - long * dy];
        let shaft = 1.0 - long / length;
        let end = [
            from[0] + (to[0] - from[0]) * shaft,
            from[1] + (to[1] - from[1]) * shaft,
        ];
        let head = Look::head(&look);
        self.path(ground, &[from, end], look)?;
        if !ground.clip.contains(to) {
            return Ok(());
        }
        let corners = [
            b,
            [base[0] - half * dy, base[1] + half * dx],
            [base[0] + half * dy, base[1] - half * dx],
        ]
        .map(pixel);
        let ink = self.sheet.borrow_mut().ink(head);
        self.root.draw(&Polygon::new(corners.to_vec(), ink))
    }

    pub(super) fn marker(&mut self, ground: &Ground<'_>, at: [f64; 2], style: PointStyle) -> Drawn {
        if !ground.clip.contains(at) {
            return Ok(());
        }
        self.mark(ground.units(at), style, 1.0)
    }

    pub(super) fn mark(&mut self, at: [f64; 2], style: PointStyle, size: f64) -> Drawn {
        let [x, y] = at;
        let r = style.radius() * size;
        self.sheet.borrow_mut().markers.push(Rect {
            low: [x - r, y - r],
            high: [x + r, y + r],
        });
        let ink = self.sheet.borrow_mut().ink(style.look());
        let polygon = |corners: &[[f64; 2]]| {
            let corners: Vec<(i32, i32)> = corners
                .iter()
                .map(|[dx, dy]| pixel([x + r * dx, y + r * dy]))
                .collect();
            self.root.draw(&Polygon::new(corners, ink))
        };
        match style.marker() {
            Marker::Circle => {
                self.root
                    .draw(&Circle::new(pixel(at), (r * PIXELS).round() as i32, ink))
            }
            // Sides and corners are chosen so that all markers have about the same area.
            Marker::Square => polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]),
            Marker::Diamond => polygon(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]),
            Marker::Triangle => polygon(&[[0.0, -1.3], [1.2, 0.8], [-1.2, 0.8]]),
            Marker::Cross => [-1.0, 1.0].iter().try_for_each(|s| {
                let ends = [pixel([x - r, y - s * r]), pixel([x + r, y + s * r])];
                self.root.draw(&PathElement::new(ends.to_vec(), ink))
            }),
        }
    }

    pub(super) fn text(&mut self, text: &str, size: f64, at: [f64; 2], anchor: HPos) -> Drawn {
        let Ok(label) = Label::read(text, size) else {
            return Ok(());
        };
        let extent = label.extent();
        let left = match anchor {
            HPos::Left => at[0],
            HPos::Center => at[0] - 0.5 * extent.width,
            HPos::Right => at[0] - extent.width,
        };
        let rect = Rect {
            low: [left, at[1] - extent.ascent],
            high: [left + extent.width, at[1] + extent.descent],
        };
        self.texts.push((text.into(), rect));
        // A halo keeps text readable on a line; on a shaded region it would be a blot.
        let crossed = {
            let sheet = self.sheet.borrow();
            let near = rect.inflated(1.0);
            let through = |stroke: &Stroke| {
                stroke.weight >= HALO_WEIGHT && stroke.part_inside(&near).is_some()
            };
            sheet.strokes.iter().any(through)
        };
        let look = Look::text(size < SIZE, crossed);
        let style = self.sheet.borrow_mut().type_style(look, size, anchor);
        self.root
            .draw(&Text::new(text.to_owned(), pixel(at), style))
    }
}
