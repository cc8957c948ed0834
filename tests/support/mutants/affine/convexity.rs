//! Wrong convex hulls.

use cagd::affine::Orient;
use cagd::affine::{BoundingBox, ConvexHull, Point};

type Place<T> = Point<T, 2>;

/// The library's hull.
pub fn hull<T: Orient>(points: &[Place<T>]) -> Vec<Place<T>> {
    let hull = ConvexHull::of(points).expect("finite points");
    hull.vertices().to_vec()
}

/// The corners of the bounding box.
pub fn corners_of_the_box<T: Orient>(points: &[Place<T>]) -> Vec<Place<T>> {
    let bounds = BoundingBox::of(points).expect("finite points");
    let [low, high] = [bounds.low(), bounds.high()];
    [[low, low], [high, low], [high, high], [low, high]]
        .map(|[x, y]| Point::new([x[0].clone(), y[1].clone()]))
        .to_vec()
}

/// The hull without the last point.
pub fn last_point_missing<T: Orient>(points: &[Place<T>]) -> Vec<Place<T>> {
    hull(&points[..points.len().max(2) - 1])
}

/// The points in the order in which they were given.
pub fn as_given<T: Orient>(points: &[Place<T>]) -> Vec<Place<T>> {
    points.to_vec()
}

/// Goes round clockwise.
pub fn clockwise<T: Orient>(points: &[Place<T>]) -> Vec<Place<T>> {
    hull(points).into_iter().rev().collect()
}
