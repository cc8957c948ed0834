use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::law::gamma;
use proptest::prelude::*;

type Plane = Point<f64, 2>;

fn points(coordinates: [[i8; 2]; 4]) -> [Plane; 4] {
    coordinates.map(|xy| Point::new(xy.map(f64::from)))
}

const ARCH: [[i8; 2]; 4] = [[0, 0], [0, 4], [4, 4], [4, 0]];

/// y is 0, 9, −9, 0: a wave with both extremes inside.
const WAVE: [[i8; 2]; 4] = [[0, 0], [1, 9], [2, -9], [3, 0]];

fn probes() -> Vec<String> {
    cagd::probes![
        answer::control_box(&points(ARCH)),
        answer::tight_box(&points(ARCH)),
        answer::tight_box(&points(WAVE)),
        answer::tight_box(&points([[0, 0], [4, 4], [8, 2], [9, 3]])),
        answer::tight_box(&points([[0, 0], [9, 9], [-9, 9], [0, 0]])),
    ]
}

/// How far a box may be off for coordinates of at most 128.
///
/// The differences of integers and the discriminant D are exact, and D ≥ 1 or D = 0. So a zero is off by at most
/// 4·2⁻⁵³·(510 + √D)/|a| < 10⁻¹², and at an extreme that changes the value by less than 6·512·10⁻²⁴.
/// What remains is the value itself: in powers of t its terms sum to at most 27·128, with at most 30 roundings,
/// and the box of the library adds at most 10 more.
fn allowed() -> f64 {
    gamma(40) * 27.0 * 128.0
}

/// The boundary of a box, to be drawn.
fn outline([low, high]: [Plane; 2]) -> [Plane; 5] {
    let corner = |x: f64, y: f64| Point::new([x, y]);
    [
        low,
        corner(high[0], low[1]),
        high,
        corner(low[0], high[1]),
        low,
    ]
}

/// The claim that the tight box has these corners, up to rounding.
fn compare(b: [[i8; 2]; 4], right: [Plane; 2]) {
    let found = answer::tight_box(&points(b));
    claim("the smallest box around the curve")
        .input(format!("control points {b:?}"))
        .picture(|| {
            let curve = BezierCurve::new(points(b)).expect("four points");
            Picture::new()
                .given((0..=64).map(|k| curve.at(f64::from(k) / 64.0)))
                .expected(outline(right))
                .found(outline(found))
        })
        .close(found, right, allowed());
}

fn corners(low: [f64; 2], high: [f64; 2]) -> [Plane; 2] {
    [Point::new(low), Point::new(high)]
}

#[test]
fn the_box_of_the_control_points() {
    let cases = [
        (ARCH, corners([0.0, 0.0], [4.0, 4.0])),
        (
            [[3, -1], [-2, 7], [5, 0], [1, 1]],
            corners([-2.0, -1.0], [5.0, 7.0]),
        ),
        ([[7, 1]; 4], corners([7.0, 1.0], [7.0, 1.0])),
    ];
    for (b, right) in cases {
        claim("the smallest box around the control points")
            .input(format!("control points {b:?}"))
            .picture(|| {
                Picture::new()
                    .given(points(b))
                    .found(outline(answer::control_box(&points(b))))
            })
            .equal(answer::control_box(&points(b)), right);
    }
}

/// Why: y = 12t(1 − t) has its largest value 3 in the middle, and x grows from 0 to 4.
#[test]
fn an_arch() {
    compare(ARCH, corners([0.0, 0.0], [4.0, 3.0]));
}

/// Why: both zeros of y′ are inside; y = 27t(1 − t)(1 − 2t), and its extremes are ±27/(6√3).
#[test]
fn a_wave() {
    let height = 27.0 / (6.0 * 3.0_f64.sqrt());
    compare(WAVE, corners([0.0, -height], [3.0, height]));
}

/// Why: both coordinates are largest at the end, though their derivatives vanish for some t > 1.
#[test]
fn extremes_beyond_the_end() {
    compare(
        [[0, 0], [2, 3], [4, 5], [5, 6]],
        corners([0.0, 0.0], [5.0, 6.0]),
    );
}

/// Why: derivatives that are zero everywhere, and a double zero in the middle.
#[test]
fn lines_and_points() {
    compare([[7, 1]; 4], corners([7.0, 1.0], [7.0, 1.0]));
    compare(
        [[2, 0], [2, 1], [2, 2], [2, 3]],
        corners([2.0, 0.0], [2.0, 3.0]),
    );
    compare(
        [[0, 0], [1, 1], [0, 0], [1, 1]],
        corners([0.0, 0.0], [1.0, 1.0]),
    );
}

proptest! {
    /// Why: any cubic, and every coordinate may have none, one or two extremes inside.
    #[test]
    fn every_cubic(b in any::<[[i8; 2]; 4]>()) {
        let curve = BezierCurve::new(points(b)).expect("four points");
        let right = curve.tight_bounding_box();
        compare(b, [*right.low(), *right.high()]);
    }
}
