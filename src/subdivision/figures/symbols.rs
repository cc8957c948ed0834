//! Figures of the section on masks and symbols.

use super::four_point::short_fraction;
use crate::figure::{Axes, Figure, PointStyle, Style};
use crate::scalar::{BigRational, OrderedScalar, Scalar};
use crate::subdivision::{LaurentPolynomial, Mask, MaskError, laws};

pub(super) fn all() -> Vec<Figure> {
    vec![difference_scheme()]
}

/// The mask with its indices shifted so that they lie around 0.
fn centred<T: Scalar>(mask: &Mask<T>) -> Result<Mask<T>, MaskError> {
    let support = mask.support();
    let middle = (support.start + support.end - 1).div_euclid(2);
    Mask::from_symbol(mask.symbol().shifted(-middle))
}

/// The mask with rounded coefficients.
fn rounded(mask: &Mask<BigRational>) -> Result<Mask<f64>, MaskError> {
    let coefficients = mask.symbol().coefficients().iter();
    Mask::new(
        mask.support().start,
        coefficients.map(OrderedScalar::to_f64),
    )
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
         Above each row of points a line shows the bound from the norms of the difference scheme; \
         the bounds of Chaikin's scheme and of the cubic one are equal, so that one line is for both. \
         All fall by a constant factor a step, so that the polygons converge.",
    )
    .slider("w", 0.01..=0.2, 0.0625)
    .draw(|values, canvas| {
        canvas.axes(Axes::new("steps k", "distance").logarithmic().whole());
        // Whether a factor 1 + z can be divided off is decided by exact numbers.
        let w = short_fraction(values.number("w")?);
        let schemes = [
            ("Chaikin", Mask::lane_riesenfeld(2)),
            ("cubic", Mask::lane_riesenfeld(3)),
            ("four-point", Mask::four_point(w)?),
        ];
        let midpoints = centred(&Mask::lane_riesenfeld(1))?;
        // A hyphen in a label would become a minus sign.
        let shown = |name: &str| name.replace('-', " ");
        // Schemes with the same bound share a line.
        let mut bounds: Vec<(String, Vec<[f64; 2]>)> = vec![];
        for (level, (name, mask)) in (1..).zip(&schemes) {
            let mask = centred(mask)?;
            let differences = mask.difference_scheme().ok_or("a factor 1 + z")?;
            let displacement = mask.displacement().ok_or("rules of sum 1")?.norm(2).to_f64();
            let mask = rounded(&mask)?;
            let mut data = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            let (mut moved, mut bound) = (vec![], vec![]);
            for k in 0..=STEPS {
                let refined = mask.refine_closed(&data)?;
                let polygon = midpoints.refine_closed(&data)?;
                let moves = refined.iter().zip(&polygon).map(|(a, b)| OrderedScalar::abs(&(a - b)));
                moved.push([k as f64, moves.fold(0.0, f64::max)]);
                // The largest difference of the data is 1.
                bound.push([k as f64, displacement * differences.norm(k).to_f64()]);
                data = refined;
            }
            canvas.points(name, moved, PointStyle::Level(level));
            canvas.legend_point(&shown(name), PointStyle::Level(level));
            match bounds.iter_mut().find(|(_, known)| *known == bound) {
                Some((names, _)) => *names = format!("{names} and {name}"),
                None => bounds.push((format!("bound: {name}"), bound)),
            }
        }
        for (series, (names, bound)) in bounds.into_iter().enumerate() {
            canvas.polyline(&names, bound, Style::Series(series));
            canvas.legend(&shown(&names), Style::Series(series));
        }
        let [.., (_, four_point)] = &schemes;
        canvas.law(
            "subdivision-difference-scheme",
            &laws::difference_scheme(
                Mask::difference_scheme,
                Mask::norm,
                four_point,
                &LaurentPolynomial::one(),
                2,
            ),
        );
        Ok(())
    })
}
