//! The figure of Kobbelt's scheme.

use cagd::law::gamma;
use cagd::subdivision::figures;

use crate::support::{ensure, figure_test, near};

/// Both ways lead to one point, and the weights are the products.
#[test]
fn figure_kobbelt() {
    figure_test(figures::figure_kobbelt(), |plot| {
        let weights: Vec<i32> = plot
            .labels()
            .filter_map(|(text, _)| text.parse().ok())
            .collect();
        let products: Vec<i32> = [-1, 9, 9, -1]
            .into_iter()
            .flat_map(|row| [-1, 9, 9, -1].map(|column| row * column))
            .collect();
        ensure(weights == products, || {
            format!("the weights are {weights:?}")
        })?;
        ensure(weights.iter().sum::<i32>() == 256, || {
            "they do not sum to 1".into()
        })?;
        let [rows, columns] =
            ["rows first", "columns first"].map(|way| plot.point(&format!("{way}/face point")));
        // 20 terms with weights below 25/16 in all, coordinates below 5.
        near("both ways", rows?, columns?, gamma(24) * 2.0 * 8.0)
    })
    .rejects("ways that differ", |plot| {
        plot.shifted("rows first/face point", [0.01, 0.0])
    })
    .snapshot();
}
