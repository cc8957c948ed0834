//! Finding room for labels.
//!
//! Every label has candidate boxes: eight sides of its anchor at three distances. A candidate is charged for what
//! it covers; the cheapest is taken, first label by label, then again in two sweeps that know all the others.
//! Nothing is random, so the same figure gives the same picture.

use super::clip::Rect;
use super::label::Extent;
use super::shape::Side;

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
    lines: &[([f64; 2], [f64; 2], f64)],
    markers: &[Rect],
    taken: &[Rect],
) -> Vec<Placed> {
    let mut placed: Vec<Option<Placed>> = vec![None; requests.len()];
    let fixed: Vec<Vec<(Placed, f64)>> = requests
        .iter()
        .map(|request| candidates(request, lines, markers, taken))
        .collect();
    for _sweep in 0..3 {
        let before = placed.clone();
        for i in 0..requests.len() {
            let mut best: Option<(f64, Placed)> = None;
            for (candidate, cost) in &fixed[i] {
                // The cheapest come first, so no later one can do better.
                if best.is_some_and(|(least, _)| *cost >= least) {
                    break;
                }
                let others = placed.iter().enumerate().filter(|(j, _)| *j != i);
                let covered: f64 = others
                    .filter_map(|(_, other)| other.as_ref())
                    .map(|other| charge(&candidate.rect, &other.rect, ON_LABEL))
                    .sum();
                let total = cost + covered;
                if best.is_none_or(|(least, _)| total < least) {
                    best = Some((total, *candidate));
                }
            }
            placed[i] = best.map(|(_, candidate)| candidate);
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

/// All candidates with what they cost, other labels apart; the cheapest first.
fn candidates(
    request: &Request,
    lines: &[([f64; 2], [f64; 2], f64)],
    markers: &[Rect],
    taken: &[Rect],
) -> Vec<(Placed, f64)> {
    // Only what is within reach of some candidate can cost anything.
    let Extent {
        width,
        ascent,
        descent,
    } = request.extent;
    let reach = request.clear + RINGS[RINGS.len() - 1] + NEAR + width.max(ascent + descent);
    let here = Rect {
        low: request.anchor,
        high: request.anchor,
    }
    .inflated(reach);
    let lines: Vec<_> = lines
        .iter()
        .filter(|(a, b, _)| here.may_meet(*a, *b))
        .collect();
    let near_by = |rects: &[Rect]| -> Vec<Rect> {
        let meets = |rect: &&Rect| here.may_meet(rect.low, rect.high);
        rects.iter().filter(meets).copied().collect()
    };
    let (markers, taken) = (near_by(markers), near_by(taken));
    let sides = request.side.map_or(SIDES.to_vec(), |side| vec![side]);
    let mut found = vec![];
    for (order, &side) in sides.iter().enumerate() {
        for ring in RINGS {
            let placed = beside(request.anchor, request.clear + ring, request.extent, side);
            let mut cost = FARTHER * ring + LATER_SIDE * order as f64;
            if !request.bounds.contains_rect(&placed.rect) {
                cost += OUTSIDE;
            }
            cost += taken
                .iter()
                .map(|text| charge(&placed.rect, text, ON_LABEL))
                .sum::<f64>();
            cost += markers
                .iter()
                .map(|marker| charge(&placed.rect, marker, ON_MARKER))
                .sum::<f64>();
            let (tight, wide) = (placed.rect.inflated(1.0), placed.rect.inflated(NEAR));
            for &&(a, b, weight) in &lines {
                // Comparing first spares most of the divisions.
                if !wide.may_meet(a, b) {
                    continue;
                }
                let Some(near) = wide.inside(a, b) else {
                    continue;
                };
                let length = (b[0] - a[0]).abs() + (b[1] - a[1]).abs();
                cost += NEAR_LINE * weight * length * (near.1 - near.0);
                if let Some(on) = tight.inside(a, b) {
                    cost += ON_LINE * weight * (length * (on.1 - on.0) + 4.0);
                }
            }
            found.push((placed, cost));
        }
    }
    // Sorting is stable: among equals the side that is tried first stays first.
    found.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    found
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
