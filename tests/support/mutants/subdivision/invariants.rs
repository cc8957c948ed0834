//! Right schemes spoiled in one respect: each takes the step of a scheme and its result.

use cagd::affine::{Affine, Point};
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{Mesh, SchemeError};

type Place = Point<f64, 3>;
type Space = Mesh<Place>;

/// The step of a scheme.
pub type Step = fn(&Space) -> Refined<Place>;

/// A spoiled step, made of a right one.
pub type Spoiled = fn(Step, &Space) -> Refined<Place>;

fn with_points(refined: &Space, point: impl FnMut(&Place) -> Place) -> Refined<Place> {
    refined.map(point).map_err(SchemeError::from)
}

/// Has weights with a sum below 1, so that every point is pulled towards the origin.
pub fn pulled_to_the_origin(step: Step, mesh: &Space) -> Refined<Place> {
    with_points(&step(mesh)?, |p| {
        Point::new([0, 1, 2].map(|k: usize| p[k] * 0.875))
    })
}

/// Raises every point by a sixteenth of the product of its first coordinates.
pub fn bent(step: Step, mesh: &Space) -> Refined<Place> {
    with_points(&step(mesh)?, |p| {
        Point::new([p[0], p[1], p[2] + p[0] * p[1] / 16.0])
    })
}

/// Raises every point by a millionth, wherever the mesh lies.
pub fn raised(step: Step, mesh: &Space) -> Refined<Place> {
    with_points(&step(mesh)?, |p| Point::new([p[0], p[1], p[2] + 1e-6]))
}

/// Moves the new point with the highest number half way to that with the lowest.
pub fn last_towards_first(step: Step, mesh: &Space) -> Refined<Place> {
    let (connectivity, mut points) = step(mesh)?.into_parts();
    if let [first, .., last] = points.as_mut_slice() {
        *last = last.lerp(first, 0.5);
    }
    Ok(Mesh::new(connectivity, points)?)
}

/// Moves the first old vertex to the second.
pub fn first_vertex_moved(step: Step, mesh: &Space) -> Refined<Place> {
    let (connectivity, mut points) = step(mesh)?.into_parts();
    points[0] = points[1];
    Ok(Mesh::new(connectivity, points)?)
}

/// Leaves out the last face.
pub fn face_lost(step: Step, mesh: &Space) -> Refined<Place> {
    let (connectivity, points) = step(mesh)?.into_parts();
    let mut faces = connectivity.face_lists();
    faces.pop();
    Ok(Mesh::from_faces(points, &faces)?)
}

/// Takes two steps for one.
pub fn two_steps(step: Step, mesh: &Space) -> Refined<Place> {
    step(&step(mesh)?)
}
