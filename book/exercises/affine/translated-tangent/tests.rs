use cagd::affine::{Point, Vector};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn point(xy: [i64; 2]) -> Point<BigRational, 2> {
    Point::new(xy.map(<BigRational as Scalar>::from_integer))
}

fn vector(xy: [i64; 2]) -> Vector<BigRational, 2> {
    Vector::from(xy.map(<BigRational as Scalar>::from_integer))
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::translated(&point([0, 0]), &vector([1, 0]), &vector([0, 5])),
        answer::translated(&point([3, -1]), &vector([2, 7]), &vector([-4, 1])),
    ]
}

/// The claim that the touching point is moved and the direction is not.
fn compare(touches: [i64; 2], direction: [i64; 2], by: [i64; 2]) {
    let (p, v, w) = (point(touches), vector(direction), vector(by));
    let moved = point([touches[0] + by[0], touches[1] + by[1]]);
    let found = || answer::translated(&p, &v, &w);
    let ends = |(p, v): (Point<BigRational, 2>, Vector<BigRational, 2>)| [p.clone(), p + v];
    claim("touching point and direction of the moved tangent")
        .input(format!(
            "point {touches:?}, direction {direction:?}, moved by {by:?}"
        ))
        .picture(|| {
            Picture::new()
                .given(ends((p.clone(), v.clone())))
                .expected(ends((moved.clone(), v.clone())))
                .found(ends(found()))
        })
        .equal(found(), (moved.clone(), v.clone()));
}

/// Why: a level tangent that is lifted stays level; one sees it without computing.
#[test]
fn a_level_tangent_is_lifted() {
    compare([0, 0], [1, 0], [0, 5]);
}

/// Why: the zero vector moves nothing, wherever the tangent is.
#[test]
fn the_translation_by_zero_changes_nothing() {
    compare([2, 3], [1, -1], [0, 0]);
}

proptest! {
    /// Why: any point, any direction and any translation, the zero vectors too.
    #[test]
    fn everywhere(p in any::<[i8; 2]>(), v in any::<[i8; 2]>(), w in any::<[i8; 2]>()) {
        let [p, v, w] = [p, v, w].map(|xy| xy.map(i64::from));
        compare(p, v, w);
    }
}
