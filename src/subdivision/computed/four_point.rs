//! Numbers of the analysis of the four-point scheme.

use super::Computed;
use crate::affine::Point;
use crate::book::tex;
use crate::scalar::{BigRational, OrderedScalar, Real, Scalar};
use crate::subdivision::{
    ControlPolygon, LaurentPolynomial, Mask, critical_tension, four_point_differences, norm_between,
};

pub(super) const ALL: &[Computed] = &[
    ("four_point_norms", four_point_norms),
    ("tension_norms", tension_norms),
    ("tension_interval_bound", tension_interval_bound),
    ("two_step_tension", two_step_tension),
    ("critical_tension", critical_tension_digits),
    ("second_differences", second_differences),
    ("distances_from_the_centre", distances_from_the_centre),
];

fn ratio(p: i64, q: i64) -> BigRational {
    <BigRational as Scalar>::from_ratio(p, q)
}

/// One scheme in a row: its name and its norms of 1, 2, … steps, each written by `number`.
fn rows(
    schemes: &[(&str, Option<Mask<BigRational>>)],
    steps: usize,
    number: impl Fn(&BigRational) -> String,
) -> String {
    let cells = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let head = std::iter::once("scheme".to_string());
    let mut table = cells(
        head.chain((1..=steps).map(|l| format!("$L = {l}$")))
            .collect(),
    );
    table += &cells(
        std::iter::once("---".into())
            .chain(vec!["--:".into(); steps])
            .collect(),
    );
    for (name, scheme) in schemes {
        let Some(scheme) = scheme else { continue };
        let norms = (1..=steps).map(|l| format!("${}$", number(&scheme.norm(l))));
        table += &cells(std::iter::once((*name).to_string()).chain(norms).collect());
    }
    table
}

/// The norms of the difference schemes for C⁰, C¹ and C², and of the second divided differences, w = 1/16.
fn four_point_norms() -> String {
    let mask = Mask::four_point(ratio(1, 16)).ok();
    let divided = |order: usize| mask.as_ref()?.divided_difference_scheme(order);
    let differences = |order: usize| divided(order)?.difference_scheme();
    let schemes = [
        ("$b$ for $C^0$", differences(0)),
        ("$b$ for $C^1$", differences(1)),
        ("$b$ for $C^2$", differences(2)),
        ("second divided differences", divided(2)),
    ];
    rows(&schemes, 6, tex::fraction)
}

/// The norms for C¹ with some tensions, as decimals.
fn tension_norms() -> String {
    let scheme = |p: i64, q: i64| four_point_differences(ratio(p, q)).ok();
    let schemes = [
        ("$w = 1/16$", scheme(1, 16)),
        ("$w = 3/20$", scheme(3, 20)),
        ("$w = 17/100$", scheme(17, 100)),
        ("$w = 9/50$", scheme(9, 50)),
        ("$w = 1/4$", scheme(1, 4)),
    ];
    rows(&schemes, 8, |norm| tex::decimal(norm, 4))
}

/// A bound for the norms of eight steps for all w from 3/20 to 9/50 at once.
fn tension_interval_bound() -> String {
    let [low, high] = [ratio(3, 20), ratio(9, 50)].map(four_point_differences);
    match (low, high) {
        (Ok(low), Ok(high)) => tex::decimal(&norm_between(&low, &high, 8), 6),
        _ => String::new(),
    }
}

/// The first digits of the tension where the norm of two steps is 1.
fn two_step_tension() -> String {
    format!("{:.4}", (Real::sqrt(5.0_f64) - 1.0) / 8.0)
}

/// The digits of w* that both ends of an exact interval share.
fn critical_tension_digits() -> String {
    let roots = critical_tension(ratio(1, 1 << 40));
    let ends = roots.isolated().iter().map(|root| {
        let [low, high] = [&root.low, &root.high].map(|end| format!("{:.14}", end.to_f64()));
        let shared = low.chars().zip(high.chars()).take_while(|(a, b)| a == b);
        shared.map(|(digit, _)| digit).collect::<String>()
    });
    ends.collect()
}

/// 4ᵏ times the second difference at a single 1 among zeros.
fn second_differences() -> String {
    let Ok(mask) = Mask::four_point(ratio(1, 16)) else {
        return String::new();
    };
    let mut table = String::from("| $k$ | second difference | $4^k$ times it |\n|--:|--:|--:|\n");
    let mut data = LaurentPolynomial::one();
    for k in 0..=6_u32 {
        let second = data.coefficient(1) - data.coefficient(0) * ratio(2, 1) + data.coefficient(-1);
        let scaled = &second * ratio(4_i64.pow(k), 1);
        table += &format!(
            "| ${k}$ | ${}$ | ${}$ |\n",
            tex::fraction(&second),
            tex::fraction(&scaled)
        );
        data = mask.apply(&data);
    }
    table
}

/// Where two schemes leave the circle through the corners of a closed square.
fn distances_from_the_centre() -> String {
    let square = [[1, 0], [0, 1], [-1, 0], [0, -1]]
        .map(|corner| Point::new(corner.map(<BigRational as Scalar>::from_integer)));
    let Ok(polygon) = ControlPolygon::closed(square) else {
        return String::new();
    };
    let vertex = |refined: ControlPolygon<Point<BigRational, 2>>, index: usize| {
        refined.vertices()[index].clone()
    };
    let places = [
        (
            "four-point: the first new vertex, which stays",
            polygon
                .four_point(ratio(1, 16))
                .map(|refined| vertex(refined, 1)),
        ),
        (
            "Chaikin: a vertex after one step",
            polygon.chaikin().map(|refined| vertex(refined, 0)),
        ),
        (
            "Chaikin: a point of the limit",
            polygon.lane_riesenfeld(1).map(|middles| vertex(middles, 1)),
        ),
    ];
    let mut table = String::from("| place | point | distance from the centre |\n|---|---|--:|\n");
    for (place, point) in places {
        let Ok(point) = point else { continue };
        let distance = Real::sqrt(
            point
                .coordinates()
                .iter()
                .map(|x| x.to_f64() * x.to_f64())
                .sum::<f64>(),
        );
        table += &format!(
            "| {place} | ${}$ | {distance:.4} |\n",
            tex::point(&point, tex::fraction)
        );
    }
    table
}
