//! The law of the intersection algorithm.

use super::largest_coordinate;
use super::subdivision::bernstein_sum;
use crate::bezier::PlaneCurve;
use crate::bezier::intersection::{Kind, Meeting, Range};
use crate::law::{Rounding, Sides};

/// `bezier-intersection-algorithm`: no intersection is lost, and what is called certain is one.
///
/// `implementation(first, second)` must give boxes of parameters.
/// `planted` are parameters with p(s) = q(t) exactly; each must lie in a box.
/// In the middle of a certain box the curves are as near as the size of the box allows, and certain boxes are disjoint.
///
/// # Rounding
///
/// The boxes are rounded outwards, so the first claim has no tolerance.
/// The speed of a curve over [a, b] is at most 2n·max|bᵢ|/(b − a); each value passes 4n + 2 roundings and the
/// middle of a box 2, relative to max(|a|, |b|)/(b − a) = r: 8nr more.
pub fn intersection_algorithm(
    implementation: impl Fn(&PlaneCurve, &PlaneCurve) -> Vec<Meeting>,
    curves: [&PlaneCurve; 2],
    planted: &[(f64, f64)],
) -> Sides<f64> {
    let meetings = implementation(curves[0], curves[1]);
    let outside = |range: &Range, u: f64| (range.low() - u).max(u - range.high()).max(0.0);
    let lost = planted.iter().map(|&(s, t)| {
        meetings
            .iter()
            .map(|box_| outside(&box_.first, s).max(outside(&box_.second, t)))
            .fold(f64::INFINITY, f64::min)
    });
    let certain: Vec<&Meeting> = meetings
        .iter()
        .filter(|meeting| meeting.kind == Kind::Certain)
        .collect();
    let sizes = curves.map(|curve| largest_coordinate(curve.control_points()));
    let apart = certain.iter().map(|meeting| {
        let middle = [meeting.first.middle(), meeting.second.middle()];
        let [p, q] = [0, 1].map(|k| {
            let t = curves[k].domain().local(middle[k]);
            bernstein_sum(curves[k].control_points(), &t)
        });
        (p[0] - q[0]).abs().max((p[1] - q[1]).abs())
    });
    let reach = certain.iter().map(|meeting| {
        let widths = [meeting.first.width(), meeting.second.width()];
        (0..2)
            .map(|k| {
                let speed = 2.0 * curves[k].degree() as f64 * sizes[k];
                speed / curves[k].domain().length().abs() * widths[k]
            })
            .sum::<f64>()
    });
    let touching = (0..certain.len())
        .flat_map(|i| (0..i).map(move |j| (i, j)))
        .filter(|&(i, j)| {
            certain[i].first.meets(&certain[j].first) && certain[i].second.meets(&certain[j].second)
        })
        .count();
    let degree = curves[0].degree().max(curves[1].degree());
    let far = curves
        .map(|curve| {
            let domain = curve.domain();
            domain.start().abs().max(domain.end().abs()) / domain.length().abs()
        })
        .into_iter()
        .fold(1.0, f64::max);
    let roundings = 8 * degree + 4 + (16.0 * degree as f64 * far).ceil() as usize;
    Sides::new(format!("{} and {}", curves[0], curves[1]))
        .at_most(
            "every planted intersection is in a box",
            lost.collect::<Vec<_>>(),
            vec![0.0; planted.len()],
            Rounding::none(),
        )
        .at_most(
            "in a certain box the curves meet",
            apart.collect::<Vec<_>>(),
            reach.collect::<Vec<_>>(),
            Rounding::new(roundings, 2.0 * (sizes[0] + sizes[1])),
        )
        .equal(
            "certain boxes are disjoint",
            [touching as f64],
            [0.0],
            Rounding::none(),
        )
}
