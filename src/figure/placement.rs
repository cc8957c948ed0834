//! Finding room for labels.
//!
//! Every label has candidate boxes: eight sides of its anchor at three distances. A candidate is charged for what
//! it covers; the cheapest is taken, first label by label, then again in two sweeps that know all the others.
//! Nothing is random, so the same figure gives the same picture.

use super::clip::Rect;
use super::label::Extent;
use super::shape::Side;
use super::stroke::Stroke;

/// A label that seeks its place, in units of the picture.
#[derive(Debug, Clone)]
pub(super) struct Request {
    pub(super) anchor: [f64; 2],
    /// How far from the anchor the label must stay: the radius of what is drawn there.
    pub(super) clear: f64,
    pub(super) extent: Extent,
    pub(super) side: Option<Side>,
    /// The panel, which the label should not leave.
    pub(super) bounds: Rect,
}

/// Where a label goes: its box, and the side of the anchor it is on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placed {
    pub(super) rect: Rect,
    pub(super) side: Side,
    pub(super) baseline: f64,
}

/// The sides in the order in which a typesetter would try them; each later one costs a little more.
const SIDES: [Side; 8] = [
    Side::AboveRight,
    Side::Above,
    Side::Right,
    Side::AboveLeft,
    Side::BelowRight,
    Side::Left,
    Side::Below,
    Side::BelowLeft,
];

/// Distances tried beyond the least one.
const RINGS: [f64; 3] = [0.0, 6.0, 13.0];

// The charges compare: leaving the panel is worse than covering a label, that is worse than covering a marker,
// that is worse than crossing lines, and any of it is worse than standing far away or on an unusual side.
const OUTSIDE: f64 = 5000.0;
const ON_LABEL: f64 = 1500.0;
const ON_MARKER: f64 = 300.0;
const ON_LINE: f64 = 7.0;
const NEAR_LINE: f64 = 1.0;
/// How near a line disturbs, in units of the picture.
const NEAR: f64 = 6.0;
const FARTHER: f64 = 1.6;
const LATER_SIDE: f64 = 0.6;

/// Places labels among what is drawn; `taken` are boxes of text that stands already.
pub(super) fn place(
    requests: &[Request],
    strokes: &[Stroke],
    markers: &[Rect],
    taken: &[Rect],
) -> Vec<Placed> {
    let mut placed: Vec<Option<Placed>> = vec![None; requests.len()];
    let mut searches: Vec<Search<'_>> = requests
        .iter()
        .map(|request| Search::new(request, strokes, markers, taken))
        .collect();
    for _sweep in 0..3 {
        let before = placed.clone();
        for (i, search) in searches.iter_mut().enumerate() {
            placed[i] = None;
            placed[i] = search.cheapest(&placed);
        }
        if placed == before {
            break;
        }
    }
    placed.into_iter().flatten().collect()
}

fn charge(a: &Rect, b: &Rect, price: f64) -> f64 {
    match a.overlap(&b.inflated(1.0)) {
        0.0 => 0.0,
        area => price * (1.0 + area / 100.0),
    }
}

/// Where a label could go.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    placed: Placed,
    /// What it costs before anything is found under it.
    least: f64,
    /// What it costs, other labels that seek their place apart; found out when it is asked for.
    cost: Option<f64>,
}

/// The search for the place of a label.
#[derive(Debug)]
struct Search<'a> {
    /// Those that cost the least come first.
    candidates: Vec<Candidate>,
    /// Only what is within reach of some candidate can cost anything.
    strokes: Vec<&'a Stroke>,
    markers: Vec<&'a Rect>,
    taken: Vec<&'a Rect>,
}

impl<'a> Search<'a> {
    fn new(
        request: &Request,
        strokes: &'a [Stroke],
        markers: &'a [Rect],
        taken: &'a [Rect],
    ) -> Self {
        let Extent {
            width,
            ascent,
            descent,
        } = request.extent;
        let reach = request.clear + RINGS[RINGS.len() - 1] + NEAR + width.max(ascent + descent);
        let here = Rect::around(request.anchor, request.anchor).inflated(reach);
        let sides = request.side.map_or(SIDES.to_vec(), |side| vec![side]);
        let mut candidates: Vec<Candidate> = sides
            .iter()
            .enumerate()
            .flat_map(|(order, &side)| RINGS.map(|ring| (order, side, ring)))
            .map(|(order, side, ring)| {
                let placed = beside(request.anchor, request.clear + ring, request.extent, side);
                let inside = request.bounds.contains_rect(&placed.rect);
                let outside = if inside { 0.0 } else { OUTSIDE };
                Candidate {
                    placed,
                    least: FARTHER * ring + LATER_SIDE * order as f64 + outside,
                    cost: None,
                }
            })
            .collect();
        candidates.sort_by(|a, b| a.least.total_cmp(&b.least));
        Self {
            candidates,
            strokes: strokes.iter().filter(|s| s.may_meet(&here)).collect(),
            markers: markers.iter().filter(|rect| here.meets(rect)).collect(),
            taken: taken.iter().filter(|rect| here.meets(rect)).collect(),
        }
    }

    /// The best place among the other labels, where they are for now.
    fn cheapest(&mut self, others: &[Option<Placed>]) -> Option<Placed> {
        let mut best: Option<(f64, Placed)> = None;
        for i in 0..self.candidates.len() {
            let Candidate {
                placed,
                least,
                cost,
            } = self.candidates[i];
            // No later one can do better.
            if best.is_some_and(|(total, _)| least >= total) {
                break;
            }
            let cost = cost.unwrap_or_else(|| self.cost(&placed.rect, least));
            self.candidates[i].cost = Some(cost);
            let covered: f64 = others
                .iter()
                .flatten()
                .map(|other| charge(&placed.rect, &other.rect, ON_LABEL))
                .sum();
            if best.is_none_or(|(total, _)| cost + covered < total) {
                best = Some((cost + covered, placed));
            }
        }
        best.map(|(_, placed)| placed)
    }

    /// What a label costs in a rectangle, with `cost` for the way there.
    fn cost(&self, rect: &Rect, mut cost: f64) -> f64 {
        let charges = |rects: &[&Rect], price| -> f64 {
            rects.iter().map(|other| charge(rect, other, price)).sum()
        };
        cost += charges(&self.taken, ON_LABEL);
        cost += charges(&self.markers, ON_MARKER);
        let (tight, wide) = (rect.inflated(1.0), rect.inflated(NEAR));
        for stroke in &self.strokes {
            let Some(near) = stroke.part_inside(&wide) else {
                continue;
            };
            let (weight, length) = (stroke.weight, stroke.length());
            cost += NEAR_LINE * weight * length * near;
            if let Some(on) = stroke.part_inside(&tight) {
                cost += ON_LINE * weight * (length * on + 4.0);
            }
        }
        cost
    }
}

/// The box of a text beside an anchor.
pub(super) fn beside(anchor: [f64; 2], clear: f64, extent: Extent, side: Side) -> Placed {
    let Extent {
        width,
        ascent,
        descent,
    } = extent;
    // Diagonally, the corner of the box keeps the distance.
    let diagonal = clear * std::f64::consts::FRAC_1_SQRT_2;
    let left = match side {
        Side::Right => anchor[0] + clear,
        Side::AboveRight | Side::BelowRight => anchor[0] + diagonal,
        Side::Above | Side::Below | Side::Centre => anchor[0] - 0.5 * width,
        Side::AboveLeft | Side::BelowLeft => anchor[0] - diagonal - width,
        Side::Left => anchor[0] - clear - width,
    };
    let baseline = match side {
        Side::Above => anchor[1] - clear - descent,
        Side::AboveRight | Side::AboveLeft => anchor[1] - diagonal - descent,
        Side::Left | Side::Right | Side::Centre => anchor[1] + 0.5 * (ascent - descent),
        Side::BelowRight | Side::BelowLeft => anchor[1] + diagonal + ascent,
        Side::Below => anchor[1] + clear + ascent,
    };
    let rect = Rect {
        low: [left, baseline - ascent],
        high: [left + width, baseline + descent],
    };
    Placed {
        rect,
        side,
        baseline,
    }
}
