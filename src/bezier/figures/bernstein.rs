//! Figures of the section on Bernstein polynomials.

use crate::affine::Interval;
use crate::bezier::{bernstein, bernstein_basis, bernstein_maximum, laws};
use crate::figure::{Axes, BoxError, Canvas, Figure, PointStyle, Side, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![bernstein_polynomials(), unimodal()]
}

/// The graphs of all Bernstein polynomials of one degree, and their values at one parameter.
#[must_use]
pub fn bernstein_polynomials() -> Figure {
    Figure::new(
        "bezier-bernstein-polynomials",
        "The Bernstein polynomials of degree 3",
        "The graphs of the four Bernstein polynomials of degree 3 over the unit interval. \
         The first falls from 1 to 0, the last rises from 0 to 1, the two others are zero at both ends and have a hump. \
         A dashed vertical line at the parameter t meets each graph in a marked point; the heights of these points sum to 1.",
    )
    .stepper("n", 1..=6, 3)
    .slider("t", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let n = values.count("n")?;
        let t = values.number("t")?;
        canvas.axes(Axes::new("t", "B_i^n(t)"));
        canvas.segment("line at t", [t, 0.0], [t, 1.0], Style::Guide);
        for i in 0..=n {
            let index = i as i64;
            canvas.graph(&format!("B_{i}"), 0.0..=1.0, |t| bernstein(n, index, t), Style::Series(i));
            canvas.point(&format!("value {i}"), [t, bernstein(n, index, t)], PointStyle::Result);
            label(canvas, n, i)?;
        }
        canvas.law("bezier-partition-of-unity", &laws::partition_of_unity(bernstein_basis, n, t));
        canvas.law("bezier-nonnegativity", &laws::nonnegativity(bernstein, n, t));
        if t == 0.0 || t == 1.0 {
            canvas.remark(
                "t is an end of the interval: one polynomial is 1 and the others are 0. \
                 That all are positive needs 0 < t < 1.",
            );
        }
        Ok(())
    })
}

/// The Bernstein polynomials of degree 4 with their maxima over i/4.
#[must_use]
pub fn unimodal() -> Figure {
    Figure::new(
        "bezier-unimodal",
        "Every Bernstein polynomial has one maximum",
        "The graphs of the five Bernstein polynomials of degree 4 over the unit interval. \
         Each has a single maximum, marked by a point; a dashed line drops from it to the axis, \
         where the places 0, 1/4, 1/2, 3/4 and 1 divide the interval into four equal parts.",
    )
    .stepper("m", 1..=6, 4)
    .draw(|values, canvas| {
        let m = values.count("m")?;
        canvas.axes(Axes::new("t", "B_i^m(t)"));
        for i in 0..=m {
            let maximum = bernstein_maximum::<f64>(m, i, &Interval::unit())?;
            let top = [maximum.place, maximum.value];
            canvas.graph(
                &format!("B_{i}"),
                0.0..=1.0,
                |t| bernstein(m, i as i64, t),
                Style::Series(i),
            );
            canvas.segment(
                &format!("place {i}"),
                [maximum.place, 0.0],
                top,
                Style::Guide,
            );
            canvas.point(&format!("maximum {i}"), top, PointStyle::Result);
            label(canvas, m, i)?;
        }
        let interval = Interval::unit();
        let middle = bernstein_maximum::<f64>(m, m / 2, &interval)?;
        canvas.law(
            "bezier-unimodal",
            &laws::unimodal(|_, _, _| middle, m, m / 2, &interval, &[0.25, 0.5, 0.75]),
        );
        if m == 1 {
            canvas.remark(
                "For m = 1 both polynomials are straight, and each is largest at an end, where its derivative is not 0.",
            );
        }
        Ok(())
    })
}

/// The name of a Bernstein polynomial at its maximum; that of the first and the last beside the graph, at a
/// height where it is free of the axis.
fn label(canvas: &mut Canvas, n: usize, i: usize) -> Result<(), BoxError> {
    let text = format!("B_{i}^{n}");
    let maximum = bernstein_maximum::<f64>(n, i, &Interval::unit())?;
    // The place where (1 − t)ⁿ is 4/5.
    let near_end = 1.0 - libm::pow(0.8, 1.0 / n as f64);
    if i == 0 {
        canvas.label_on(Side::Right, &text, [near_end, 0.8]);
    } else if i == n {
        canvas.label_on(Side::Left, &text, [1.0 - near_end, 0.8]);
    } else {
        canvas.label(&text, [maximum.place, maximum.value]);
    }
    Ok(())
}
