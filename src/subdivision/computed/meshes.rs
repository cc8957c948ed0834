//! The numbers of elements, step by step.

use super::Computed;
use crate::subdivision::{HalfEdgeMesh, MeshError, Refinement, solids};

pub(super) const ALL: &[Computed] = &[("element_counts", element_counts)];

/// Vertices, edges and faces of three solids after 0 to 5 steps, counted.
fn element_counts() -> String {
    let solids = [
        (
            solids::octahedron::<f64>().connectivity().clone(),
            Refinement::Triangles,
        ),
        (
            solids::cube::<f64>().connectivity().clone(),
            Refinement::Quadrilaterals,
        ),
        (
            solids::cube::<f64>().connectivity().clone(),
            Refinement::CutCorners,
        ),
    ];
    let columns = solids
        .into_iter()
        .map(|(mesh, refinement)| counts(mesh, refinement, 5));
    let Ok(columns) = columns.collect::<Result<Vec<_>, _>>() else {
        return String::new();
    };
    let mut table = String::from(
        "| step | octahedron, triangles | cube, quadrilaterals | cube, cut corners |\n|--:|--:|--:|--:|\n",
    );
    for step in 0..=5 {
        let cells: Vec<String> = columns.iter().map(|column| column[step].clone()).collect();
        table += &format!("| {step} | {} |\n", cells.join(" | "));
    }
    table
}

/// The numbers V, E, F after 0, …, `steps` steps, counted in the refined meshes.
fn counts(
    mut mesh: HalfEdgeMesh,
    refinement: Refinement,
    steps: usize,
) -> Result<Vec<String>, MeshError> {
    let mut rows = vec![];
    for step in 0..=steps {
        let [v, e, f] = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()];
        rows.push(format!("{v}, {e}, {f}"));
        if step < steps {
            mesh = refinement.refine(&mesh)?;
        }
    }
    Ok(rows)
}
