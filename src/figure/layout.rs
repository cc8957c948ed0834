//! Where panels go, and which part of the world each shows.

use super::clip::Rect;
use super::label::{Label, SIZE};
use super::plot::{Frame, Plot};
use super::shape::{Aspect, Panel, Window};

/// The width of every figure, in units of the picture.
///
/// A telephone shows it 0.7 times, a wide screen at most 1.25 times as large, so text stays readable.
pub(super) const WIDTH: f64 = 480.0;

/// Room between panels.
const GAP: f64 = 16.0;
/// Room above a panel for its caption.
const CAPTION: f64 = 22.0;
/// The height of a row of the legend.
pub(super) const LEGEND: f64 = 22.0;
/// Room around geometry, for markers and labels.
const PADDING: f64 = 26.0;
/// Room around a graph with axes: left, top, right, bottom.
const AXES: [f64; 4] = [42.0, 30.0, 18.0, 44.0];

/// A panel with its place in the picture.
#[derive(Debug)]
pub(super) struct Laid<'a> {
    pub(super) panel: &'a Panel,
    pub(super) frame: Frame,
    /// What the window asked for, without the room around it.
    pub(super) data: Window,
    /// The middle and the base line of the caption.
    pub(super) caption: [f64; 2],
    /// Entries of the legend: which, and the left end of its base line.
    pub(super) legend: Vec<(usize, [f64; 2])>,
}

impl Laid<'_> {
    /// What is drawn beyond this rectangle (in units of the axes) is cut off.
    pub(super) fn clip(&self) -> Rect {
        let Window { low, high } = self.frame.window;
        match self.panel.axes {
            None => Rect { low, high },
            // A line on the border of the data keeps its full width.
            Some(_) => {
                let [.., width, height] = self.frame.rectangle;
                let ([w, h], margin) = (self.frame.window.size(), 3.0);
                let (dx, dy) = (margin * w / width, margin * h / height);
                Rect {
                    low: [self.data.low[0] - dx, self.data.low[1] - dy],
                    high: [self.data.high[0] + dx, self.data.high[1] + dy],
                }
            }
        }
    }
}

/// The size of a panel, before rows are aligned.
struct Sketch<'a> {
    panel: &'a Panel,
    data: Window,
    /// Left, top, right, bottom room around the data.
    padding: [f64; 4],
    width: f64,
    height: f64,
    /// Units of the picture in a unit of the axes.
    scale: [f64; 2],
    legend: Vec<(usize, [f64; 2])>,
    legend_rows: usize,
}

/// Lays out all panels; returns them with the height of the picture.
pub(super) fn layout(plot: &Plot) -> (Vec<Laid<'_>>, f64) {
    let mut laid = vec![];
    let mut top = 0.0;
    for row in rows(plot) {
        let width = (WIDTH - GAP * (row.len() as f64 - 1.0)) / row.len() as f64;
        let sketches: Vec<Sketch<'_>> =
            row.iter().map(|panel| sketch(plot, panel, width)).collect();
        let most = |f: fn(&Sketch<'_>) -> f64| sketches.iter().map(f).fold(0.0, f64::max);
        let caption = most(|s| {
            if s.panel.caption.is_some() {
                CAPTION
            } else {
                0.0
            }
        });
        let height = most(|s| s.height);
        let legend = most(|s| {
            if s.legend_rows > 0 {
                s.legend_rows as f64 * LEGEND + 3.0
            } else {
                0.0
            }
        });
        for (k, sketch) in sketches.into_iter().enumerate() {
            let left = k as f64 * (width + GAP);
            laid.push(sketch.placed(left, top + caption, height));
        }
        top += caption + height + legend + GAP;
    }
    (laid, (top - GAP).max(40.0))
}

/// The panels in rows: as the figure says, then those that it does not mention.
fn rows(plot: &Plot) -> Vec<Vec<&Panel>> {
    let named = |name: &String| plot.panels.iter().find(|panel| panel.name == *name);
    let mut rows: Vec<Vec<&Panel>> = plot
        .rows
        .iter()
        .map(|row| row.iter().filter_map(named).collect())
        .filter(|row: &Vec<&Panel>| !row.is_empty())
        .collect();
    let rest: Vec<&Panel> = plot
        .panels
        .iter()
        .filter(|panel| !plot.rows.iter().flatten().any(|name| *name == panel.name))
        .collect();
    if rows.is_empty() && rest.len() == 2 {
        rows.push(rest);
    } else {
        rows.extend(rest.into_iter().map(|panel| vec![panel]));
    }
    rows
}

/// A window that has an extent in both directions, around the one given.
fn proper(window: Option<Window>) -> Window {
    let Some(Window { mut low, mut high }) = window else {
        return Window {
            low: [0.0, 0.0],
            high: [1.0, 1.0],
        };
    };
    for k in 0..2 {
        // Half a unit is arbitrary; a single point has no size of its own.
        if high[k] <= low[k] {
            let other = high[1 - k] - low[1 - k];
            let half = if other > 0.0 { 0.2 * other } else { 0.5 };
            low[k] -= half;
            high[k] += half;
        }
    }
    Window { low, high }
}

fn sketch<'a>(plot: &Plot, panel: &'a Panel, width: f64) -> Sketch<'a> {
    let default = plot
        .windows
        .iter()
        .find(|(name, _)| *name == panel.name)
        .map(|(_, window)| *window);
    let explicit = panel.window.or(match panel.aspect {
        // Text cannot be scaled, so a scheme takes the room it needs.
        Aspect::Picture => None,
        _ => default,
    });
    let data = proper(explicit.or_else(|| panel.natural_window()));
    let padding = match (&panel.axes, panel.aspect) {
        (Some(_), _) => AXES,
        (None, Aspect::Picture) => [8.0; 4],
        (None, _) => [PADDING; 4],
    };
    let [w, h] = data.size();
    let room = width - padding[0] - padding[2];
    let (scale, height) = match panel.aspect {
        Aspect::Picture => (1.0_f64.min(room / w), h * 1.0_f64.min(room / w)),
        Aspect::Free(ratio) => {
            let height = ratio * width - padding[1] - padding[3];
            return Sketch::new(panel, data, padding, width, [room / w, height / h], height);
        }
        Aspect::Equal => {
            // Not higher than this part of the width, so that the text below the figure is in sight.
            let highest = 0.86 * width - padding[1] - padding[3];
            let lowest = 0.16 * width;
            let scale = (room / w).min(highest / h);
            (scale, (h * scale).max(lowest))
        }
    };
    Sketch::new(panel, data, padding, width, [scale, scale], height)
}

impl<'a> Sketch<'a> {
    fn new(
        panel: &'a Panel,
        data: Window,
        padding: [f64; 4],
        width: f64,
        scale: [f64; 2],
        inner_height: f64,
    ) -> Self {
        let height = inner_height + padding[1] + padding[3];
        let (legend, legend_rows) = legend(panel, width);
        Sketch {
            panel,
            data,
            padding,
            width,
            height,
            scale,
            legend,
            legend_rows,
        }
    }

    /// Puts the panel at its place; room left over is shared by both sides of the data.
    fn placed(self, left: f64, top: f64, height: f64) -> Laid<'a> {
        let [pl, pt, pr, pb] = self.padding;
        let [w, h] = self.data.size();
        let spare_x = (self.width - pl - pr) - w * self.scale[0];
        let spare_y = (height - pt - pb) - h * self.scale[1];
        let low = [
            self.data.low[0] - (pl + 0.5 * spare_x) / self.scale[0],
            self.data.low[1] - (pb + 0.5 * spare_y) / self.scale[1],
        ];
        let high = [
            self.data.high[0] + (pr + 0.5 * spare_x) / self.scale[0],
            self.data.high[1] + (pt + 0.5 * spare_y) / self.scale[1],
        ];
        let frame = Frame {
            panel: self.panel.name.clone(),
            rectangle: [left, top, self.width, height],
            window: Window { low, high },
        };
        let bottom = top + height;
        Laid {
            panel: self.panel,
            frame,
            data: self.data,
            caption: [left + 0.5 * self.width, top - 7.0],
            legend: self
                .legend
                .into_iter()
                .map(|(i, [x, y])| (i, [left + x, bottom + y]))
                .collect(),
        }
    }
}

/// The entries of the legend in as few rows as they need.
fn legend(panel: &Panel, width: f64) -> (Vec<(usize, [f64; 2])>, usize) {
    const SWATCH: f64 = 34.0;
    const APART: f64 = 18.0;
    let mut entries = vec![];
    let (mut x, mut row) = (PADDING, 0);
    for (i, (text, _)) in panel.legend.iter().enumerate() {
        let needed = SWATCH + Label::read(text, SIZE).map_or(0.0, |label| label.extent().width);
        if x > PADDING && x + needed > width - 4.0 {
            x = PADDING;
            row += 1;
        }
        entries.push((i, [x, row as f64 * LEGEND + 17.0]));
        x += needed + APART;
    }
    let rows = if entries.is_empty() { 0 } else { row + 1 };
    (entries, rows)
}
