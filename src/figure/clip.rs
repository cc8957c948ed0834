//! Cutting off what lies outside a panel.
//!
//! It is done here, on coordinates, and not by an SVG clip path: no ids, fewer bytes, and labels know what is seen.

/// A rectangle with sides parallel to the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Rect {
    pub(super) fn inflated(&self, by: f64) -> Self {
        Rect {
            low: [self.low[0] - by, self.low[1] - by],
            high: [self.high[0] + by, self.high[1] + by],
        }
    }

    pub(super) fn contains(&self, p: [f64; 2]) -> bool {
        (0..2).all(|k| self.low[k] <= p[k] && p[k] <= self.high[k])
    }

    pub(super) fn contains_rect(&self, other: &Rect) -> bool {
        self.contains(other.low) && self.contains(other.high)
    }

    /// The smallest rectangle with two points in it.
    pub(super) fn around(a: [f64; 2], b: [f64; 2]) -> Self {
        Rect {
            low: [a[0].min(b[0]), a[1].min(b[1])],
            high: [a[0].max(b[0]), a[1].max(b[1])],
        }
    }

    /// Whether it has a point in common with another one.
    pub(super) fn meets(&self, other: &Rect) -> bool {
        (0..2).all(|k| self.high[k] >= other.low[k] && self.low[k] <= other.high[k])
    }

    /// The area in common with another one.
    pub(super) fn overlap(&self, other: &Rect) -> f64 {
        if !self.meets(other) {
            return 0.0;
        }
        let side = |k: usize| self.high[k].min(other.high[k]) - self.low[k].max(other.low[k]);
        side(0) * side(1)
    }

    /// The parameters between which a + t·(b − a), 0 ≤ t ≤ 1, lies inside (Liang and Barsky).
    pub(super) fn inside(&self, a: [f64; 2], b: [f64; 2]) -> Option<(f64, f64)> {
        self.inside_of(a, b, (0.0, 1.0))
    }

    fn inside_of(
        &self,
        a: [f64; 2],
        b: [f64; 2],
        (mut enter, mut leave): (f64, f64),
    ) -> Option<(f64, f64)> {
        for k in 0..2 {
            let d = b[k] - a[k];
            let (to_low, to_high) = (self.low[k] - a[k], self.high[k] - a[k]);
            if d == 0.0 {
                if to_low > 0.0 || to_high < 0.0 {
                    return None;
                }
            } else {
                let (first, last) = if d > 0.0 {
                    (to_low / d, to_high / d)
                } else {
                    (to_high / d, to_low / d)
                };
                enter = enter.max(first);
                leave = leave.min(last);
            }
        }
        (enter <= leave).then_some((enter, leave))
    }

    /// The part of the infinite line through two different points that lies inside.
    pub(super) fn line(&self, a: [f64; 2], b: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        if a == b {
            return None;
        }
        let (enter, leave) = self.inside_of(a, b, (f64::NEG_INFINITY, f64::INFINITY))?;
        Some([between(a, b, enter), between(a, b, leave)])
    }

    /// The pieces of a polyline that lie inside.
    pub(super) fn polyline(&self, points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let mut pieces: Vec<Vec<[f64; 2]>> = vec![];
        let mut connected = false;
        for pair in points.windows(2) {
            let Some((enter, leave)) = self.inside(pair[0], pair[1]) else {
                connected = false;
                continue;
            };
            if !connected || enter > 0.0 {
                pieces.push(vec![between(pair[0], pair[1], enter)]);
            }
            if let Some(piece) = pieces.last_mut() {
                piece.push(between(pair[0], pair[1], leave));
            }
            connected = leave >= 1.0;
        }
        pieces
    }

    /// The part of a polygon that lies inside (Sutherland and Hodgman).
    pub(super) fn polygon(&self, vertices: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut polygon = vertices.to_vec();
        for k in 0..2 {
            for (bound, sign) in [(self.low[k], 1.0), (self.high[k], -1.0)] {
                let depth = |p: [f64; 2]| sign * (p[k] - bound);
                let mut cut = vec![];
                for (i, &b) in polygon.iter().enumerate() {
                    let a = polygon[(i + polygon.len() - 1) % polygon.len()];
                    if (depth(a) < 0.0) != (depth(b) < 0.0) {
                        cut.push(between(a, b, depth(a) / (depth(a) - depth(b))));
                    }
                    if depth(b) >= 0.0 {
                        cut.push(b);
                    }
                }
                polygon = cut;
            }
        }
        polygon
    }
}

fn between(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    match t {
        0.0 => a,
        1.0 => b,
        t => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = Rect {
        low: [0.0, 0.0],
        high: [1.0, 1.0],
    };

    #[test]
    fn a_polyline_is_cut_into_the_pieces_inside() {
        let w = [
            [-0.5, 0.5],
            [0.5, 0.5],
            [0.5, 1.5],
            [0.75, 1.5],
            [0.75, 0.0],
        ];
        assert_eq!(
            UNIT.polyline(&w),
            vec![
                vec![[0.0, 0.5], [0.5, 0.5], [0.5, 1.0]],
                vec![[0.75, 1.0], [0.75, 0.0]]
            ]
        );
        assert!(UNIT.polyline(&[[2.0, 0.0], [3.0, 1.0]]).is_empty());
    }

    #[test]
    fn a_polygon_keeps_its_part_inside() {
        let triangle = [[0.5, 0.5], [1.5, 0.5], [0.5, 1.5]];
        assert_eq!(
            UNIT.polygon(&triangle),
            vec![[0.5, 1.0], [0.5, 0.5], [1.0, 0.5], [1.0, 1.0], [1.0, 1.0]]
        );
        assert!(
            UNIT.polygon(&[[2.0, 2.0], [3.0, 2.0], [3.0, 3.0]])
                .is_empty()
        );
    }

    #[test]
    fn a_line_runs_from_side_to_side() {
        assert_eq!(
            UNIT.line([0.25, 0.25], [0.5, 0.5]),
            Some([[0.0, 0.0], [1.0, 1.0]])
        );
        assert_eq!(UNIT.line([0.0, 2.0], [1.0, 2.0]), None);
        assert_eq!(UNIT.line([0.5, 0.5], [0.5, 0.5]), None);
    }
}
