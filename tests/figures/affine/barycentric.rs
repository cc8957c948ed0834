//! Figures of barycentric coordinates.

use cagd::affine::{Affine, Point, figures, signed_area};
use cagd::law::gamma;

use crate::support::{ensure, figure_test, near};

/// The arrows are the vectors B − G and G − A beside the line, and the captions say their shares of B − A.
#[test]
fn barycentric_on_line() {
    figure_test(figures::barycentric_on_line(), |plot| {
        for (panel, [alpha, beta]) in [("inside", [0.7, 0.3]), ("outside", [-0.5, 1.5])] {
            let place = |name: &str| plot.point(&format!("{panel}/{name}"));
            let [a, b, g] = [place("A")?, place("B")?, place("G")?];
            let way = b - a;
            // The foot is computed with 3 products, 2 sums, a quotient and a combination; coordinates are below 6.
            let bound = gamma(2 * 10) * 4.0 * 6.0;
            near("G = αA + βB", g, a.lerp(&b, beta), bound)?;
            for (name, share, ends) in [("alpha", alpha, [g, b]), ("beta", beta, [a, g])] {
                let [from, to] = plot.segment(&format!("{panel}/{name}"))?;
                near(name, from + way * share, to, bound)?;
                let [first, second] = [from - ends[0], to - ends[1]];
                ensure((first - second).amax() <= bound, || {
                    format!("{name} is not drawn beside its points")
                })?;
            }
        }
        Ok(())
    })
    .rejects("a point off the line", |plot| {
        plot.shifted("inside/G", [0.0, 0.1])
    })
    .rejects("the arrows exchanged", |plot| {
        plot.swapped("outside/alpha", "outside/beta")
    })
    .snapshot();
}

/// The labels say the ratio of the areas of the triangles that are drawn.
#[test]
fn barycentric_in_triangle() {
    figure_test(figures::barycentric_in_triangle(), |plot| {
        let area =
            |corners: &[cagd::figure::Place]| signed_area(&corners[0], &corners[1], &corners[2]);
        let g = plot.point("G")?;
        let corners = [plot.point("A")?, plot.point("B")?, plot.point("C")?];
        let whole = area(&corners);
        let labels: Vec<&str> = plot.labels().map(|(text, _)| text).collect();
        for (i, (name, sign)) in [("A", "\\alpha"), ("B", "\\beta"), ("C", "\\gamma")]
            .into_iter()
            .enumerate()
        {
            let part = plot.polygon(&format!("opposite {name}"))?;
            let mut expected = corners;
            expected[i] = g;
            for (found, expected) in std::iter::zip(part, expected) {
                near("a corner", *found, expected, 0.0)?;
            }
            let text = format!("{sign} = {}", cagd::figure::decimal(area(part) / whole, 2));
            ensure(labels.contains(&text.as_str()), || {
                format!("`{text}` is not among {labels:?}")
            })?;
        }
        Ok(())
    })
    .rejects("the triangles of the class notes", |plot| {
        plot.swapped("opposite A", "opposite C")
    })
    .rejects("another point", |plot| plot.shifted("G", [0.2, 0.0]))
    .snapshot();
}

/// M₁ halves AB, M₂ halves M₁B, B halves AM₃, and both arrows are the vector B − A.
#[test]
fn exercise_points_on_line() {
    figure_test(figures::exercise_points_on_line(), |plot| {
        let [a, b] = [plot.point("A")?, plot.point("B")?];
        let [first, second, third] = [plot.point("M_1")?, plot.point("M_2")?, plot.point("M_3")?];
        let middle = |p: &Point<f64, 2>, q: &Point<f64, 2>| p.lerp(q, 0.5);
        // Small whole coordinates and weights in quarters: nothing is rounded.
        near("M_1", first, middle(&a, &b), 0.0)?;
        near("M_2", second, middle(&first, &b), 0.0)?;
        near("B", b, middle(&a, &third), 0.0)?;
        for name in ["vector", "the same vector"] {
            let [from, to] = plot.segment(name)?;
            // The arrows stand beside the line, at places that are rounded: a sum and a difference of at most 10.
            near(name, from + (b - a), to, gamma(2) * 10.0)?;
        }
        Ok(())
    })
    .rejects("M_3 at the other side", |plot| {
        plot.shifted("M_3", [-12.0, -3.0])
    })
    .rejects("a vector of another length", |plot| {
        plot.scaled("vector", 1.1)
    })
    .snapshot();
}
