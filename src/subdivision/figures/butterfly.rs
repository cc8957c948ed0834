//! Figures of the section on the modified Butterfly scheme.

use super::loop_scheme::{KNOB, mean, painted, spoke};
use crate::figure::{Figure, Place, PointStyle, Style, View, decimal};
use crate::subdivision::{
    Butterfly, Fan, FanNet, SurfaceScheme, butterfly_centre_weight, butterfly_star_weights,
    butterfly_weights, laws, solids,
};

pub(super) fn all() -> Vec<Figure> {
    vec![
        figure_butterfly(),
        figure_butterfly_special(),
        figure_butterfly_result(),
    ]
}

/// The eight points of the regular stencil in the plane: the ends, the opposite vertices, the wings.
fn eight_points() -> [Place; 8] {
    let h = libm::sqrt(3.0) / 2.0;
    [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.5, h],
        [0.5, -h],
        [-0.5, h],
        [1.5, h],
        [-0.5, -h],
        [1.5, -h],
    ]
    .map(Place::new)
}

/// The eight-point stencil with its weights.
#[must_use]
pub fn figure_butterfly() -> Figure {
    Figure::new(
        "subdivision-figure-butterfly",
        "The eight-point stencil of the Butterfly scheme",
        "An edge with the two triangles beside it and the four triangles beside these, in the shape of a butterfly. \
         The ends of the edge carry the weight one half, the vertices opposite to it one eighth, \
         and the four vertices at the tips of the wings minus one sixteenth. The new point is the middle of the edge.",
    )
    .draw(|_, canvas| {
        let places = eight_points();
        let triangles = [[0, 1, 2], [1, 0, 3], [0, 2, 4], [1, 5, 2], [0, 6, 3], [1, 3, 7]];
        for triangle in triangles {
            let name = format!("triangle {triangle:?}");
            let around = triangle.into_iter().chain([triangle[0]]);
            canvas.polyline(&name, around.map(|i: usize| places[i]), Style::Connector);
        }
        let [end, opposite, wing] = butterfly_weights::<f64>();
        let weights = [end, end, opposite, opposite, wing, wing, wing, wing];
        let terms = [0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| (weights[i], places[i]));
        let labels = terms.map(|(weight, place)| {
            let denominator = (1.0 / weight.abs()) as u32;
            let sign = if weight < 0.0 { "-" } else { "" };
            (place, format!("{sign}1/{denominator}"))
        });
        canvas.stencil("new point", labels, mean(&terms)?);
        Ok(())
    })
}

/// The star of a vertex of valence k with its weights.
#[must_use]
pub fn figure_butterfly_special() -> Figure {
    Figure::new(
        "subdivision-figure-butterfly-special",
        "The stencil at a vertex of valence k",
        "A vertex with k neighbours on a circle around it. The vertex carries the weight three quarters, \
         the neighbours carry the weights s zero, s one and so on, counted from the neighbour on the right. \
         The new point on the edge to this neighbour is marked near the middle of that edge.",
    )
    .stepper("k", 3..=9, 5)
    .draw(|values, canvas| {
        let k = values.count("k")?;
        let centre = Place::origin();
        let ring: Vec<Place> = (0..k).map(|j| spoke(j, k)).collect();
        for (j, &place) in ring.iter().enumerate() {
            canvas.segment(&format!("spoke {j}"), centre, place, Style::Connector);
        }
        canvas.polyline("ring", ring.iter().chain(ring.first()), Style::Connector);
        let star = butterfly_star_weights::<f64>(k)?;
        let terms: Vec<_> = std::iter::once((butterfly_centre_weight(), centre))
            .chain(star.into_iter().zip(ring))
            .collect();
        let labels = terms.iter().enumerate().map(|(i, (weight, place))| {
            let weight = decimal(*weight, 4);
            let text = match i.checked_sub(1) {
                None => weight,
                Some(j) => format!("s_{j} = {weight}"),
            };
            (*place, text)
        });
        let labels: Vec<_> = labels.collect();
        canvas.stencil("new point", labels, mean(&terms)?);
        canvas.caption(&format!("$k = {k}$"));
        let fan = Fan::new(FanNet::Triangles, 6, 2)?;
        let regular = |data: &[f64]| {
            let refined = fan.refine(&Butterfly::MODIFIED, data);
            refined.unwrap_or_default()
        };
        canvas.law(
            "subdivision-modified-butterfly-properties",
            &laws::modified_butterfly_properties(butterfly_star_weights, regular, k),
        );
        Ok(())
    })
}

/// The icosahedron and its interpolating refinement.
#[must_use]
pub fn figure_butterfly_result() -> Figure {
    Figure::new(
        "subdivision-figure-butterfly-result",
        "The icosahedron after some steps of the modified Butterfly scheme",
        "A rounded body that was an icosahedron; the twelve vertices of the icosahedron are marked where they look towards us, \
         and lie on the body, because the scheme does not move old vertices.",
    )
    .stepper("steps", 0..=4, 3)
    .handle("view", View::degrees(25.0, 25.0).knob(KNOB))
    .draw(|values, canvas| {
        let view = View::of_knob(values.point("view")?, KNOB);
        let icosahedron = solids::icosahedron::<f64>();
        let mesh = Butterfly::MODIFIED.refine_times(&icosahedron, values.count("steps")?)?;
        canvas.surface("surface", &view, &painted(&mesh).closed());
        // The body looks like a ball around the origin: the vertices in front of it are seen.
        let seen = icosahedron.points().iter().filter(|p| view.seen(p)[2] > 0.0);
        let places: Vec<Place> = seen.map(|p| view.place(p)).collect();
        canvas.points("vertices", places, PointStyle::Result);
        canvas.law(
            "subdivision-modified-butterfly",
            &laws::modified_butterfly(|mesh| Butterfly::MODIFIED.refine(mesh), &icosahedron),
        );
        Ok(())
    })
}
