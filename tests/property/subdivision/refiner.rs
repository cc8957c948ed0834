//! The quick refinement gives what the schemes give.

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::subdivision::{
    CatmullClark, FastScheme, HalfEdgeMesh, Loop, Mesh, Refiner, StencilCascade, SurfaceScheme,
    solids,
};
use proptest::prelude::*;

use super::meshes::{Planted, Space, polygon_meshes, triangle_meshes};
use crate::generators::for_all_of;
use crate::support::{Outcome, holds, rejects};

type Quick = fn(FastScheme, &Space, usize) -> Space;

/// Both meshes have the same lists, and coordinates that differ by rounding only.
///
/// A point is a sum of at most 2·12 + 1 terms with positive weights of sum 1, faces of at most 16 corners among them.
/// So a coordinate of one step passes at most 16 + 24 + 8 roundings on each side, and is at most as large as the largest.
fn same_mesh(found: &Space, expected: &Space, control: &Space, steps: usize) -> Sides<f64> {
    let flat = |mesh: &Space| {
        let coordinates = mesh.points().iter().flat_map(|p| p.coordinates().to_vec());
        coordinates.collect::<Vec<f64>>()
    };
    let lists = |mesh: &Space| {
        let tables = mesh.connectivity().tables();
        let lists = [tables.origin, tables.flip, tables.next, tables.edge];
        lists
            .concat()
            .into_iter()
            .map(|n| n as f64)
            .collect::<Vec<f64>>()
    };
    let largest = flat(control)
        .into_iter()
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    Sides::new(format!("{:?}", control.connectivity().face_lists()))
        .equal(
            "the half-edges",
            lists(found),
            lists(expected),
            Rounding::none(),
        )
        .equal(
            "the points",
            flat(found),
            flat(expected),
            Rounding::new(2 * 48 * steps, largest),
        )
}

fn fast(scheme: FastScheme, mesh: &Space, steps: usize) -> Space {
    let mut refiner = Refiner::new(scheme);
    // Memory of another mesh must leave no trace.
    refiner
        .refine(&solids::octahedron(), 2)
        .expect("an octahedron");
    refiner.refine(mesh, steps).expect("a small mesh").clone()
}

fn without_boundary_rule(scheme: FastScheme, mesh: &Space, steps: usize) -> Space {
    let refined = fast(scheme, mesh, steps);
    let mut points = refined.points().to_vec();
    let moved = refined
        .connectivity()
        .vertices()
        .find(|&v| refined.connectivity().is_boundary(v));
    if let Some(v) = moved {
        points[v.index()] = Point::new([0.0, 0.0, points[v.index()][2] + 1.0]);
    }
    Mesh::new(refined.connectivity().clone(), points).expect("finite points")
}

fn one_step_too_few(scheme: FastScheme, mesh: &Space, steps: usize) -> Space {
    fast(scheme, mesh, steps - 1)
}

#[test]
fn quick_refinement() {
    fn law(
        scheme: FastScheme,
        slow: &impl SurfaceScheme<Point<f64, 3>>,
        meshes: impl Strategy<Value = Planted>,
        quick: Quick,
    ) -> Outcome {
        for_all_of(48, (meshes, 1_usize..=2), |(planted, steps)| {
            let expected = slow.refine_times(&planted.mesh, *steps);
            same_mesh(
                &quick(scheme, &planted.mesh, *steps),
                &expected.expect("a small mesh"),
                &planted.mesh,
                *steps,
            )
        })
    }

    let triangles = |quick| law(FastScheme::Loop, &Loop, triangle_meshes(), quick);
    let polygons = |quick| {
        law(
            FastScheme::CatmullClark,
            &CatmullClark,
            polygon_meshes(),
            quick,
        )
    };
    for law in [&triangles as &dyn Fn(Quick) -> Outcome, &polygons] {
        holds(law(fast));
        rejects("a wrong boundary", law(without_boundary_rule));
        rejects("one step too few", law(one_step_too_few));
    }
}

/// Stencils give the points that refinement gives, in single precision.
fn stencils(scheme: FastScheme, planted: &Planted, spoil: fn(&mut [[f32; 4]])) -> Sides<f64> {
    let mesh = &planted.mesh;
    let mut control: Vec<[f32; 4]> = mesh
        .points()
        .iter()
        .map(|p| [p[0] as f32, p[1] as f32, p[2] as f32, 1.0])
        .collect();
    let expected = fast(scheme, mesh, 2);
    let largest = mesh.points().iter().flat_map(|p| p.coordinates().to_vec());
    let largest = largest.fold(1.0, |m: f64, x| m.max(x.abs()));
    spoil(&mut control);
    let mut cascade = StencilCascade::new(scheme, mesh.connectivity(), 2).expect("a small mesh");
    let found = cascade.apply(&control).expect("a point a vertex");
    let numbers = |points: &[[f32; 4]]| {
        points
            .iter()
            .flatten()
            .map(|&x| f64::from(x))
            .collect::<Vec<f64>>()
    };
    let expected = expected.points().iter();
    let expected = expected
        .flat_map(|p| [p[0], p[1], p[2], 1.0])
        .collect::<Vec<f64>>();
    // A rounding in single precision is as large as 2²⁹ in double precision; the numbers and the weights are rounded too.
    let roundings = 2 * (1 << 29) * 60;
    Sides::new(format!("{:?}", mesh.connectivity().face_lists())).equal(
        "the points",
        numbers(found),
        expected,
        Rounding::new(roundings, largest),
    )
}

#[test]
fn stencils_kept_in_memory() {
    let law = |spoil: fn(&mut [[f32; 4]])| {
        for_all_of(48, polygon_meshes(), |planted| {
            let sides = stencils(FastScheme::CatmullClark, planted, spoil);
            if planted.connectivity().uniform_face_degree() == Some(3) {
                sides.and(stencils(FastScheme::Loop, planted, spoil))
            } else {
                sides
            }
        })
    };
    holds(law(|_| ()));
    rejects(
        "a control point elsewhere",
        law(|points| points[1][2] += 4.0),
    );
}

#[test]
fn what_cannot_be_refined_is_refused() {
    let cube = solids::cube::<f64>();
    let refused = Refiner::new(FastScheme::Loop)
        .refine(&cube, 1)
        .map(|_| ())
        .unwrap_err();
    assert!(
        refused.to_string().contains("face 0 has 4 vertices"),
        "{refused}"
    );
    // Two triangles back to back: every vertex has two edges.
    let pillow = HalfEdgeMesh::from_faces(3, &[[0, 1, 2], [0, 2, 1]]).expect("a closed surface");
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::new);
    let pillow = Mesh::new(pillow, points.to_vec()).expect("a point a vertex");
    let refused = Refiner::new(FastScheme::CatmullClark)
        .refine(&pillow, 1)
        .map(|_| ())
        .unwrap_err();
    let expected = CatmullClark.refine(&pillow).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("vertex 0, which has valence 2"),
        "{refused}"
    );
    assert!(
        expected
            .to_string()
            .contains("vertex 0, which has valence 2"),
        "{expected}"
    );
    let far = cube
        .map(|p| Point::new([p[0] * f64::MAX, p[1], p[2]]))
        .expect("finite");
    let refused = Refiner::new(FastScheme::CatmullClark)
        .refine(&far, 1)
        .map(|_| ())
        .unwrap_err();
    assert!(refused.to_string().contains("not finite"), "{refused}");
}
