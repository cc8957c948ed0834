//! The wrong curve beside the right one, as a figure of the house.

use crate::figure::{Figure, FigureError, PointStyle, Style};
use crate::workbook::checking::verdict::{PictureStroke, Verdict};

/// The picture of what is wrong, as SVG; `None` if there is nothing to draw.
pub fn of(verdict: &Verdict, title: &str) -> Option<String> {
    svg(title, strokes(verdict)).ok().flatten()
}

/// The strokes that go with the first test that failed.
pub fn strokes(verdict: &Verdict) -> &[PictureStroke] {
    verdict
        .first_failure()
        .and_then(|test| test.picture.as_deref())
        .unwrap_or_default()
}

/// A part of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// The smallest coordinates.
    pub low: [f64; 2],
    /// The largest coordinates.
    pub high: [f64; 2],
}

/// The strokes whose points can be drawn, without those that are not finite.
pub fn drawable(strokes: &[PictureStroke]) -> Vec<PictureStroke> {
    strokes
        .iter()
        .map(|stroke| PictureStroke {
            role: stroke.role.clone(),
            points: stroke
                .points
                .iter()
                .copied()
                .filter(|point| point.iter().all(|x| x.is_finite()))
                .collect(),
        })
        // A curve that stays where it is is a point, and is drawn as one.
        .map(|mut stroke| {
            stroke.points.dedup();
            stroke
        })
        .filter(|stroke| !stroke.points.is_empty())
        .collect()
}

/// What to show of the plane: all that was given and is right, and of what was found as much as lies near it.
///
/// A wrong curve may run far away; beyond three times the size of the right one it would leave that too small to see.
/// `None` if there is nothing to show, or nothing that numbers can measure.
pub fn window(strokes: &[PictureStroke]) -> Option<Window> {
    let right = bounds(strokes.iter().filter(|stroke| stroke.role != "found"));
    let all = bounds(strokes.iter())?;
    let right = right.unwrap_or(all);
    let size = (0..2)
        .map(|axis| right.high[axis] - right.low[axis])
        .fold(0.0, f64::max);
    let reach = if size > 0.0 { size } else { 1.0 };
    let low = std::array::from_fn(|axis| all.low[axis].max(right.low[axis] - reach));
    let high = std::array::from_fn(|axis| all.high[axis].min(right.high[axis] + reach));
    let margin = 0.04 * (high[0] - low[0] as f64).max(high[1] - low[1]);
    let margin = if margin > 0.0 { margin } else { 1.0 };
    let window = Window {
        low: low.map(|x: f64| x - margin),
        high: high.map(|x: f64| x + margin),
    };
    let is_wide = (0..2).all(|axis| (window.high[axis] - window.low[axis]).is_normal());
    is_wide.then_some(window)
}

fn bounds<'a>(strokes: impl Iterator<Item = &'a PictureStroke>) -> Option<Window> {
    let mut bounds: Option<Window> = None;
    for &point in strokes.flat_map(|stroke| &stroke.points) {
        let window = bounds.get_or_insert(Window {
            low: point,
            high: point,
        });
        for (axis, x) in point.into_iter().enumerate() {
            window.low[axis] = window.low[axis].min(x);
            window.high[axis] = window.high[axis].max(x);
        }
    }
    bounds
}

/// The picture as SVG; `None` if there is nothing to draw.
///
/// # Errors
///
/// The strokes cannot be drawn.
pub fn svg(title: &str, strokes: &[PictureStroke]) -> Result<Option<String>, FigureError> {
    let strokes = drawable(strokes);
    let Some(window) = window(&strokes) else {
        return Ok(None);
    };
    let figure = Figure::new(
        "answer",
        title,
        "Grey: what was given. Blue: what is right. Red, dashed: what the answer gave.",
    )
    .draw(move |_, canvas| {
        canvas.window(window.low, window.high);
        for (number, stroke) in strokes.iter().enumerate() {
            let (line, point) = match stroke.role.as_str() {
                "given" => (Style::ControlPolygon, PointStyle::Control),
                "expected" => (Style::Curve, PointStyle::OnCurve),
                _ => (Style::SecondCurve, PointStyle::Result),
            };
            let name = format!("{} {number}", stroke.role);
            match stroke.points.as_slice() {
                [single] => canvas.point(&name, *single, point),
                points => canvas.polyline(&name, points.iter().copied(), line),
            }
        }
        for (role, text, style) in [
            ("given", "given", Style::ControlPolygon),
            ("expected", "expected", Style::Curve),
            ("found", "found", Style::SecondCurve),
        ] {
            if strokes.iter().any(|stroke| stroke.role == role) {
                canvas.legend(&format!("\\text{{{text}}}"), style);
            }
        }
        Ok(())
    });
    figure.svg().map(Some)
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
    fn a_wrong_curve_far_away_leaves_the_right_one_large() {
        let strokes = [
            stroke("expected", &[[0.0, 0.0], [1.0, 1.0]]),
            stroke("found", &[[0.0, 0.0], [1e9, 0.5]]),
        ];
        let window = window(&strokes).expect("there is something to see");
        assert!(window.high[0] < 3.0, "{window:?}");
        assert!(svg("t", &strokes).is_ok_and(|svg| svg.is_some()));
    }

    #[test]
    fn what_cannot_be_drawn_is_left_out() {
        let strokes = [
            stroke("expected", &[[2.0, 3.0]]),
            stroke("found", &[[f64::NAN, 0.0]]),
        ];
        let picture = svg("a < b", &strokes).expect("it can be drawn");
        let picture = picture.expect("a point is there");
        assert!(picture.contains("expected") && !picture.contains("NaN"));
        assert!(picture.contains("a &lt; b"), "{picture}");
        assert_eq!(svg("t", &[]).expect("nothing fails"), None);
        let infinite = [stroke("found", &[[f64::INFINITY, 0.0]])];
        assert_eq!(svg("t", &infinite).expect("nothing fails"), None);
        let huge = [stroke("expected", &[[-f64::MAX, 0.0], [f64::MAX, 0.0]])];
        assert_eq!(svg("t", &huge).expect("nothing fails"), None);
    }
}
