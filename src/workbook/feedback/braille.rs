//! The wrong curve beside the right one, in the letters of a terminal.

use anstyle::{AnsiColor, Style};
use drawille::Canvas;

use super::paint::{GOOD, columns, paint};
use super::picture::{Window, drawable, window};
use crate::workbook::checking::verdict::PictureStroke;

/// What is drawn, from below to above.
const ROLES: [(&str, Style); 3] = [
    ("given", AnsiColor::BrightBlack.on_default()),
    ("expected", AnsiColor::Blue.on_default().bold()),
    ("found", AnsiColor::Red.on_default().bold()),
];

/// The room in letters: one picture with colours.
const LARGE: [usize; 2] = [64, 16];
/// The room in letters: several pictures side by side without colours.
const SMALL: [usize; 2] = [23, 9];
/// Dots in a letter of Braille.
const DOTS: [usize; 2] = [2, 4];
/// Letters of Braille without any dot.
const EMPTY: char = '\u{2800}';

/// The picture as lines of text; `None` if there is nothing to see.
///
/// With colours it is one picture, without them one for each role.
pub fn drawn(strokes: &[PictureStroke], with_colours: bool) -> Option<String> {
    let strokes = drawable(strokes);
    let window = window(&strokes)?;
    let room = if with_colours { LARGE } else { SMALL };
    let layers: Vec<(&str, Style, Vec<Vec<char>>)> = ROLES
        .into_iter()
        .filter(|(role, _)| strokes.iter().any(|stroke| stroke.role == *role))
        .map(|(role, style)| {
            let own = strokes.iter().filter(|stroke| stroke.role == role);
            (role, style, letters(own, &window, room))
        })
        .collect();
    Some(if with_colours {
        overlaid(&layers)
    } else {
        side_by_side(&layers, room[0])
    })
}

/// One above the other; where two meet in a letter, the upper one has the colour.
fn overlaid(layers: &[(&str, Style, Vec<Vec<char>>)]) -> String {
    let mut text = String::new();
    let mut met = false;
    let rows = layers.iter().map(|(.., rows)| rows.len()).max();
    for row in 0..rows.unwrap_or_default() {
        let mut line = String::new();
        let width = layers.iter().map(|(.., rows)| rows[row].len()).max();
        for column in 0..width.unwrap_or_default() {
            let mut dots = 0;
            let mut colour = None;
            for (_, style, rows) in layers {
                let letter = rows[row][column];
                if letter != EMPTY {
                    dots |= letter as u32 - EMPTY as u32;
                    colour = Some(style);
                }
            }
            if meets(layers, row, column) {
                colour = Some(&GOOD);
                met = true;
            }
            let letter = char::from_u32(EMPTY as u32 + dots).unwrap_or(EMPTY);
            match colour {
                Some(style) => line.push_str(&paint(*style, letter)),
                None => line.push(' '),
            }
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    let mut legend: Vec<String> = layers
        .iter()
        .map(|(role, style, _)| format!("{} {role}", paint(*style, "⠒⠒")))
        .collect();
    if met {
        legend.push(format!("{} found as expected", paint(GOOD, "⠒⠒")));
    }
    text + &legend.join("   ") + "\n"
}

/// Whether the expected and the found curve are the same in a letter.
fn meets(layers: &[(&str, Style, Vec<Vec<char>>)], row: usize, column: usize) -> bool {
    let letter = |role: &str| {
        let (.., rows) = layers.iter().find(|(name, ..)| *name == role)?;
        Some(rows[row][column]).filter(|&letter| letter != EMPTY)
    };
    letter("expected").is_some() && letter("expected") == letter("found")
}

/// A picture for each, with its name above.
fn side_by_side(layers: &[(&str, Style, Vec<Vec<char>>)], width: usize) -> String {
    let filled = |text: &str| format!("{text}{}", " ".repeat(width + 2 - columns(text).min(width)));
    let names: String = layers.iter().map(|(role, ..)| filled(role)).collect();
    let mut text = format!("{}\n", names.trim_end());
    let rows = layers.iter().map(|(.., rows)| rows.len()).max();
    for row in 0..rows.unwrap_or_default() {
        let line: String = layers
            .iter()
            .map(|(.., rows)| filled(&rows[row].iter().collect::<String>()))
            .collect();
        text.push_str(line.replace(EMPTY, " ").trim_end());
        text.push('\n');
    }
    text
}

/// Strokes as letters; equal lengths look equal in both directions.
fn letters<'a>(
    strokes: impl Iterator<Item = &'a PictureStroke>,
    window: &Window,
    room: [usize; 2],
) -> Vec<Vec<char>> {
    let size: [f64; 2] = std::array::from_fn(|axis| window.high[axis] - window.low[axis]);
    let dots: [f64; 2] = std::array::from_fn(|axis| (room[axis] * DOTS[axis] - 1) as f64);
    let scale = (dots[0] / size[0]).min(dots[1] / size[1]);
    let place = |[x, y]: [f64; 2]| [(x - window.low[0]) * scale, (window.high[1] - y) * scale];
    let mut canvas = Canvas::new(1, 1);
    let mut set = |[x, y]: [f64; 2]| {
        let [x, y] = [x.round(), y.round()];
        if (0.0..=size[0] * scale).contains(&x) && (0.0..=size[1] * scale).contains(&y) {
            canvas.set(x as u32, y as u32);
        }
    };
    for stroke in strokes {
        let points: Vec<[f64; 2]> = stroke.points.iter().map(|&point| place(point)).collect();
        if let [[x, y]] = points[..] {
            // A single dot is easily missed.
            for (dx, dy) in [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                set([x + dx, y + dy]);
            }
        }
        for pair in points.windows(2) {
            let [[ax, ay], [bx, by]] = [pair[0], pair[1]];
            let length = (bx - ax).abs().max((by - ay).abs());
            // What leaves the window far away is drawn with gaps, which nobody sees.
            let steps = length.ceil().clamp(1.0, 4000.0);
            for step in 0..=steps as u32 {
                let t = f64::from(step) / steps;
                set([ax + (bx - ax) * t, ay + (by - ay) * t]);
            }
        }
    }
    // The same for every role, whatever it has drawn.
    let height = ((size[1] * scale / DOTS[1] as f64) as usize + 1).min(room[1]);
    let mut rows: Vec<Vec<char>> = canvas
        .rows()
        .iter()
        .map(|row| {
            row.chars()
                .map(|c| if c == ' ' { EMPTY } else { c })
                .collect()
        })
        .collect();
    rows.resize(height, Vec::new());
    for row in &mut rows {
        row.resize(room[0], EMPTY);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stroke(role: &str, points: &[[f64; 2]]) -> PictureStroke {
        PictureStroke {
            role: role.into(),
            points: points.to_vec(),
        }
    }

    #[test]
    fn without_colours_each_role_has_its_picture() {
        let strokes = [
            stroke("expected", &[[0.0, 0.0], [1.0, 1.0]]),
            stroke("found", &[[0.0, 1.0], [1.0, 1.0]]),
        ];
        let text = drawn(&strokes, false).expect("there is something to see");
        assert!(text.starts_with("expected"), "{text}");
        assert!(!text.contains('\u{1b}'), "{text}");
        assert!(text.lines().all(|line| columns(line) <= 78), "{text}");
        let coloured = drawn(&strokes, true).expect("there is something to see");
        assert!(coloured.contains('\u{1b}'));
        assert!(coloured.lines().all(|line| columns(line) <= 78));
    }

    #[test]
    fn where_the_curves_agree_it_is_said() {
        let line = [[0.0, 0.0], [1.0, 1.0]];
        let same = [stroke("expected", &line), stroke("found", &line)];
        let legend = "found as expected";
        assert!(drawn(&same, true).is_some_and(|text| text.contains(legend)));
        let other = [[0.0, 1.0], [0.2, 1.0]];
        let differ = [stroke("expected", &line), stroke("found", &other)];
        assert!(drawn(&differ, true).is_some_and(|text| !text.contains(legend)));
    }

    #[test]
    fn a_rising_line_rises() {
        let rows = letters(
            [stroke("found", &[[0.0, 0.0], [1.0, 1.0]])].iter(),
            &Window {
                low: [0.0, 0.0],
                high: [1.0, 1.0],
            },
            [8, 4],
        );
        assert_eq!(rows.len(), 4);
        let first = |row: &Vec<char>| row.iter().position(|&c| c != EMPTY);
        assert!(first(&rows[0]) > first(&rows[3]), "{rows:?}");
    }

    #[test]
    fn wild_numbers_do_no_harm() {
        let strokes = [
            stroke("expected", &[[0.0, 0.0], [1.0, 1.0]]),
            stroke("found", &[[-1e300, 1e300], [f64::NAN, 0.0], [1e300, 2.0]]),
        ];
        assert!(drawn(&strokes, true).is_some());
        let wide = [
            stroke("expected", &[[0.0, 0.0], [10.0, 0.1]]),
            stroke("found", &[[0.0, 0.0], [5.0, -900.0]]),
        ];
        assert!(drawn(&wide, true).is_some() && drawn(&wide, false).is_some());
        assert_eq!(drawn(&[stroke("found", &[])], true), None);
    }
}
