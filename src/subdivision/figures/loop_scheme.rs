//! Figures of the section on Loop's scheme.

use crate::affine::{Affine, Point};
use crate::figure::{BoxError, Figure, Place, PointStyle, Style, Surface, View, decimal};
use crate::subdivision::{
    Creases, Loop, Mesh, SurfaceScheme, VertexId, box_spline_222, laws, loop_beta,
    loop_edge_weights, loop_lattice_mask, solids,
};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_loop(), loop_limit(), loop_box_spline()]
}

/// The radius of the ball by which the reader turns a surface.
pub(super) const KNOB: f64 = 1.0;

/// A mesh in space as a surface to paint.
pub(super) fn painted(mesh: &Mesh<Point<f64, 3>>) -> Surface {
    Surface::new(
        mesh.points().iter().copied(),
        mesh.connectivity().face_lists(),
    )
}

/// Neighbour i of k on the unit circle.
pub(super) fn spoke(i: usize, k: usize) -> Place {
    let angle = std::f64::consts::TAU * i as f64 / k as f64;
    Place::new([libm::cos(angle), libm::sin(angle)])
}

/// The mean of weighted places.
pub(super) fn mean(terms: &[(f64, Place)]) -> Result<Place, BoxError> {
    Ok(Place::affine_combination(terms.iter().copied())?)
}

/// Both stencils, and an octahedron that is refined.
#[must_use]
pub fn figure_loop() -> Figure {
    const PANELS: [&str; 3] = ["edge point", "vertex point", "mesh"];
    Figure::new(
        "subdivision-figure-loop",
        "Loop's scheme: both stencils, and the octahedron after some steps",
        "On the left two triangles with a common edge; the ends of the edge carry the weight three eighths, \
         the two opposite vertices one eighth, and the new point lies in the middle of the edge. \
         On the right a vertex with k neighbours; each neighbour carries the weight beta, the vertex itself the rest. \
         Below, an octahedron after some steps, in which every triangle became four each time, and looks like a rounded body.",
    )
    .rows(&[&PANELS[..2], &PANELS[2..]])
    .stepper("k", 3..=12, 5)
    .stepper("steps", 0..=4, 2)
    .handle_in(PANELS[2], "view", View::degrees(25.0, 25.0).knob(KNOB))
    .draw(|values, canvas| {
        canvas.panel(PANELS[0]);
        canvas.caption("edge point");
        let height = libm::sqrt(3.0);
        let corners = [[0.0, 0.0], [2.0, 0.0], [1.0, height], [1.0, -height]].map(Place::new);
        let [a, b, c, d] = corners;
        for (name, triangle) in [("triangle abc", [a, b, c]), ("triangle bad", [b, a, d])] {
            canvas.polyline(name, triangle.into_iter().chain([triangle[0]]), Style::Connector);
        }
        let weights = loop_edge_weights::<f64>();
        let point = mean(&[0, 1, 2, 3].map(|i: usize| (weights[i], corners[i])))?;
        let labels = weights.map(|w| format!("{}/8", decimal(8.0 * w, 3)));
        canvas.stencil("edge point", corners.into_iter().zip(labels), point);

        let k = values.count("k")?;
        canvas.panel(PANELS[1]);
        canvas.caption(&format!("vertex point, $k = {k}$"));
        let beta = loop_beta::<f64>(k)?;
        let ring: Vec<Place> = (0..k).map(|i| spoke(i, k)).collect();
        let centre = Place::origin();
        for (i, &place) in ring.iter().enumerate() {
            canvas.segment(&format!("spoke {i}"), centre, place, Style::Connector);
        }
        canvas.polyline("ring", ring.iter().chain(ring.first()), Style::Connector);
        let own = 1.0 - k as f64 * beta;
        let terms: Vec<_> = std::iter::once((own, centre))
            .chain(ring.iter().map(|&place| (beta, place)))
            .collect();
        let labels = terms.iter().map(|(weight, place)| (*place, decimal(*weight, 3)));
        canvas.stencil("vertex point", labels, mean(&terms)?);
        let star = Mesh::new(
            solids::triangle_fan(k),
            terms.iter().map(|(_, p)| Point::new([p[0], p[1], 0.0])).collect(),
        )?;
        canvas.law("subdivision-loop", &laws::loop_rules(|mesh| Loop.refine(mesh), &star));

        canvas.panel(PANELS[2]);
        let steps = values.count("steps")?;
        canvas.caption(&format!("octahedron, step {steps}"));
        let view = View::of_knob(values.point("view")?, KNOB);
        let mesh = Loop.refine_times(&solids::octahedron(), steps)?;
        canvas.surface("surface", &view, &painted(&mesh).closed());
        Ok(())
    })
}

/// The octahedron with the limit positions and normals of its vertices on the refined surface.
#[must_use]
pub fn loop_limit() -> Figure {
    Figure::new(
        "subdivision-loop-limit",
        "Limit positions and normals of the octahedron's vertices",
        "The octahedron as a frame of thin lines, and inside it the surface after some steps of Loop's scheme. \
         A line leads from each vertex that we see from the front to its limit position, which lies on the surface, \
         and an arrow there is the normal of the surface.",
    )
    .stepper("steps", 0..=4, 4)
    .handle("view", View::degrees(25.0, 25.0).knob(KNOB))
    .draw(|values, canvas| {
        let view = View::of_knob(values.point("view")?, KNOB);
        let octahedron = solids::octahedron::<f64>();
        let old = octahedron.connectivity();
        let mesh = Loop.refine_times(&octahedron, values.count("steps")?)?;
        canvas.surface("surface", &view, &painted(&mesh).closed().without_edges());
        let place = |v: VertexId| view.place(octahedron.point(v));
        for e in old.edges() {
            let [a, b] = old.edge_vertices(e);
            canvas.segment(&format!("edge {e}"), place(a), place(b), Style::Guide);
        }
        for v in old.vertices() {
            let limit = Loop.limit_point(&octahedron, v)?;
            let [first, second] = Loop.limit_tangents(&octahedron, v)?;
            let normal = first.cross(&second).normalize();
            // What looks away from us is hidden by the surface.
            if view.seen(&(Point::origin() + normal))[2] <= 0.0 {
                continue;
            }
            let tip = limit + normal * 0.4;
            canvas.segment(&format!("way of {v}"), place(v), view.place(&limit), Style::Guide);
            canvas.arrow(&format!("normal at {v}"), view.place(&limit), view.place(&tip), Style::Tangent);
            canvas.point(&format!("limit of {v}"), view.place(&limit), PointStyle::Result);
            canvas.label(&format!("v_{}", v.0), place(v));
        }
        canvas.law(
            "subdivision-loop-limit",
            &laws::loop_limit(
                |mesh| Loop.refine(mesh),
                |mesh, v| Loop.limit_point(mesh, v),
                |mesh, v| Loop.limit_tangents(mesh, v),
                &octahedron,
            ),
        );
        Ok(())
    })
}

/// The support of M₂₂₂ in a lattice of equilateral triangles with sides 1: a hexagon, its middle vertex raised, corners kept.
fn spike() -> Result<(Mesh<Point<f64, 3>>, Creases), BoxError> {
    let corner = |i: usize| {
        let on_circle = spoke(i, 6);
        Point::new([2.0 * on_circle[0], 2.0 * on_circle[1], 0.0])
    };
    let points = std::iter::once(Point::origin()).chain((0..6).map(corner));
    let hexagon = Mesh::new(solids::triangle_fan(6), points.collect())?;
    let corners = (1..=6).map(VertexId);
    let creases = Creases::new(hexagon.connectivity(), [], corners)?;
    // A step leaves a plane lattice as it is and halves its sides.
    let (flat, creases) = Loop.refine_creased(&hexagon, &creases)?;
    let (connectivity, mut points) = flat.into_parts();
    points[0] = Point::new([0.0, 0.0, 1.0]);
    Ok((Mesh::new(connectivity, points)?, creases))
}

/// The graph of M₂₂₂: one raised vertex of the regular lattice, refined, in the limit positions.
#[must_use]
pub fn loop_box_spline() -> Figure {
    Figure::new(
        "subdivision-loop-box-spline",
        "The box spline: a regular mesh with one raised vertex",
        "A flat hexagon of triangles whose middle vertex was raised to height one. \
         After some steps of Loop's scheme, with all vertices in their limit positions, it is a smooth hill, \
         and the hexagon is its foot: two triangles reach from the middle to the rim. \
         Its top has half the height of the raised vertex. The picture shows heights three times as large.",
    )
    .stepper("steps", 0..=3, 2)
    .handle("view", View::degrees(20.0, 42.0).knob(KNOB))
    .draw(|values, canvas| {
        // A hexagon with corners at the distance 2 fits from every side, from straight above by the room around the window.
        canvas.window([-2.0, -1.75], [2.0, 1.75]);
        let view = View::of_knob(values.point("view")?, KNOB);
        let (mut mesh, mut creases) = spike()?;
        for _ in 0..values.count("steps")? {
            (mesh, creases) = Loop.refine_creased(&mesh, &creases)?;
        }
        let connectivity = mesh.connectivity();
        let points = connectivity.vertices().map(|v| {
            let point = mesh.point(v);
            // The rim stays where it is; the limit stencil is that of the inside.
            let height = if connectivity.is_boundary(v) { 0.0 } else { Loop.limit_point(&mesh, v)?[2] };
            Ok(Point::new([point[0], point[1], 3.0 * height]))
        });
        let points = points.collect::<Result<Vec<Point<f64, 3>>, BoxError>>()?;
        let top = points.iter().max_by(|p, q| p[2].total_cmp(&q[2]));
        let top = top.copied().unwrap_or_else(Point::origin);
        canvas.surface("graph", &view, &Surface::new(points, connectivity.face_lists()));
        canvas.point("top", view.place(&top), PointStyle::Result);
        canvas.label("M(0) = 1/2", view.place(&top));
        canvas.law(
            "subdivision-loop-box-spline",
            &laws::loop_box_spline(&loop_lattice_mask()?, box_spline_222, &[0.25, 0.5]),
        );
        Ok(())
    })
}
