//! The numbers of elements, step by step.

use super::Computed;
use crate::subdivision::{HalfEdgeMesh, MeshError, Refinement, solids};

pub(super) const ALL: &[Computed] = &[("element_counts", element_counts)];

/// How many steps are shown: the numbers have few digits.
const STEPS: usize = 4;

/// Vertices, edges and faces of three solids after some steps, counted.
fn element_counts() -> String {
    let octahedron = solids::octahedron::<f64>();
    let cube = solids::cube::<f64>();
    let refined = [
        (&octahedron, Refinement::Triangles),
        (&cube, Refinement::Quadrilaterals),
        (&cube, Refinement::CutCorners),
    ];
    let columns = refined
        .into_iter()
        .map(|(solid, refinement)| counts(solid.connectivity().clone(), refinement));
    let Ok(columns) = columns.collect::<Result<Vec<_>, _>>() else {
        return String::new();
    };
    let mut table = String::from(
        "| step | octahedron, triangles | cube, quadrilaterals | cube, cut corners |\n|--:|--:|--:|--:|\n",
    );
    for step in 0..=STEPS {
        let cells: Vec<String> = columns.iter().map(|column| column[step].clone()).collect();
        table += &format!("| {step} | {} |\n", cells.join(" | "));
    }
    table
}

/// The numbers V, E, F after 0, 1, … steps, counted in the refined meshes.
fn counts(mut mesh: HalfEdgeMesh, refinement: Refinement) -> Result<Vec<String>, MeshError> {
    let mut rows = vec![];
    for step in 0..=STEPS {
        let [v, e, f] = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()];
        rows.push(format!("${v}, {e}, {f}$"));
        if step < STEPS {
            mesh = refinement.refine(&mesh)?;
        }
    }
    Ok(rows)
}
