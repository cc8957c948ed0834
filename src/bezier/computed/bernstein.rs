//! Tables of binomial coefficients and Bernstein polynomials.

use super::Computed;
use crate::affine::Interval;
use crate::bezier::{bernstein_basis, bernstein_maximum, binomial};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("pascal_triangle", pascal_triangle),
    ("bernstein_table", bernstein_table),
    ("bernstein_maxima", bernstein_maxima),
];

/// The rows 0 … 5 of Pascal's triangle, with the zeros to the left and to the right.
fn pascal_triangle() -> String {
    let columns = -1..=6;
    let mut table = String::from("| $n$ |");
    for k in columns.clone() {
        table += &format!(" $k = {k}$ |");
    }
    table += "\n|---|";
    table += &"---|".repeat(columns.clone().count());
    for n in 0..=5 {
        table += &format!("\n| {n} |");
        for k in columns.clone() {
            table += &format!(" {} |", tex::decimal(&binomial(n, k), 0));
        }
    }
    table + "\n"
}

/// The values of degree 0 … 4 at t = 1/4, and their sums.
fn bernstein_table() -> String {
    let t = BigRational::from_ratio(1, 4);
    let mut table = String::from(
        "| $n$ | $B_0^n(\\tfrac14)$ | $B_1^n(\\tfrac14)$ | $B_2^n(\\tfrac14)$ | $B_3^n(\\tfrac14)$ | $B_4^n(\\tfrac14)$ | sum |\n|---|---|---|---|---|---|---|\n",
    );
    for n in 0..=4 {
        let values = bernstein_basis(n, t.clone());
        let sum: BigRational = values.iter().sum();
        let mut cells: Vec<String> = values.iter().map(tex::fraction).collect();
        cells.resize(5, "0".into());
        table += &format!(
            "| {n} | ${}$ | ${}$ |\n",
            cells.join("$ | $"),
            tex::fraction(&sum)
        );
    }
    table
}

/// Place and value of the maximum for m = 4 on [0, 1] and on [2, 6].
fn bernstein_maxima() -> String {
    let interval = Interval::new(BigRational::from_ratio(2, 1), BigRational::from_ratio(6, 1))
        .expect("two different ends");
    let mut table = String::from(
        "| $i$ | place of the maximum of $B_i^4$ on $[0,1]$ | on $[2,6]$ | value |\n|---|---|---|---|\n",
    );
    for i in 0..=4 {
        let unit = bernstein_maximum::<BigRational>(4, i, &Interval::unit()).expect("0 ≤ i ≤ 4");
        let other = bernstein_maximum(4, i, &interval).expect("0 ≤ i ≤ 4");
        table += &format!(
            "| {i} | ${}$ | ${}$ | ${}$ |\n",
            tex::fraction(&unit.place),
            tex::fraction(&other.place),
            tex::fraction(&unit.value)
        );
    }
    table
}
