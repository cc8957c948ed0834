//! Figures of the section on affine combinations.

use crate::affine::{
    CombinationKind, Linear, Point, Vector, barycentre as balance, laws, plane_determinant,
};
use crate::figure::{Figure, PointStyle, Style, decimal};
use crate::scalar::{Real, exact};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_combinations(), barycentre()]
}

/// The plane, the line and the segment of all linear, affine and convex combinations of two vectors.
#[must_use]
pub fn figure_combinations() -> Figure {
    Figure::new(
        "affine-figure-combinations",
        "Linear, affine and convex combinations of two vectors",
        "Two arrows a and b from the origin. \
         The whole plane is shaded: it holds all linear combinations. \
         A dashed line runs through the tips of both arrows: the affine combinations. \
         Its part between the tips is drawn thick: the convex combinations. \
         A marked point is the combination that is chosen; it is the corner of a parallelogram along a and b.",
    )
    .slider("\\lambda", -1.5..=1.5, -0.5)
    .slider("\\mu", -1.5..=2.0, 1.5)
    .handle("a", [2.4, 0.4])
    .handle("b", [0.8, 1.7])
    .draw(|values, canvas| {
        let (low, high) = ([-1.6, -0.9], [4.4, 3.1]);
        // In steps of 1/64 the sum is free of rounding, and a reader finds λ + μ = 1.
        let step = |x: f64| libm::round(x * 64.0) / 64.0;
        let [lambda, mu] = [values.number("\\lambda")?, values.number("\\mu")?].map(step);
        let [a, b] = [values.point("a")?, values.point("b")?].map(|tip| tip.from_origin());
        let origin = Point::origin();
        let [along_a, along_b] = [a.scaled(lambda), b.scaled(mu)];
        let combination = origin + along_a + along_b;
        canvas.window(low, high);
        canvas.rectangle("linear combinations", low, high, Style::Region);
        canvas.line("affine combinations", a, b, Style::Extension);
        canvas.segment("convex combinations", a, b, Style::Curve);
        canvas.polyline(
            "parallelogram",
            [origin, origin + along_a, combination, origin + along_b, origin],
            Style::Guide,
        );
        canvas.arrow("a", origin, a, Style::Tangent);
        canvas.arrow("b", origin, b, Style::Tangent);
        canvas.point("combination", combination, PointStyle::Result);
        canvas.label("a", a);
        canvas.label("b", b);
        canvas.label("\\lambda a + \\mu b", combination);
        let [exact_a, exact_b] = [a, b].map(|v| Vector::from([0, 1].map(|k| exact(v[k]).unwrap_or_default())));
        let weights = [lambda, mu].map(|weight| exact(weight).unwrap_or_default());
        let law = laws::line_through_two_points(
            |lambda, mu| CombinationKind::of(&[lambda.clone(), mu.clone()]),
            [&exact_a, &exact_b],
            [&weights[0], &weights[1]],
        );
        canvas.law("affine-line-through-two-points", &law);
        if plane_determinant(&a, &b) == 0.0 {
            canvas.remark(
                "a and b are linearly dependent: their combinations do not fill the plane, \
                 and other weights than those with the sum 1 lead to the line as well.",
            );
        }
        let kind = match CombinationKind::of(&[lambda, mu]) {
            CombinationKind::Linear => "linear",
            CombinationKind::Affine => "affine",
            CombinationKind::Convex => "convex",
        };
        let [lambda, mu] = [lambda, mu].map(|weight| decimal(weight, 2));
        canvas.caption(&format!("$\\lambda = {lambda}$, $\\mu = {mu}$: {kind}"));
        canvas.legend("linear", Style::Region);
        canvas.legend("affine", Style::Extension);
        canvas.legend("convex", Style::Curve);
        Ok(())
    })
}

/// How large the disc of the weight 1 is.
const UNIT_RADIUS: f64 = 0.28;

/// Three weights, drawn as discs, and the point where they balance.
#[must_use]
pub fn barycentre() -> Figure {
    Figure::new(
        "affine-barycentre",
        "The barycentre of three weighted points",
        "Three points as discs whose areas are proportional to their weights, \
         joined by thin lines with the barycentre. \
         It lies nearest to the heaviest point. \
         The weights and the coordinates of the barycentre are written above.",
    )
    .slider("w_0", 0.0..=6.0, 1.0)
    .slider("w_1", 0.0..=6.0, 2.0)
    .slider("w_2", 0.0..=6.0, 5.0)
    .handles("A", [[0.0, 0.0], [6.0, 0.6], [2.0, 4.0]])
    .draw(|values, canvas| {
        let weights = [
            values.number("w_0")?,
            values.number("w_1")?,
            values.number("w_2")?,
        ];
        let points = values.points("A")?;
        let masses: Vec<_> = std::iter::zip(weights, points.iter().copied()).collect();
        let centre = balance(&masses).ok();
        for (i, (weight, point)) in masses.iter().enumerate() {
            if let Some(centre) = centre {
                canvas.segment(&format!("lever {i}"), *point, centre, Style::Guide);
            }
            let radius = UNIT_RADIUS * Real::sqrt(*weight);
            canvas.circle(&format!("mass {i}"), *point, radius, Style::Disc);
            canvas.point(&format!("A_{i}"), *point, PointStyle::Control);
            canvas.label(&format!("A_{i}"), point);
        }
        let law = laws::barycentre(|masses| balance(masses).ok(), &masses, &2.0, (0, &1.0));
        canvas.law("affine-barycentre", &law);
        let [u, v, w] = weights.map(|weight| decimal(weight, 2));
        let Some(centre) = centre else {
            canvas.caption(&format!("weights {u}, {v}, {w}: no barycentre"));
            canvas.remark(
                "The weights sum to 0, and nothing can be divided by their sum. A barycentre needs another sum.",
            );
            return Ok(());
        };
        canvas.point("G", centre, PointStyle::Result);
        canvas.label("G", centre);
        let [x, y] = [0, 1].map(|k| decimal(centre[k], 2));
        canvas.caption(&format!("weights {u}, {v}, {w}: $G = ({x}, {y})$"));
        if weights.contains(&0.0) {
            canvas.remark("A weight is 0: its point has no part in the barycentre.");
        }
        Ok(())
    })
}
