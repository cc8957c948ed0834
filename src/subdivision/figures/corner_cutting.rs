//! Figures of the section on corner cutting.

use crate::affine::{Affine, Point};
use crate::bezier::bounds::euclidean_norm;
use crate::bspline::UniformSpline;
use crate::figure::{Axes, BoxError, Canvas, Figure, Place, PointStyle, Style};
use crate::subdivision::{ControlPolygon, ControlPolygonError, SchemeKind, laws};

pub(super) fn all() -> Vec<Figure> {
    vec![
        approximating_interpolating(),
        figure_chaikin(),
        chaikin_convergence(),
        figure_lane_riesenfeld(),
    ]
}

/// A polygon in the plane.
pub(super) type Polygon = ControlPolygon<Place>;

/// Draws a polygon, closed or open.
pub(super) fn draw_polygon(canvas: &mut Canvas, name: &str, polygon: &Polygon, style: Style) {
    if polygon.is_closed() {
        canvas.polygon(name, polygon.vertices(), style);
    } else {
        canvas.polyline(name, polygon.vertices(), style);
    }
}

/// Draws a spline over its whole domain.
pub(super) fn draw_spline(canvas: &mut Canvas, name: &str, spline: &UniformSpline<Place>) {
    let domain = spline.domain();
    // A sample can be rounded to a parameter just outside of the domain.
    let at = |u: f64| {
        let inside = u.clamp(domain.start(), domain.end());
        spline.at(inside).unwrap_or(spline.control_points()[0])
    };
    canvas.curve(name, domain.start()..=domain.end(), at, Style::Curve);
}

/// A step as the laws want it: what cannot be refined stays, and the law is violated.
pub(super) fn stepped<P: Affine>(
    step: impl Fn(&ControlPolygon<P>) -> Result<ControlPolygon<P>, ControlPolygonError>,
) -> impl Fn(&ControlPolygon<P>) -> ControlPolygon<P> {
    move |polygon| step(polygon).unwrap_or_else(|_| polygon.clone())
}

/// Says so where all vertices of the polygon are in one place.
pub(super) fn remark_on_one_place(canvas: &mut Canvas, points: &[Place]) {
    if points.windows(2).all(|leg| leg[0] == leg[1]) {
        canvas.remark(
            "All points are in one place. The weights of every rule sum to 1, so all new points are in this place, too.",
        );
    }
}

/// The polygon after some steps.
pub(super) fn refined(
    polygon: &Polygon,
    steps: usize,
    step: impl Fn(&Polygon) -> Result<Polygon, ControlPolygonError>,
) -> Result<Polygon, ControlPolygonError> {
    (0..steps).try_fold(polygon.clone(), |polygon, _| step(&polygon))
}

/// One polygon refined by Chaikin's algorithm and by the four-point scheme.
#[must_use]
pub fn approximating_interpolating() -> Figure {
    const PANELS: [&str; 2] = ["approximating", "interpolating"];
    Figure::new(
        "subdivision-approximating-interpolating",
        "One polygon, an approximating and an interpolating scheme",
        "The same closed polygon with six vertices twice. \
         On the left it is refined by Chaikin's algorithm: the refined polygon runs inside and touches the middles of the legs. \
         On the right it is refined by the four-point scheme: the refined polygon passes through all six vertices and swings out between them.",
    )
    .rows(&[&PANELS])
    .handles_in(
        PANELS[0],
        "p",
        [[0.0, 0.6], [2.6, 0.0], [3.0, 1.8], [5.0, 2.2], [3.4, 4.2], [0.6, 3.6]],
    )
    .stepper("k", 0..=6, 3)
    .draw(|values, canvas| {
        let given = ControlPolygon::closed(values.points("p")?)?;
        let steps = values.count("k")?;
        let refined = [
            refined(&given, steps, ControlPolygon::chaikin)?,
            refined(&given, steps, |polygon| polygon.four_point(0.0625))?,
        ];
        for (panel, refined) in std::iter::zip(PANELS, refined) {
            canvas.panel(panel);
            canvas.caption(panel);
            draw_polygon(canvas, "refined", &refined, Style::Curve);
            draw_polygon(canvas, "polygon", &given, Style::Guide);
            canvas.points("vertices", given.vertices(), PointStyle::Control);
        }
        let across = ControlPolygon::closed(given.vertices().iter().map(|p| p[0]))?;
        let kinds = [SchemeKind::Approximating, SchemeKind::Interpolating { first: 0 }];
        for (panel, kind) in std::iter::zip(PANELS, kinds) {
            canvas.panel(panel);
            let step = stepped(|polygon: &ControlPolygon<f64>| match kind {
                SchemeKind::Approximating => polygon.chaikin(),
                SchemeKind::Interpolating { .. } => polygon.four_point(0.0625),
            });
            canvas.law(
                "subdivision-approximating-interpolating",
                &laws::approximating_interpolating(step, kind, &across, [2.0, 1.0]),
            );
        }
        remark_on_one_place(canvas, given.vertices());
        Ok(())
    })
}

/// Steps 1, 2 and 3 of Chaikin's algorithm, and the limit with a step of the reader's choice.
#[must_use]
pub fn figure_chaikin() -> Figure {
    const PANELS: [&str; 4] = ["k = 1", "k = 2", "k = 3", "limit"];
    Figure::new(
        "subdivision-figure-chaikin",
        "Each step cuts the corners, and the middles of the legs stay",
        "Four panels with the same open polygon of five vertices. \
         The first three show the polygon after one, two and three steps: in each step every corner is replaced by a shorter edge. \
         The last panel shows the limit curve, which runs from the middle of the first leg to the middle of the last, \
         and the polygon after a chosen number of steps.",
    )
    .rows(&[&PANELS[..2], &PANELS[2..]])
    .handles_in(
        PANELS[0],
        "p",
        [[0.0, 0.0], [0.8, 3.4], [4.2, 4.0], [4.6, 0.4], [7.4, 1.6]],
    )
    .stepper("k", 0..=6, 1)
    .draw(|values, canvas| {
        let given = ControlPolygon::open(values.points("p")?)?;
        let spline = given.spline(2)?;
        for (steps, panel) in (1..).zip(PANELS) {
            canvas.panel(panel);
            draw_polygon(canvas, "polygon", &given, Style::ControlPolygon);
            if panel == "limit" {
                draw_spline(canvas, "limit", &spline);
                let steps = values.count("k")?;
                canvas.caption(&format!("limit, and $k = {steps}$"));
                let cut = refined(&given, steps, ControlPolygon::chaikin)?;
                canvas.polyline("refined", cut.vertices(), Style::SecondPolygon);
            } else {
                canvas.caption(&format!("$k = {steps}$"));
                let cut = refined(&given, steps, ControlPolygon::chaikin)?;
                canvas.polyline("refined", cut.vertices(), Style::SecondPolygon);
            }
            if steps == 1 {
                canvas.labels("p", given.vertices());
            }
        }
        canvas.panel(PANELS[0]);
        let step = stepped(ControlPolygon::chaikin);
        canvas.law("subdivision-chaikin", &laws::chaikin(step, &given));
        remark_on_one_place(canvas, given.vertices());
        Ok(())
    })
}

/// How many steps are measured.
const STEPS: usize = 6;

/// The distance of the polygon and the quadratic spline after k steps, beside the formula.
#[must_use]
pub fn chaikin_convergence() -> Figure {
    Figure::new(
        "subdivision-chaikin-convergence",
        "The distance of polygon and spline is divided by four in each step",
        "Two panels. The first shows a closed polygon with its quadratic spline. \
         The second shows, on a logarithmic scale against the step k from 0 to 6, \
         the largest distance of the polygon of step k from the spline, measured at many parameters; \
         the points lie on the dashed straight line of the formula, which falls by the factor 4 in each step.",
    )
    .rows(&[&["curve", "distance"]])
    .handles_in(
        "curve",
        "p",
        [[0.0, 0.0], [4.0, 0.6], [5.2, 3.6], [2.6, 2.4], [0.4, 4.4]],
    )
    .draw(|values, canvas| {
        let given = ControlPolygon::closed(values.points("p")?)?;
        let spline = given.spline(2)?;
        canvas.panel("curve");
        draw_spline(canvas, "spline", &spline);
        draw_polygon(canvas, "polygon", &given, Style::Guide);
        canvas.points("vertices", given.vertices(), PointStyle::Control);
        canvas.labels("p", given.vertices());

        canvas.panel("distance");
        canvas.free_aspect(1.0);
        canvas.axes(Axes::new("k", "distance").logarithmic().whole());
        // A logarithm needs positive numbers; with all vertices in one place the distance is 0.
        let positive = |distance: f64| distance.max(1e-9);
        let largest = (0..given.vertices().len() as i64)
            .filter_map(|i| {
                let [before, here, after] = [i - 1, i, i + 1].map(|i| given.vertex(i));
                Some((*after? - *here?) - (*here? - *before?))
            })
            .map(|difference| euclidean_norm(&difference))
            .fold(0.0, f64::max);
        let formula = (0..=STEPS).map(|k| {
            let quartered = largest / 8.0 / 4f64.powi(k as i32);
            Point::new([k as f64, positive(quartered)])
        });
        canvas.polyline("formula", formula, Style::Guide);
        let measured = (0..=STEPS).map(|k| {
            let cut = refined(&given, k, ControlPolygon::chaikin)?;
            let distance = distance_of(&cut, &spline);
            Ok(Point::new([k as f64, positive(distance)]))
        });
        let measured = measured.collect::<Result<Vec<_>, BoxError>>()?;
        canvas.points("measured", measured, PointStyle::Result);
        canvas.legend_point("measured", PointStyle::Result);
        canvas.legend("the formula", Style::Guide);
        canvas.law(
            "subdivision-chaikin-convergence",
            &laws::chaikin_convergence(stepped(ControlPolygon::chaikin), &given, STEPS),
        );
        remark_on_one_place(canvas, given.vertices());
        Ok(())
    })
}

/// The largest distance of the spline from the point of the closed polygon with the same parameter.
///
/// Vertex j belongs to the place j − 1/2 of the domain, in units of a leg; eight places a leg are tried.
fn distance_of(polygon: &Polygon, spline: &UniformSpline<Place>) -> f64 {
    let domain = spline.domain();
    let legs = polygon.legs().count() as f64;
    polygon
        .legs()
        .enumerate()
        .flat_map(|(j, (start, end))| {
            (0..=8).map(move |eighths| {
                let lambda = f64::from(eighths) / 8.0;
                let place = (j as f64 - 0.5 + lambda).rem_euclid(legs);
                (place, *start + (*end - *start) * lambda)
            })
        })
        .filter_map(|(place, point)| {
            let on_spline = spline.at(domain.start() + place / legs * domain.length());
            Some(euclidean_norm(&(on_spline.ok()? - point)))
        })
        .fold(0.0, f64::max)
}

/// The averaging rounds of one step for five points, and the limit.
#[must_use]
pub fn figure_lane_riesenfeld() -> Figure {
    const PANELS: [&str; 4] = ["round 1", "round 2", "round 3", "limit"];
    Figure::new(
        "subdivision-figure-lane-riesenfeld",
        "The rounds of averaging in one step, and the spline in the limit",
        "Four panels with the same five points. All points are doubled; \
         the first three panels show the polygon after the first, second and third round of averaging: \
         round markers on vertices and middles of legs, then on the quarters of the legs, then one point in the middle of each leg and one beside each inner vertex. \
         The last panel shows the polygon after all n rounds, with the limit curve, a spline of degree n.",
    )
    .rows(&[&PANELS[..2], &PANELS[2..]])
    .handles_in(
        PANELS[0],
        "p",
        [[0.0, 0.0], [1.0, 3.2], [4.0, 4.0], [5.4, 0.6], [8.0, 2.4]],
    )
    .stepper("n", 1..=4, 3)
    .draw(|values, canvas| {
        let given = ControlPolygon::open(values.points("p")?)?;
        let n = values.count("n")?;
        let rounds = given.averaging_rounds(n)?;
        for (round, panel) in (1..).zip(PANELS) {
            canvas.panel(panel);
            draw_polygon(canvas, "polygon", &given, Style::ControlPolygon);
            if panel == "limit" {
                canvas.caption(&format!("$n = {n}$: result and limit"));
                draw_spline(canvas, "limit", &given.spline(n)?);
                canvas.polyline("result", rounds[n].vertices(), Style::SecondPolygon);
            } else if let Some(averaged) = rounds.get(round) {
                canvas.caption(&format!("round {round} of {n}"));
                canvas.polyline("averaged", averaged.vertices(), Style::Level(round));
            } else {
                canvas.caption(&format!("no round {round} for $n = {n}$"));
            }
            if round == 1 {
                canvas.labels("p", given.vertices());
            }
        }
        canvas.panel(PANELS[3]);
        let step = |polygon: &Polygon, n| stepped(|p: &Polygon| p.lane_riesenfeld(n))(polygon);
        canvas.law("subdivision-lane-riesenfeld", &laws::lane_riesenfeld(step, &given, n));
        remark_on_one_place(canvas, given.vertices());
        Ok(())
    })
}
