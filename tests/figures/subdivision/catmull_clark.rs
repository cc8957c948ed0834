//! Figures of Catmull–Clark subdivision, its limits and creases.

use cagd::figure::Place;
use cagd::law::gamma;
use cagd::subdivision::figures;

use crate::support::{ensure, figure_test, near};

/// Every new point is the mean of the points of its stencil with the weights that stand there.
#[test]
fn figure_catmull_clark() {
    figure_test(figures::figure_catmull_clark(), |plot| {
        // The vertices of the grid are read off from its edges, the weights from the labels.
        let labels: Vec<(String, Place)> = plot
            .labels()
            .map(|(text, at)| (text.to_owned(), at))
            .collect();
        let mut from = 0;
        for (panel, count) in [("face point", 4), ("edge point", 6), ("vertex point", 9)] {
            let mut mean = [0.0; 2];
            let mut sum = 0.0;
            for (i, (text, at)) in labels[from..from + count].iter().enumerate() {
                let (n, d) = text.split_once('/').ok_or("a weight is a fraction")?;
                let weight: f64 = n.parse::<f64>()? / d.parse::<f64>()?;
                let point = plot.point(&format!("{panel}/stencil {i}"))?;
                near("a weight stands at its point", *at, point, 0.0)?;
                sum += weight;
                mean[0] += weight * point[0];
                mean[1] += weight * point[1];
            }
            from += count;
            ensure(sum == 1.0, || {
                format!("the weights of the {panel} sum to {sum}")
            })?;
            // Weights are dyadic and coordinates are whole: nothing is rounded.
            near(
                panel,
                plot.point(&format!("{panel}/stencil"))?,
                Place::new(mean),
                0.0,
            )?;
        }
        let surface = plot.surface("cube/surface")?;
        ensure(surface.places.len() == 98, || {
            format!(
                "the cube has 98 vertices after two steps, not {}",
                surface.places.len()
            )
        })
    })
    .rejects("a face point beside the middle", |plot| {
        plot.shifted("face point/stencil", [0.1, 0.0])
    })
    .rejects("a vertex of the stencil elsewhere", |plot| {
        plot.shifted("vertex point/stencil 3", [0.0, 0.2])
    })
    .snapshot();
}

/// The limits lie half of the way to the centre, on the body, and the normals point away from it.
#[test]
fn catmull_clark_limit() {
    figure_test(figures::catmull_clark_limit(), |plot| {
        let bound = gamma(40) * 4.0;
        let mut seen = 0;
        for v in 0..8 {
            let Ok(limit) = plot.point(&format!("limit {v}")) else {
                continue;
            };
            seen += 1;
            let [vertex, end] = plot.segment(&format!("way {v}"))?;
            near("the way ends at the limit", end, limit, 0.0)?;
            let half = Place::new([vertex[0] / 2.0, vertex[1] / 2.0]);
            near("half of the way to the centre", limit, half, bound)?;
            let [start, tip] = plot.segment(&format!("normal {v}"))?;
            near("the normal stands on the limit", start, limit, 0.0)?;
            // By symmetry the normal at a vertex of the cube is its diagonal.
            let along = (tip - start).perp(&(vertex - start));
            ensure(along.abs() <= 8.0 * bound, || {
                format!("normal {v} is not the diagonal")
            })?;
        }
        ensure((4..=6).contains(&seen), || {
            format!("{seen} vertices are in front")
        })
    })
    .rejects("a limit off the diagonal", |plot| {
        plot.shifted("limit 5", [0.05, 0.0])
    })
    .snapshot();
}

/// The rim of the top is drawn: a closed polygon of sharp edges whose ends are vertices of the body.
#[test]
fn creases() {
    figure_test(figures::creases(), |plot| {
        let surface = plot.surface("body")?;
        let names: Vec<String> = plot
            .names()
            .map(|(_, name)| name.to_owned())
            .filter(|name| name.starts_with("crease"))
            .collect();
        // Four edges, three times halved, all at the top, which is in front.
        ensure(names.len() == 32, || {
            format!("{} sharp edges are drawn", names.len())
        })?;
        for name in &names {
            for end in plot.segment(name)? {
                let on_body = surface.places.contains(&end);
                ensure(on_body, || {
                    format!("an end of {name} is no vertex of the body")
                })?;
            }
        }
        Ok(())
    })
    .rejects("a rim beside the body", |plot| {
        let name = plot
            .names()
            .map(|(_, name)| name.to_owned())
            .find(|name| name.starts_with("crease"));
        plot.shifted(&name.unwrap_or_default(), [0.02, 0.0])
    })
    .snapshot();
}
