//! A surface of polygons: which faces are seen, in which order they are painted, and how light they are.

use super::view::View;
use crate::affine::{Point, Vector};
use crate::figure::place::Place;

/// How many steps the brightness of a face has.
pub(in crate::figure) const SHADES: u8 = 6;

/// The direction to the light, as seen by the viewer: from the upper left, behind him.
const LIGHT: [f64; 3] = [-0.36, 0.48, 0.8];

/// A surface of polygons in space, for [`Canvas::surface`](crate::figure::Canvas::surface).
///
/// Faces are lists of vertices, counterclockwise as seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    points: Vec<Point<f64, 3>>,
    faces: Vec<Vec<u32>>,
    closed: bool,
    wires: bool,
    marked: Vec<usize>,
}

/// Which side or part of a surface a face shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Cover {
    /// The outside.
    Front,
    /// The inside of a surface that is not closed.
    Back,
    /// The outside of a face that the figure points out.
    Marked,
}

/// A face as it was painted.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedFace {
    /// The number of the face in the surface.
    pub number: usize,
    /// Its vertices.
    pub corners: Vec<u32>,
    /// What it shows.
    pub cover: Cover,
    /// Its brightness, from 0 in the shadow to 5 in full light.
    pub shade: u8,
}

impl Surface {
    /// A surface with these points and faces, both of its sides to be seen.
    #[must_use]
    pub fn new(points: impl IntoIterator<Item = Point<f64, 3>>, faces: Vec<Vec<u32>>) -> Self {
        Surface {
            points: points.into_iter().collect(),
            faces,
            closed: false,
            wires: true,
            marked: vec![],
        }
    }

    /// The surface encloses a body: faces that look away from the viewer are hidden and need not be painted.
    #[must_use]
    pub fn closed(self) -> Self {
        Surface {
            closed: true,
            ..self
        }
    }

    /// Without lines along the edges.
    #[must_use]
    pub fn without_edges(self) -> Self {
        Surface {
            wires: false,
            ..self
        }
    }

    /// With another colour for these faces.
    #[must_use]
    pub fn marked(self, faces: impl IntoIterator<Item = usize>) -> Self {
        Surface {
            marked: faces.into_iter().collect(),
            ..self
        }
    }

    pub(super) fn has_edges(&self) -> bool {
        self.wires
    }

    /// The places of all vertices.
    pub(super) fn places(&self, view: &View) -> Vec<Place> {
        self.points.iter().map(|point| view.place(point)).collect()
    }

    /// Places that show the whole surface from every direction: the box of a ball around it.
    pub(super) fn room(&self, view: &View) -> [Place; 2] {
        let [low, high] = [f64::min, f64::max].map(|least: fn(f64, f64) -> f64| {
            [0, 1, 2].map(|k| {
                let coordinates = self.points.iter().map(|point| point[k]);
                coordinates.reduce(least).unwrap_or(0.0)
            })
        });
        let centre = Point::new([0, 1, 2].map(|k: usize| 0.5 * (low[k] + high[k])));
        let radius = self
            .points
            .iter()
            .map(|point| (*point - centre).norm())
            .fold(0.0, f64::max);
        let middle = view.place(&centre);
        [-radius, radius].map(|r| Place::new([middle[0] + r, middle[1] + r]))
    }

    /// The faces that are painted, the farthest first; faces with a corner that does not exist are left out.
    ///
    /// The order is that of the middles of the faces, which is right for small faces that do not cut each other.
    pub(super) fn painted(&self, view: &View) -> Vec<PaintedFace> {
        let seen: Vec<Vector<f64, 3>> = self.points.iter().map(|point| view.seen(point)).collect();
        let places = self.places(view);
        let mut painted: Vec<(f64, PaintedFace)> = vec![];
        for (number, corners) in self.faces.iter().enumerate() {
            if corners.len() < 3 || corners.iter().any(|&v| v as usize >= seen.len()) {
                continue;
            }
            let towards_us = area(&places, corners) > 0.0;
            let cover = match (towards_us, self.closed) {
                (true, _) if self.marked.contains(&number) => Cover::Marked,
                (true, _) => Cover::Front,
                (false, false) => Cover::Back,
                (false, true) => continue,
            };
            let depth = corners.iter().map(|&v| seen[v as usize][2]).sum::<f64>();
            let normal = normal(&seen, corners) * if towards_us { 1.0 } else { -1.0 };
            let light = (0..3).map(|k| normal[k] * LIGHT[k]).sum::<f64>().max(0.0);
            // Six steps of equal width; full light belongs to the last.
            let shade = (light * f64::from(SHADES)).min(f64::from(SHADES - 1)) as u8;
            let face = PaintedFace {
                number,
                corners: corners.clone(),
                cover,
                shade,
            };
            painted.push((depth / corners.len() as f64, face));
        }
        // The sort keeps the order of faces with equal depth, so the picture is the same everywhere.
        painted.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        painted.into_iter().map(|(_, face)| face).collect()
    }
}

/// Twice the area of a polygon in the picture, positive if it runs counterclockwise.
fn area(places: &[Place], corners: &[u32]) -> f64 {
    sides(corners)
        .map(|(a, b)| {
            let (a, b) = (places[a], places[b]);
            a[0] * b[1] - a[1] * b[0]
        })
        .sum()
}

/// The unit normal of a polygon that need not be plane (Newell's sum over its sides); 0 if it has no area.
fn normal(points: &[Vector<f64, 3>], corners: &[u32]) -> Vector<f64, 3> {
    let sum: Vector<f64, 3> = sides(corners)
        .map(|(a, b)| points[a].cross(&points[b]))
        .sum();
    let length = sum.norm();
    if length > 0.0 { sum / length } else { sum }
}

fn sides(corners: &[u32]) -> impl Iterator<Item = (usize, usize)> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(&a, &b)| (a as usize, b as usize))
}

/// Sets of faces that may be painted at once, in the order in which the sets are painted.
///
/// Faces of a set have the same cover and brightness and do not cover each other, so that they can be one path.
/// Two faces that look to the same side and have a common corner do not cover each other; for others their boxes decide.
pub(in crate::figure) fn groups<'a>(
    faces: &'a [PaintedFace],
    places: &[Place],
) -> Vec<Vec<&'a PaintedFace>> {
    let boxes: Vec<[[f64; 2]; 2]> = faces.iter().map(|face| bounds(face, places)).collect();
    let covers = |i: usize, j: usize| {
        let (a, b) = (&faces[i], &faces[j]);
        let apart =
            (0..2).any(|k| boxes[i][1][k] <= boxes[j][0][k] || boxes[j][1][k] <= boxes[i][0][k]);
        let same_side = (a.cover == Cover::Back) == (b.cover == Cover::Back);
        let neighbours = || a.corners.iter().any(|v| b.corners.contains(v));
        !(apart || same_side && neighbours())
    };
    let mut groups: Vec<Vec<usize>> = vec![];
    for (i, face) in faces.iter().enumerate() {
        let behind = groups
            .iter()
            .rposition(|group| group.iter().any(|&j| covers(i, j)));
        let after = behind.map_or(0, |group| group + 1);
        let same = |group: &Vec<usize>| {
            group
                .first()
                .is_some_and(|&j| faces[j].cover == face.cover && faces[j].shade == face.shade)
        };
        match groups[after..].iter().position(same) {
            Some(group) => groups[after + group].push(i),
            None => groups.push(vec![i]),
        }
    }
    groups
        .into_iter()
        .map(|group| group.into_iter().map(|i| &faces[i]).collect())
        .collect()
}

fn bounds(face: &PaintedFace, places: &[Place]) -> [[f64; 2]; 2] {
    let corner = |least: fn(f64, f64) -> f64, start: f64| {
        [0, 1].map(|k| {
            let coordinates = face.corners.iter().map(|&v| places[v as usize][k]);
            coordinates.fold(start, least)
        })
    };
    [
        corner(f64::min, f64::INFINITY),
        corner(f64::max, f64::NEG_INFINITY),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(height: f64, size: f64) -> [Point<f64, 3>; 4] {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| Point::new([size * x, size * y, height]))
    }

    #[test]
    fn the_nearer_face_is_painted_later_and_never_in_one_path_with_what_it_hides() {
        let points = [square(1.0, 1.0), square(0.0, 2.0)].concat();
        let surface = Surface::new(points, vec![vec![0, 1, 2, 3], vec![4, 5, 6, 7]]);
        let view = View::from_above();
        let painted = surface.painted(&view);
        let order: Vec<usize> = painted.iter().map(|face| face.number).collect();
        assert_eq!(order, [1, 0]);
        assert_eq!(painted[0].shade, painted[1].shade);
        assert_eq!(groups(&painted, &surface.places(&view)).len(), 2);
    }

    #[test]
    fn the_inside_of_a_closed_surface_is_not_painted() {
        let faces = vec![vec![0, 1, 2, 3], vec![7, 6, 5, 4]];
        let surface = Surface::new([square(1.0, 1.0), square(0.0, 1.0)].concat(), faces);
        let numbers = |surface: &Surface, view: View| -> Vec<(usize, Cover)> {
            let painted = surface.painted(&view);
            painted
                .iter()
                .map(|face| (face.number, face.cover))
                .collect()
        };
        let above = View::from_above();
        assert_eq!(
            numbers(&surface, above),
            [(1, Cover::Back), (0, Cover::Front)]
        );
        let closed = surface.closed();
        assert_eq!(numbers(&closed, above), [(0, Cover::Front)]);
        let below = View::degrees(0.0, -90.0);
        assert_eq!(numbers(&closed.marked([1]), below), [(1, Cover::Marked)]);
    }

    #[test]
    fn neighbours_of_one_brightness_become_one_path() {
        let points = [
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [2.0, 0.0],
            [2.0, 1.0],
        ]
        .map(|[x, y]| Point::new([x, y, 0.0]));
        let surface = Surface::new(points, vec![vec![0, 1, 2, 3], vec![1, 4, 5, 2]]);
        let view = View::from_above();
        assert_eq!(
            groups(&surface.painted(&view), &surface.places(&view)).len(),
            1
        );
    }

    #[test]
    fn a_turned_view_keeps_lengths_and_the_right_hand() {
        let view = View::degrees(37.0, 21.0);
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .map(|axis| view.seen(&Point::new(axis)));
        // Sums of three products of numbers up to 1, each with a few roundings.
        let bound = crate::law::gamma(16);
        assert!((x.cross(&y) - z).amax() <= 2.0 * bound);
        assert!((x.dot(&x) - 1.0).abs() <= bound && x.dot(&z).abs() <= bound);
    }
}
