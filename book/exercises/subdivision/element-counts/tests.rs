use cagd::check::claim;
use cagd::subdivision::{HalfEdgeMesh, Refinement, solids};
use proptest::prelude::*;

fn probes() -> Vec<String> {
    let torus = [9, 27, 18];
    cagd::probes![
        answer::loop_counts([4, 6, 4], 0),
        answer::loop_counts([4, 6, 4], 2),
        answer::loop_counts(torus, 2),
        answer::catmull_clark_counts([5, 8, 5], 0),
        answer::catmull_clark_counts([5, 8, 5], 1),
        answer::catmull_clark_counts([5, 8, 5], 2),
        answer::catmull_clark_counts(torus, 1),
    ]
}

fn compare_loop(name: &str, counts: [u64; 3], steps: u32, expected: [u64; 3]) {
    claim("[V, E, F] after steps of Loop's scheme")
        .input(format!("{name}, [V, E, F] = {counts:?}, steps = {steps}"))
        .equal(answer::loop_counts(counts, steps), expected);
}

fn compare_catmull_clark(name: &str, counts: [u64; 3], steps: u32, expected: [u64; 3]) {
    claim("[V, E, F] after steps of Catmull–Clark subdivision")
        .input(format!("{name}, [V, E, F] = {counts:?}, steps = {steps}"))
        .equal(answer::catmull_clark_counts(counts, steps), expected);
}

/// Why: the first step can be counted by hand.
#[test]
fn one_step() {
    compare_loop("a tetrahedron", [4, 6, 4], 1, [10, 24, 16]);
    compare_catmull_clark("a cube", [8, 12, 6], 1, [26, 48, 24]);
}

/// Why: a pyramid has faces of two kinds, and only its first step is special.
#[test]
fn other_faces_than_quadrilaterals() {
    compare_catmull_clark("a pyramid over a square", [5, 8, 5], 1, [18, 32, 16]);
    compare_catmull_clark("a pyramid over a square", [5, 8, 5], 2, [66, 128, 64]);
}

/// Why: nothing happens in no step.
#[test]
fn no_step() {
    compare_loop("a tetrahedron", [4, 6, 4], 0, [4, 6, 4]);
    compare_catmull_clark("a pyramid over a square", [5, 8, 5], 0, [5, 8, 5]);
}

/// Why: V − E + F is 2 for a sphere only.
#[test]
fn a_torus() {
    compare_loop("a torus", [9, 27, 18], 1, [36, 108, 72]);
    compare_catmull_clark("a torus", [9, 18, 9], 2, [144, 288, 144]);
}

/// Why: the numbers of many steps can be told, but not counted.
#[test]
fn ten_steps() {
    compare_loop(
        "a tetrahedron",
        [4, 6, 4],
        10,
        [2_097_154, 6_291_456, 4_194_304],
    );
    compare_catmull_clark("a cube", [8, 12, 6], 10, [6_291_458, 12_582_912, 6_291_456]);
}

/// The numbers of a mesh, and those after some steps, counted in the refined mesh.
fn counted(mesh: HalfEdgeMesh, steps: u32, refinement: Refinement) -> [[u64; 3]; 2] {
    let counts = |mesh: &HalfEdgeMesh| {
        [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|n| n as u64)
    };
    let before = counts(&mesh);
    let after = (0..steps).fold(mesh, |mesh, _| {
        refinement.refine(&mesh).expect("a closed mesh")
    });
    [before, counts(&after)]
}

proptest! {
    /// Why: it compares with the numbers of real meshes.
    #[test]
    fn as_counted(columns in 3_usize..5, rows in 3_usize..5, holes in 0_usize..3, steps in 0_u32..4) {
        let torus = solids::torus_triangles(columns, rows);
        let [before, after] = counted(torus, steps, Refinement::Triangles);
        compare_loop("a torus", before, steps, after);
        let plate = solids::plate_with_holes::<f64>(holes).connectivity().clone();
        let [before, after] = counted(plate, steps.min(2), Refinement::Quadrilaterals);
        compare_catmull_clark("a plate with holes", before, steps.min(2), after);
    }
}
