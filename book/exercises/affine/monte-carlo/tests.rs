use cagd::affine::{BoundingBox, Point, UniformPoints};
use cagd::check::{Picture, claim};
use proptest::prelude::*;

/// The centres of the cells of a grid of n × n in the unit square.
fn grid(n: u32) -> Vec<[f64; 2]> {
    let middle = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
    (0..n * n).map(|k| [middle(k % n), middle(k / n)]).collect()
}

fn probes() -> Vec<String> {
    let left = |x: f64| move |point: [f64; 2]| point[0] < x;
    cagd::probes![
        answer::estimate([0.0, 0.0], [2.0, 4.0], &grid(2), left(1.0)),
        answer::estimate([1.0, 1.0], [5.0, 3.0], &grid(4), left(2.0)),
        answer::estimate([0.0, 0.0], [2.0, 4.0], &grid(2), |_| true),
        answer::estimate([0.0, 0.0], [1.0, 1.0], &[], |_| true),
    ]
}

/// Compares with the expected area and standard error.
///
/// Seven roundings lead to each number: two differences, two products, a quotient, 1 − q, the root. Each is relative
/// and at most 2⁻⁵³, but that of 1 − q may be enlarged where q is near 1; the shapes here keep q ≤ 15/16, so by at
/// most 16. So 10⁻¹³ of the box is more than enough, and far less than any mistake.
fn compare(
    [low, high]: [[f64; 2]; 2],
    points: &[[f64; 2]],
    contains: impl Fn([f64; 2]) -> bool + Copy,
    expected: Option<(f64, f64)>,
    shape: &str,
) {
    let size = (high[0] - low[0]) * (high[1] - low[1]);
    let corner = |x: f64, y: f64| Point::new([x, y]);
    claim("area and standard error")
        .input(format!(
            "the box from {low:?} to {high:?}, {} points, {shape}",
            points.len()
        ))
        .picture(|| {
            let [[a, b], [c, d]] = [low, high];
            Picture::new().given([
                corner(a, b),
                corner(c, b),
                corner(c, d),
                corner(a, d),
                corner(a, b),
            ])
        })
        .close(
            answer::estimate(low, high, points, contains),
            expected,
            1e-13 * size,
        );
}

/// Why: a quarter of four points is hit, so that one can follow every step.
#[test]
fn a_quarter_of_the_unit_square() {
    let corner = |[x, y]: [f64; 2]| x < 0.5 && y < 0.5;
    // p = 1/4, √(p(1 − p)/4) = √3/8.
    let expected = Some((0.25, 3.0_f64.sqrt() / 8.0));
    compare(
        [[0.0; 2], [1.0; 2]],
        &grid(2),
        corner,
        expected,
        "the corner x < 1/2, y < 1/2",
    );
}

/// Why: half of the box from the origin, where the size of the box matters.
#[test]
fn half_of_a_box() {
    let box_ = [[0.0, 0.0], [2.0, 4.0]];
    let expected = Some((4.0, 2.0));
    compare(box_, &grid(2), |[x, _]| x < 1.0, expected, "the half x < 1");
    compare(box_, &grid(2), |[_, y]| y > 2.0, expected, "the half y > 2");
}

/// Why: a box need not begin at the origin, in neither direction, and a quarter of it is hit.
#[test]
fn a_box_elsewhere() {
    // |Q| = 8, p = 1/4, N = 16: 8·√(3/16/16) = √3/2.
    let expected = Some((2.0, 3.0_f64.sqrt() / 2.0));
    let above = [[1.0, 2.0], [5.0, 4.0]];
    compare(
        above,
        &grid(4),
        |[x, _]| x < 2.0,
        expected,
        "the strip x < 2",
    );
    compare(
        above,
        &grid(4),
        |[_, y]| y < 2.5,
        expected,
        "the strip y < 5/2",
    );
    let below = [[-5.0, -3.0], [-1.0, -1.0]];
    compare(
        below,
        &grid(4),
        |[x, _]| x < -4.0,
        expected,
        "the strip x < −4",
    );
    compare(
        below,
        &grid(4),
        |[_, y]| y > -1.5,
        expected,
        "the strip y > −3/2",
    );
}

/// Why: if every point hits or none does, the standard error is 0.
#[test]
fn everything_and_nothing() {
    let box_ = [[1.0, 0.0], [3.0, 3.0]];
    compare(
        box_,
        &grid(3),
        |_| true,
        Some((6.0, 0.0)),
        "a shape that fills the box",
    );
    compare(
        box_,
        &grid(3),
        |_| false,
        Some((0.0, 0.0)),
        "the empty shape",
    );
}

/// Without points there is no estimate.
#[test]
fn no_points() {
    compare([[0.0; 2], [1.0; 2]], &[], |_| true, None, "any shape");
}

/// Why: 10000 random points and the quarter disc, for which the estimate is known to be near π/4.
#[test]
fn the_quarter_disc() {
    let square = BoundingBox::of(&[[0.0, 0.0], [1.0, 1.0]].map(Point::new)).expect("a box");
    // The points are the same in every run.
    let points: Vec<_> = UniformPoints::new(square, 1)
        .take(10_000)
        .map(|p| [p[0], p[1]])
        .collect();
    let disc = |[x, y]: [f64; 2]| x * x + y * y <= 1.0;
    let hits = points.iter().filter(|&&point| disc(point)).count();
    let share = hits as f64 / 1e4;
    let error = (share * (1.0 - share) / 1e4).sqrt();
    assert!(
        (share - std::f64::consts::FRAC_PI_4).abs() < 3.0 * error,
        "{share} ± {error}"
    );
    compare(
        [[0.0; 2], [1.0; 2]],
        &points,
        disc,
        Some((share, error)),
        "the quarter disc",
    );
}

proptest! {
    /// Why: any box, and any share of the columns or rows of a grid.
    #[test]
    fn strips(low in any::<[i8; 2]>(), size in [1..50_u8, 1..50_u8], n in 1..=16_u32, k in 0..2_usize, hit in 0..16_u32) {
        let low = low.map(f64::from);
        let size = size.map(f64::from);
        let high = [low[0] + size[0], low[1] + size[1]];
        let share = f64::from(hit % n) / f64::from(n);
        let end = low[k] + size[k] * share;
        let area = size[0] * size[1];
        let error = area * (share * (1.0 - share)).sqrt() / f64::from(n);
        let shape = format!("the strip {} < {end}", ["x", "y"][k]);
        compare([low, high], &grid(n), |point| point[k] < end, Some((area * share, error)), &shape);
    }
}
