//! Figures of the section on meshes.

use crate::affine::{Point, Vector};
use crate::figure::{Figure, Side, Style, midpoint};
use crate::subdivision::{HalfEdgeId, HalfEdgeMesh, Mesh, laws};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_half_edge()]
}

/// How far a half-edge is drawn from its edge, and its ends from the vertices, as parts of its length.
const INSET: [f64; 2] = [0.055, 0.13];

/// The faces of the fragment: a quadrilateral, and two triangles at its sides.
const FACES: [&[u32]; 3] = [&[0, 1, 2, 3], &[2, 1, 4], &[3, 2, 5]];

/// Where the half-edge `h` is drawn: beside its edge, on the side of its face.
fn arrow(mesh: &Mesh<Point<f64, 2>>, h: HalfEdgeId) -> [Point<f64, 2>; 2] {
    let connectivity = mesh.connectivity();
    let start = *mesh.point(connectivity.origin(h));
    let along = *mesh.point(connectivity.destination(h)) - start;
    let to_the_left = Vector::from([-along[1], along[0]]);
    let [aside, gap] = INSET;
    let shifted = start + to_the_left * aside;
    [shifted + along * gap, shifted + along * (1.0 - gap)]
}

/// A fragment of a mesh with one half-edge and all that it knows.
#[must_use]
pub fn figure_half_edge() -> Figure {
    Figure::new(
        "subdivision-figure-half-edge",
        "A half-edge and its neighbours",
        "A quadrilateral and two triangles at its sides. \
         Beside every edge run two arrows in opposite directions, each on the side of its face; along the boundary the outer one has no face. \
         One arrow, h, is heavy. Marked with it are its flip on the other side of the edge, the next and the previous arrow around the face, \
         the vertex where it starts, its edge and its face. \
         A stepper walks through all half-edges.",
    )
    .stepper("h", 0..=15, 1)
    .handles(
        "p",
        [[0.0, 0.0], [3.2, 0.2], [3.4, 3.0], [0.2, 3.2], [5.8, 1.9], [2.3, 5.2]],
    )
    .draw(|values, canvas| {
        let connectivity = HalfEdgeMesh::from_faces(6, &FACES)?;
        let mesh = Mesh::new(connectivity, values.points("p")?)?;
        let connectivity = mesh.connectivity();
        for f in connectivity.faces() {
            let corners: Vec<_> = mesh.face_points(f).copied().collect();
            canvas.polygon(&format!("face {}", f.0), corners, Style::Region);
        }
        for e in connectivity.edges() {
            let [a, b] = connectivity.edge_vertices(e).map(|v| mesh.point(v));
            canvas.polyline(&format!("edge {}", e.0), [a, b], Style::ControlPolygon);
        }
        let h = HalfEdgeId(values.count("h")? as u32);
        let marked = [
            ("h", h, Style::Curve),
            ("\\text{flip}", connectivity.flip(h), Style::Tangent),
            ("\\text{next}", connectivity.next(h), Style::Level(2)),
            ("\\text{prev}", connectivity.prev(h), Style::Level(3)),
        ];
        for other in connectivity.half_edges() {
            if marked.iter().all(|&(_, known, _)| known != other) {
                let [from, to] = arrow(&mesh, other);
                canvas.arrow(&format!("half-edge {}", other.0), from, to, Style::Connector);
            }
        }
        for (name, other, style) in marked {
            let [from, to] = arrow(&mesh, other);
            canvas.arrow(name, from, to, style);
            let aside = (to - from) * 0.5;
            let middle = midpoint(from, to) + Vector::from([-aside[1], aside[0]]) * 0.3;
            canvas.text(&format!("name of {name}"), name, middle, Side::Centre);
        }
        let start = connectivity.origin(h);
        canvas.label("v", mesh.point(start));
        let ends = connectivity.edge_vertices(connectivity.edge(h)).map(|v| mesh.point(v));
        // On the edge itself, between its two halves.
        canvas.label_on(Side::Centre, "e", midpoint(ends[0], ends[1]));
        if let Some(f) = connectivity.face(h) {
            let corners: Vec<_> = mesh.face_points(f).copied().collect();
            let sum: Vector<f64, 2> = corners.iter().map(Point::from_origin).sum();
            let middle = Point::origin() + sum / corners.len() as f64;
            canvas.text("face of h", "f", middle, Side::Centre);
        } else {
            canvas.remark("h has no face: it runs along the boundary, and its next and previous half-edge, too.");
        }
        let faces = FACES.map(<[u32]>::to_vec);
        canvas.law(
            "subdivision-half-edge",
            &laws::half_edge::<f64>(|_, _| connectivity.tables(), 6, &faces, 1),
        );
        Ok(())
    })
}
