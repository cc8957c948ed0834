//! Figures of the section on Bernstein polynomials.

use cagd::bezier::figures;
use cagd::law::gamma;

use crate::support::{ensure, figure_test};

/// The marked points lie on the graphs, and their heights sum to 1; so do the graphs everywhere.
#[test]
fn bernstein_polynomials() {
    figure_test(figures::bernstein_polynomials(), |plot| {
        let mut sums = vec![0.0; 241];
        let mut total = 0.0;
        for i in 0..=3 {
            let value = plot.point(&format!("value {i}"))?;
            let graph: Vec<_> = plot.samples(&format!("B_{i}"))?.collect();
            ensure(graph.contains(&(value[0], value)), || {
                format!("{value} is not on the graph of B_{i}")
            })?;
            total += value[1];
            for (sum, (_, point)) in sums.iter_mut().zip(&graph) {
                *sum += point[1];
            }
        }
        // 3·3 + 1 roundings for a value, 4 for the sum.
        let allowed = gamma(14);
        ensure((total - 1.0).abs() <= allowed, || {
            format!("the values sum to {total}")
        })?;
        ensure(sums.iter().all(|sum| (sum - 1.0).abs() <= allowed), || {
            "the graphs do not sum to 1".into()
        })
    })
    .rejects("a value off its graph", |plot| {
        plot.shifted("value 1", [0.0, 0.02])
    })
    .rejects("a graph that is too high", |plot| plot.scaled("B_2", 1.05))
    .snapshot();
}

/// Each graph rises up to its marked point and falls behind it, and the marks divide the axis evenly.
#[test]
fn unimodal() {
    figure_test(figures::unimodal(), |plot| {
        for i in 0..=4 {
            let top = plot.point(&format!("maximum {i}"))?;
            let [foot, head] = plot.segment(&format!("place {i}"))?;
            // i/4 is a binary fraction, so the place is exact.
            ensure(top[0] == i as f64 / 4.0, || {
                format!("maximum {i} is at {top}")
            })?;
            ensure(foot == [top[0], 0.0].into() && head == top, || {
                format!("the line of maximum {i} leads from {foot} to {head}")
            })?;
            let graph: Vec<_> = plot.samples(&format!("B_{i}"))?.collect();
            for pair in graph.windows(2) {
                let ((_, p), (t, q)) = (pair[0], pair[1]);
                let rises = p[1] < q[1];
                ensure(rises == (t <= top[0]), || {
                    format!("B_{i} between {p} and {q}")
                })?;
            }
            ensure(graph.contains(&(top[0], top)), || {
                format!("{top} is not on B_{i}")
            })?;
        }
        Ok(())
    })
    .rejects("a mark beside the maximum", |plot| {
        plot.shifted("maximum 1", [0.05, 0.0])
    })
    .rejects("two graphs exchanged", |plot| plot.swapped("B_1", "B_2"))
    .snapshot();
}
