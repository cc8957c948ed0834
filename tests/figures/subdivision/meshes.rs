//! Figures of the section on meshes.

use cagd::affine::Vector;
use cagd::figure::{BoxError, Place};
use cagd::subdivision::figures;

use crate::support::{ensure, figure_test, near};

/// The arrows follow each other as flip, next and prev say, each on the left side of its edge.
#[test]
fn figure_half_edge() {
    figure_test(figures::figure_half_edge(), |plot| {
        // With the default values h runs along the edge from 1 to 2 of the quadrilateral 0 1 2 3.
        let p: Vec<Place> = plot.handles().iter().map(|handle| handle.place).collect();
        let beside = |name: &str, start: usize, end: usize| -> Result<(), BoxError> {
            let along = p[end] - p[start];
            let left = Vector::from([-along[1], along[0]]) * 0.055;
            let expected = [0.13, 0.87].map(|part| p[start] + left + along * part);
            let drawn = plot.segment(name)?;
            // Sums of three terms of size up to 6, computed in another order.
            let bound = cagd::law::gamma(8) * 18.0;
            near(name, drawn[0], expected[0], bound)?;
            near(name, drawn[1], expected[1], bound)
        };
        beside("h", 1, 2)?;
        beside("\\text{flip}", 2, 1)?;
        beside("\\text{next}", 2, 3)?;
        beside("\\text{prev}", 0, 1)?;
        for (label, expected) in [("v", p[1]), ("e", p[1] + (p[2] - p[1]) * 0.5)] {
            let found = plot.labels().find(|(text, _)| *text == label);
            let (_, at) = found.ok_or("a label is missing")?;
            near(label, at, expected, cagd::law::gamma(4) * 6.0)?;
        }
        let arrows = plot
            .names()
            .filter(|(_, name)| name.starts_with("half-edge"))
            .count();
        ensure(arrows == 12, || {
            format!("{arrows} other half-edges of 16 − 4")
        })
    })
    .rejects("a flip on the same side", |plot| {
        plot.swapped("h", "\\text{flip}")
    })
    .rejects("an arrow off its edge", |plot| {
        plot.shifted("\\text{next}", [0.0, 0.2])
    })
    .snapshot();
}
