//! Figures of the section on masks and symbols.

use crate::figure::{Axes, Figure, PointStyle, Style};
use crate::scalar::OrderedScalar;
use crate::subdivision::{Mask, MaskError};

pub(super) fn all() -> Vec<Figure> {
    vec![difference_scheme()]
}

/// The mask with its indices shifted so that they lie around 0.
fn centred(mask: &Mask<f64>) -> Result<Mask<f64>, MaskError> {
    let support = mask.support();
    let middle = (support.start + support.end - 1).div_euclid(2);
    Mask::from_symbol(mask.symbol().shifted(-middle))
}

/// How far three schemes move the polygon from step to step, and the bound for it.
#[must_use]
pub fn difference_scheme() -> Figure {
    const STEPS: usize = 7;
    Figure::new(
        "subdivision-difference-scheme",
        "How far the polygons move",
        "Against the number of steps, on a logarithmic scale: the largest distance between the polygon before and after a step, \
         for Chaikin's scheme, the cubic scheme and the four-point scheme, which refine the number 1 among zeros. \
         Above each row of points a line shows the bound from the norms of the difference scheme. \
         All fall by a constant factor a step, so that the polygons converge.",
    )
    .slider("w", 0.01..=0.2, 0.0625)
    .draw(|values, canvas| {
        canvas.axes(Axes::new("steps k", "distance").logarithmic().whole());
        let schemes = [
            ("Chaikin", Mask::lane_riesenfeld(2)),
            ("cubic", Mask::lane_riesenfeld(3)),
            ("four-point", Mask::four_point(values.number("w")?)?),
        ];
        for (series, (name, mask)) in schemes.iter().enumerate() {
            let mask = centred(mask)?;
            let midpoints = centred(&Mask::lane_riesenfeld(1))?;
            // The rules sum to 1, so these two exist; no bound is drawn if rounding says otherwise.
            let bounds = mask.difference_scheme().zip(mask.displacement());
            let mut data = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            let (mut moved, mut bound) = (vec![], vec![]);
            for k in 0..=STEPS {
                let refined = mask.refine_closed(&data)?;
                let polygon = midpoints.refine_closed(&data)?;
                let distances = refined.iter().zip(&polygon).map(|(a, b)| OrderedScalar::abs(&(a - b)));
                moved.push([k as f64, distances.fold(0.0, f64::max)]);
                if let Some((differences, displacement)) = &bounds {
                    // The largest difference of the data is 1.
                    bound.push([k as f64, displacement.norm(2) * differences.norm(k)]);
                }
                data = refined;
            }
            canvas.points(name, moved, PointStyle::Level(series + 1));
            if !bound.is_empty() {
                canvas.polyline(&format!("bound: {name}"), bound, Style::Series(series));
            }
            canvas.legend_point(name, PointStyle::Level(series + 1));
            canvas.legend(&format!("bound: {name}"), Style::Series(series));
        }
        Ok(())
    })
}
