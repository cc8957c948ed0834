//! Figures of the section on the four-point scheme.

use super::corner_cutting::{Polygon, refined, remark_on_one_place};
use crate::affine::Point;
use crate::figure::{Axes, BoxError, Canvas, Figure, Place, PointStyle, Style, decimal};
use crate::scalar::{BigRational, OrderedScalar, Real, Scalar, exact};
use crate::subdivision::{
    ControlPolygon, LaurentPolynomial, LocalMatrix, Mask, MaskError, critical_tension,
    four_point_differences, laws,
};

const SIXTEENTH: f64 = 1.0 / 16.0;

/// A slider's number to four digits, as a fraction: exact numbers get longer with each step of a scheme.
pub(super) fn short_fraction(x: f64) -> BigRational {
    <BigRational as Scalar>::from_ratio(libm::round(x * 1e4) as i64, 10_000)
}

/// The vertices of a polygon, the first once more at the end if it is closed.
fn outline(polygon: &Polygon) -> Vec<Place> {
    let again = usize::from(polygon.is_closed());
    let points = polygon.vertices();
    points.iter().chain(&points[..again]).copied().collect()
}

/// Six points, refined as a closed polygon and as an open one with two kinds of ends.
#[must_use]
pub fn figure_four_point() -> Figure {
    const PANELS: [&str; 3] = ["closed", "two phantom points", "ends mirrored anew"];
    Figure::new(
        "subdivision-figure-four-point",
        "Six points, as a closed polygon and as an open one with either end rule",
        "Three panels with the same six points and the polygon after some steps of the four-point scheme, which looks smooth \
         and passes through all six points. In the first panel the polygon is closed. \
         In the second it is open, with two phantom points beyond each end, which are drawn and named. \
         In the third it is open, and before every step a phantom point is put beyond each end, the mirror image of the second point. \
         The new points of the first step are marked. Both open curves look the same.",
    )
    .rows(&[&PANELS[..1], &PANELS[1..]])
    .slider("w", 0.0..=0.25, SIXTEENTH)
    .stepper("steps", 1..=5, 4)
    .handles_in(
        PANELS[0],
        "p",
        [[0.0, 0.6], [0.3, 1.6], [2.2, 3.2], [3.9, 1.4], [5.3, 1.8], [5.5, 0.8]],
    )
    .draw(|values, canvas| {
        let (w, steps) = (values.number("w")?, values.count("steps")?);
        let points = values.points("p")?;
        let closed = ControlPolygon::closed(points.iter().copied())?;
        let open = ControlPolygon::open(points.iter().copied())?;
        let phantoms = open.with_mirrored_ends()?.with_mirrored_ends()?;
        let plain = |polygon: &Polygon| polygon.four_point(w);
        let mirrored = |polygon: &Polygon| polygon.with_mirrored_ends()?.four_point(w);
        // With two phantom points a side the points that stay begin with a phantom point.
        let inner = |polygon: Polygon| -> Vec<Place> {
            let points = polygon.vertices();
            points[2..points.len() - 2].to_vec()
        };
        let drawn = [
            (closed.clone(), outline(&refined(&closed, 1, plain)?), outline(&refined(&closed, steps, plain)?)),
            (open.clone(), inner(refined(&phantoms, 1, plain)?), inner(refined(&phantoms, steps, plain)?)),
            (open.clone(), outline(&refined(&open, 1, mirrored)?), outline(&refined(&open, steps, mirrored)?)),
        ];
        for (panel, (polygon, first, last)) in PANELS.into_iter().zip(drawn) {
            canvas.panel(panel);
            canvas.caption(panel);
            canvas.polyline("polygon", outline(&polygon), Style::ControlPolygon);
            canvas.polyline("refined", last, Style::Curve);
            canvas.points("new points", first.into_iter().skip(1).step_by(2), PointStyle::Level(1));
        }
        canvas.panel(PANELS[0]);
        canvas.labels("p", &points);
        canvas.panel(PANELS[1]);
        let named: Vec<(i64, Place)> = (-2..).zip(phantoms.vertices().iter().copied()).collect();
        let ends = [&named[..2], &named[named.len() - 2..]].concat();
        canvas.points("phantom points", ends.iter().map(|(_, at)| at), PointStyle::Guide);
        for (i, at) in ends {
            canvas.label(&format!("p_{{{i}}}"), at);
        }
        canvas.panel(PANELS[0]);
        canvas.law(
            "subdivision-four-point-scheme",
            &laws::four_point_scheme(ControlPolygon::four_point, &closed, w),
        );
        if w == 0.0 {
            canvas.remark("w = 0: each new point is the middle of its leg. The polygon stays as it is, with its corners.");
        }
        remark_on_one_place(canvas, &points);
        Ok(())
    })
}

/// The numbers that are 1 at 0 and 0 elsewhere, after some steps, from the parameter −3 to 3.
fn basic_limit_values(w: f64, steps: usize) -> Result<Vec<[f64; 2]>, BoxError> {
    let values = (-6..=6).map(|i| f64::from(u8::from(i == 0)));
    let mut polygon = ControlPolygon::open(values)?;
    for _ in 0..steps {
        polygon = polygon.four_point(w)?;
    }
    // Of the indices −6 … 6 the outer ones are lost by and by; the limit is 0 outside of −3 … 3.
    let parts = libm::exp2(steps as f64);
    let middle = (polygon.vertices().len() - 1) as f64 / 2.0;
    let places = polygon.vertices().iter().enumerate();
    let graph = places.map(|(i, &value)| [(i as f64 - middle) / parts, value]);
    Ok(graph
        .filter(|[t, _]| OrderedScalar::abs(t) <= 3.0)
        .collect())
}

/// The basic limit function with its derivative, and the second differences at 0 that grow without bound.
#[must_use]
pub fn four_point_convergence() -> Figure {
    const PANELS: [&str; 2] = ["limit", "second differences"];
    Figure::new(
        "subdivision-four-point-convergence",
        "The limit of one point 1 among zeros",
        "Above, the limit function of the data that are 1 at 0 and 0 at all other whole numbers, together with its derivative. \
         The function has the value 1 at 0, waves of decreasing size on both sides, and is 0 beyond −3 and 3. \
         The derivative is continuous and has fine ripples. \
         Below, 4ᵏ times the second difference at 0 after k steps: the values lie on a falling line and tend to minus infinity.",
    )
    .rows(&[&PANELS[..1], &PANELS[1..]])
    .stepper("steps", 1..=6, 6)
    .draw(|values, canvas| {
        let steps = values.count("steps")?;
        let graph = basic_limit_values(SIXTEENTH, steps)?;
        let slope = |pair: &[[f64; 2]]| {
            let [[s, a], [t, b]] = [pair[0], pair[1]];
            [(s + t) / 2.0, (b - a) / (t - s)]
        };
        let slopes: Vec<[f64; 2]> = graph.windows(2).map(slope).collect();
        canvas.panel(PANELS[0]);
        canvas.axes(Axes::new("t", "f"));
        canvas.polyline("limit", graph, Style::Curve);
        canvas.polyline("derivative", slopes, Style::SecondCurve);
        canvas.legend("limit $f$", Style::Curve);
        canvas.legend("derivative $f'$", Style::SecondCurve);
        canvas.panel(PANELS[1]);
        canvas.axes(Axes::new("steps k", "4^k \\Delta^2").whole());
        let mut scaled = vec![];
        for k in 0..=6 {
            let graph = basic_limit_values(SIXTEENTH, k)?;
            let middle = graph.len() / 2;
            let second = graph[middle + 1][1] - 2.0 * graph[middle][1] + graph[middle - 1][1];
            scaled.push([k as f64, second * libm::exp2(2.0 * k as f64)]);
        }
        canvas.segment("line", [0.0, -2.0], [6.0, -11.0], Style::Guide);
        canvas.points("second differences", scaled, PointStyle::Result);
        canvas.legend("$-2-3k/2$", Style::Guide);
        // The data of the picture, and any cubic beside them.
        canvas.law(
            "subdivision-four-point-convergence",
            &laws::four_point_convergence(
                ControlPolygon::four_point,
                &[1.0, -2.0, 0.5, 0.25],
                steps as u32,
            ),
        );
        Ok(())
    })
}

/// Norms against the tension with the two bounds, and the curve for the chosen tension.
#[must_use]
pub fn four_point_tension() -> Figure {
    const PANELS: [&str; 2] = ["norms", "curve"];
    const STEPS: [usize; 4] = [1, 2, 4, 8];
    Figure::new(
        "subdivision-four-point-tension",
        "For which tensions the norms prove C¹",
        "Above, the norms of 1, 2, 4 and 8 steps of the difference scheme against the tension w from 0 to 0.25. \
         The norm of two steps crosses the line of height 1 at w = 0.1545; that of four steps farther to the right, that of eight \
         farther still, but none beyond w = 0.1927, where a vertical line stands. \
         Below, a closed polygon of six points and its refinement for the tension that is chosen, \
         together with that for w = 1/16.",
    )
    .rows(&[&PANELS[..1], &PANELS[1..]])
    .slider("w", 0.0..=0.25, 0.17)
    .handles_in(
        PANELS[1],
        "p",
        [[0.0, 0.0], [0.4, 2.4], [2.2, 1.4], [4.0, 3.0], [4.6, 0.6], [2.6, -0.4]],
    )
    .draw(|values, canvas| {
        let w = values.number("w")?;
        canvas.panel(PANELS[0]);
        canvas.axes(Axes::new("w", "norm"));
        canvas.window([0.0, 0.0], [0.25, 2.0]);
        let norm = |w: f64, steps: usize| {
            four_point_differences(w).map(|scheme| scheme.norm(steps))
        };
        for (series, steps) in STEPS.into_iter().enumerate() {
            // 40 chords for functions that are piecewise polynomial with a few pieces.
            let samples = (0..=40).map(|i| f64::from(i) / 160.0);
            let graph = samples.map(|w| Ok([w, norm(w, steps)?]));
            let graph: Vec<[f64; 2]> = graph.collect::<Result<_, MaskError>>()?;
            canvas.polyline(&format!("L = {steps}"), graph, Style::Series(series));
            canvas.legend(&format!("$L = {steps}$"), Style::Series(series));
        }
        canvas.segment("one", [0.0, 1.0], [0.25, 1.0], Style::Guide);
        let two_steps = (Real::sqrt(5.0) - 1.0) / 8.0;
        let root = critical_tension(BigRational::from_ratio(1, 1 << 20));
        let limit = root.isolated().first().map_or(f64::NAN, |root| root.parameter().to_f64());
        for (name, place) in [("two steps", two_steps), ("limit", limit)] {
            canvas.segment(name, [place, 0.0], [place, 2.0], Style::Guide);
            canvas.label(&decimal(place, 4), [place, 0.2]);
        }
        canvas.point("chosen", [w, norm(w, 8)?], PointStyle::Result);
        canvas.panel(PANELS[1]);
        canvas.caption(&format!("w = {}", decimal(w, 3)));
        let polygon = ControlPolygon::closed(values.points("p")?)?;
        canvas.polyline("polygon", outline(&polygon), Style::ControlPolygon);
        let step = |w: f64| move |polygon: &Polygon| polygon.four_point(w);
        let usual = refined(&polygon, 5, step(SIXTEENTH))?;
        canvas.legend("$w$ as chosen", Style::Curve);
        canvas.legend("$w = 1/16$", Style::SecondCurve);
        canvas.polyline("w = 1/16", outline(&usual), Style::SecondCurve);
        canvas.polyline("chosen curve", outline(&refined(&polygon, 5, step(w))?), Style::Curve);
        canvas.labels("p", polygon.vertices());
        if w > 0.0 {
            let exactly = exact(w).ok_or("a finite tension")?;
            canvas.law(
                "subdivision-four-point-tension",
                &laws::four_point_tension(|w| Mask::four_point(w).ok(), &exactly),
            );
            if w > limit {
                canvas.remark("w is beyond the second vertical line: no number of steps has a norm below 1, and the limit is not C¹.");
            }
        } else {
            canvas.remark("w = 0: each new point is the middle of its leg. The norms are 1, and the limit is the polygon with its corners.");
        }
        Ok(())
    })
}

/// The norms for the orders 0, 1 and 2 against the number of steps.
#[must_use]
pub fn four_point_analysis() -> Figure {
    Figure::new(
        "subdivision-four-point-analysis",
        "Norms of the difference schemes of the four-point scheme",
        "On a logarithmic scale against the number of steps from 1 to 8: the norms of the difference schemes for C⁰, C¹ and C². \
         The first falls from 5/8 on in a straight line. The second begins at 1 and then falls. The third stays at 1.",
    )
    .slider("w", 0.01..=0.2, SIXTEENTH)
    .draw(|values, canvas| {
        canvas.axes(Axes::new("steps L", "norm").logarithmic().whole());
        // Whether a factor 1 + z can be divided off is decided by exact numbers.
        let w = short_fraction(values.number("w")?);
        let mask = Mask::four_point(w)?;
        for order in 0..=2 {
            // For C² two more factors 1 + z are needed, which only w = 1/16 has.
            let scheme = mask.divided_difference_scheme(order).and_then(|scheme| scheme.difference_scheme());
            let Some(scheme) = scheme else { continue };
            let norms: Vec<[f64; 2]> = (1..=8).map(|steps| [steps as f64, scheme.norm(steps).to_f64()]).collect();
            canvas.polyline(&format!("order {order}"), norms, Style::Series(order));
            canvas.legend(&format!("$C^{order}$"), Style::Series(order));
        }
        canvas.segment("one", [1.0, 1.0], [8.0, 1.0], Style::Guide);
        // The law is about w = 1/16, and about any data: here the number 1 among zeros.
        canvas.law(
            "subdivision-four-point-analysis",
            &laws::four_point_analysis(Mask::norm, LocalMatrix::of, &LaurentPolynomial::one()),
        );
        if values.number("w")? != SIXTEENTH {
            canvas.remark(
                "w is not 1/16: the symbol has two factors 1 + z and no more, so that there is no scheme for the second differences. \
                 What is said of norms and eigenvalues below is about w = 1/16.",
            );
        }
        Ok(())
    })
}

/// Points on a line stay there, points on a circle do not.
#[must_use]
pub fn figure_precision() -> Figure {
    const PANELS: [&str; 3] = ["line", "circle", "deviation"];
    Figure::new(
        "subdivision-figure-precision",
        "Points on a line stay on the line, points on a circle leave the circle",
        "Three panels. In the first, points on a line and their refinement by the four-point scheme, which stays on the line. \
         In the second, the corners of a regular polygon on a circle and their refinement, a closed curve that runs inside of the circle \
         between the corners. In the third, the deviation along the curves: that from the line is 0 everywhere, that from the circle is 0 \
         at the corners and largest between them.",
    )
    .rows(&[&PANELS[..2], &PANELS[2..]])
    .handles_in(PANELS[0], "a", [[0.0, 0.2], [4.0, 2.6]])
    .stepper("corners", 3..=12, 4)
    .draw(|values, canvas| {
        let ends = values.points("a")?;
        let [start, end] = [ends[0], ends[1]];
        let places = [0.0, 0.15, 0.5, 0.6, 0.85, 1.0];
        let on_line = places.map(|s| start + (end - start) * s);
        let line = ControlPolygon::open(on_line)?;
        let refined_line = refined(&line, 5, |polygon| {
            polygon.with_mirrored_ends()?.four_point(SIXTEENTH)
        })?;
        let corners = values.count("corners")?;
        let corner = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / corners as f64;
            Point::new([Real::cos(angle), Real::sin(angle)])
        };
        let circle = ControlPolygon::closed((0..corners).map(corner))?;
        let refined_circle = refined(&circle, 5, |polygon| polygon.four_point(SIXTEENTH))?;
        let draw = |canvas: &mut Canvas, polygon: &Polygon, curve: &Polygon| {
            canvas.points("points", polygon.vertices(), PointStyle::Control);
            canvas.polyline("refined", outline(curve), Style::Curve);
        };
        canvas.panel(PANELS[0]);
        canvas.caption("collinear points");
        draw(canvas, &line, &refined_line);
        canvas.panel(PANELS[1]);
        canvas.caption("points of the circle");
        canvas.circle("circle", [0.0, 0.0], 1.0, Style::Guide);
        draw(canvas, &circle, &refined_circle);
        canvas.panel(PANELS[2]);
        canvas.axes(Axes::new("fraction of the parameters", "deviation"));
        canvas.free_aspect(0.4);
        let direction = end - start;
        let length = Real::sqrt(direction.dot(&direction));
        let from_line = |p: &Place| {
            let v = *p - start;
            // Both ends at one place make no line; the distance is then that from the point.
            if length == 0.0 {
                Real::sqrt(v.dot(&v))
            } else {
                OrderedScalar::abs(&((direction[0] * v[1] - direction[1] * v[0]) / length))
            }
        };
        let from_circle = |p: &Place| {
            let v = p.from_origin();
            1.0 - Real::sqrt(v.dot(&v))
        };
        let along = |points: Vec<Place>, deviation: &dyn Fn(&Place) -> f64| -> Vec<[f64; 2]> {
            let last = (points.len() - 1).max(1) as f64;
            let graph = points.iter().enumerate();
            graph.map(|(i, p)| [i as f64 / last, deviation(p)]).collect()
        };
        canvas.polyline("from the circle", along(outline(&refined_circle), &from_circle), Style::Curve);
        canvas.polyline("from the line", along(outline(&refined_line), &from_line), Style::SecondCurve);
        canvas.legend("from the circle", Style::Curve);
        canvas.legend("from the line", Style::SecondCurve);
        canvas.panel(PANELS[0]);
        canvas.law(
            "subdivision-linear-precision",
            &laws::linear_precision(
                |mask, points| mask.refine_closed(points).ok(),
                |mask, numbers| mask.refine_closed(numbers).ok(),
                &Mask::four_point(SIXTEENTH)?,
                &[start, end],
                &places,
            ),
        );
        if start == end {
            canvas.remark("Both ends are in one place, which is no line: all points are there, and stay there.");
        }
        Ok(())
    })
}
