//! Triangular schemes and tables: values in columns, with arrows between neighbours.

use super::canvas::Canvas;
use super::label::{LEADING, SIZE, block};
use super::shape::Side;
use super::style::Style;

/// Room between two columns, for arrows with a label on them, in units of the picture.
const ARROW_ROOM: f64 = 52.0;
/// Room between two columns without arrows.
const PLAIN_ROOM: f64 = 22.0;

/// A scheme of entries in columns: a triangle as of de Casteljau, or a table.
///
/// Entries are labels; `\n` begins a second line, for a value below its name.
/// What is drawn has names: with `canvas.scheme("scheme", …)` the entry of row 1 in column 2 is the text
/// `scheme[2][1]`, and the arrow from it to row 0 in column 3 is `scheme[2][1]->[0]`.
///
/// ```
/// use cagd::figure::{Figure, Scheme};
///
/// let figure = Figure::new("demo", "A scheme", "Two values and their mean.").draw(|_, canvas| {
///     let scheme = Scheme::triangle([vec!["b_0\n2", "b_1\n4"], vec!["b_0^1\n3"]]).weights("1-t", "t");
///     canvas.scheme("scheme", &scheme);
///     Ok(())
/// });
/// let plot = figure.plot(&figure.defaults())?;
/// assert_eq!(plot.text("scheme[1][0]")?, "b_0^1\n3");
/// # Ok::<(), cagd::figure::BoxError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scheme {
    columns: Vec<Vec<String>>,
    triangle: bool,
    weights: Option<(String, String)>,
    highlighted: Vec<((usize, usize), usize)>,
    headed: bool,
}

impl Scheme {
    fn new<S: Into<String>>(columns: impl IntoIterator<Item = Vec<S>>, triangle: bool) -> Self {
        let columns = columns
            .into_iter()
            .map(|column| column.into_iter().map(Into::into).collect())
            .collect();
        Scheme {
            columns,
            triangle,
            weights: None,
            highlighted: vec![],
            headed: false,
        }
    }

    /// A triangle: each column stands half a row lower than the one before, and each entry gets an arrow from
    /// its two neighbours in the column before.
    pub fn triangle<S: Into<String>>(columns: impl IntoIterator<Item = Vec<S>>) -> Self {
        Scheme::new(columns, true)
    }

    /// A table, column by column.
    pub fn table<S: Into<String>>(columns: impl IntoIterator<Item = Vec<S>>) -> Self {
        Scheme::new(columns, false)
    }

    /// Draws a line below the first row, which holds the headings: `NAME.rule`.
    ///
    /// ```
    /// use cagd::figure::{Figure, Scheme};
    ///
    /// let figure = Figure::new("demo", "A table", "Two columns with headings.").draw(|_, canvas| {
    ///     canvas.scheme("table", &Scheme::table([vec!["k", "0", "1"], vec!["4^k", "1", "4"]]).headed());
    ///     Ok(())
    /// });
    /// let plot = figure.plot(&figure.defaults())?;
    /// let [from, to] = plot.segment("table.rule")?;
    /// assert!(from[1] == to[1] && from[1] < 0.0, "level, below the first row");
    /// # Ok::<(), cagd::figure::BoxError>(())
    /// ```
    #[must_use]
    pub fn headed(self) -> Self {
        Scheme {
            headed: true,
            ..self
        }
    }

    /// Labels for the arrows of a triangle: those that go down (from the upper neighbour) and those that go up.
    #[must_use]
    pub fn weights(self, down: &str, up: &str) -> Self {
        Scheme {
            weights: Some((down.into(), up.into())),
            ..self
        }
    }

    /// Draws the arrow from row `row` of column `column` to row `target` of the next one in the style of tangents.
    #[must_use]
    pub fn highlighted(mut self, column: usize, row: usize, target: usize) -> Self {
        self.highlighted.push(((column, row), target));
        self
    }

    pub(super) fn draw(&self, name: &str, canvas: &mut Canvas) {
        let width = |entry: &String| block(entry, SIZE)[0];
        let tallest = self
            .columns
            .iter()
            .flatten()
            .map(|entry| block(entry, SIZE)[1])
            .fold(LEADING * SIZE, f64::max);
        let row = if self.triangle {
            (tallest + 20.0).max(46.0)
        } else {
            tallest + 9.0
        };
        let room = if self.triangle {
            ARROW_ROOM
        } else {
            PLAIN_ROOM
        };
        let mut x = 0.0;
        let mut before: Option<(f64, f64)> = None;
        for (j, column) in self.columns.iter().enumerate() {
            let half = 0.5 * column.iter().map(width).fold(0.0, f64::max);
            x += half + if j > 0 { room } else { 0.0 };
            let y = |i: usize, j: usize| {
                -row * (i as f64 + if self.triangle { 0.5 * j as f64 } else { 0.0 })
            };
            for (i, entry) in column.iter().enumerate() {
                canvas.text(
                    &format!("{name}[{j}][{i}]"),
                    entry,
                    [x, y(i, j)],
                    Side::Centre,
                );
                let Some((source, source_half)) = before.filter(|_| self.triangle) else {
                    continue;
                };
                for k in [i, i + 1] {
                    if self.columns[j - 1].get(k).is_none() {
                        continue;
                    }
                    let (from, to) = (
                        [source + source_half + 5.0, y(k, j - 1)],
                        [x - half - 5.0, y(i, j)],
                    );
                    // Arrows end a little above and below the middle of an entry, so that their heads do not meet.
                    let lift = if k == i { 5.0 } else { -5.0 };
                    let ends = ([from[0], from[1] - 0.5 * lift], [to[0], to[1] + lift]);
                    let hot = self.highlighted.contains(&((j - 1, k), i));
                    let style = if hot {
                        Style::Tangent
                    } else {
                        Style::Connector
                    };
                    canvas.arrow(
                        &format!("{name}[{}][{k}]->[{i}]", j - 1),
                        ends.0,
                        ends.1,
                        style,
                    );
                    if let Some((down, up)) = &self.weights {
                        let at = [0.5 * (ends.0[0] + ends.1[0]), 0.5 * (ends.0[1] + ends.1[1])];
                        // Between two arrows that leave one entry there is room for one label, and so there is
                        // between two that meet: each label stands above its arrow.
                        let (text, side) = if k == i {
                            (down, Side::AboveRight)
                        } else {
                            (up, Side::AboveLeft)
                        };
                        canvas.small_label(text, at, side);
                    }
                }
            }
            before = Some((x, half));
            x += half;
        }
        if self.headed {
            let ends = [[-4.0, -0.5 * row], [x + 4.0, -0.5 * row]];
            canvas.segment(&format!("{name}.rule"), ends[0], ends[1], Style::Connector);
        }
    }
}
