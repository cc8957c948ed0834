use cagd::affine::{Affine, Point};
use cagd::bezier::BezierCurve;
use cagd::check::claim;
use cagd::law::Violation;
use cagd::scalar::{BigRational, Scalar};

type Points = Vec<Point<BigRational, 2>>;
type Implementation = fn(&[Point<BigRational, 2>]) -> Points;

fn number(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

/// Polygons of each degree up to 4: one point at (1, 2) and the others at the origin, and one without symmetry.
fn polygons() -> Vec<Points> {
    let point = |x, y| Point::new([number(x), number(y)]);
    (1..=5_usize)
        .flat_map(|count| {
            let unit = |place| {
                let mut points = vec![point(0, 0); count];
                points[place] = point(1, 2);
                points
            };
            let general = (0..count as i64)
                .map(|i| point(i * i - 3, 2 - i * i * i))
                .collect();
            (0..count).map(unit).chain([general]).collect::<Vec<_>>()
        })
        .collect()
}

/// What the law says of an implementation: the first violation, or none.
fn judge(implementation: Implementation) -> Result<(), Violation> {
    for b in polygons() {
        // A polynomial of degree n + 1 is known from n + 2 values; the elevated one may have degree n + 2.
        for k in 0..=b.len() as i64 + 1 {
            answer::law(implementation, &b, &BigRational::from_ratio(k, 2)).judge()?;
        }
    }
    Ok(())
}

#[track_caller]
fn fails(what: &str, implementation: Implementation) {
    claim("the law on an implementation that does not elevate the degree by one")
        .input(what)
        .holds(
            judge(implementation).is_err(),
            "the law is violated for some input",
            "it holds for every input",
        );
}

fn elevated_with(b: &[Point<BigRational, 2>], weight: fn(i64, i64) -> BigRational) -> Points {
    let n = b.len() - 1;
    let inner = (1..=n).map(|i| b[i].lerp(&b[i - 1], weight(i as i64, n as i64)));
    let first = std::iter::once(b[0].clone());
    first.chain(inner).chain([b[n].clone()]).collect()
}

fn by_formula(b: &[Point<BigRational, 2>]) -> Points {
    elevated_with(b, |i, n| BigRational::from_ratio(i, n + 1))
}

fn by_the_library(b: &[Point<BigRational, 2>]) -> Points {
    let curve = BezierCurve::new(b.to_vec()).expect("at least one point");
    curve.elevated().control_points().to_vec()
}

fn unchanged(b: &[Point<BigRational, 2>]) -> Points {
    b.to_vec()
}

fn twice(b: &[Point<BigRational, 2>]) -> Points {
    by_formula(&by_formula(b))
}

fn midpoints(b: &[Point<BigRational, 2>]) -> Points {
    elevated_with(b, |_, _| BigRational::from_ratio(1, 2))
}

fn weights_swapped(b: &[Point<BigRational, 2>]) -> Points {
    elevated_with(b, |i, n| BigRational::from_ratio(n + 1 - i, n + 1))
}

fn right_in_x(b: &[Point<BigRational, 2>]) -> Points {
    let coordinates = by_formula(b).into_iter().zip(midpoints(b));
    coordinates
        .map(|(right, middle)| Point::new([right[0].clone(), middle[1].clone()]))
        .collect()
}

fn backwards(b: &[Point<BigRational, 2>]) -> Points {
    by_formula(b).into_iter().rev().collect()
}

fn probes() -> Vec<String> {
    let accepts = |implementation| judge(implementation).is_ok();
    cagd::probes![
        accepts(by_formula),
        accepts(unchanged),
        accepts(twice),
        accepts(midpoints),
        accepts(backwards),
        accepts(right_in_x),
    ]
}

/// Why: a law that is too strict is wrong, too.
#[test]
fn it_holds_for_right_implementations() {
    for (name, implementation) in [
        ("the formula of the chapter", by_formula as Implementation),
        ("the library", by_the_library),
    ] {
        let verdict = judge(implementation);
        let found = verdict
            .as_ref()
            .err()
            .map(ToString::to_string)
            .unwrap_or_default();
        claim("the law on a right implementation")
            .input(name)
            .holds(verdict.is_ok(), "the law holds", found);
    }
}

#[test]
fn it_rejects_a_wrong_number_of_points() {
    fails("the polygon unchanged", unchanged);
    fails("elevated twice", twice);
    fails("no point at all", |_| Vec::new());
}

/// Why: one point more, the same ends, but another curve.
#[test]
fn it_rejects_another_curve() {
    fails("the middles of the legs", midpoints);
    fails("the weights of the two neighbours swapped", weights_swapped);
    fails("right in x, the middles of the legs in y", right_in_x);
    fails("the last point repeated", |b| {
        elevated_with(b, |_, _| number(0))
    });
}

/// Why: the same points in another order are another motion.
#[test]
fn it_rejects_other_ends() {
    fails("the elevated polygon backwards", backwards);
    fails("always the first point", |b| {
        vec![b[0].clone(); b.len() + 1]
    });
}
