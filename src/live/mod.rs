//! Figures that answer: drawn again, by the same code, with the values that a reader chooses.
//!
//! A page asks with a text and is answered with a text; whether the answer comes from wasm in the page or from the
//! local server makes no difference. A question is the id of a figure, its values and, while a handle is dragged,
//! where the handle went in the picture:
//!
//! ```text
//! bezier-figure-de-casteljau
//! b=0,0;1,2;3,1&t=0.25
//! b 2 310.5 96
//! ```
//!
//! An answer has one fact a line, its fields between tabs, then an empty line and the SVG ([`Answer`] lists them).
//! No geometry is left to the page: it moves what it is told to move.

use std::fmt::Write;
use std::sync::OnceLock;

use crate::figure::{
    Figure, FigureError, Frame, HandlePlace, LawReading, ParameterKind, Position, Value, Values,
    decimal, power_of_ten, readable,
};
use crate::gallery::{self, Figures};
use crate::law::Relation;

/// What a page is told about a figure with certain values.
///
/// | line | fields |
/// |---|---|
/// | `values` | the values as a query string, to ask again with and to link to |
/// | `size` | width and height of the picture |
/// | `handle` | parameter, index, x and y in the picture, what it stands for and where it is |
/// | `slider`, `stepper` | parameter, lowest, highest and present value, the value in words |
/// | `law` | id of the statement, claim, left side, sign, right side, how well they agree, `holds` or `fails` |
/// | `remark` | what is special about these values |
/// | `error` | why there is no picture for these values |
///
/// # Examples
///
/// ```
/// let answer = cagd::live::answer("bezier-figure-de-casteljau\nt=0.5\n");
/// let (facts, svg) = answer.split_once("\n\n").expect("facts, then the picture");
/// assert!(facts.contains("\nslider\tt\t0\t1\t0.5\t"));
/// assert!(svg.starts_with("<svg"));
/// let answer = cagd::live::answer("subdivision-limit-stencils\nscheme=3\n");
/// assert!(answer.contains("\nstepper\tscheme\t0\t3\t3\tscheme: four-point\n"));
/// assert!(cagd::live::answer("nothing\n\n").starts_with("error\tthere is no figure `nothing`"));
/// ```
#[derive(Debug, Clone, Default)]
pub struct Answer {
    facts: String,
    svg: String,
}

/// Answers a question of a page about any figure of the book; what is wrong with it is part of the answer.
#[must_use]
pub fn answer(question: &str) -> String {
    static ALL: LiveFigures = LiveFigures::new(gallery::all);
    ALL.answer(question)
}

/// Some figures that answer; they are made at the first question and remember what they need at each drawing.
#[derive(Debug)]
pub struct LiveFigures {
    make: Figures,
    made: OnceLock<Vec<Live>>,
}

impl LiveFigures {
    /// The figures that `make` makes.
    #[must_use]
    pub const fn new(make: Figures) -> Self {
        Self {
            make,
            made: OnceLock::new(),
        }
    }

    /// Answers a question about one of them, as [`answer`] does.
    #[must_use]
    pub fn answer(&self, question: &str) -> String {
        let mut lines = question.lines();
        let id = lines.next().unwrap_or_default().trim();
        let values = lines.next().unwrap_or_default().trim();
        let drag = lines.next().unwrap_or_default().trim();
        let mut answer = Answer::default();
        match self.find(id) {
            Some(figure) => {
                if let Err(error) = answer.draw(figure, values, drag) {
                    answer.fact("error", &[&error.to_string()]);
                }
            }
            None => answer.fact(
                "error",
                &[&format!("there is no figure `{id}`; reload the page")],
            ),
        }
        format!("{}\n{}", answer.facts, answer.svg)
    }

    fn find(&self, id: &str) -> Option<&Live> {
        let made = self.made.get_or_init(|| {
            let live = |figure| Live {
                figure,
                frames: OnceLock::new(),
            };
            (self.make)().into_iter().map(live).collect()
        });
        made.iter().find(|live| live.figure.id() == id)
    }
}

/// A figure, and where its panels and handles are.
#[derive(Debug)]
struct Live {
    figure: Figure,
    /// The frames do not depend on the values, so those of the default picture serve for all.
    frames: OnceLock<Vec<Frame>>,
}

impl Live {
    fn frames(&self) -> Result<&[Frame], FigureError> {
        if let Some(frames) = self.frames.get() {
            return Ok(frames);
        }
        let frames = self.figure.plot(&self.figure.defaults())?.picture().frames;
        Ok(self.frames.get_or_init(|| frames))
    }
}

impl Answer {
    fn fact(&mut self, name: &str, fields: &[&str]) {
        self.facts.push_str(name);
        for field in fields {
            // Tabs and line ends part the fields and the facts.
            let field = field.replace(['\t', '\n', '\r'], " ");
            self.facts.push('\t');
            self.facts.push_str(&field);
        }
        self.facts.push('\n');
    }

    fn draw(&mut self, live: &Live, values: &str, drag: &str) -> Result<(), FigureError> {
        let figure = &live.figure;
        let mut values = figure.values(values)?;
        if !drag.is_empty() {
            values = dragged(live, &values, drag)?;
        }
        self.fact("values", &[&values.to_string()]);
        let plot = figure.plot(&values)?;
        let picture = plot.picture();
        let [width, height] = picture.size;
        self.fact("size", &[&decimal(width, 2), &decimal(height, 2)]);
        for (handle, at) in plot.handles().iter().zip(&picture.handles) {
            self.handle(handle, *at);
        }
        for parameter in figure.parameters() {
            self.control(&parameter.name, &parameter.kind, &values)?;
        }
        let several = plot
            .readings()
            .windows(2)
            .any(|pair| pair[0].panel != pair[1].panel);
        for law in plot.readings() {
            let claim = match several {
                true => format!("{}: {}", law.panel, law.claim),
                false => law.claim.clone(),
            };
            self.fact(
                "law",
                &[
                    &law.statement,
                    &claim,
                    &law.left,
                    &law.relation.to_string(),
                    &law.right,
                    &agreement(law),
                    if law.holds { "holds" } else { "fails" },
                ],
            );
        }
        for remark in plot.remarks() {
            self.fact("remark", &[remark]);
        }
        self.svg = picture.svg;
        Ok(())
    }

    fn handle(&mut self, handle: &HandlePlace, at: [f64; 2]) {
        let index = handle
            .index
            .map(|index| index.to_string())
            .unwrap_or_default();
        let name = spoken(&handle.parameter);
        let [x, y] = handle.place.position().map(sensible);
        let words = match handle.index {
            Some(index) => format!("{name} {index} at ({x}, {y})"),
            None => format!("{name} at ({x}, {y})"),
        };
        self.fact(
            "handle",
            &[
                &handle.parameter,
                &index,
                &decimal(at[0], 2),
                &decimal(at[1], 2),
                &words,
            ],
        );
    }

    fn control(
        &mut self,
        name: &str,
        kind: &ParameterKind,
        values: &Values,
    ) -> Result<(), FigureError> {
        match (kind, values.get(name)?) {
            (ParameterKind::Slider { low, high, .. }, Value::Number(value)) => {
                let words = format!("{} = {}", written(name), readable(*value));
                self.fact(
                    "slider",
                    &[
                        name,
                        &low.to_string(),
                        &high.to_string(),
                        &value.to_string(),
                        &words,
                    ],
                );
            }
            (
                ParameterKind::Stepper {
                    low, high, names, ..
                },
                Value::Count(value),
            ) => {
                let words = match names.get(value - low) {
                    Some(chosen) => format!("{}: {chosen}", written(name)),
                    None => format!("{} = {value}", written(name)),
                };
                self.fact(
                    "stepper",
                    &[
                        name,
                        &low.to_string(),
                        &high.to_string(),
                        &value.to_string(),
                        &words,
                    ],
                );
            }
            _ => {}
        }
        Ok(())
    }
}

/// The values after a handle went to a point of the picture: `b 2 310.5 96`, or `m  310.5 96` without an index.
fn dragged(live: &Live, values: &Values, drag: &str) -> Result<Values, FigureError> {
    let figure = &live.figure;
    let unreadable = || FigureError::Unreadable {
        figure: figure.id().to_owned(),
        text: drag.to_owned(),
        reason: "a drag is written as name, index, x, y".to_owned(),
    };
    let words: Vec<&str> = drag.split(' ').collect();
    let [name, index, x, y] = words.as_slice() else {
        return Err(unreadable());
    };
    let number = |text: &str| text.parse::<f64>().map_err(|_| unreadable());
    let at = [number(x)?, number(y)?];
    let index: Option<usize> = match *index {
        "" => None,
        index => Some(index.parse().map_err(|_| unreadable())?),
    };
    let parameter = figure.parameters().iter().find(|p| p.name == *name);
    let panel = match parameter.map(|parameter| &parameter.kind) {
        Some(ParameterKind::Handles { panel, .. } | ParameterKind::Handle { panel, .. }) => panel,
        _ => return Err(unreadable()),
    };
    let frames = live.frames()?;
    let frame = match panel {
        Some(panel) => frames.iter().find(|frame| frame.panel == *panel),
        None => frames.first(),
    };
    let place = place(frame.ok_or_else(unreadable)?, at);
    Ok(match (values.get(name)?, index) {
        (Value::Points(points), Some(index)) if index < points.len() => {
            let mut points = points.clone();
            points[index] = place.into();
            values.clone().with(name, Value::Points(points))
        }
        (Value::Point(_), None) => values.clone().with_point(name, place),
        _ => return Err(unreadable()),
    })
}

/// Where in the world a point of the picture is.
fn place(frame: &Frame, at: [f64; 2]) -> [f64; 2] {
    let [x, y] = frame.to_world(at);
    // A hundredth of the picture's unit is as fine as a hand is.
    let step = |size: f64, pixels: f64| libm::pow(10.0, libm::floor(libm::log10(size / pixels)));
    let ([left, low], [right, high]) = (frame.window.low, frame.window.high);
    let (w, h) = (right - left, high - low);
    let round = |x: f64, step: f64| {
        let rounded = libm::round(x / step) * step;
        decimal(rounded, 12).parse().unwrap_or(rounded)
    };
    [
        round(x, step(w, frame.rectangle[2])),
        round(y, step(h, frame.rectangle[3])),
    ]
}

/// A number with three significant digits, as a reader wants to see it.
fn sensible(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let digits = 2.0 - libm::floor(libm::log10(x.abs()));
    decimal(x, digits.clamp(0.0, 12.0) as usize)
}

/// How well the two sides of a claim agree, in words.
fn agreement(law: &LawReading) -> String {
    let apart = power_of_ten(law.residual);
    let allowed = power_of_ten(law.allowed);
    match (law.holds, law.relation) {
        (true, _) if law.residual == 0.0 => "without any difference".to_owned(),
        (true, Relation::AtMost) if law.residual < 0.0 => {
            format!("with {} to spare", readable(-law.residual))
        }
        (true, _) => format!("up to {apart}; rounding allows {allowed}"),
        (false, _) => format!("by {apart}; rounding allows {allowed}"),
    }
}

/// A mathematical name as it is written: `\lambda` is λ, `m_11` is m₁₁.
fn written(name: &str) -> String {
    let name = match name.trim_start_matches('\\') {
        "alpha" => "α",
        "lambda" => "λ",
        "mu" => "μ",
        "varphi" => "φ",
        other => other,
    };
    match name.split_once('_') {
        Some((stem, index)) => {
            let lowered = index.chars().filter_map(|digit| match digit {
                '{' | '}' => None,
                digit => Some(digit.to_digit(10).map_or(digit, |d| LOWERED[d as usize])),
            });
            format!("{stem}{}", lowered.collect::<String>())
        }
        None => name.to_owned(),
    }
}

const LOWERED: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

/// A mathematical name as it is spoken: `\alpha` is alpha, `b_1` is b 1.
fn spoken(name: &str) -> String {
    let mut spoken = String::new();
    for letter in name.chars() {
        match letter {
            '\\' | '{' | '}' | '$' => {}
            '_' | '^' => spoken.push(' '),
            _ => {
                let _ = write!(spoken, "{letter}");
            }
        }
    }
    spoken
}
