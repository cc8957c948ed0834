//! The figure of Doo–Sabin subdivision.

use super::catmull_clark::{closed_surface, edges};
use crate::figure::{Figure, Place, PointStyle, Style, View};
use crate::subdivision::{DooSabin, Mesh, SurfaceScheme, laws, solids};

const KNOB: f64 = 2.2;

pub(super) fn all() -> Vec<Figure> {
    vec![figure_doo_sabin()]
}

/// The three kinds of new faces, and the cube after some steps.
#[must_use]
pub fn figure_doo_sabin() -> Figure {
    Figure::new(
        "subdivision-figure-doo-sabin",
        "Faces shrink, and every edge and every vertex becomes a face",
        "On the left a plane mesh of nine quadrilaterals and, inside, the mesh after one step. \
         Its faces are of three kinds, each in a colour of its own: a smaller copy inside each old face, \
         a quadrilateral across each inner edge, and a face around each inner vertex. \
         On the right a cube after a number of steps: its six faces have become smaller, \
         its edges strips and its corners triangles.",
    )
    .rows(&[&["mesh", "cube"]])
    .handles_in("mesh", "p", [[1.0, 1.0], [2.1, 0.9], [0.9, 2.1], [2.2, 2.0]])
    .stepper("steps", 0..=3, 1)
    .handle_in("cube", "view", View::degrees(32.0, 24.0).knob(KNOB))
    .draw(|values, canvas| {
        let grid = solids::grid::<f64>(3, 3);
        let mesh = grid.connectivity();
        let mut places: Vec<Place> = grid.points().iter().map(|p| Place::new([p[0], p[1]])).collect();
        for (vertex, at) in [5, 6, 9, 10].into_iter().zip(values.points("p")?) {
            places[vertex] = at;
        }
        canvas.panel("mesh");
        canvas.caption("one step in the plane");
        edges(canvas, "edge", mesh, &places);
        let given = Mesh::new(mesh.clone(), places.clone())?;
        let refined = DooSabin.refine(&given)?;
        canvas.law("subdivision-doo-sabin", &laws::doo_sabin(|mesh| DooSabin.refine(mesh), &given));
        let inner_edges = mesh.edges().filter(|&e| !mesh.is_boundary_edge(e)).count();
        for f in refined.connectivity().faces() {
            let corners: Vec<Place> = refined.face_points(f).copied().collect();
            let [kind, share] = match f.index() {
                i if i < mesh.face_count() => ["face", "1"],
                i if i < mesh.face_count() + inner_edges => ["edge face", "2"],
                _ => ["vertex face", "3"],
            };
            let style = Style::Share(share.parse()?);
            canvas.polygon(&format!("{kind} {}", f.0), &corners, style);
        }
        canvas.points("new vertices", refined.points(), PointStyle::OnCurve);
        canvas.points("old vertices", &places, PointStyle::Control);
        let steps = values.count("steps")?;
        let cube = DooSabin.refine_times(&solids::cube(), steps)?;
        let view = View::of_knob(values.point("view")?, KNOB);
        canvas.panel("cube");
        canvas.caption(&match steps {
            1 => "the cube after 1 step".to_owned(),
            steps => format!("the cube after {steps} steps"),
        });
        canvas.surface("surface", &view, &closed_surface(&cube, steps));
        Ok(())
    })
}
