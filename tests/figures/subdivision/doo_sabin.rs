//! The figure of Doo–Sabin subdivision.

use cagd::affine::signed_area;
use cagd::figure::Place;
use cagd::law::gamma;
use cagd::subdivision::figures;

use crate::support::{ensure, figure_test, near};

/// Each face holds a smaller one with the same centroid, and the other faces fill the gaps between them.
#[test]
fn figure_doo_sabin() {
    figure_test(figures::figure_doo_sabin(), |plot| {
        let centroid = |corners: &[Place]| {
            let mean =
                |axis: usize| corners.iter().map(|p| p[axis]).sum::<f64>() / corners.len() as f64;
            Place::new([mean(0), mean(1)])
        };
        let old = plot.points("mesh/old vertices")?;
        for f in 0..9 {
            let new = plot.polygon(&format!("mesh/face {f}"))?;
            let [i, j] = [f % 3, f / 3];
            let corner = |i: usize, j: usize| old[i + 4 * j];
            let corners = [
                corner(i, j),
                corner(i + 1, j),
                corner(i + 1, j + 1),
                corner(i, j + 1),
            ];
            near(
                "the centroid stays",
                centroid(new),
                centroid(&corners),
                gamma(40) * 8.0,
            )?;
        }
        let kinds = |kind: &str| {
            let names = plot.names().filter(|(_, name)| name.starts_with(kind));
            names.count()
        };
        let counts = [kinds("face "), kinds("edge face "), kinds("vertex face ")];
        ensure(counts == [9, 12, 4], || {
            format!("{counts:?} faces of the three kinds")
        })?;
        for (_, name) in plot.names().filter(|(_, name)| name.contains("face ")) {
            let corners = plot.polygon(&format!("mesh/{name}"))?;
            let area = signed_area(&corners[0], &corners[1], &corners[2]);
            ensure(area > 0.0, || format!("{name} is turned over"))?;
        }
        Ok(())
    })
    .rejects("a new face beside its place", |plot| {
        plot.shifted("mesh/face 4", [0.1, 0.0])
    })
    .snapshot();
}
