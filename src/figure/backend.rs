//! The `plotters` backend that writes our SVG.
//!
//! plotters counts in whole pixels; here a pixel is a hundredth of a unit of the picture, so that curves are
//! smooth, and what is written are decimals that are exact quotients of integers: the same bytes everywhere.
//! A colour is the number of a [`Look`], which becomes a CSS class.

use std::cell::RefCell;
use std::convert::Infallible;
use std::fmt::Write;
use std::rc::Rc;

use plotters::prelude::{Color, RGBColor, ShapeStyle, TextStyle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontDesc, FontFamily, FontStyle};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use super::clip::Rect;
use super::label::Label;
use super::stroke::Stroke;
use super::style::Look;

/// Backend pixels in a unit of the picture.
pub(super) const PIXELS: f64 = 100.0;

/// Vertices of a path that deviate less than this many pixels (0.03 units) from the chord are left out.
const THINNING: f64 = 3.0;

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

/// What is drawn so far.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    body: String,
    /// A path that the next one of the same class continues.
    open_path: Option<String>,
    looks: Vec<Look>,
    /// Lines on it, in units of the picture.
    pub(super) strokes: Vec<Stroke>,
    /// Markers on it.
    pub(super) markers: Vec<Rect>,
}

/// Writes on a shared sheet.
#[derive(Debug, Clone)]
pub(super) struct SvgBackend {
    pub(super) sheet: Rc<RefCell<Sheet>>,
    pub(super) size: (u32, u32),
}

impl Sheet {
    /// The style by which plotters knows a look.
    pub(super) fn ink(&mut self, look: Look) -> ShapeStyle {
        let number = match self.looks.iter().position(|known| *known == look) {
            Some(number) => number,
            None => {
                self.looks.push(look);
                self.looks.len() - 1
            }
        };
        RGBColor((number & 0xff) as u8, (number >> 8) as u8, 0).filled()
    }

    /// A style for text; `anchor` says which part of the text stands at its position.
    pub(super) fn type_style(&mut self, look: Look, size: f64, anchor: HPos) -> TextStyle<'static> {
        TextStyle {
            font: FontDesc::new(FontFamily::Serif, size, FontStyle::Normal),
            color: self.ink(look).color.to_backend_color(),
            pos: Pos::new(anchor, VPos::Bottom),
        }
    }

    fn look(&self, color: BackendColor) -> Look {
        self.looks[usize::from(color.rgb.0) + 256 * usize::from(color.rgb.1)].clone()
    }

    /// The rules of the looks that were used, on paper and on dark ground; and the elements.
    pub(super) fn into_parts(mut self) -> (String, String, String) {
        self.close_path();
        let (mut light, mut dark) = (String::new(), String::new());
        for look in &self.looks {
            let (on_paper, on_dark) = look.rules();
            // Text gets its colour from the page.
            if look.layer < 4 {
                light.push_str(&on_paper);
                dark.push_str(&on_dark);
            }
        }
        (light, dark, self.body)
    }

    fn close_path(&mut self) {
        if self.open_path.take().is_some() {
            self.body.push_str("\"/>");
        }
    }

    fn path(&mut self, points: &[BackendCoord], closed: bool, look: &Look) {
        let points = thinned(points);
        let Some((&first, rest)) = points.split_first() else {
            return;
        };
        if self.open_path.as_deref() != Some(&look.class) {
            self.close_path();
            let _ = write!(self.body, "<path class=\"{}\" d=\"", look.class);
            self.open_path = Some(look.class.clone());
        }
        self.body.push('M');
        pair(&mut self.body, first);
        let mut last = first;
        for (i, &next) in rest.iter().enumerate() {
            if i == 0 {
                self.body.push('l');
            } else if next.0 >= last.0 {
                // A minus sign separates as well as a space.
                self.body.push(' ');
            }
            pair(&mut self.body, (next.0 - last.0, next.1 - last.1));
            self.strokes
                .push(Stroke::new(units(last), units(next), look.weight));
            last = next;
        }
        if closed {
            self.body.push('z');
            self.strokes
                .push(Stroke::new(units(last), units(first), look.weight));
        }
        if look.layer == 0 || look.layer == 3 {
            // Filled paths must not merge: overlaps would be painted once instead of twice.
            self.close_path();
        }
    }

    /// Writes faces of a surface as one path, in tenths of a unit: many faces are to stay a small picture.
    pub(super) fn faces(&mut self, faces: &[Vec<BackendCoord>], look: Look) {
        self.close_path();
        let _ = write!(self.body, "<path class=\"{}\" d=\"", look.class);
        for face in faces {
            let rounded = face.iter().map(|&(x, y)| (tenth(x), tenth(y)));
            let mut corners: Vec<BackendCoord> = rounded.collect();
            corners.dedup();
            let Some((&first, rest)) = corners.split_first() else {
                continue;
            };
            self.body.push('M');
            pair(&mut self.body, first);
            let mut last = first;
            for (i, &next) in rest.iter().enumerate() {
                if i == 0 {
                    self.body.push('l');
                } else if next.0 >= last.0 {
                    self.body.push(' ');
                }
                pair(&mut self.body, (next.0 - last.0, next.1 - last.1));
                self.strokes
                    .push(Stroke::new(units(last), units(next), look.weight));
                last = next;
            }
            self.body.push('z');
        }
        self.body.push_str("\"/>");
        self.ink(look);
    }
}

/// Hundredths, rounded to tenths.
fn tenth(hundredths: i32) -> i32 {
    (hundredths + 5).div_euclid(10) * 10
}

fn units((x, y): BackendCoord) -> [f64; 2] {
    [f64::from(x) / PIXELS, f64::from(y) / PIXELS]
}

/// Writes hundredths as a decimal: `1234` is `12.34`.
fn hundredths(out: &mut String, n: i32) {
    let (sign, n) = (if n < 0 { "-" } else { "" }, n.unsigned_abs());
    let (whole, part) = (n / 100, n % 100);
    let _ = match (whole, part) {
        (_, 0) => write!(out, "{sign}{whole}"),
        (0, p) if p % 10 == 0 => write!(out, "{sign}.{}", p / 10),
        (0, p) => write!(out, "{sign}.{p:02}"),
        (w, p) if p % 10 == 0 => write!(out, "{sign}{w}.{}", p / 10),
        (w, p) => write!(out, "{sign}{w}.{p:02}"),
    };
}

fn pair(out: &mut String, (x, y): BackendCoord) {
    hundredths(out, x);
    if y >= 0 {
        out.push(' ');
    }
    hundredths(out, y);
}

/// The vertices that matter (Ramer, Douglas and Peucker).
fn thinned(points: &[BackendCoord]) -> Vec<BackendCoord> {
    let n = points.len();
    if n < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; n];
    (keep[0], keep[n - 1]) = (true, true);
    let mut open = vec![(0, n - 1)];
    while let Some((first, last)) = open.pop() {
        let (a, b) = (points[first], points[last]);
        let (dx, dy) = (f64::from(b.0 - a.0), f64::from(b.1 - a.1));
        let length2 = dx * dx + dy * dy;
        let distance2 = |p: BackendCoord| {
            let (px, py) = (f64::from(p.0 - a.0), f64::from(p.1 - a.1));
            let t = if length2 > 0.0 {
                ((px * dx + py * dy) / length2).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let (ex, ey) = (px - t * dx, py - t * dy);
            ex * ex + ey * ey
        };
        let farthest = (first + 1..last).map(|i| (i, distance2(points[i]))).fold(
            (first, 0.0),
            |worst, next| if next.1 > worst.1 { next } else { worst },
        );
        if farthest.1 > THINNING * THINNING {
            keep[farthest.0] = true;
            open.push((first, farthest.0));
            open.push((farthest.0, last));
        }
    }
    points
        .iter()
        .zip(keep)
        .filter(|(_, keep)| *keep)
        .map(|(p, _)| *p)
        .collect()
}

impl DrawingBackend for SvgBackend {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Outcome {
        self.draw_circle(point, 1, &color, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Outcome {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        _fill: bool,
    ) -> Outcome {
        self.fill_polygon(
            [(left, top), (right, top), (right, bottom), (left, bottom)],
            style,
        )
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        let mut sheet = self.sheet.borrow_mut();
        let look = sheet.look(style.color());
        let points: Vec<BackendCoord> = path.into_iter().collect();
        sheet.path(&points, false, &look);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        _fill: bool,
    ) -> Outcome {
        let mut sheet = self.sheet.borrow_mut();
        let look = sheet.look(style.color());
        sheet.close_path();
        let _ = write!(sheet.body, "<circle class=\"{}\" cx=\"", look.class);
        hundredths(&mut sheet.body, center.0);
        sheet.body.push_str("\" cy=\"");
        hundredths(&mut sheet.body, center.1);
        sheet.body.push_str("\" r=\"");
        hundredths(&mut sheet.body, i32::try_from(radius).unwrap_or(i32::MAX));
        sheet.body.push_str("\"/>");
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vert: I,
        style: &S,
    ) -> Outcome {
        let mut sheet = self.sheet.borrow_mut();
        let look = sheet.look(style.color());
        let points: Vec<BackendCoord> = vert.into_iter().collect();
        sheet.path(&points, true, &look);
        Ok(())
    }

    fn draw_text<TStyle: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &TStyle,
        pos: BackendCoord,
    ) -> Outcome {
        // What cannot be read was refused when it was put on the canvas.
        let Ok(label) = Label::read(text, style.size()) else {
            return Ok(());
        };
        let mut sheet = self.sheet.borrow_mut();
        let look = sheet.look(style.color());
        sheet.close_path();
        sheet.body.push_str("<text x=\"");
        hundredths(&mut sheet.body, pos.0);
        sheet.body.push_str("\" y=\"");
        hundredths(&mut sheet.body, pos.1);
        sheet.body.push('"');
        if !look.class.is_empty() {
            let _ = write!(sheet.body, " class=\"{}\"", look.class);
        }
        sheet.body.push_str(match style.anchor().h_pos {
            HPos::Left => ">",
            HPos::Center => " text-anchor=\"middle\">",
            HPos::Right => " text-anchor=\"end\">",
        });
        label.write(&mut sheet.body);
        sheet.body.push_str("</text>");
        Ok(())
    }

    fn estimate_text_size<TStyle: BackendTextStyle>(
        &self,
        text: &str,
        style: &TStyle,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let [width, height] = super::label::block(text, style.size());
        Ok(((width * PIXELS) as u32, (height * PIXELS) as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hundredths_are_written_as_short_as_can_be() {
        let written = |n| {
            let mut out = String::new();
            hundredths(&mut out, n);
            out
        };
        let found = [0, 5, -5, 50, 100, -1234, 1230].map(written);
        assert_eq!(found, ["0", ".05", "-.05", ".5", "1", "-12.34", "12.3"]);
    }

    #[test]
    fn thinning_keeps_what_deviates() {
        let straight = [(0, 0), (500, 2), (1000, 0)];
        assert_eq!(thinned(&straight), [(0, 0), (1000, 0)]);
        let bent = [(0, 0), (500, 20), (1000, 0)];
        assert_eq!(thinned(&bent), bent);
    }
}
