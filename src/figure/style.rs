//! The visual language of the book: what a line or a point means decides how it looks.
//!
//! Colour is never the only cue: every pair of styles that can meet in one figure differs in width, dash or
//! marker as well.
//!
//! A colour is a CSS variable with a fallback, `var(--fig-curve, #0072b2)`, so that a page's theme decides and a
//! picture looked at alone is right too. [`PAGE_CSS`](super::PAGE_CSS) sets the variables for mdBook's themes.

use std::fmt::Write;

use super::palette::{
    ACCENT, BACK, CURVE, Colour, FRONT, GUIDE, LEVEL_1, LEVEL_2, LEVEL_3, LEVEL_4, MARKED, PAPER,
    POLYGON, REGION, TEXT, mixed,
};
use super::space::{Cover, SHADES};

/// How a line, a polygon or a region looks: by its role, never by a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Style {
    /// The curve that the figure is about: heavy, blue, solid.
    Curve,
    /// The curve outside its interval, or a part that is only thought of: blue, dashed.
    Extension,
    /// A second curve, compared with the first: vermillion, long dashes.
    SecondCurve,
    /// A control polygon: thin, grey, solid, with hollow circles at its vertices.
    ControlPolygon,
    /// The polygon of the second curve: thin, vermillion, with hollow circles.
    SecondPolygon,
    /// A level of a construction (1, 2, 3, …): each has its colour and its marker.
    Level(usize),
    /// A member of a family of functions (0, 1, 2, …): each has its colour and its dashes.
    Series(usize),
    /// A tangent, a chord, an axis of symmetry: what the statement is about, besides the curve.
    Tangent,
    /// A helping line: thin, grey, dashed.
    Guide,
    /// An arrow from an entry of a scheme to the next: thin, grey.
    Connector,
    /// The outline of a bound, such as a bounding box: grey, short dashes.
    Bound,
    /// A filled region without outline: a convex hull, a strip.
    Region,
    /// A second filled region.
    SecondRegion,
    /// A part of a filled whole (1, 2, 3, …): each has the colour of the point of that [`PointStyle::Level`].
    Share(usize),
    /// A filled disc or polygon with an outline that itself is what is shown.
    Disc,
}

/// How a point looks: by its role.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PointStyle {
    /// A control point: hollow circle.
    Control,
    /// A control point of the second curve.
    SecondControl,
    /// A point on the curve: solid, blue.
    OnCurve,
    /// What the figure computes: solid, large, vermillion.
    Result,
    /// A point of a construction level; its marker is the level's.
    Level(usize),
    /// A point that only helps: small, grey.
    Guide,
    /// A cross, for positions on an axis or intersection points.
    Cross,
}

/// The shapes of markers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Marker {
    Circle,
    Square,
    Diamond,
    Triangle,
    Cross,
}

/// Everything that can be drawn has one of these looks; plotters knows it by its number.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Look {
    pub(super) class: String,
    stroke: Option<Colour>,
    fill: Option<(Colour, f64)>,
    width: f64,
    dash: &'static str,
    /// How much a label minds lying on it.
    pub(super) weight: f64,
    /// Light and shadow of a face, and how much of the light it has, in per cent; instead of a fill.
    shading: Option<([Colour; 2], u32)>,
    /// Regions lie below guides, these below lines, these below points.
    pub(super) layer: u8,
}

const LEVELS: [Colour; 4] = [LEVEL_1, LEVEL_2, LEVEL_3, LEVEL_4];
const SERIES: [(Colour, &str); 6] = [
    (CURVE, ""),
    (ACCENT, "9 4"),
    (LEVEL_2, "2 4"),
    (LEVEL_3, "9 4 2 4"),
    (LEVEL_1, "5 3"),
    (LEVEL_4, "1 3"),
];

impl Look {
    fn line(class: impl Into<String>, stroke: Colour, width: f64, dash: &'static str) -> Self {
        Look {
            class: class.into(),
            stroke: Some(stroke),
            fill: None,
            width,
            dash,
            weight: 1.0,
            shading: None,
            layer: 2,
        }
    }

    fn area(class: &str, fill: Colour, opacity: f64) -> Self {
        Look {
            class: class.into(),
            stroke: None,
            fill: Some((fill, opacity)),
            width: 0.0,
            dash: "",
            weight: 0.2,
            shading: None,
            layer: 0,
        }
    }

    fn dot(class: impl Into<String>, stroke: Colour, fill: Colour, width: f64) -> Self {
        Look {
            class: class.into(),
            stroke: Some(stroke),
            fill: Some((fill, 1.0)),
            width,
            dash: "",
            weight: 1.0,
            shading: None,
            layer: 3,
        }
    }

    /// A face of a surface, with or without lines along its edges.
    pub(super) fn face(cover: Cover, shade: u8, edges: bool) -> Self {
        let (name, colours) = match cover {
            Cover::Front => ("front", FRONT),
            Cover::Back => ("back", BACK),
            Cover::Marked => ("marked", MARKED),
        };
        let smooth = if edges { "" } else { "smooth-" };
        Look {
            class: format!("{smooth}{name}-{shade}"),
            stroke: edges.then_some(POLYGON),
            fill: None,
            // Without lines, a thin one in the colour of the face covers the gap to its neighbours.
            width: if edges { 0.7 } else { 0.4 },
            dash: "",
            // A label on a surface needs a halo.
            weight: 0.35,
            shading: Some((colours, 100 * u32::from(shade) / u32::from(SHADES - 1))),
            layer: 0,
        }
    }

    /// An axis with its ticks.
    pub(super) fn axis() -> Self {
        Look {
            layer: 1,
            ..Look::line("axis", POLYGON, 1.1, "")
        }
    }

    /// The line y = 0 of a function graph, and the grid.
    pub(super) fn grid() -> Self {
        Look {
            weight: 0.1,
            layer: 1,
            ..Look::line("grid", GUIDE, 0.6, "1 3")
        }
    }

    /// The text of labels, or of ticks and captions; with a halo where a line runs through it.
    pub(super) fn text(small: bool, halo: bool) -> Self {
        let class = match (small, halo) {
            (false, false) => "",
            (false, true) => "halo",
            (true, false) => "caption",
            (true, true) => "caption halo",
        };
        Look {
            class: class.into(),
            stroke: None,
            fill: None,
            width: 0.0,
            dash: "",
            weight: 0.0,
            shading: None,
            layer: 4,
        }
    }

    /// The head of an arrow.
    pub(super) fn head(of: &Look) -> Self {
        Look {
            class: format!("{}-head", of.class),
            stroke: None,
            fill: of.stroke.map(|colour| (colour, 1.0)),
            width: 0.0,
            dash: "",
            ..of.clone()
        }
    }

    /// The rules of this look: on paper, and what changes on dark ground.
    pub(super) fn rules(&self) -> (String, String) {
        let Look {
            class,
            stroke,
            fill,
            width,
            dash,
            shading,
            ..
        } = self;
        let (mut light, mut dark) = (String::new(), String::new());
        let mut paint = |property: &str, colour: Option<Colour>| {
            match colour {
                None => write!(light, "{property}:none;"),
                // The first declaration is for viewers that know no variables.
                Some(Colour {
                    name,
                    light: on_paper,
                    dark: on_dark,
                }) => write!(
                    dark,
                    "{property}:{on_dark};{property}:var(--fig-{name},{on_dark});"
                )
                .and(write!(
                    light,
                    "{property}:{on_paper};{property}:var(--fig-{name},{on_paper});"
                )),
            }
            .expect("writing to a string")
        };
        if shading.is_none() {
            paint("fill", fill.map(|(colour, _)| colour));
        }
        if stroke.is_some() {
            paint("stroke", *stroke);
        }
        if let Some(([lit, shadow], percent)) = shading {
            let mix = |rule: &mut String, lit_colour: &str, shadow_colour: &str| {
                let plain = mixed(lit_colour, shadow_colour, f64::from(*percent) / 100.0);
                let mixture = format!(
                    "color-mix(in srgb,var(--fig-{},{lit_colour}) {percent}%,var(--fig-{},{shadow_colour}))",
                    lit.name, shadow.name
                );
                for property in ["fill", "stroke"]
                    .iter()
                    .take(if stroke.is_some() { 1 } else { 2 })
                {
                    let _ = write!(rule, "{property}:{plain};{property}:{mixture};");
                }
            };
            mix(&mut light, lit.light, shadow.light);
            mix(&mut dark, lit.dark, shadow.dark);
        }
        if let Some((_, opacity)) = fill.filter(|(_, opacity)| *opacity < 1.0) {
            let _ = write!(light, "fill-opacity:{opacity};");
        }
        if *width > 0.0 {
            let _ = write!(light, "stroke-width:{width};");
        }
        if !dash.is_empty() {
            let _ = write!(light, "stroke-dasharray:{dash};");
        }
        let rule = |body: String| match body.trim_end_matches(';') {
            "" => String::new(),
            body => format!(".cagd .{class}{{{body}}}"),
        };
        (rule(light), rule(dark))
    }
}

/// The rules that every figure needs.
pub(super) fn base_rules() -> String {
    // The book's fonts, then what is like them; a font much wider would need other estimates in `label`.
    const FONTS: &str = "Pagella,\"Pagella Math\",\"TeX Gyre Pagella\",Palatino,\"Palatino Linotype\",\"STIX Two Text\",\"Times New Roman\",serif";
    let Colour {
        light: paper,
        dark: night,
        ..
    } = PAPER;
    let Colour {
        light: ink,
        dark: chalk,
        ..
    } = TEXT;
    format!(
        ".cagd:root{{color:{ink};background:{paper}}}\
         .cagd{{stroke-linejoin:round;stroke-linecap:round}}\
         .cagd text{{fill:currentColor;font:{size}px {FONTS};font-family:var(--fig-font,{FONTS})}}\
         .cagd .halo{{stroke:{paper};stroke:var(--fig-paper,{paper});stroke-width:3px;paint-order:stroke}}\
         .cagd .caption{{font-size:{caption}px}}\
         .cagd .i{{font-style:italic}}\
         @media(prefers-color-scheme:dark){{.cagd:root{{color:{chalk};background:{night}}}\
         .cagd .halo{{stroke:{night};stroke:var(--fig-paper,{night})}}}}",
        size = super::label::SIZE,
        caption = super::label::CAPTION_SIZE,
    )
}

impl Style {
    pub(super) fn look(self) -> Look {
        match self {
            Style::Curve => Look::line("curve", CURVE, 2.6, ""),
            Style::Extension => Look::line("extension", CURVE, 1.8, "7 5"),
            Style::SecondCurve => Look::line("second-curve", ACCENT, 2.2, "11 4"),
            Style::ControlPolygon => Look::line("polygon", POLYGON, 1.4, ""),
            Style::SecondPolygon => Look::line("second-polygon", ACCENT, 1.2, ""),
            Style::Level(level) => {
                let k = level.max(1) - 1;
                Look::line(
                    format!("level-{}", k % LEVELS.len() + 1),
                    LEVELS[k % LEVELS.len()],
                    1.5,
                    "",
                )
            }
            Style::Series(k) => {
                let k = k % SERIES.len();
                Look::line(format!("series-{k}"), SERIES[k].0, 2.2, SERIES[k].1)
            }
            Style::Tangent => Look::line("tangent", ACCENT, 1.8, ""),
            Style::Guide => Look {
                layer: 1,
                weight: 0.4,
                ..Look::line("guide", GUIDE, 1.1, "4 4")
            },
            Style::Connector => Look {
                layer: 1,
                ..Look::line("connector", GUIDE, 1.1, "")
            },
            Style::Bound => Look {
                layer: 1,
                weight: 0.5,
                ..Look::line("bound", POLYGON, 1.3, "2 4")
            },
            Style::Region => Look::area("region", REGION, 0.2),
            Style::SecondRegion => Look::area("second-region", ACCENT, 0.16),
            Style::Share(part) => {
                let k = (part.max(1) - 1) % LEVELS.len();
                Look::area(&format!("share-{}", k + 1), LEVELS[k], 0.3)
            }
            Style::Disc => Look {
                fill: Some((ACCENT, 0.25)),
                layer: 1,
                ..Look::line("disc", ACCENT, 1.2, "")
            },
        }
    }

    /// The style of the points that a polyline of this style shows at its vertices.
    pub(super) fn vertices(self) -> Option<PointStyle> {
        match self {
            Style::ControlPolygon => Some(PointStyle::Control),
            Style::SecondPolygon => Some(PointStyle::SecondControl),
            Style::Level(level) => Some(PointStyle::Level(level)),
            _ => None,
        }
    }
}

impl PointStyle {
    pub(super) fn look(self) -> Look {
        match self {
            PointStyle::Control => Look::dot("control", POLYGON, PAPER, 1.8),
            PointStyle::SecondControl => Look::dot("second-control", ACCENT, PAPER, 1.8),
            PointStyle::OnCurve => Look::dot("on-curve", PAPER, CURVE, 1.0),
            PointStyle::Result => Look::dot("result", PAPER, ACCENT, 1.4),
            PointStyle::Level(level) => {
                let k = (level.max(1) - 1) % LEVELS.len();
                Look::dot(format!("dot-{}", k + 1), PAPER, LEVELS[k], 0.8)
            }
            PointStyle::Guide => Look::dot("dot-guide", PAPER, GUIDE, 0.8),
            PointStyle::Cross => Look {
                layer: 3,
                ..Look::line("cross", ACCENT, 2.0, "")
            },
        }
    }

    pub(super) fn marker(self) -> Marker {
        match self {
            PointStyle::Level(level) => [
                Marker::Circle,
                Marker::Square,
                Marker::Diamond,
                Marker::Triangle,
            ][(level.max(1) - 1) % 4],
            PointStyle::Cross => Marker::Cross,
            _ => Marker::Circle,
        }
    }

    /// Half the size of the marker, in units of the picture.
    pub(super) fn radius(self) -> f64 {
        match self {
            PointStyle::Control | PointStyle::SecondControl => 4.4,
            PointStyle::OnCurve => 4.2,
            PointStyle::Result => 5.6,
            PointStyle::Level(_) => 4.0,
            PointStyle::Guide => 3.0,
            PointStyle::Cross => 4.5,
        }
    }
}
