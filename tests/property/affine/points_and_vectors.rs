//! Properties of points and vectors.

use cagd::affine::{Affine, Point, Vector, laws, point_seen_from};

use super::inputs::{eighth, place, vector};
use crate::generators::for_all;
use crate::support::mutants::affine::points_and_vectors as mutants;
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Vector2 = Vector<f64, 2>;

#[test]
fn space() {
    type Translate = fn(&Point2, &Vector2) -> Point2;
    type Difference = fn(&Point2, &Point2) -> Vector2;
    let law = |translate: Translate, difference: Difference| {
        for_all((place(), place(), vector(), vector()), |(p, q, u, v)| {
            laws::space(translate, difference, [p, q], [u, v])
        })
    };
    let translate: Translate = Affine::translated;
    let difference: Difference = Affine::difference;
    holds(law(translate, difference));
    holds(law(
        |point, vector| *point + *vector,
        |end, start| *end - *start,
    ));
    rejects("the way twice", law(mutants::moved_twice, difference));
    rejects(
        "one coordinate",
        law(mutants::first_coordinate_moved, difference),
    );
    rejects(
        "end and start swapped",
        law(translate, mutants::difference_reversed),
    );
    rejects("start forgotten", law(translate, mutants::start_forgotten));
}

#[test]
fn points_versus_vectors() {
    type Multiple = fn(&Point2, &f64, &Point2) -> Point2;
    let law = |multiple: Multiple| {
        for_all(
            (place(), place(), eighth(), place()),
            |(o, other, factor, p)| laws::points_versus_vectors(multiple, [o, other], factor, p),
        )
    };
    holds(law(|o, factor, p| point_seen_from(o, &[(*factor, *p)])));
    rejects(
        "coordinates multiplied",
        law(mutants::coordinates_multiplied),
    );
    rejects("begun at the point", law(mutants::begun_at_the_point));
    rejects("origin not added", law(mutants::origin_not_added));
}
